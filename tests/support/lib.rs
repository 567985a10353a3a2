//! What the tests share.

// f64 holds every integer used here exactly, and no pixel lies left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]
#![allow(missing_docs, clippy::missing_panics_doc)]
#![allow(clippy::must_use_candidate, clippy::return_self_not_must_use)]

pub mod bounds;
pub mod comparison;
pub mod counter;
pub mod drawing;
pub mod erased;
pub mod meshes;
pub mod mode;
pub mod moves;
pub mod random;
pub mod recorder;
pub mod reference;
pub mod spread;
