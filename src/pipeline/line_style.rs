//! Styles of lines: one pixel wide, of a width, or anti-aliased.

use core::cell::Cell;

use super::call::Call;
use super::{Drawn, run};
use crate::canvas::Blending;
use crate::raster::{
    self, Blitter, ClippedVertex, Coverage, Hairline, LineWidth, Rasterizer, SmoothLine,
};
use crate::shade::{PixelFormat, ShaderFor};
use crate::span::{Shading, Smooth};
use crate::view::ProjectionKind;

/// A style of lines on a canvas of color `C`: [`Hairline`], [`LineWidth`] or, in a color of several
/// [`PixelFormat`], [`SmoothLine`]. Sealed.
///
/// [`DrawOptions::with_line`](crate::DrawOptions::with_line) takes it.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::{LineStyle, prelude::*};
/// fn draw<L>(canvas: &mut Canvas<'_, Rgb565>, line: L, mesh: &Mesh, mvp: &Mvp, color: Rgb565)
/// where
///     L: LineStyle<Rgb565>,
/// {
///     canvas.draw_edges(&DrawOptions::new().with_line(line), mesh, mvp, &Flat::new(color));
/// }
/// ```
#[allow(private_bounds)] // so that it is sealed
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot draw lines of color `{C}`",
    note = "a line is a `Hairline`, a `LineWidth` or, in a color with channels (`PixelFormat`), a `SmoothLine`"
)]
pub trait LineStyle<C>: Copy + Stroke<C> {}

#[diagnostic::do_not_recommend]
impl<C, L: Stroke<C>> LineStyle<C> for L {}

/// Draws a line between two ends.
pub(super) type DrawLine<'l> = &'l dyn Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]);

/// What a [`LineStyle`] does.
pub(super) trait Stroke<C>: Copy {
    /// What the rasterizer tells the shading about each line.
    type State: Default + 'static;

    /// Colors the pixels.
    type Shading<'s, S: ShaderFor<C>, B: Blending<C>>: Shading<Color = C>;

    /// The shading of lines of this style, which reads `state`.
    fn shading<S: ShaderFor<C>, B: Blending<C>>(
        state: &Self::State,
        shader: S,
        blending: B,
    ) -> Self::Shading<'_, S, B>;

    /// By how many rows a line may reach beyond its ends.
    fn reach(self) -> i32;

    /// Draws a line between two ends, and writes `state` for the shading.
    fn line(self, state: &Self::State, raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]);

    /// Returns [`line`](Self::line) with this style and this state, as a [`DrawLine`].
    #[inline]
    fn bind(self, state: &Self::State) -> impl Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]) {
        move |raster, ends| self.line(state, raster, ends)
    }

    /// Draws all edges of a mesh. All styles but [`Hairline`] share the code.
    #[inline]
    fn edges<K: ProjectionKind>(
        self,
        state: &Self::State,
        call: &Call<'_, K>,
        blitter: &mut dyn Blitter,
    ) -> Drawn {
        run::edges(call, &self.bind(state) as DrawLine<'_>, blitter)
    }
}

impl<C> Stroke<C> for Hairline {
    type State = ();
    type Shading<'s, S: ShaderFor<C>, B: Blending<C>> = (S, B);

    #[inline]
    fn shading<S: ShaderFor<C>, B: Blending<C>>((): &(), shader: S, blending: B) -> (S, B) {
        (shader, blending)
    }

    #[inline]
    fn reach(self) -> i32 {
        0
    }

    #[inline]
    fn line(self, (): &(), raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]) {
        raster::line(raster, ends);
    }

    /// Without a [`DrawLine`]: a program that draws only hairlines is smaller if it calls the rasterizer directly.
    #[inline]
    fn edges<K: ProjectionKind>(
        self,
        (): &(),
        call: &Call<'_, K>,
        blitter: &mut dyn Blitter,
    ) -> Drawn {
        run::edges(call, raster::line, blitter)
    }
}

impl<C> Stroke<C> for LineWidth {
    type State = ();
    type Shading<'s, S: ShaderFor<C>, B: Blending<C>> = (S, B);

    #[inline]
    fn shading<S: ShaderFor<C>, B: Blending<C>>((): &(), shader: S, blending: B) -> (S, B) {
        (shader, blending)
    }

    #[inline]
    fn reach(self) -> i32 {
        self.reach()
    }

    #[inline]
    fn line(self, (): &(), raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]) {
        raster::wide_line(raster, ends, self);
    }
}

impl<C: PixelFormat> Stroke<C> for SmoothLine {
    type State = Cell<Coverage>;
    type Shading<'s, S: ShaderFor<C>, B: Blending<C>> = Smooth<'s, S, B>;

    #[inline]
    fn shading<S: ShaderFor<C>, B: Blending<C>>(
        coverage: &Self::State,
        shader: S,
        blending: B,
    ) -> Smooth<'_, S, B> {
        Smooth {
            shader,
            blending,
            coverage,
        }
    }

    #[inline]
    fn reach(self) -> i32 {
        self.width().reach()
    }

    #[inline]
    fn line(self, coverage: &Self::State, raster: &mut Rasterizer<'_>, ends: [&ClippedVertex; 2]) {
        raster::smooth_line(raster, ends, self.width(), coverage);
    }
}
