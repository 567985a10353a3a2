//! Traits that other crates can use but not implement.

/// The supertrait of all sealed traits. It is public, but in a private module, so other crates cannot name it.
pub trait Sealed {}

/// Implements [`Sealed`] for types, so that they can implement the sealed traits of this crate.
macro_rules! sealed {
    ($($Type:ty),+) => {
        $(impl $crate::sealed::Sealed for $Type {})+
    };
}
pub(crate) use sealed;
