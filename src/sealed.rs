//! Traits that other crates can use but not implement.

/// The supertrait of such traits; public in name only.
pub trait Sealed {}

/// Lets the traits of this crate be implemented for types.
macro_rules! sealed {
    ($($Type:ty),+) => {
        $(impl $crate::sealed::Sealed for $Type {})+
    };
}
pub(crate) use sealed;
