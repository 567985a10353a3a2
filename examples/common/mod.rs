//! What the examples and tests draw in common.

pub mod lighthouse;
pub mod scenes;
