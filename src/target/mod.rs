//! Where pixels go: the caller's memory as a canvas, with or without depth, whole or in bands.

mod canvas;
mod depth;
mod draw_target;
mod storage;

pub(crate) use canvas::check_size;
pub use canvas::{Canvas, MAX_SIZE};
pub use depth::{Depth, DepthBuffer, NoDepth};
pub use storage::{Bytes, Native, Storage};
