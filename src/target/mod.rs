//! Where pixels go: the caller's memory as a canvas, with or without depth, whole or in bands.

mod canvas;
mod depth;
mod depth_test;
mod draw_target;
mod float_depth;
mod storage;

pub use canvas::{Canvas, MAX_SIZE};
pub(crate) use canvas::{Cells, check_size};
pub(crate) use depth::linear;
pub use depth::{Depth, DepthBuffer, NoDepth};
pub use depth_test::{Biased, DepthTest, NoTest, TestAndWrite, TestOnly, WriteOnly};
pub use float_depth::FloatDepth;
pub use storage::{Bytes, Native, Storage};
