//! From spans to pixels: interpolation, depth test, shader, blending, store.
//!
//! A [`plan`] says how pixels are computed. Each triangle has a plan; if its mode decides later, each span has one. An
//! [`interpolator`] lays [planes](setup) over a triangle and starts its spans, and [`Blit`] calls the kernel that the
//! plan names: [`straight`] adds; [`pieces`] adds, and computes a reciprocal at the ends of straight pieces; [`newton`]
//! refines a reciprocal at every pixel; [`divide`] divides at every pixel.

// Kernels are inlined. Out of line, a kernel keeps its interpolants and steps in memory. On Cortex-M4, this takes 8
// instructions per pixel in addition to 18.
#![allow(clippy::inline_always)]
// Kernels take arguments by value if they change them or keep them in registers.
#![allow(clippy::needless_pass_by_value)]

mod blit;
mod divide;
mod gradient;
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
pub(crate) use shading::{Shading, Smooth, is_plane};
