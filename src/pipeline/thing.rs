//! What a canvas draws, and with which shading.

#![allow(private_bounds, private_interfaces)] // of traits that only this crate calls

use core::cell::Cell;

use embedded_graphics::pixelcolor::PixelColor;

use super::call::{Call, Region};
use super::options::DrawOptions;
use super::{Drawn, run};
use crate::canvas::{Blending, Canvas, DepthBuffer, DepthTest, Storage};
use crate::mesh::Mesh;
use crate::raster::{self, Blitter, ClippedVertex, DepthShift, LineStyle, Rasterizer};
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
pub trait Thing<C>: Sealed {
    /// Draws the thing to some rows of a frame.
    fn draw<V: AsMvp>(self, to: Region<'_>, mvp: &V, paint: impl Paint<C>) -> Drawn;
}

/// The last part of a draw call, where pixels get their colors: a canvas, options and a shader.
pub(super) trait Paint<C> {
    type Shader: ShaderFor<C>;
    type Blending: Blending<C>;
    type Test: DepthTest;

    /// The shading of all pixels except the pixels of smooth lines.
    fn shading(&self) -> (Self::Shader, Self::Blending, Self::Test);

    /// Runs the stages before the pixels. `shading` colors the pixels.
    fn run<K: ProjectionKind>(
        &mut self,
        shift: DepthShift,
        shading: impl Shading<Color = C>,
        stages: impl FnOnce(&mut dyn Blitter) -> Drawn,
    ) -> Drawn;
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
    type Shader = S;
    type Blending = B;
    type Test = Z;

    #[inline]
    fn shading(&self) -> (S, B, Z) {
        (self.2, self.1.blending, self.1.depth)
    }

    #[inline]
    fn run<K: ProjectionKind>(
        &mut self,
        shift: DepthShift,
        shading: impl Shading<Color = C>,
        stages: impl FnOnce(&mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        stages(&mut Blit::<_, _, _, K, _>::new(
            self.1.mode,
            self.0,
            shading,
            shift,
        ))
    }
}

impl Sealed for &Mesh<'_> {}

impl<C> Thing<C> for &Mesh<'_> {
    fn draw<V: AsMvp>(self, to: Region<'_>, mvp: &V, mut paint: impl Paint<C>) -> Drawn {
        let call = Call::new(to, self, mvp);
        paint.run::<V::Kind>(call.projector.depth_shift(), paint.shading(), |blitter| {
            run::draw(&call, blitter)
        })
    }
}

/// Draws a line between two ends.
pub(super) type DrawLine<'l> = &'l dyn Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]);

/// How lines are drawn on a canvas of color `C`.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot draw lines of color `{C}`",
    note = "anti-aliased lines need a color that implements `PixelFormat`"
)]
pub trait Pen<C>: Copy {
    /// Runs the stages before the pixels, and tells them how to draw a line.
    fn paint<K: ProjectionKind>(
        self,
        paint: impl Paint<C>,
        shift: DepthShift,
        stages: impl FnOnce(DrawLine<'_>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn;
}

impl<C> Pen<C> for LineStyle {
    #[inline]
    fn paint<K: ProjectionKind>(
        self,
        mut paint: impl Paint<C>,
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
        paint.run::<K>(shift, paint.shading(), |blitter| stages(line, blitter))
    }
}

impl<C: PixelFormat> Pen<C> for LineStyle<true> {
    #[inline]
    fn paint<K: ProjectionKind>(
        self,
        mut paint: impl Paint<C>,
        shift: DepthShift,
        stages: impl FnOnce(DrawLine<'_>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        let coverage = Cell::default();
        let line = |raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]| {
            raster::smooth_line(raster, ends, self.half(), &coverage);
        };
        let (shader, blending, test) = paint.shading();
        let shading = Smooth {
            shader,
            blending,
            test,
            coverage: &coverage,
        };
        paint.run::<K>(shift, shading, |blitter| stages(&line, blitter))
    }
}
