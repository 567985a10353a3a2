//! What the boards share: scenes, and the driver of their displays.
//!
//! The code does not depend on the chip, so it runs on your computer as well: the tests of this package check its
//! pictures and the bytes on the bus.
#![no_std]
#![deny(unsafe_code)]

pub mod ball;
pub mod floor;
pub mod led;
#[cfg(feature = "model")]
pub mod model;
pub mod panel;
#[cfg(feature = "picos")]
pub mod pico;
#[cfg(all(feature = "picos", not(feature = "rtic")))]
pub mod queue;
pub mod report;
pub mod slow_bus;
#[cfg(feature = "world")]
pub mod walk;

#[cfg(feature = "ball")]
pub use ball as scene;
#[cfg(not(feature = "ball"))]
pub use floor as scene;
