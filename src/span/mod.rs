//! From spans of pixels to pixels: interpolation, depth test, shader, store.
//!
//! [`Blit`] starts each span, asks the [mode](mode) which of four kernels draws it, and calls that: [`straight`]
//! adds, [`pieces`] adds and divides at the ends of straight pieces, [`newton`] multiplies at every pixel, [`divide`]
//! divides there.

// Outlined, a kernel has its interpolants and steps in memory: 8 instructions a pixel more on Cortex-M4 (of 18).
#![allow(clippy::inline_always)]
// Kernels take what they change or keep in registers by value.
#![allow(clippy::needless_pass_by_value)]

mod blit;
mod divide;
mod mode;
mod newton;
mod pieces;
mod pixels;
mod straight;
#[cfg(test)]
mod tests;

pub(crate) use blit::Blit;
pub use mode::{Affine, Exact, Fast, Mode, Newton};
