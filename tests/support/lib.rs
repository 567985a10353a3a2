//! Code that several test packages and the program `trade` share.
//!
//! | file | contents |
//! |---|---|
//! | `reference` | the f64 model of the whole pipeline, and the tests of the model |
//! | `random` | random inputs, the same in each run; a search for a small input that fails |
//! | `recorder` | shaders that record their input |
//! | `drawing`, `comparison` | draw calls through a recorder, and their comparison with the model |
//! | `erased` | shaders behind a pointer, so that many shaders share one compiled rasterizer |
//! | `mode` | the interpolation modes as values of one type |
//! | `bounds`, `spread` | the errors that formats allow, and the errors that a test measures |
//! | `moves`, `meshes`, `counter` | transforms and meshes for tests; a canvas that counts how often a pixel is drawn |

// f64 holds every integer used here exactly, and no pixel lies left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]
// Only tests call these functions, and a test may panic.
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
