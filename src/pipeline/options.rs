//! The options of a draw call.

use embedded_graphics::geometry::Size;

use super::call::Screen;
use crate::canvas::{DepthTest, Replace, TestAndWrite};
use crate::raster::Cull;
use crate::span::{Mode, Newton, Plain};
use crate::view::Viewport;

/// The options of a draw call: which faces are culled, which part of the frame is drawn to, the interpolation mode, the
/// depth test, and how colors are blended with the colors on the canvas.
///
#[cfg_attr(doc, doc = page_picture!("options", "A ring by the default options; with front faces culled; as lines; as points"))]
/// By default, a draw call culls back faces, draws to the whole frame in mode [`Newton`], tests and stores depths, and
/// replaces the colors on the canvas.
///
/// ```
/// use fixel::prelude::*;
/// let left: DrawOptions = DrawOptions::new().with_viewport(Viewport::new(0, 0, 160, 240)?);
/// assert_eq!(left.viewport, Some(Viewport::new(0, 0, 160, 240)?));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DrawOptions<M = Newton, Z = TestAndWrite, B = Replace> {
    /// Which faces are culled.
    pub cull: Cull,
    /// The part of the frame that is drawn to; `None` for the whole frame.
    pub viewport: Option<Viewport>,
    /// How attributes are interpolated.
    pub mode: M,
    /// How depths are tested and stored.
    pub depth_test: Z,
    /// How colors are blended with the colors on the canvas.
    pub blending: B,
}

impl<M, Z: DepthTest, B> DrawOptions<M, Z, B> {
    /// The part of a frame of this size that is drawn to, the faces that are culled, and whether depths are biased.
    #[inline]
    pub(super) fn screen(&self, frame: Size) -> Screen {
        Screen {
            frame,
            viewport: self.viewport.unwrap_or(Viewport::whole(frame)),
            cull: self.cull,
            is_biased: Z::IS_BIASED,
        }
    }
}

impl<M, Z: Copy, B: Copy> DrawOptions<M, Z, B> {
    /// The shading of pixels with these options.
    #[inline]
    pub(super) const fn shading<S>(&self, shader: S) -> Plain<S, B, Z> {
        Plain {
            shader,
            blending: self.blending,
            test: self.depth_test,
        }
    }
}

impl Default for DrawOptions {
    fn default() -> Self {
        Self::new()
    }
}

impl DrawOptions {
    /// The default options.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            cull: Cull::Back,
            viewport: None,
            mode: Newton::DEFAULT,
            depth_test: TestAndWrite,
            blending: Replace,
        }
    }
}

impl<M: Copy, Z: Copy, B: Copy> DrawOptions<M, Z, B> {
    /// Sets which faces are culled.
    #[must_use]
    pub const fn with_cull(self, cull: Cull) -> Self {
        Self { cull, ..self }
    }

    /// Projects to this part of the frame, and draws only there.
    #[must_use]
    pub const fn with_viewport(self, viewport: Viewport) -> Self {
        Self {
            viewport: Some(viewport),
            ..self
        }
    }

    /// Sets the interpolation mode.
    #[must_use]
    pub const fn with_mode<N: Mode>(self, mode: N) -> DrawOptions<N, Z, B> {
        self.with(mode, self.depth_test, self.blending)
    }

    /// Sets how depths are tested and stored. On a canvas without a depth buffer, this setting has no effect.
    #[must_use]
    pub const fn with_depth_test<Y: DepthTest>(self, depth_test: Y) -> DrawOptions<M, Y, B> {
        self.with(self.mode, depth_test, self.blending)
    }

    /// Sets how colors are blended with the colors on the canvas.
    #[must_use]
    pub const fn with_blending<A: Copy>(self, blending: A) -> DrawOptions<M, Z, A> {
        self.with(self.mode, self.depth_test, blending)
    }

    /// The same options with another mode, depth test and blending, which may have other types.
    const fn with<N, Y, A>(self, mode: N, depth_test: Y, blending: A) -> DrawOptions<N, Y, A> {
        DrawOptions {
            cull: self.cull,
            viewport: self.viewport,
            mode,
            depth_test,
            blending,
        }
    }
}
