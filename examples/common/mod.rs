//! Scenes and tools that examples and tests share.

// Not every example uses all of them.
#![allow(dead_code)]

pub mod gyroscope;
pub mod lighthouse;
pub mod scenes;
/// Only used on a microcontroller without an operating system.
#[cfg(target_os = "none")]
pub mod stack;
