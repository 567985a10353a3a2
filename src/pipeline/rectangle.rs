//! Which pixels a mesh may change: a rectangle.

use core::ops::Range;

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;

use super::vertex::Projector;
use crate::math::Vec3;
use crate::mesh::{Bounds, Positions};
use crate::raster::ScreenVertex;
use crate::view::{AsMvp, ProjectionKind, Viewport};

impl Viewport {
    /// The pixels of this viewport that a draw call may change, if it draws a mesh within `bounds`: a rectangle around
    /// the box on the screen, rounded outward to whole pixels. `None` if there are no such pixels.
    ///
    /// If a mesh moves over a still picture, clear, draw and send to the display only this rectangle: see the example.
    ///
    /// `reach` is how many pixels lines and points reach beyond their positions:
    ///
    /// | drawn as | `reach` |
    /// |---|---|
    /// | triangles, hairlines, points of one pixel | 0 |
    /// | wide or smooth lines, larger points | half of the width or of the size, rounded up |
    /// | sprites with a size [in pixels](crate::Sprites::in_pixels) that face the viewer, with the anchor inside them | width plus height, times the greatest scale |
    /// | other [sprites](crate::Sprites), [attenuated](crate::PointStyle::attenuated) points | 1; and enlarge `bounds` by their size |
    ///
    /// The rectangle contains everything that a mesh in `bounds` can draw. Before the rectangle is rounded outward,
    /// each of its sides is at most 1/16 pixel outside the box, unless the box is more than 100 times as large as its
    /// distance from the eye. If the near plane of a perspective projection cuts the box, the rectangle is the whole
    /// viewport.
    ///
    /// The viewport may reach beyond the frame, and a canvas may hold only a band of the frame. To keep the part that is
    /// in memory, intersect the rectangle with the canvas's
    /// [`bounding_box`](embedded_graphics::geometry::Dimensions::bounding_box).
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use embedded_graphics::{draw_target::DrawTarget, geometry::Dimensions, primitives::PointsIter};
    /// use fixel::mesh::Bounds;
    /// use fixel::prelude::*;
    ///
    /// static DIAL: Mesh = shape!(torus(fx!(0.1), 32, 6));
    /// static NEEDLE: Mesh = shape!(cuboid(vec3!(0.05, 0.8, 0.05)));
    /// static BOUNDS: Bounds = NEEDLE.bounds();
    /// const SIZE: u32 = 48;
    ///
    /// let view = Projection::perspective(deg!(40), (1, 1), fx!(1), fx!(20))?
    ///     * Camera::look_at(vec3!(0, 0, 4), Vec3::ZERO, Vec3::Y)?;
    /// let needle = |angle| view * Transform::rotate_z(angle);
    /// let white = Flat::new(Gray8::WHITE);
    ///
    /// // The dial is drawn once. The picture starts as a copy of it.
    /// let mut dial = [Gray8::BLACK; (SIZE * SIZE) as usize];
    /// let upright = view * Transform::rotate_x(deg!(90));
    /// Canvas::new(&mut dial, SIZE, SIZE)?.draw(&DIAL, &upright, &Flat::new(Gray8::new(90)));
    /// let mut pixels = dial;
    /// let mut canvas = Canvas::new(&mut pixels, SIZE, SIZE)?;
    /// canvas.draw(&NEEDLE, &needle(deg!(0)), &white);
    ///
    /// // The needle turns: restore the pixels where it was, and draw it where it is.
    /// let screen = canvas.viewport();
    /// let areas = [deg!(0), deg!(20)].map(|angle| screen.rectangle_on_screen(&BOUNDS, &needle(angle), 0));
    /// let before = areas[0].unwrap();
    /// let still = before.points().map(|at| dial[at.y as usize * SIZE as usize + at.x as usize]);
    /// let Ok(()) = canvas.fill_contiguous(&before, still);
    /// canvas.draw(&NEEDLE, &needle(deg!(20)), &white);
    /// // Only these two areas have changed: send them to the display.
    /// assert!(areas.iter().flatten().all(|area| area.size.width * area.size.height < SIZE * SIZE / 4));
    ///
    /// // The same picture, drawn as a whole.
    /// let mut whole = dial;
    /// Canvas::new(&mut whole, SIZE, SIZE)?.draw(&NEEDLE, &needle(deg!(20)), &white);
    /// assert!(canvas.pixels().eq(whole));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn rectangle_on_screen<V: AsMvp>(
        &self,
        bounds: &Bounds,
        mvp: &V,
        reach: u32,
    ) -> Option<Rectangle> {
        let corners = bounds.corners();
        let positions = Positions::long(&corners);
        let [columns, rows] = self.projector(positions, mvp).extent()?;
        let reach = reach.min(Self::MAX).cast_signed();
        let inside = |of: Range<i32>, viewport: Range<i32>| {
            let start = (of.start - reach).max(viewport.start);
            let end = (of.end + reach).min(viewport.end);
            let size = u32::try_from(end - start).unwrap_or_default();
            (start, size)
        };
        let [across, down] = self.pixels();
        let ((x, width), (y, height)) = (inside(columns, across), inside(rows, down));
        if width == 0 || height == 0 {
            return None;
        }
        Some(Rectangle::new(Point::new(x, y), Size::new(width, height)))
    }
}

impl Bounds {
    /// The corners of the box.
    fn corners(&self) -> [Vec3; 8] {
        let (a, b) = (self.least, self.most);
        let mut corners = [a; 8];
        for (at, corner) in corners.iter_mut().enumerate() {
            let pick = |axis: u32, a, b| if at >> axis & 1 == 0 { a } else { b };
            *corner = Vec3::new(pick(0, a.x, b.x), pick(1, a.y, b.y), pick(2, a.z, b.z));
        }
        corners
    }
}

/// Columns and rows of a frame. They may reach beyond it.
type Pixels = [Range<i32>; 2];

impl<K: ProjectionKind> Projector<'_, K> {
    /// The pixels in which triangles may have corners after clipping, if all of their corners are in a box. The eight
    /// positions of this projector are the corners of the box. `None` if there are no such pixels.
    fn extent(&self) -> Option<Pixels> {
        let (mut any, mut all) = (0, !0);
        // The least and the greatest clip coordinates and screen coordinates of the corners.
        let mut clip = [[i64::MAX, i64::MIN]; 3];
        let mut screen = [[i32::MAX, i32::MIN]; 2];
        let mut is_cut = false;
        for corner in 0..8 {
            let position = self.clip_position(corner);
            let outcode = self.outcode(&position);
            any |= outcode;
            all &= outcode;
            // In perspective, the first plane is the near plane. A position in front of it has no place on the screen.
            if K::PERSPECTIVE && outcode & 1 != 0 {
                is_cut = true;
                continue;
            }
            widen(&mut clip, position);
            widen(&mut screen, self.nearest_inside(position));
        }
        if all != 0 {
            return None;
        }
        let margin = if is_cut {
            return Some([-EVERYTHING..EVERYTHING, -EVERYTHING..EVERYTHING]);
        } else if any == 0 {
            1
        } else {
            self.margin(&clip)
        };
        // Positions on the screen are below 2^21, and the margin is at most 2^23.
        Some(screen.map(|[least, most]| (least - margin) >> 8..((most + margin) >> 8) + 1))
    }

    /// Where a position is on the screen or, if it is outside the guard band, the nearest place in the guard band.
    fn nearest_inside(&self, [t, x, y]: [i64; 3]) -> [i32; 2] {
        let mut at = ScreenVertex::UNSET;
        let inside = |x: i64, axis| {
            let w = self.w(t, axis);
            x.clamp(-w, w)
        };
        // Under a parallel projection, t is the depth, which does not matter here.
        let depth_or_w = if K::PERSPECTIVE { t } else { 0 };
        let position = [depth_or_w, inside(x, 1), inside(y, 2)];
        self.project(0, Some(&position), &mut at);
        at.screen
    }

    /// How far outside of the corners' extent on the screen a position may be drawn, in units of 1/256 pixel, if its
    /// triangle is clipped. `clip` is the extent of the corners in clip space, all ahead of the near plane.
    ///
    /// Clip positions are linear in the position, and exact. So without clipping, a position is drawn within the
    /// extent of the corners, except for its own rounding and the rounding of a corner: 1/256 pixel in all.
    ///
    /// Where a plane cuts an edge, the cut is on the edge, except that it is moved onto the plane, and rounded to whole
    /// units. How far it is moved is the error of the fraction (below 2^-28, and two units where distances are halved)
    /// times the sum of the distances of the edge's ends. Let R be the greatest extent of a clip coordinate. Distances
    /// are differences of two coordinates, so a cut is moved by at most e = 2R · 2^-28 + 4. Six planes cut one after
    /// another, each from the cuts of those before, so a corner is within 6e of the box. With w at least m, x / w has an
    /// error of at most 12e / (m − 6e). That is at most 16e / m, or everything counts as visible. In units of 2^-19,
    /// the margin is 2^23 · e / m = (R / 2^4 + 2^25) / m.
    fn margin(&self, clip: &[[i64; 2]; 3]) -> i32 {
        let extent = clip.map(|[least, most]| most.abs_diff(least));
        let [least, _] = clip[0];
        let margin = [1, 2].map(|axis| {
            // m is at least 2^bits.
            let bits = self.w(least, axis).max(1).ilog2();
            let range = extent[0].max(extent[axis]);
            (range >> (bits + 4).min(63)) + ((1 << 25) >> bits)
        });
        // Two units more, because both shifts round down.
        let margin = margin[0].max(margin[1]) + 3;
        margin.min(1 << 23) as i32
    }
}

/// A number of pixels that is more than any viewport has.
const EVERYTHING: i32 = 1 << 15;

/// Enlarges ranges so that they contain some values.
fn widen<T: Copy + Ord, const N: usize>(ranges: &mut [[T; 2]; N], values: [T; N]) {
    for ([least, most], value) in ranges.iter_mut().zip(values) {
        (*least, *most) = ((*least).min(value), (*most).max(value));
    }
}
