//! How a draw call is to be done.

use embedded_graphics::geometry::Size;

use crate::pipeline::Cull;
use crate::span::{Interpolate, Newton};
use crate::view::Viewport;

/// How a draw call is to be done: which faces are culled, where on the canvas, by which mode.
///
/// The default culls back faces and draws to the whole frame in mode [`Newton`].
///
/// ```
/// use fixel::prelude::*;
/// let left: DrawOptions = DrawOptions::new().viewport(Viewport::new(0, 0, 160, 240)?);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DrawOptions<I = Newton> {
    pub(super) cull: Cull,
    pub(super) viewport: Option<Viewport>,
    pub(super) mode: I,
}

impl Default for DrawOptions {
    fn default() -> Self {
        Self::new()
    }
}

impl DrawOptions {
    /// The default.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            cull: Cull::Back,
            viewport: None,
            mode: Newton,
        }
    }
}

impl<I: Copy> DrawOptions<I> {
    /// Leaves out other faces.
    #[must_use]
    pub const fn cull(self, cull: Cull) -> Self {
        Self { cull, ..self }
    }

    /// Draws into a part of the frame, and into that only.
    #[must_use]
    pub const fn viewport(self, viewport: Viewport) -> Self {
        Self {
            viewport: Some(viewport),
            ..self
        }
    }

    /// The viewport in a frame of this size.
    pub(super) fn viewport_in(&self, frame: Size) -> Viewport {
        self.viewport.unwrap_or(Viewport::whole(frame))
    }

    /// Interpolates in another mode.
    #[must_use]
    pub const fn mode<J: Interpolate>(self, mode: J) -> DrawOptions<J> {
        DrawOptions {
            cull: self.cull,
            viewport: self.viewport,
            mode,
        }
    }
}
