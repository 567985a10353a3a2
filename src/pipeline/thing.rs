//! What a canvas draws, and with which shading.

use core::cell::Cell;
use core::ops::Range;

use embedded_graphics::pixelcolor::PixelColor;

use super::call::{Call, Screen};
use super::options::DrawOptions;
use super::{Drawn, run};
use crate::canvas::{Blending, Canvas, DepthBuffer, DepthTest, Storage};
use crate::mesh::Mesh;
use crate::raster::{self, Blitter, ClippedVertex, Coverage, DepthShift, LineStyle, Rasterizer};
use crate::sealed::Sealed;
use crate::shade::{PixelFormat, ShaderFor};
use crate::span::{Blit, Mode, Shading, Smooth};
use crate::view::{AsMvp, ProjectionKind};

/// A thing that can be drawn on a canvas of color `C`.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be drawn on a canvas of color `{C}`",
    note = "draw `&mesh`, `&mesh.part(range)`, `mesh.edges(style)`, `mesh.outline(&outline, style)`, \
            `style.between(from, to)`, `mesh.points(style)` or `&sprites`"
)]
#[allow(private_bounds)] // `Paint` is named only here
pub trait Thing<C>: Sealed {
    /// Draws it to some rows of a frame.
    fn draw<V: AsMvp>(
        self,
        screen: &Screen,
        rows: &Range<u32>,
        mvp: &V,
        paint: impl Paint<C>,
    ) -> Drawn;
}

/// The pixels' end of a draw call: a canvas, options and a shader.
pub(super) trait Paint<C> {
    /// Colors the pixels, unless lines are smooth.
    type Shading: Shading<Color = C>;

    /// Colors the pixels, unless lines are smooth.
    fn shading(&self) -> Self::Shading;

    /// Runs the stages before the pixels.
    fn plain<K: ProjectionKind>(
        self,
        shift: DepthShift,
        stages: impl FnOnce(&mut dyn Blitter) -> Drawn,
    ) -> Drawn;

    /// Runs the stages before the pixels; each pixel is covered as far as the cell says, which the stages set.
    fn smooth<K: ProjectionKind>(
        self,
        shift: DepthShift,
        coverage: &Cell<Coverage>,
        stages: impl FnOnce(&mut dyn Blitter) -> Drawn,
    ) -> Drawn
    where
        C: PixelFormat;
}

impl<C, O, D, M, Z, B, S> Paint<C> for (&mut Canvas<'_, C, O, D>, &DrawOptions<M, Z, B>, S)
where
    C: PixelColor,
    O: Storage<C>,
    D: DepthBuffer,
    M: Mode,
    Z: DepthTest,
    B: Blending<C>,
    S: ShaderFor<C>,
{
    type Shading = (S, B);

    #[inline]
    fn shading(&self) -> (S, B) {
        (self.2, self.1.blending())
    }

    #[inline]
    fn plain<K: ProjectionKind>(
        self,
        shift: DepthShift,
        stages: impl FnOnce(&mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        let shading = self.shading();
        let modes = (self.1.mode(), self.1.depth());
        stages(&mut Blit::<_, _, _, K, _, _>::new(
            modes, self.0, shading, shift,
        ))
    }

    #[inline]
    fn smooth<K: ProjectionKind>(
        self,
        shift: DepthShift,
        coverage: &Cell<Coverage>,
        stages: impl FnOnce(&mut dyn Blitter) -> Drawn,
    ) -> Drawn
    where
        C: PixelFormat,
    {
        let (shader, blending) = self.shading();
        let shading = Smooth {
            shader,
            blending,
            coverage,
        };
        let modes = (self.1.mode(), self.1.depth());
        stages(&mut Blit::<_, _, _, K, _, _>::new(
            modes, self.0, shading, shift,
        ))
    }
}

impl Sealed for &Mesh<'_> {}

#[allow(private_bounds)]
impl<C> Thing<C> for &Mesh<'_> {
    fn draw<V: AsMvp>(
        self,
        screen: &Screen,
        rows: &Range<u32>,
        mvp: &V,
        paint: impl Paint<C>,
    ) -> Drawn {
        let call = Call::new(screen, rows, self, mvp);
        paint.plain::<V::Kind>(call.depth_shift(), |blitter| run::draw(&call, blitter))
    }
}

/// Draws a line between two ends.
pub(super) type DrawLine<'l> = &'l dyn Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]);

/// How triangles or lines are drawn on a canvas of color `C`.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot draw lines of color `{C}`",
    note = "anti-aliased lines need a color of several `PixelFormat`"
)]
#[allow(private_bounds)] // `Paint` is named only here
pub trait Pen<C>: Copy {
    /// Runs the stages before the pixels, which draw each line as they are told.
    #[allow(private_interfaces)]
    fn paint<K: ProjectionKind>(
        self,
        paint: impl Paint<C>,
        shift: DepthShift,
        stages: impl FnOnce(DrawLine<'_>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn;
}

/// How faces are drawn: filled.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Fill;

#[allow(private_bounds)]
impl<C> Pen<C> for Fill {
    #[inline]
    #[allow(private_interfaces)]
    fn paint<K: ProjectionKind>(
        self,
        paint: impl Paint<C>,
        shift: DepthShift,
        stages: impl FnOnce(DrawLine<'_>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        paint.plain::<K>(shift, |blitter| stages(&|_, _| (), blitter))
    }
}

#[allow(private_bounds)]
impl<C> Pen<C> for LineStyle {
    #[inline]
    #[allow(private_interfaces)]
    fn paint<K: ProjectionKind>(
        self,
        paint: impl Paint<C>,
        shift: DepthShift,
        stages: impl FnOnce(DrawLine<'_>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        let wide = |raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]| {
            raster::wide_line(raster, ends, self.half());
        };
        let line: DrawLine<'_> = if self.is_hairline() {
            &raster::line
        } else {
            &wide
        };
        paint.plain::<K>(shift, |blitter| stages(line, blitter))
    }
}

#[allow(private_bounds)]
impl<C: PixelFormat> Pen<C> for LineStyle<true> {
    #[inline]
    #[allow(private_interfaces)]
    fn paint<K: ProjectionKind>(
        self,
        paint: impl Paint<C>,
        shift: DepthShift,
        stages: impl FnOnce(DrawLine<'_>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        let coverage = Cell::default();
        let line = |raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]| {
            raster::smooth_line(raster, ends, self.half(), &coverage);
        };
        paint.smooth::<K>(shift, &coverage, |blitter| stages(&line, blitter))
    }
}
