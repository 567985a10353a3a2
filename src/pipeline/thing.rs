//! What a canvas draws.

#![allow(private_bounds, private_interfaces)] // of a trait that only this crate calls

use core::cell::Cell;

use super::call::{Call, Region};
use super::{Drawn, run};
use crate::canvas::{Blending, DepthTest};
use crate::mesh::{CornerCache, Mesh};
use crate::raster::{self, Blitter, ClippedVertex, Coverage, LineStyle, Rasterizer};
use crate::sealed::Sealed;
use crate::shade::ShaderFor;
use crate::span::{Plain, Shading};
use crate::view::AsMvp;

/// A thing that can be drawn on a canvas of color `C`.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be drawn on a canvas of color `{C}`",
    note = "draw `&mesh`, `&mesh.part(range)`, `mesh.edges(style)`, `mesh.outline(&outline, style)`, \
            `style.between(from, to)`, `mesh.points(style)` or `&sprites`; anti-aliased lines need a color that \
            implements `PixelFormat`"
)]
pub trait Thing<C>: Copy + Sealed {
    /// The shading of the thing's pixels: [`Plain`] or, for anti-aliased lines, [`Smooth`](crate::span::Smooth).
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest>: Shading<Color = C>
        + From<(Plain<S, B, Z>, &'c Cell<Coverage>)>;

    /// Runs the stages of a draw call.
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn;
}

/// The target of a draw call: the rows of a frame, and the blitter that draws their pixels.
pub struct Target<'t, P> {
    pub(super) region: Region<'t>,
    pub(super) shading: &'t P,
    /// Where the rasterizer puts how much of each pixel an anti-aliased line covers.
    pub(super) coverage: &'t Cell<Coverage>,
    pub(super) blitter: &'t mut dyn Blitter,
    /// Whether an effect of the shader keeps what it computes at corners.
    pub(super) keeps_corners: bool,
}

impl Sealed for &Mesh<'_> {}

impl<C> Thing<C> for &Mesh<'_> {
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest> = Plain<S, B, Z>;

    #[inline]
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn {
        let corners;
        let mut call = Call::new(to.region, self, mvp);
        if call.is_outside() {
            let submitted = self.faces().len() as u32;
            return Drawn {
                submitted,
                ..Drawn::default()
            };
        }
        if to.keeps_corners {
            corners = CornerCache::new();
            call.placement.corners = Some(&corners);
        }
        run::draw(&call, to.blitter)
    }
}

/// Draws a line between two ends.
pub(super) type DrawLine<'l> = &'l dyn Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]);

impl<const SMOOTH: bool> LineStyle<SMOOTH> {
    /// Passes `stages` the function that draws a line in this style.
    #[inline]
    pub(super) fn with_line(
        self,
        coverage: &Cell<Coverage>,
        stages: impl FnOnce(DrawLine<'_>) -> Drawn,
    ) -> Drawn {
        let smooth = |raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]| {
            raster::smooth_line(raster, ends, self.half(), coverage);
        };
        let wide = |raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]| {
            raster::wide_line(raster, ends, self.half());
        };
        stages(if SMOOTH {
            &smooth
        } else if self.is_hairline() {
            &raster::line
        } else {
            &wide
        })
    }
}
