//! From model space to the screen: one matrix per draw call, one reciprocal per vertex.

use core::marker::PhantomData;

use crate::Scalar;
use crate::math::{AffineRow, Transform, compose};
use crate::mesh::{Index, Place, Positions};
use crate::num::block::{self, BlockFloat};
use crate::num::reciprocal;
use crate::num::wide::{PREFERS_SHORT, dot, product, short_dot};
use crate::raster::{DepthShift, ScreenVertex};
use crate::view::{Projection, ProjectionKind, Row, Viewport};

/// Half the width and height of the guard band, in pixels: the room about the viewport's center in
/// which screen coordinates are exact, and to which triangles are clipped.
const GUARD: i32 = 2048;
/// The guard band's half width, 2^19 units of 1/256 pixel.
const GUARD_BITS: u32 = GUARD.trailing_zeros() + 8;

/// A position in clip space: x and y to the right and down in units of the guard band, and t, which
/// is w under a perspective and depth under a parallel projection. All three times 2^`fraction`.
pub(crate) type ClipPosition = [i64; 3];

/// How many units a clip coordinate may be beyond a side plane and count as inside: what rounding
/// may take a point that was cut from an edge with both ends inside.
const SIDE_TOLERANCE: i64 = 8;

/// The upper half.
#[inline]
const fn upper(value: i64) -> i32 {
    (value >> 32) as i32
}

/// The way from model space to the screen, made once for a draw call.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projector<'m, K> {
    positions: Positions<'m>,
    rows: [[i32; 3]; 3],
    offsets: [i64; 3],
    /// Fraction bits of clip coordinates.
    fraction: i32,
    /// The least t inside, and how much above it the greatest is.
    least: i64,
    depth: u64,
    /// The viewport's center, in units of 1/256 pixel.
    center: [i32; 2],
    kind: PhantomData<K>,
}

/// `row` times `unit` and `size`, in units of 2^-12 as sizes are in parts of the guard band.
fn scaled(row: &Row, unit: BlockFloat, size: i32) -> AffineRow {
    let factor = unit.times(BlockFloat::new(size.into(), 12));
    let (factor, exp) = factor.rounded();
    let exp = row.exp + exp;
    let [x, y, z, offset] = row
        .m
        .map(|m| BlockFloat::new(i64::from(m) * i64::from(factor), exp));
    let mut mantissas = [0; 3];
    let exp = block::normalize(&mut mantissas, &[x, y, z]);
    AffineRow {
        row: mantissas,
        exp,
        offset,
    }
}

impl<'m, K: ProjectionKind> Projector<'m, K> {
    /// The way of `positions` through `view` and `projection` to the pixels of `viewport`.
    pub(crate) fn new(
        positions: Positions<'m>,
        projection: &Projection<K>,
        view: &Transform,
        viewport: &Viewport,
    ) -> Self {
        let [near, far] = [projection.near, projection.far].map(Scalar::to_bits);
        // The row of t and what it is multiplied with, and what x and y are beside the viewport's scale.
        let (depth, depth_unit, unit) = if K::PERSPECTIVE {
            // t = w / near, a little above 1 at the near plane: the greatest 1/t, 1 - 2^-16, leaves
            // room for rounding before a depth of 65536.
            let one = BlockFloat::new((1 << 16) + 1, 0).over(BlockFloat::new(near.into(), 0));
            let toward = Row {
                m: [0, 0, -(1 << 29), 0],
                exp: 29,
            };
            (toward, one, one)
        } else {
            // t = (far - distance) / (far - near), a little below 1 at the near plane. The row is the
            // dividend alone: in it the far plane keeps its bits whatever the length between them.
            let length = i64::from(far) - i64::from(near);
            let exp = 14
                + far
                    .unsigned_abs()
                    .leading_zeros()
                    .clamp(1, 15)
                    .cast_signed();
            let toward = Row {
                m: [0, 0, 1 << exp, block::shift(far.into(), exp - 16) as i32],
                exp,
            };
            let part = BlockFloat::new((1 << 16) - 1, 0).over(BlockFloat::new(length, 0));
            (toward, part, BlockFloat::new(1, 0))
        };
        let [width, height] = viewport.size().map(u32::cast_signed);
        let [x, y] = &projection.rows;
        let lines = [
            (x, unit, width),
            (y, unit, -height),
            (&depth, depth_unit, 1 << 12),
        ]
        .map(|(row, unit, size)| scaled(row, unit, size));
        let clip = compose(&lines, view);

        // The finest exponent at which coefficients keep below 2^29 and offsets below 2^60. With
        // coordinates of 31 bits a sum stays below 3 · 2^60 + 2^60 = 2^62. Mantissas have 30 bits.
        let exp = (clip.linear_exp - 1)
            .min(clip.translation_exp + 60 - 16 - 30)
            .clamp(0, 40);
        let fraction = exp + 16;
        // Where the exponent would have been below 0, they are taken for smaller than they are.
        let (down, up) = (
            (clip.linear_exp - exp).max(1),
            (fraction - clip.translation_exp).min(30),
        );
        let one = 1i64 << fraction;
        let margin = (one >> 16).max(1);
        let [least, most] = if K::PERSPECTIVE {
            let most = unit.times(BlockFloat::new(far.into(), 16));
            [one + margin, most.at(fraction).min(i64::MAX >> 1)]
        } else {
            [0, one - margin]
        };
        Self {
            positions,
            rows: clip
                .linear
                .map(|row| row.map(|m| ((m >> (down - 1).min(31)) + 1) >> 1)),
            offsets: clip.translation.map(|m| block::shift(m.into(), up)),
            fraction,
            least,
            depth: (most - least).max(0).cast_unsigned(),
            center: viewport.center(),
            kind: PhantomData,
        }
    }

    /// A position of model space in clip space; the origin's for an index that no checked list holds.
    #[inline]
    pub(super) fn clip_position(&self, index: Index) -> ClipPosition {
        let place = self.positions.place(index);
        match place {
            Place::Short { position, up } if PREFERS_SHORT => {
                self.short_clip_position(position, up)
            }
            _ => {
                let position = place.to_bits();
                let ([x, y, t], [ox, oy, ot]) = (&self.rows, self.offsets);
                [
                    ox + dot(x, &position),
                    oy + dot(y, &position),
                    ot + dot(t, &position),
                ]
            }
        }
    }

    /// The same of a short position, where products of 16 bits are the faster ones.
    #[inline(never)]
    fn short_clip_position(&self, position: [i16; 3], up: u32) -> ClipPosition {
        let ([x, y, t], [ox, oy, ot]) = (&self.rows, self.offsets);
        [
            ox + short_dot(x, position, up),
            oy + short_dot(y, position, up),
            ot + short_dot(t, position, up),
        ]
    }

    /// The homogeneous coordinate: w, or 1 under a parallel projection.
    #[inline]
    fn w(&self, t: i64) -> i64 {
        if K::PERSPECTIVE {
            t
        } else {
            1 << self.fraction
        }
    }

    /// The bound of a coordinate at each of the planes 0 to 5: near or far, far or near, left, right,
    /// top, bottom. The first two bound t, the next x, the last y.
    #[inline]
    fn bound(&self, t: i64, plane: u32) -> i64 {
        match plane {
            0 => self.least,
            1 => self.least + self.depth.cast_signed(),
            _ if plane & 1 == 0 => -self.w(t),
            _ => self.w(t),
        }
    }

    /// How far inside a plane a position is.
    #[inline(never)]
    pub(super) fn distance(&self, position: &ClipPosition, plane: u32) -> i64 {
        let [x, y, t] = *position;
        let value = match plane >> 1 {
            0 => t,
            1 => x,
            _ => y,
        };
        let distance = value - self.bound(t, plane);
        // All are below 2^62.
        if plane & 1 == 0 { distance } else { -distance }
    }

    /// Puts a position on an edge that `plane` cuts onto the plane.
    #[inline]
    pub(super) fn put_onto(&self, [x, y, t]: &mut ClipPosition, plane: u32) {
        let bound = self.bound(*t, plane);
        *match plane >> 1 {
            0 => t,
            1 => x,
            _ => y,
        } = bound;
    }

    /// Whether a distance from a plane counts as outside.
    #[inline]
    pub(super) const fn is_outside(distance: i64, plane: u32) -> bool {
        distance < if plane < 2 { 0 } else { -SIDE_TOLERANCE }
    }

    /// Whether a position is inside all planes, as [`outcode`](Self::outcode) decides it.
    #[inline]
    fn is_inside(&self, &[x, y, t]: &ClipPosition) -> bool {
        let ahead = t.wrapping_sub(self.least).cast_unsigned() <= self.depth;
        let w = self.w(t);
        // The upper halves suffice for all but what is next to a side plane.
        let size = |x: i64| upper(x) ^ (upper(x) >> 31);
        ahead
            && (size(x).max(size(y)) < upper(w)
                || x.unsigned_abs().max(y.unsigned_abs()) <= (w + SIDE_TOLERANCE).cast_unsigned())
    }

    /// A bit for each plane that a position is outside of.
    ///
    /// A call, as it takes long; few vertices of what is to be seen need it.
    #[inline(never)]
    fn outcode(&self, position: &ClipPosition) -> u8 {
        (0..6).fold(0, |outcode, plane| {
            let is_outside = Self::is_outside(self.distance(position, plane), plane);
            outcode | u8::from(is_outside) << plane
        })
    }

    /// Finds one of the positions on the screen.
    #[inline]
    pub(crate) fn project(&self, index: Index, to: &mut ScreenVertex) {
        self.place(index, None, to);
    }

    /// Finds a position of clip space that is inside on the screen, such as a corner of a clipped polygon.
    #[inline]
    pub(super) fn project_inside(&self, position: &ClipPosition, to: &mut ScreenVertex) {
        self.place(0, Some(position), to);
    }

    /// The one or the other.
    ///
    /// A call, and one that writes where it is told to: what asks for a vertex is short, and the vertex not copied.
    #[inline(never)]
    fn place(&self, index: Index, inside: Option<&ClipPosition>, to: &mut ScreenVertex) {
        let position = if let Some(position) = inside {
            *position
        } else {
            if PREFERS_SHORT && self.positions.are_short() {
                return self.place_short(index, to);
            }
            let position = self.clip_position(index);
            if !self.is_inside(&position) {
                *to = self.placed_outside(index, &position);
                return;
            }
            position
        };
        let (screen, q, exponent) = if K::PERSPECTIVE {
            // t is positive and below 2^62. With t' = t · 2^up / 2^33 of 31 bits and x' half so
            // large, x / t = x' · r / 2^60.
            //
            // What is inside has 16 bits of t at least, so that its upper half, shifted by 30 if
            // need be, is not zero: all that follows is of 32 bits.
            let (mut position, mut coarse) = (position, 0);
            if upper(position[2]) == 0 {
                position = position.map(|x| x << 30);
                coarse = 30;
            }
            let [x, y, t] = position;
            let up = upper(t).leading_zeros();
            let shifted = |x: i64, up: u32| {
                let lower = x.cast_unsigned() as u32;
                upper(x) << up | (lower >> 1 >> (31 - up)).cast_signed()
            };
            let r = reciprocal(shifted(t, up & 31).cast_unsigned() >> 1).cast_signed();
            let on_screen = |x: i64| {
                let product = product(shifted(x, up.wrapping_sub(2) & 31), r);
                ((product + (1 << (59 - GUARD_BITS))) >> (60 - GUARD_BITS)) as i32
            };
            (
                [on_screen(x), on_screen(y)],
                r.cast_unsigned(),
                (up + coarse) as u8,
            )
        } else {
            let [x, y, t] = position;
            let down = GUARD_BITS.cast_signed() - self.fraction;
            let on_screen = |x: i64| block::shift(x, down) as i32;
            let q = block::shift(t, 31 - self.fraction);
            ([on_screen(x), on_screen(y)], q.cast_unsigned() as u32, 0)
        };
        let [cx, cy] = self.center;
        // What is inside by the tolerance alone may be a little beyond the guard band.
        let [x, y] = screen.map(|x| x.clamp(-(1 << GUARD_BITS), (1 << GUARD_BITS) - 1));
        *to = ScreenVertex {
            screen: [x + cx, y + cy],
            q,
            exponent,
            outcode: 0,
            index,
        };
    }

    /// A short position on the screen, apart from the others so that it takes no registers from them.
    #[inline(never)]
    fn place_short(&self, index: Index, to: &mut ScreenVertex) {
        let position = self.clip_position(index);
        if self.is_inside(&position) {
            self.place(index, Some(&position), to);
        } else {
            *to = self.placed_outside(index, &position);
        }
    }

    #[inline]
    fn placed_outside(&self, index: Index, position: &ClipPosition) -> ScreenVertex {
        ScreenVertex {
            outcode: self.outcode(position),
            index,
            ..ScreenVertex::NONE
        }
    }

    /// An interpolant is shifted down by this less its exponent to be a depth, 2^16 at the near plane.
    #[inline]
    pub(crate) fn depth_shift(&self) -> DepthShift {
        DepthShift(if K::PERSPECTIVE {
            // 1/t = q · 2^(exponent + fraction - 94), and depth is 2^16 times that.
            78 - self.fraction
        } else {
            // Exponents are 0.
            15
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Window;
    use crate::{Angle, Mesh, fx, vec3};

    /// What cores that prefer short products do with short positions, against what others do.
    fn alike<K: ProjectionKind>(projection: &Projection<K>) {
        let ends = [i16::MIN, -12_345, -1, 0, 1, 777, i16::MAX];
        let turn = Transform::rotate(vec3!(1, 2, 3), Angle::from_degrees(50)).unwrap();
        let view = Transform::translate(vec3!(0, 0, -40)) * turn;
        let viewport = Viewport::new(3, 5, 320, 240).unwrap();
        let (mut inside, mut outside) = (0, 0);
        for fraction in [0, 3, 10, 16] {
            for x in ends {
                let positions = ends.map(|y| [x, y, y.wrapping_mul(7) >> 1]);
                let mesh = Mesh::short(&positions, fraction, &[]).unwrap();
                let projector = Projector::new(mesh.positions(), projection, &view, &viewport);
                for index in 0..7 {
                    let Place::Short { position, up } = mesh.positions().place(index) else {
                        panic!("a long position");
                    };
                    let short = projector.short_clip_position(position, up);
                    assert_eq!(short, projector.clip_position(index));

                    let [mut short, mut wide] = [ScreenVertex::NONE; 2];
                    projector.place_short(index, &mut short);
                    projector.project(index, &mut wide);
                    let fields = |v: ScreenVertex| (v.screen, v.q, v.exponent, v.outcode);
                    assert_eq!(fields(short), fields(wide));
                    // What clipping makes is inside, and has no index.
                    *(if wide.outcode == 0 {
                        &mut inside
                    } else {
                        &mut outside
                    }) += 1;
                }
            }
        }
        assert!(
            inside > 20 && outside > 20,
            "{inside} inside, {outside} outside"
        );
    }

    #[test]
    fn short_positions_in_perspective() {
        let fov = Angle::from_degrees(60);
        alike(&Projection::perspective(fov, (320, 240), fx!(1), fx!(100)).unwrap());
    }

    #[test]
    fn short_positions_in_parallel() {
        let window = Window {
            left: fx!(-20),
            right: fx!(20),
            bottom: fx!(-15),
            top: fx!(15),
        };
        alike(&Projection::orthographic(window, fx!(1), fx!(100)).unwrap());
    }
}
