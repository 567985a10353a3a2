//! The options of a draw call.

use embedded_graphics::geometry::Size;

use crate::raster::Cull;
use crate::span::{Fast, Mode, Newton};
use crate::target::{DepthTest, TestAndWrite};
use crate::view::Viewport;

/// The options of a draw call: which faces are culled, which part of the frame is drawn to, the interpolation mode,
/// and the depth test.
///
/// By default, a draw call culls back faces, draws to the whole frame in mode [`Newton`], and tests and stores
/// depths.
///
/// ```
/// use fixel::prelude::*;
/// let left: DrawOptions = DrawOptions::new().with_viewport(Viewport::new(0, 0, 160, 240)?);
/// assert_eq!(left.viewport(), Some(Viewport::new(0, 0, 160, 240)?));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DrawOptions<M = Newton, Z = TestAndWrite> {
    pub(super) cull: Cull,
    pub(super) viewport: Option<Viewport>,
    pub(super) mode: M,
    pub(super) depth: Z,
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
            mode: Newton,
            depth: TestAndWrite,
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

impl<M: Copy, Z: Copy> DrawOptions<M, Z> {
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
    pub const fn with_mode<N: Mode>(self, mode: N) -> DrawOptions<N, Z> {
        DrawOptions {
            cull: self.cull,
            viewport: self.viewport,
            mode,
            depth: self.depth,
        }
    }

    /// Sets how depths are tested and stored. On a canvas without a depth buffer, this has no effect.
    #[must_use]
    pub const fn with_depth<Y: DepthTest>(self, depth: Y) -> DrawOptions<M, Y> {
        DrawOptions {
            cull: self.cull,
            viewport: self.viewport,
            mode: self.mode,
            depth,
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
        self.mode
    }

    /// Returns how depths are tested and stored.
    #[must_use]
    pub const fn depth(&self) -> Z {
        self.depth
    }

    /// The viewport in a frame of this size.
    pub(super) fn viewport_in(&self, frame: Size) -> Viewport {
        self.viewport.unwrap_or(Viewport::whole(frame))
    }
}
