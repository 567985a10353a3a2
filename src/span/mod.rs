//! From spans to pixels: interpolation, depth test, shader, blending, store.
//!
//! For each triangle and, where a mode decides later, for each span there is a [`plan`]. An [`interpolator`] lays
//! [planes](setup) and starts spans as the plan says, and [`Blit`] calls its kernel: [`straight`] adds, [`pieces`] adds
//! and computes a reciprocal at the ends of straight pieces, [`newton`] refines a reciprocal at every pixel, [`divide`]
//! divides at every pixel.

// Kernels are inlined: out of line, a kernel keeps its interpolants and steps in memory, which takes 8 instructions per
// pixel on Cortex-M4 in addition to 18.
#![allow(clippy::inline_always)]
// Kernels take by value what they change or keep in registers.
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
