//! The options of a draw call.

use embedded_graphics::geometry::Size;

use super::call::Screen;
use crate::canvas::{DepthTest, Replace, TestAndWrite};
use crate::raster::{Cull, Hairline};
use crate::span::{Fast, Mode, Newton};
use crate::view::Viewport;

/// The options of a draw call: which faces are culled, which part of the frame is drawn to, the interpolation mode,
/// the depth test, how colors are blended with those on the canvas, and how lines are drawn.
///
#[cfg_attr(doc, doc = page_picture!("options", "A ring by the default options; with front faces culled; as lines; as points"))]
/// By default, a draw call culls back faces, draws to the whole frame in mode [`Newton`], tests and stores depths, and
/// replaces the colors on the canvas. Lines are one pixel wide.
///
/// ```
/// use fixel::prelude::*;
/// let left: DrawOptions = DrawOptions::new().with_viewport(Viewport::new(0, 0, 160, 240)?);
/// assert_eq!(left.viewport(), Some(Viewport::new(0, 0, 160, 240)?));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DrawOptions<M = Newton, Z = TestAndWrite, B = Replace, L = Hairline> {
    cull: Cull,
    viewport: Option<Viewport>,
    pub(super) pixels: PixelOptions<M, Z, B>,
    pub(super) line: L,
}

/// The options that each pixel is drawn with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct PixelOptions<M, Z, B> {
    pub(super) mode: M,
    pub(super) depth: Z,
    pub(super) blending: B,
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
            pixels: PixelOptions {
                mode: Newton,
                depth: TestAndWrite,
                blending: Replace,
            },
            line: Hairline,
        }
    }

    /// The default options in mode [`Fast`], within ¼ texel: for cores without 64-bit products, such as Cortex-M0+.
    ///
    /// ```
    /// use fixel::mode::Fast;
    /// use fixel::prelude::*;
    /// let quarter = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
    /// assert_eq!(DrawOptions::fast(), quarter);
    /// ```
    #[must_use]
    pub const fn fast() -> DrawOptions<Fast> {
        Self::new().with_mode(Fast::within(crate::fx!(0.25)))
    }
}

impl<M: Copy, Z: Copy, B: Copy, L: Copy> DrawOptions<M, Z, B, L> {
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
    pub const fn with_mode<N: Mode>(self, mode: N) -> DrawOptions<N, Z, B, L> {
        self.with(mode, self.pixels.depth, self.pixels.blending, self.line)
    }

    /// Sets how depths are tested and stored. On a canvas without a depth buffer, this has no effect.
    #[must_use]
    pub const fn with_depth<Y: DepthTest>(self, depth: Y) -> DrawOptions<M, Y, B, L> {
        self.with(self.pixels.mode, depth, self.pixels.blending, self.line)
    }

    /// Sets how colors are blended with those on the canvas.
    #[must_use]
    pub const fn with_blending<A: Copy>(self, blending: A) -> DrawOptions<M, Z, A, L> {
        self.with(self.pixels.mode, self.pixels.depth, blending, self.line)
    }

    /// Sets how lines are drawn: as one of the [`LineStyle`](crate::LineStyle)s. The methods that draw edges and
    /// outlines accept all styles; those that draw triangles, points and sprites accept only options with [`Hairline`].
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let wide = DrawOptions::new().with_line(LineWidth::new(fx!(3))?);
    /// let smooth = DrawOptions::new().with_line(LineWidth::new(fx!(1.5))?.smooth());
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn with_line<N: Copy>(self, line: N) -> DrawOptions<M, Z, B, N> {
        let pixels = self.pixels;
        self.with(pixels.mode, pixels.depth, pixels.blending, line)
    }

    /// The same options with these four, which may have other types.
    const fn with<N: Copy, Y: Copy, A: Copy, J: Copy>(
        self,
        mode: N,
        depth: Y,
        blending: A,
        line: J,
    ) -> DrawOptions<N, Y, A, J> {
        DrawOptions {
            cull: self.cull,
            viewport: self.viewport,
            pixels: PixelOptions {
                mode,
                depth,
                blending,
            },
            line,
        }
    }

    /// Returns which faces are culled.
    #[must_use]
    pub const fn cull(&self) -> Cull {
        self.cull
    }

    /// Returns the part of the frame that is drawn to; `None` for the whole frame.
    #[must_use]
    pub const fn viewport(&self) -> Option<Viewport> {
        self.viewport
    }

    /// Returns how attributes are interpolated.
    #[must_use]
    pub const fn mode(&self) -> M {
        self.pixels.mode
    }

    /// Returns how depths are tested and stored.
    #[must_use]
    pub const fn depth(&self) -> Z {
        self.pixels.depth
    }

    /// Returns how colors are blended with those on the canvas.
    #[must_use]
    pub const fn blending(&self) -> B {
        self.pixels.blending
    }

    /// Returns how lines are drawn.
    #[must_use]
    pub const fn line(&self) -> L {
        self.line
    }
}

impl<M, Z, B, L> DrawOptions<M, Z, B, L> {
    /// The part of a frame of this size that is drawn to, and the faces that are culled.
    pub(super) fn screen(&self, frame: Size) -> Screen {
        Screen {
            frame,
            viewport: self.viewport.unwrap_or(Viewport::whole(frame)),
            cull: self.cull,
        }
    }
}
