//! The canvas: a frame, or a band of a frame, in memory of the caller, with or without a depth buffer.
//!
#![cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#![cfg_attr(doc, doc = page_picture!("formats", "A ball in 16 bits of color, in four grays, in black and white"))]
//! A [`Canvas`] has three type parameters: its color, how the color is stored, and its depth buffer. The compiler
//! infers these types from your slices. Write them out only if the canvas stores words or bytes. Each draw call chooses
//! how it uses the depth buffer, and how its colors are blended with the colors on the canvas.
//!
//! | choice | types |
//! |---|---|
//! | storage of a color | [`Native`], [`Words`], or embedded-graphics' `BigEndian` and `LittleEndian` for bytes |
//! | depth buffer | [`NoDepth`], [`LinearDepth`], [`FloatDepth`] or [`WideFloatDepth`] |
//! | depth test of a draw call | [`TestAndWrite`], [`TestOnly`], [`TestNearer`], [`TestBehind`], [`WriteOnly`], [`NoTest`], or [`Biased`] around one of these |
//! | blending of a draw call | [`Replace`], [`Opacity`], [`Add`] or [`Multiply`] |

mod blending;
#[allow(clippy::module_inception)] // one type, one file
mod canvas;
mod color_index;
mod contrast;
mod depth;
mod depth_test;
mod diffusion;
mod label;
mod storage;

pub use blending::{Add, Blending, Multiply, Opacity, Replace};
pub use canvas::Canvas;
pub(crate) use canvas::check_size;
pub use color_index::ColorIndex;
pub use contrast::Contrast;
pub use depth::{DepthBuffer, FloatDepth, LinearDepth, NoDepth, WideFloatDepth};
pub use depth_test::{
    Biased, DepthTest, NoTest, TestAndWrite, TestBehind, TestNearer, TestOnly, WriteOnly,
};
pub use diffusion::ErrorDiffusion;
pub use label::Label;
pub(crate) use storage::{Cells, Memory};
pub use storage::{Native, Storage, Words};
