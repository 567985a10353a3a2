//! Points: a mesh's positions, each one pixel, a square or a disc.

use super::Drawn;
use super::call::Call;
use super::thing::{Target, Thing};
use crate::canvas::{Blending, DepthTest};
use crate::mesh::{Index, Indices, Mesh};
use crate::num::block::{self, BlockFloat};
use crate::num::wide::product;
use crate::raster::{self, Blitter, PointStyle, Rasterizer, ScreenVertex};
use crate::sealed::Sealed;
use crate::shade::ShaderFor;
use crate::span::{Plain, Shading};
use crate::view::{AsMvp, Projection, ProjectionKind, Viewport};

/// The positions of a mesh, to be drawn as points.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Points<'m> {
    mesh: &'m Mesh<'m>,
    style: PointStyle,
}

impl Mesh<'_> {
    /// The mesh's positions, to be drawn as points by [`Canvas::draw`](crate::Canvas::draw): for each, a pixel, a
    /// square or a disc.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
    /// use fixel::prelude::*;
    /// let stars = [vec3!(-4, 0, -4), vec3!(0.5, 0, -8), vec3!(9, 0, -16)];
    /// let stars = Mesh::new(&stars, &[])?;
    /// let projection = Projection::perspective(deg!(60), (24, 9), fx!(1), fx!(20))?;
    /// let mut color = [BinaryColor::Off; 24 * 9];
    /// let mut canvas = Canvas::new(&mut color, 24, 9)?;
    /// let style = PointStyle::round(fx!(4))?.attenuated();
    /// canvas.draw(stars.points(style), &projection, &Flat::new(BinaryColor::On));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "........................",
    ///     "..#####.................",
    ///     ".#######................",
    ///     "########...###..........",
    ///     "########...###.##.......",
    ///     "########...###..........",
    ///     ".#######................",
    ///     "..#####.................",
    ///     "........................",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn points(&self, style: PointStyle) -> Points<'_> {
        Points { mesh: self, style }
    }
}

impl Sealed for Points<'_> {}

impl<C> Thing<C> for Points<'_> {
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest> = Plain<S, B, Z>;

    #[inline]
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn {
        let call = Call::new(to.region, self.mesh, mvp);
        if self.style.is_pixel() {
            pixels(&call, to.blitter)
        } else {
            let half = HalfSize::new(self.style, mvp.projection_of(), &to.region.0.viewport);
            sized_points(&call, &half, self.style.is_round(), to.blitter)
        }
    }
}

/// Half the size of points, in units of 1/256 pixel.
enum HalfSize {
    /// All points have this half size.
    Equal(i64),
    /// Half the size is mantissa · 2^-exponent / distance, with the distance in units of the near plane's distance.
    OverDistance(i32, i32),
}

impl HalfSize {
    /// Half the size of points in this style, drawn to a viewport.
    #[inline(never)]
    fn new<K: ProjectionKind>(
        style: PointStyle,
        projection: &Projection<K>,
        viewport: &Viewport,
    ) -> Self {
        let size = BlockFloat::new(style.size().to_bits().into(), 16);
        if !style.is_attenuated() {
            return Self::Equal(BlockFloat::new(size.value, 16 - 7).at(0));
        }
        // At distance 1, a unit of world space is as high as `scale` halves of the viewport.
        let [_, row] = &projection.rows;
        let [_, scale, ..] = row.m;
        let height = viewport.size().height;
        let size = size
            .times(BlockFloat::new(scale.into(), row.exp))
            .times(BlockFloat::new(height.into(), 2));
        if K::PERSPECTIVE {
            let near = BlockFloat::new(projection.near.to_bits().into(), 16);
            let (mantissa, exp) = size.over(near).rounded();
            Self::OverDistance(mantissa, exp)
        } else {
            Self::Equal(block::shift(size.value, 8 - size.exp))
        }
    }
}

/// Draws all positions of a mesh as pixels.
#[inline(never)]
fn pixels<K: ProjectionKind>(call: &Call<'_, K>, blitter: &mut dyn Blitter) -> Drawn {
    each_point(
        call,
        (blitter, call.is_outside()),
        |_| 0,
        |raster, at, _| raster::point(raster, at, None),
    )
}

/// Draws all positions of a mesh as squares or discs.
#[inline(never)]
fn sized_points<K: ProjectionKind>(
    call: &Call<'_, K>,
    half: &HalfSize,
    is_round: bool,
    blitter: &mut dyn Blitter,
) -> Drawn {
    let half_of = |at: &ScreenVertex| {
        raster::half_size(match *half {
            HalfSize::Equal(half) => half,
            HalfSize::OverDistance(mantissa, exp) => {
                // near / w = q · 2^(exponent − 16 − shift), as for the depth.
                let shift = i32::from(at.exponent) - 16 - call.projector.depth_shift().0 - exp;
                block::shift(product(mantissa, at.q.cast_signed()), shift + 8)
            }
        })
    };
    // Large points may reach into the picture from far outside.
    each_point(call, (blitter, false), half_of, |raster, at, half| {
        raster::sized_point(raster, at, half, is_round);
    })
}

/// Draws all positions of a mesh that are inside all planes, each by `point`, which receives half the point's size in
/// units of 1/256 pixel. Draws none if all points are known to be outside the view.
#[inline]
fn each_point<K: ProjectionKind>(
    call: &Call<'_, K>,
    (blitter, is_outside): (&mut dyn Blitter, bool),
    half_of: impl Fn(&ScreenVertex) -> i32,
    point: impl Fn(&mut Rasterizer<'_>, &ScreenVertex, i32),
) -> Drawn {
    let count = call.placement.mesh.positions().len();
    let mut raster = call.rasterizer(blitter);
    for index in 0..if is_outside { 0 } else { count as u32 } {
        // A mesh has at most 65,536 positions.
        let index = index as Index;
        let mut at = ScreenVertex::UNSET;
        call.projector.project(index, None, &mut at);
        if at.outcode != 0 {
            continue;
        }
        let (half, [_, y]) = (half_of(&at), at.screen);
        if raster.meets([y, y], (half >> 8) + 1) {
            raster.next_thin(Indices::of_point(index), 0, false);
            point(&mut raster, &at, half);
        }
    }
    Drawn::new([count as u32, 0], &raster, &call.placement)
}
