//! From spans to pixels: interpolation, depth test, shader, blending, store.
//!
//! A [`plan`] says how pixels are computed. The mode chooses one plan for all spans of a triangle, or one plan for each
//! span. An [`interpolator`] computes the [planes](setup) of a triangle's interpolants, and the first values of each
//! span. [`Blit`] then calls the kernel (the loop over pixels) that the plan names: [`straight`] only adds; [`pieces`]
//! adds, and computes a reciprocal at the ends of straight pieces; [`newton`] refines a reciprocal at every pixel;
//! [`divide`] divides at every pixel.

// Kernels are inlined. A kernel out of line would keep its interpolants and steps in memory. On Cortex-M4, this would
// add 8 instructions per pixel to 18.
#![allow(clippy::inline_always)]
// Kernels take arguments by value if they change them or keep them in registers.
#![allow(clippy::needless_pass_by_value)]

mod blit;
mod divide;
mod interpolant;
mod interpolator;
mod mode;
mod newton;
mod pieces;
mod pixels;
mod plan;
mod scale;
mod setup;
mod shading;
mod straight;
#[cfg(test)]
mod tests;

pub(crate) use blit::Blit;
pub use mode::{Affine, Compact, Exact, Fast, Mode, Newton};
pub(crate) use shading::{Plain, Shading, Smooth, is_plane};
