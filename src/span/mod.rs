//! From spans of pixels to pixels: interpolation, depth test, shader, store.
//!
//! [`Blit`] starts each span, asks the [mode](mode) which of four kernels draws it, and calls that: [`straight`]
//! adds, [`pieces`] adds and divides at the ends of straight pieces, [`newton`] multiplies at every pixel, [`divide`]
//! divides there.

mod blit;
mod divide;
mod mode;
mod newton;
mod pieces;
mod pixels;
mod straight;

pub(crate) use blit::Blit;
pub use mode::{Affine, Exact, Fast, Mode, Newton};
