//! What the examples and tests draw in common.

// Not every example uses all of it.
#![allow(dead_code)]

pub mod gyroscope;
pub mod lighthouse;
pub mod scenes;
/// Measured on the bare stack of a microcontroller.
#[cfg(target_os = "none")]
pub mod stack;
