//! Scenes and tools that examples and tests share.

// Not every example uses all modules.
#![allow(dead_code)]

pub mod lighthouse;
pub mod rotations;
pub mod scenes;
/// Only microcontrollers without an operating system use this module.
#[cfg(target_os = "none")]
pub mod stack;
