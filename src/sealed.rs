//! Traits that other crates can use but not implement.

/// The supertrait of all sealed traits. It is public, but in a private module, so other crates cannot name it.
pub trait Sealed {}
