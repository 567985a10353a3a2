//! The canvas: the caller's memory for a frame or a band of it, with or without a depth buffer.

mod canvas;
mod depth;
mod depth_test;
mod draw_target;
mod format;
mod storage;

pub use canvas::{Canvas, MAX_SIZE};
pub(crate) use canvas::{Cells, check_size};
pub(crate) use depth::Buffer;
pub use depth::{Depth, DepthBuffer, NoDepth};
pub use depth_test::{Biased, DepthTest, NoTest, TestAndWrite, TestOnly, WriteOnly};
pub(crate) use format::linear;
pub use format::{DepthFormat, Float, Linear, WideFloat};
pub use storage::{Bytes, Native, Storage};
