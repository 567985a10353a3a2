//! The checks that are fuzzed, and the parts of the crate's tests that they need.

#[path = "../accuracy/bounds.rs"]
pub mod bounds;
#[path = "../fuzzed/mod.rs"]
pub mod fuzzed;
#[path = "../accuracy/mode.rs"]
pub mod mode;
#[path = "../accuracy/moves.rs"]
pub mod moves;
#[path = "../common/recorder.rs"]
pub mod recorder;
#[path = "../reference/mod.rs"]
pub mod reference;
