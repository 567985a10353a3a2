//! Where points and meshes are on the screen: questions to a canvas that draw nothing, and labels.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;

use super::options::DrawOptions;
use super::vertex::Projector;
use crate::canvas::{Canvas, DepthBuffer, DepthTest, Label, Storage};
use crate::math::Vec3;
use crate::mesh::{Bounds, Positions};
use crate::num::{Subpixel, block::BlockFloat};
use crate::raster::ScreenVertex;
use crate::view::{AsMvp, ProjectionKind};

/// The screen position of a point of model space; [`Canvas::project`] returns it.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// let mut pixels = [Gray8::new(0); 64];
/// let canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let projection = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.5), fx!(10))?;
/// let at = canvas.project(&DrawOptions::new(), &projection, vec3!(0.5, 1, -2)).unwrap();
/// assert_eq!((at.x.floor(), at.y.floor()), (5, 2));
/// assert_eq!(at.depth, 65535 / 4);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ScreenPoint {
    /// Columns from the frame's left edge, rounded to the nearest 1/256. A pixel in column n has its center at n + 0.5.
    pub x: Subpixel,
    /// Rows from the frame's top edge, rounded to the nearest 1/256.
    pub y: Subpixel,
    /// The depth as the canvas's depth buffer would store it; linear if the canvas has no depth buffer.
    pub depth: u16,
}

impl ScreenPoint {
    /// The same position, in front of everything: nothing hides a [label](Canvas::label) there.
    #[must_use]
    pub const fn on_top(self) -> Self {
        Self {
            depth: u16::MAX,
            ..self
        }
    }
}

impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// The screen position of a point of model space: bit for bit the position at which a draw call draws the point.
    ///
    /// The result is `None` if the point is nearer than the near plane, beyond the far plane, or more than 2048 pixels
    /// away from the viewport's center, horizontally or vertically. The position may lie outside the viewport.
    ///
    /// Use it to place a [`label`](Self::label) beside an object. For the opposite direction, from a pixel into the
    /// scene, see [`ray`](Self::ray).
    #[must_use]
    pub fn project(
        &self,
        options: &DrawOptions<impl Copy, impl DepthTest, impl Copy>,
        mvp: &impl AsMvp,
        point: Vec3,
    ) -> Option<ScreenPoint> {
        let viewport = options.screen(self.frame_size()).viewport;
        let projector = Projector::new(
            Positions::of_one(&point),
            mvp.projection_of(),
            &mvp.model_view_of(),
            &viewport,
        );
        let mut at = ScreenVertex::UNSET;
        projector.project(0, None, &mut at);
        if at.outcode != 0 {
            return None;
        }
        let [x, y] = at.screen.map(Subpixel::from_bits);
        Some(ScreenPoint {
            x,
            y,
            depth: D::encode(at.q, projector.depth_shift().right_shift(at.exponent)) as u16,
        })
    }

    /// A [`DrawTarget`](embedded_graphics::draw_target::DrawTarget) for text, or for anything else that
    /// embedded-graphics draws, at a point of the scene. Its origin is the pixel that contains `at`, and nearer
    /// surfaces hide what is drawn.
    ///
    /// Everything drawn to the label has the point's depth, so the label looks like a sheet of paper that faces the
    /// viewer. A pixel is drawn if it is at least as near as the stored depth. The stored depth does not change.
    /// Drawing cannot fail. Any point and any rectangle is allowed; `clear` fills every pixel that the scene does not
    /// hide.
    ///
    /// A label at a point of a surface may be hidden by parts of the same surface that are nearer. To avoid this, give
    /// [`ScreenPoint::depth`] a greater value, or project a point in front of the surface. Nothing hides a label
    /// [`on_top`](ScreenPoint::on_top).
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
    ///     if let Some(at) = canvas.project(&DrawOptions::new(), &projection, point) {
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
        Label::new(self, Point::new(x, y), at.depth)
    }

    /// Whether a mesh within `bounds` may have a pixel in this canvas. If the result is `false`, the mesh certainly has
    /// none, whether it is drawn as triangles, as points or as hairlines. [Wide](crate::LineStyle) lines, points larger
    /// than [one pixel](crate::PointStyle) and [sprites](crate::Sprites) reach beyond their positions. For these,
    /// enlarge `bounds` by half of their width or size; for smooth lines, by half a pixel more.
    ///
    /// On a Cortex-M4 the test takes as many instructions as two or three triangles of one pixel, most of them for a
    /// set-up that every draw call needs before its first vertex. So a mesh that you skip, because it is out of view or
    /// in another band, costs no more than this test.
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
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::mesh::Bounds;
    /// use fixel::prelude::*;
    /// static FINE: Mesh = shape!(sphere(24, 16));
    /// static COARSE: Mesh = shape!(sphere(8, 6));
    /// static BOUNDS: Bounds = FINE.bounds();
    /// let mut pixels = [Gray8::new(0); 64 * 64];
    /// let mut canvas = Canvas::new(&mut pixels, 64, 64)?;
    /// let projection = Projection::perspective(deg!(60), (1, 1), fx!(0.5), fx!(100))?;
    /// for (distance, faces) in [(4, FINE.faces().len()), (40, COARSE.faces().len())] {
    ///     let mvp = projection * Transform::translate(Vec3::from_ints(0, 0, -distance));
    ///     let level = match canvas.size_on_screen(&DrawOptions::new(), &BOUNDS, &mvp) {
    ///         24.. => &FINE,
    ///         _ => &COARSE,
    ///     };
    ///     let drawn = canvas.draw(level, &mvp, &Flat::new(Gray8::new(9)));
    ///     assert_eq!(drawn.submitted, faces as u32);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn size_on_screen<V: AsMvp>(
        &self,
        options: &DrawOptions<impl Copy, impl DepthTest, impl Copy>,
        bounds: &Bounds,
        mvp: &V,
    ) -> u32 {
        let view = mvp.model_view_of();
        let (a, b) = (view.point(bounds.least), view.point(bounds.most));
        let diagonal = a.wide_distance(b);
        // How far the box's center is ahead of the eye, times two.
        let ahead = -(i64::from(a.z.to_bits()) + i64::from(b.z.to_bits()));
        if V::Kind::PERSPECTIVE && ahead <= diagonal {
            return u32::MAX;
        }
        let viewport = options.screen(self.frame_size()).viewport;
        let [width, _] = mvp.projection_of().pixel(&viewport);
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
