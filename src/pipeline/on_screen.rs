//! Where points and meshes are on the screen: questions that draw nothing, and labels.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;

use super::options::DrawOptions;
use super::vertex::Projector;
use crate::canvas::{Canvas, DepthBuffer, DepthTest, Label, Storage};
use crate::math::Vec3;
use crate::mesh::{Bounds, Positions};
use crate::num::{Subpixel, block::BlockFloat};
use crate::raster::ScreenVertex;
use crate::view::{AsMvp, ProjectionKind, Viewport};

/// The screen position of a point of model space; [`Viewport::project`] returns it.
///
/// ```
/// use fixel::canvas::LinearDepth;
/// use fixel::prelude::*;
/// let screen = Viewport::new(0, 0, 8, 8)?;
/// let projection = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.5), fx!(10))?;
/// let at = screen.project(vec3!(0.5, 1, -2), &projection).unwrap();
/// assert_eq!((at.x.floor(), at.y.floor()), (5, 2));
/// assert_eq!(at.depth::<LinearDepth>(), 65535 / 4);
/// // Of two points, the nearer one has the greater nearness.
/// let behind = screen.project(vec3!(0.5, 1, -3), &projection).unwrap();
/// assert!(at.nearness > behind.nearness);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ScreenPoint {
    /// Columns from the frame's left edge, rounded to the nearest 1/256. A pixel in column n has its center at n + 0.5.
    pub x: Subpixel,
    /// Rows from the frame's top edge, rounded to the nearest 1/256.
    pub y: Subpixel,
    /// How near the point is: of two points under the same projection, the nearer one has the greater number. The
    /// number tells distances apart that differ by 2⁻²⁵ of themselves, which is finer than any depth buffer.
    pub nearness: u32,
}

/// The low bits of a nearness: how many bits of the depth it keeps. The higher bits are the exponent.
const MANTISSA: u32 = 26;
/// The greatest right shift of a depth, whose exponent is 0.
const MOST_DOWN: u32 = 47;

impl ScreenPoint {
    /// The same position on the screen, with the nearest depth, so that nothing hides a [label](Canvas::label) there.
    #[must_use]
    pub const fn on_top(self) -> Self {
        Self {
            nearness: u32::MAX,
            ..self
        }
    }

    /// The depth of the point, as a depth buffer of the format `D` stores it.
    #[must_use]
    pub fn depth<D: DepthBuffer>(self) -> u16 {
        let q = (self.nearness << (31 - MANTISSA)) & i32::MAX.cast_unsigned();
        let down = MOST_DOWN.saturating_sub(self.nearness >> MANTISSA);
        D::encode(q, down.max(15)) as u16
    }
}

/// The nearness of a depth `q` · 2^-`down`, where `q` has 31 bits, and `down` is from 15 to 47.
fn nearness(q: u32, down: u32) -> u32 {
    // Only under a parallel projection, the top bits of q may be 0. All formats drop the bits that are dropped here.
    let up = q.leading_zeros().saturating_sub(1);
    MOST_DOWN.saturating_sub(down + up) << MANTISSA | q.wrapping_shl(up) >> (31 - MANTISSA)
}

/// Questions about the screen that need no canvas, so you can ask them before you draw, or while another core draws.
/// The viewport of a whole canvas is [`Canvas::viewport`].
impl Viewport {
    /// The screen position of a point of model space, bit for bit as in a draw call to this viewport.
    ///
    /// The result is `None` if the point is nearer than the near plane, beyond the far plane, or more than 2048 pixels
    /// away from the viewport's center, horizontally or vertically. The position may lie outside the viewport.
    ///
    /// Use the position to place a [`label`](Canvas::label) beside an object. For the opposite direction, from a pixel
    /// into the scene, see [`ray`](Self::ray).
    #[must_use]
    pub fn project(&self, point: Vec3, mvp: &impl AsMvp) -> Option<ScreenPoint> {
        let projector = self.projector(Positions::of_one(&point), mvp);
        let mut at = ScreenVertex::UNSET;
        projector.project(0, None, &mut at);
        if at.outcode != 0 {
            return None;
        }
        let [x, y] = at.screen.map(Subpixel::from_bits);
        Some(ScreenPoint {
            x,
            y,
            nearness: nearness(at.q, projector.depth_shift().right_shift(at.exponent)),
        })
    }

    /// The transform of positions to the pixels of this viewport.
    pub(super) fn projector<'p, V: AsMvp>(
        &self,
        positions: Positions<'p>,
        mvp: &V,
    ) -> Projector<'p, V::Kind> {
        Projector::new(positions, mvp.projection_of(), &mvp.model_view_of(), self)
    }

    /// The size of `bounds` on the screen in whole pixels: the length of the box's diagonal, as seen at the distance of
    /// the box's center. (If the mesh is a ball, its box is a cube, and the ball's diameter is 1/√3 of the diagonal.)
    /// Use this size to choose among meshes with different levels of detail. The length is rounded to the nearest 1/256
    /// pixel, then down to whole pixels.
    ///
    /// Under a perspective projection, the result is `u32::MAX` unless the center is ahead of the eye by more than half
    /// of the diagonal. The corners of `bounds` are rounded to [`Scalar`](crate::Scalar)s in eye space, and saturate
    /// there.
    ///
    /// ```
    /// use fixel::mesh::Bounds;
    /// use fixel::prelude::*;
    /// static FINE: Mesh = shape!(sphere(24, 16));
    /// static COARSE: Mesh = shape!(sphere(8, 6));
    /// static BOUNDS: Bounds = FINE.bounds();
    /// let screen = Viewport::new(0, 0, 64, 64)?;
    /// let projection = Projection::perspective(deg!(60), (1, 1), fx!(0.5), fx!(100))?;
    /// for (distance, wanted) in [(4, &FINE), (40, &COARSE)] {
    ///     let mvp = projection * Transform::translate(Vec3::from_ints(0, 0, -distance));
    ///     let level = match screen.size_on_screen(&BOUNDS, &mvp) {
    ///         24.. => &FINE,
    ///         _ => &COARSE,
    ///     };
    ///     assert_eq!(level, wanted);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn size_on_screen<V: AsMvp>(&self, bounds: &Bounds, mvp: &V) -> u32 {
        let view = mvp.model_view_of();
        let (a, b) = (view.point(bounds.least), view.point(bounds.most));
        let diagonal = a.wide_distance(b);
        // How far the box's center is ahead of the eye, times two.
        let ahead = -(i64::from(a.z.to_bits()) + i64::from(b.z.to_bits()));
        if V::Kind::PERSPECTIVE && ahead <= diagonal {
            return u32::MAX;
        }
        let [width, _] = mvp.projection_of().pixel(self);
        let pixel = if V::Kind::PERSPECTIVE {
            width.times(BlockFloat::new(ahead, 17))
        } else {
            width
        };
        let size = BlockFloat::new(diagonal, 16).over(pixel);
        // The size is rounded to the nearest 2^-8, then down to a whole number.
        u32::try_from(size.at(8) >> 8).unwrap_or(u32::MAX)
    }
}

impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// A [`DrawTarget`](embedded_graphics::draw_target::DrawTarget) for text, or for anything else that
    /// embedded-graphics draws, at a point of the scene. The target's origin is the pixel that contains `at`.
    /// Surfaces that are nearer than `at` hide the pixels of the label.
    ///
    /// Everything drawn to the label has the point's depth, so the label looks like a sheet of paper that faces the
    /// viewer. A pixel of the label is drawn if the point is at least as near as the depth that the canvas has stored
    /// there. The stored depth does not change. Drawing cannot fail. Any point and any rectangle is allowed; `clear`
    /// fills every pixel that the scene does not hide.
    ///
    /// A label at a point of a surface may be hidden by parts of the same surface that are nearer. To avoid this,
    /// project a point in front of the surface. Or place the label at `at.on_top()` ([`on_top`](ScreenPoint::on_top)),
    /// where nothing hides it.
    ///
    /// ```
    /// use embedded_graphics::mock_display::MockDisplay;
    /// use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_4X6};
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// use embedded_graphics::{Drawable, geometry::Point, text::Text};
    /// use fixel::prelude::*;
    /// static WALL: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// let projection = Projection::perspective(deg!(90), (2, 1), fx!(0.5), fx!(20))?;
    /// let (mut pixels, mut depths) = ([Rgb565::BLACK; 26 * 13], [0; 26 * 13]);
    /// let mut canvas = Canvas::new(&mut pixels, 26, 13)?.with_depth(&mut depths)?;
    /// canvas.clear(Rgb565::BLACK);
    ///
    /// let wall = projection * Transform::translate(vec3!(0, 0, -3));
    /// canvas.draw(&WALL, &wall, &Flat::new(Rgb565::BLUE));
    /// // One label behind the front of the wall, and one in front of it.
    /// let style = MonoTextStyle::new(&FONT_4X6, Rgb565::WHITE);
    /// for (text, point) in [("Behind", vec3!(-12, 1, -6)), ("Before", vec3!(-5.4, -2, -2.9))] {
    ///     if let Some(at) = canvas.viewport().project(point, &projection) {
    ///         Text::new(text, Point::zero(), style).draw(&mut canvas.label(at))?;
    ///     }
    /// }
    ///
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "KKKKKKKKKKKKKKKKKKKKKKKKKK",
    ///     "WWKKKKKKWKKKKWKKKKKKKKWKKK",
    ///     "WKWKKWKKWWKKKKKKWWKKKWWKKK",
    ///     "WWKKWKWKWKBBBBBBWKWKWKWKKK",
    ///     "WKWKWWKKWKBBBBBBWKWKWKWKKK",
    ///     "WWKKKWWKWKBBBBBBWKWKKWWKKK",
    ///     "WWKKKKKKKKBBBBBBKKKKKKKKKK",
    ///     "WKWKKWKKKWBBBBBBWKWKKWKKKK",
    ///     "WWKKWKWKWWBBBBBBWWKKWKWKKK",
    ///     "WKWKWWKKKWBBBBBBWKKKWWKKKK",
    ///     "WWKKKWWKKWKKKWKKWKKKKWWKKK",
    ///     "KKKKKKKKKKKKKKKKKKKKKKKKKK",
    ///     "KKKKKKKKKKKKKKKKKKKKKKKKKK",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn label(&mut self, at: ScreenPoint) -> Label<'_, Self> {
        // A subpixel has eight fraction bits; a shift rounds down.
        let [x, y] = [at.x, at.y].map(|at| at.to_bits() >> 8);
        Label::new(self, Point::new(x, y), at.depth::<D>())
    }

    /// Whether a mesh within `bounds` may have a pixel in this canvas. If the result is `false`, the mesh certainly has
    /// none, whether it is drawn as triangles, as points or as hairlines. [Wide](crate::LineStyle) lines, points larger
    /// than [one pixel](crate::PointStyle) and [sprites](crate::Sprites) reach beyond their positions. For these,
    /// enlarge `bounds` by half of their width or size, in units of the model (for smooth lines, by half a pixel more).
    ///
    /// If a mesh [keeps its bounds](crate::Mesh::with_bounds), its draw call makes the same test for the whole frame.
    /// So call this function only for a test that the draw call does not make: whether an object of several meshes is
    /// in view, or whether a mesh is in this band. On a Cortex-M4 the test takes as many instructions as one or two
    /// triangles of one pixel. Most of these instructions set up the transform, as every draw call does before its
    /// first vertex.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::mesh::Bounds;
    /// use fixel::prelude::*;
    /// static BALL: Mesh = shape!(sphere(16, 12));
    /// static BOUNDS: Bounds = BALL.bounds();
    /// let mut pixels = [Gray8::new(0); 64];
    /// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
    /// let projection = Projection::perspective(deg!(60), (1, 1), fx!(0.5), fx!(100))?;
    /// for (x, is_seen) in [(fx!(0), true), (fx!(9), false)] {
    ///     let mvp = projection * Transform::translate(Vec3::new(x, fx!(0), fx!(-5)));
    ///     if canvas.is_in_view(&DrawOptions::new(), &BOUNDS, &mvp) {
    ///         canvas.draw(&BALL, &mvp, &Flat::new(Gray8::new(9)));
    ///     }
    ///     assert_eq!(canvas.is_in_view(&DrawOptions::new(), &BOUNDS, &mvp), is_seen);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn is_in_view(
        &self,
        options: &DrawOptions<impl Copy, impl DepthTest, impl Copy>,
        bounds: &Bounds,
        mvp: &impl AsMvp,
    ) -> bool {
        let screen = options.screen(self.frame_size());
        let projector = Projector::new(
            Positions::of_one(&Vec3::ZERO),
            mvp.projection_of(),
            &mvp.model_view_of(),
            &screen.viewport,
        );
        let scissor = screen.scissor(self.rows());
        !scissor.is_empty() && !projector.misses(bounds, &scissor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::{FloatDepth, LinearDepth, NoDepth, WideFloatDepth};
    use crate::random::cases;
    use crate::raster::{LEAST_WEIGHT, MOST_WEIGHT};
    use rand::Rng;

    fn depth_in<D: DepthBuffer>(q: u32, down: u32) {
        let at = ScreenPoint {
            x: Subpixel::ZERO,
            y: Subpixel::ZERO,
            nearness: nearness(q, down),
        };
        let depth = u32::from(at.depth::<D>());
        assert_eq!(depth, D::encode(q, down), "{q} >> {down}");
        assert_eq!(at.on_top().depth::<D>(), u16::MAX);
    }

    /// From a nearness, each format makes the depth that it makes of the depth itself. In perspective, the top bit of q
    /// is set. Under a parallel projection, the shift is 15.
    #[test]
    fn a_nearness_keeps_the_depth_of_every_format() {
        cases(1 << 14, |random| {
            let small =
                random.random_range(LEAST_WEIGHT..MOST_WEIGHT) >> random.random_range(0..20);
            let parallel = (small.max(LEAST_WEIGHT), 15);
            let perspective = (
                random.random_range(1 << 30..MOST_WEIGHT),
                random.random_range(15..=47),
            );
            for (q, down) in [parallel, perspective] {
                depth_in::<NoDepth>(q, down);
                depth_in::<LinearDepth>(q, down);
                depth_in::<FloatDepth>(q, down);
                depth_in::<WideFloatDepth>(q, down);
                // A depth that is nearer by a step of 2^-25 has a greater nearness.
                let step = (q >> 25).max(1);
                assert!(
                    nearness(q + step, down) > nearness(q, down),
                    "{q} >> {down}"
                );
            }
        });
    }
}
