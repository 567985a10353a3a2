//! Vertex projection, from model space to the screen: one matrix per draw call, one reciprocal per vertex.

use core::hint::black_box;
use core::marker::PhantomData;
use core::ops::Range;

use crate::math::{AffineRow, Transform, compose};
use crate::mesh::{Bounds, Index, List, Positions, StoredPosition};
use crate::num::block::{self, BlockFloat};
use crate::num::reciprocal;
use crate::num::wide::{self, SHIFTS_LATER, Word, high, product};
use crate::raster::{DepthShift, LEAST_WEIGHT, MOST_WEIGHT, Scissor, ScreenVertex};
use crate::view::{Projection, ProjectionKind, ProjectionRow, Viewport};

/// Half the width and height of the guard band, in pixels. The guard band is the area around the viewport's center in
/// which screen coordinates are exact, and to which triangles are clipped.
const GUARD: i32 = 2048;
/// An exponent, 19: the guard band's half width is 2^19 units of 1/256 pixel.
const GUARD_BITS: u32 = GUARD.trailing_zeros() + 8;

/// A position in clip space: t, then x to the right and y down, in units of the guard band. t is w in perspective, and
/// depth under a parallel projection. Each coordinate is an integer with the fraction bits of its row.
pub(crate) type ClipPosition = [i64; 3];

/// Which coordinate of a [`ClipPosition`] a plane bounds.
const fn axis(plane: u32) -> usize {
    (plane >> 1) as usize
}

/// How many units a clip coordinate may lie beyond a side plane and still count as inside. Rounding may move a point
/// this far if the point was cut from an edge with both ends inside.
const SIDE_TOLERANCE: i64 = 8;

/// The upper half of 64 bits.
#[inline]
const fn upper(value: i64) -> i32 {
    (value >> 32) as i32
}

/// The transform from model space to the screen, computed once per draw call.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projector<'m, K> {
    positions: List<'m>,
    rows: [wide::Row; 3],
    offsets: [i64; 3],
    /// Fraction bits of each clip coordinate. In perspective, the three numbers are equal, because x and y are divided
    /// by w.
    fractions: [u8; 3],
    /// The range of t (see [`ClipPosition`]) between the near and far planes: the least t, negated as in `bound`, and
    /// the greatest t.
    ends: [i64; 2],
    /// The viewport's center, in units of 1/256 pixel.
    center: [i32; 2],
    kind: PhantomData<K>,
}

/// `row` times `unit`, a mantissa with its exponent, and `size`. `size` counts units of 2^-12, because the guard band is
/// 2^12 pixels wide.
#[inline(never)]
fn scaled(row: &ProjectionRow, (m, exp): (i32, i32), size: i32) -> AffineRow {
    let (factor, exp) = BlockFloat::new(product(m, size), exp + 12).rounded();
    // A factor has bit 29 set, so mantissas keep their bits and take at most one more.
    let [x, y, z, offset] = row.m;
    let mut linear = [x, y, z];
    for m in &mut linear {
        *m = ((product(*m, factor) + (1 << 28)) >> 29) as i32;
    }
    AffineRow {
        row: linear,
        exp: row.exp + exp - 29,
        offset: [offset, factor],
        offset_exp: row.offset_exp + exp,
    }
}

/// The greatest number of fraction bits of a coefficient.
const MOST_EXP: i32 = 40;

/// Writes `line`, a row of the transform to clip space, applied after `view`, with as many fraction bits as fit.
/// Returns the number of fraction bits of the clip coordinate.
#[inline(never)]
fn finest_row(line: &AffineRow, view: &Transform, row: &mut [i32; 3], offset: &mut i64) -> u8 {
    let mut linear = [BlockFloat::ZERO; 3];
    let moved = line.after(view, &mut linear);
    // The limits are the same as in perspective: see `Projector::new`.
    let of_offset = moved.finest(60).saturating_sub(16);
    let exp = linear
        .iter()
        .fold(of_offset, |exp, m| exp.min(m.finest(29)));
    let exp = exp.clamp(0, MOST_EXP);
    // If the exponent was clamped to 0, coefficients and offset saturate.
    for (m, number) in row.iter_mut().zip(&linear) {
        *m = number.at(exp).clamp(-(1 << 29), 1 << 29) as i32;
    }
    *offset = moved.at(exp + 16).clamp(-(1 << 60), 1 << 60);
    (exp + 16).cast_unsigned() as u8
}

impl<'m, K: ProjectionKind> Projector<'m, K> {
    /// The transform of `positions` through `view` and `projection` to the pixels of `viewport`.
    pub(crate) fn new(
        positions: Positions<'m>,
        projection: &Projection<K>,
        view: &Transform,
        viewport: &Viewport,
    ) -> Self {
        let (far, (m, exp)) = (projection.far.to_bits(), projection.of_distance);
        // The row that gives t, and the factor by which x and y are multiplied in addition to the viewport's size.
        let (depth, unit) = if K::PERSPECTIVE {
            let depth = AffineRow {
                row: [0, 0, -m],
                exp,
                offset: [0; 2],
                offset_exp: 0,
            };
            (depth, (m, exp))
        } else {
            // Both terms have the same factor, so that the far plane keeps its bits, even if the planes are very close
            // together. The factor is even, because coefficients have 29 bits: if the view does not turn, nothing more
            // is rounded.
            let m = m & !1;
            let depth = AffineRow {
                row: [0, 0, m],
                exp,
                offset: [m, far],
                offset_exp: exp + 16,
            };
            (depth, (1 << 29, 29))
        };
        let [width, height] = [viewport.width, viewport.height].map(u32::cast_signed);
        let [x, y] = &projection.rows;
        let lines = [depth, scaled(x, unit, width), scaled(y, unit, -height)];
        let (mut rows, mut offsets, mut fractions) = ([[0; 3]; 3], [0; 3], [0; 3]);
        if K::PERSPECTIVE {
            // All rows have one exponent, because x and y are divided by t.
            let clip = compose(&lines, view);
            // The finest exponent at which coefficients stay below 2^29 and offsets below 2^60. Positions have 31 bits
            // and a sign, so the sum of three products and an offset stays below 3 · 2^60 + 2^60 = 2^62. Mantissas have
            // 30 bits.
            let exp = (clip.linear_exp - 1)
                .min(clip.translation_exp + 60 - 16 - 30)
                .clamp(0, MOST_EXP);
            let fraction = exp + 16;
            // If the exponent was clamped to 0, coefficients and offsets are treated as smaller than they are.
            let (down, up) = (
                (clip.linear_exp - exp).max(1),
                (fraction - clip.translation_exp).min(30),
            );
            rows = clip.linear;
            for m in rows.as_flattened_mut() {
                *m = ((*m >> (down - 1).min(31)) + 1) >> 1;
            }
            offsets = clip.translation.map(|m| block::shift(m.into(), up));
            fractions = [fraction.cast_unsigned() as u8; 3];
        } else {
            // Each row has its own exponent, because a box may be millions of times as wide as it is deep or high.
            let to = rows.iter_mut().zip(&mut offsets).zip(&mut fractions);
            for (line, ((row, offset), fraction)) in lines.iter().zip(to) {
                *fraction = finest_row(line, view, row, offset);
            }
        }
        // At the near plane, t is 1 + 2^-16, or 1 − 2^-16 under a parallel projection: see above. The near plane is
        // taken to be nearer by 2^-27 of its distance or, under a parallel projection, by 2^-19 of the distance between
        // the planes, because rounding must not move a point that lies exactly in the plane to the outside. (Terms of t
        // have an error of 2^-29 of the greatest term. Under a parallel projection, this term may be a few hundred.)
        let fraction = i32::from(fractions[0]);
        let ends = if K::PERSPECTIVE {
            let least = (1 << 27) + (1 << 11) - 1;
            let most = BlockFloat::new(product(m, far), exp + 16);
            [
                -block::shift(least, fraction - 27),
                most.at(fraction).min(i64::MAX >> 1),
            ]
        } else {
            let most = (1 << 19) - (1 << 3) + 1;
            [0, block::shift(most, fraction - 19)]
        };
        Self {
            positions: positions.list(),
            rows: rows.map(wide::Row::new),
            offsets,
            fractions,
            ends,
            center: viewport.center(),
            kind: PhantomData,
        }
    }

    /// The same transform for other positions.
    pub(super) fn with_positions<'p>(&self, positions: Positions<'p>) -> Projector<'p, K> {
        Projector {
            positions: positions.list(),
            ..*self
        }
    }

    /// The clip position of a position of model space. For an index beyond the positions, which no checked list
    /// contains, the result is the clip position of the origin.
    #[inline]
    pub(super) fn clip_position(&self, index: Index) -> ClipPosition {
        let stored = self.positions.stored(index);
        if !SHIFTS_LATER {
            return wide::Row::add_dots(&self.rows, &stored.to_bits(), self.offsets);
        }
        let dots = |position: [i32; 3]| wide::Row::add_dots(&self.rows, &position, [0; 3]);
        let [t, x, y] = match stored {
            StoredPosition::Short { position, up } => {
                dots(position.map(i32::from)).map(|dot| wide::up(dot, up))
            }
            StoredPosition::Long(position) => dots(position.to_bits()),
        };
        let [ot, ox, oy] = self.offsets;
        [ot + t, ox + x, oy + y]
    }

    /// The homogeneous coordinate with the fraction bits of x or y: w in perspective, 1 under a parallel projection.
    #[inline]
    pub(super) fn w(&self, t: i64, axis: usize) -> i64 {
        if K::PERSPECTIVE {
            t
        } else {
            1 << self.fractions.get(axis).map_or(0, |bits| bits & 63)
        }
    }

    /// The bound of a coordinate at a plane. A plane with an even number bounds the coordinate from below, and the
    /// bound is negated. A plane with an odd number bounds the coordinate from above. Planes 0 and 1 bound t (near and
    /// far or, under a parallel projection, far and near), planes 2 and 3 bound x (left and right), and planes 4 and 5
    /// bound y (top and bottom).
    #[inline]
    fn bound(&self, t: i64, plane: u32) -> i64 {
        let end = self.ends.get(plane as usize).copied();
        end.unwrap_or(self.w(t, axis(plane)))
    }

    /// How far inside a plane a position lies; negative outside.
    #[inline(never)]
    pub(super) fn distance(&self, position: &ClipPosition, plane: u32) -> i64 {
        let [t, ..] = *position;
        let value = position.get(axis(plane)).copied().unwrap_or_default();
        let bound = self.bound(t, plane);
        // All values are below 2^62.
        if plane & 1 == 0 {
            bound + value
        } else {
            bound - value
        }
    }

    /// Moves a position, where `plane` cuts an edge, exactly onto the plane.
    #[inline]
    pub(super) fn put_onto(&self, position: &mut ClipPosition, plane: u32) {
        let bound = self.bound(position[0], plane);
        if let Some(value) = position.get_mut(axis(plane)) {
            *value = if plane & 1 == 0 { -bound } else { bound };
        }
    }

    /// Whether a position counts as outside of a plane.
    #[inline(never)]
    pub(super) fn is_outside(&self, position: &ClipPosition, plane: u32) -> bool {
        let tolerance = if plane < 2 { 0 } else { SIDE_TOLERANCE };
        self.distance(position, plane) + tolerance < 0
    }

    /// One bit for each plane outside of which a position lies.
    #[inline]
    pub(super) fn outcode(&self, position: &ClipPosition) -> u8 {
        let &[t, x, y] = position;
        // t, x and y are below 2^62.
        let [nearest, farthest] = self.ends;
        // The upper halves decide, unless the position is next to a side plane.
        let size = |x: i64| upper(x) ^ (upper(x) >> 31);
        let ends = (t + nearest) | (farthest - t);
        let is_inside = if K::PERSPECTIVE {
            ends >= 0 && size(x).max(size(y)) < upper(t)
        } else {
            let [of_x, of_y] = [1, 2].map(|axis| upper(self.w(t, axis)));
            ends >= 0 && size(x) < of_x && size(y) < of_y
        };
        if is_inside {
            0
        } else {
            self.each_outcode(*position)
        }
    }

    /// The [`outcode`](Self::outcode), computed plane by plane.
    ///
    /// Out of line, because it is long and few vertices of visible triangles need it. The position is passed by value,
    /// so that the caller's position stays in registers.
    #[inline(never)]
    fn each_outcode(&self, position: ClipPosition) -> u8 {
        if cfg!(for_size) {
            return (0..6).fold(0, |outcode, plane| {
                outcode | u8::from(self.is_outside(&position, plane)) << plane
            });
        }
        // A loop would choose the coordinate and the bound of each plane. (If the compiler knew that only `ends` are
        // read, it would pass these and not `self`, in registers that the caller needs.)
        let [nearest, farthest] = black_box(self).ends;
        let [t, x, y] = position;
        let [w_x, w_y] = [1, 2].map(|axis| self.w(t, axis) + SIDE_TOLERANCE);
        let bit = |distance: i64, plane: u32| (upper(distance).cast_unsigned() >> 31) << plane;
        let outcode = bit(nearest + t, 0)
            | bit(farthest - t, 1)
            | bit(w_x + x, 2)
            | bit(w_x - x, 3)
            | bit(w_y + y, 4)
            | bit(w_y - y, 5);
        outcode as u8
    }

    /// Projects a position to the screen: `inside` if it is given, otherwise the position at `index`. `inside` is a
    /// position of clip space that is inside all planes, such as a corner of a clipped polygon.
    ///
    /// Out of line, with an out-parameter: callers stay short, and the vertex is not copied.
    #[inline(never)]
    pub(crate) fn project(
        &self,
        index: Index,
        inside: Option<&ClipPosition>,
        to: &mut ScreenVertex,
    ) {
        // Copied, because the compiler keeps a position in memory if it is sometimes behind a reference.
        let position = if let Some(position) = inside {
            *position
        } else {
            let position = self.clip_position(index);
            let outcode = self.outcode(&position);
            if outcode != 0 {
                *to = ScreenVertex {
                    outcode,
                    index,
                    ..ScreenVertex::UNSET
                };
                return;
            }
            position
        };
        let (screen, q, exponent) = if K::PERSPECTIVE {
            // t is positive and below 2^62. Let t' = t · 2^up / 2^33, which has 31 bits, r = 2^61 / t' and
            // x' = x · 2^up / 2^34. Then x / t = x' · r / 2^60.
            //
            // Inside all planes, t has at least 16 bits. So its upper half is not zero, after a shift by 30 if need
            // be, and everything that follows needs only 32 bits.
            let ([mut t, mut x, mut y], mut coarse) = (position, 0);
            if upper(t) == 0 {
                (t, x, y) = (t << 30, x << 30, y << 30);
                coarse = 30;
            }
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
                r.cast_unsigned().min(MOST_WEIGHT),
                (up + coarse) as u8,
            )
        } else {
            // Inside all planes, a coordinate is at most 1, apart from rounding, so 61 fraction bits fit. A coordinate
            // has at most 56 fraction bits.
            let ([t, x, y], [of_t, of_x, of_y]) = (position, self.fractions);
            let raised = |x: i64, of_x| x << (61_u8.wrapping_sub(of_x) & 63);
            let on_screen = |x, of_x| {
                ((raised(x, of_x) + (1 << (60 - GUARD_BITS))) >> (61 - GUARD_BITS)) as i32
            };
            let q = ((raised(t, of_t) + (1 << 29)) >> 30).cast_unsigned() as u32;
            let q = q.clamp(LEAST_WEIGHT, MOST_WEIGHT);
            ([on_screen(x, of_x), on_screen(y, of_y)], q, 0)
        };
        let [cx, cy] = self.center;
        // A position that is inside only by the tolerance may lie slightly beyond the guard band. (Written without
        // `map`, because `map` stays a loop in a build for size.)
        let clamped = |x: i32| x.clamp(-(1 << GUARD_BITS), (1 << GUARD_BITS) - 1);
        let [x, y] = screen;
        *to = ScreenVertex {
            screen: [clamped(x) + cx, clamped(y) + cy],
            q,
            exponent,
            outcode: 0,
            index,
        };
    }

    /// Whether a box is certain to have no point in the scissor, nor within a pixel of it. The scissor may extend
    /// beyond the viewport by half the width of a line.
    #[inline(never)]
    pub(super) fn misses(&self, bounds: &Bounds, scissor: &Scissor) -> bool {
        let (least, most) = (bounds.least.to_bits(), bounds.most.to_bits());
        if !cfg!(for_size) && self.shows_middle(&least, &most, scissor) {
            return false;
        }
        // A plane's coefficients are rounded down twice, by up to half a unit each time, and multiplied by a corner's
        // coordinate. The plane's offset is rounded by up to one unit before it is multiplied by at most 2^19.
        // `is_outside` halves coefficients and offset.
        let mut error: i64 = 1 << 19;
        for (least, most) in least.iter().zip(&most) {
            error += i64::from(least.unsigned_abs().max(most.unsigned_abs()));
        }
        // Whether even the corner that lies farthest toward the inside of a plane is outside the plane. Coefficients
        // take 30 bits, so the sum takes 63 bits.
        let is_outside = |plane: [i32; 3], offset: i64| {
            let mut farthest = (offset >> 1) + error;
            for (c, (&least, &most)) in plane.iter().zip(least.iter().zip(&most)) {
                let c = c >> 1;
                farthest += product(c, if c < 0 { least } else { most });
            }
            farthest < 0
        };
        let [t, x, y] = &self.rows.map(|row| row.whole());
        let [t_offset, x_offset, y_offset] = self.offsets;
        let [nearest, farthest] = self.ends;
        if is_outside(*t, t_offset + nearest) || is_outside(t.map(|c| -c), farthest - t_offset) {
            return true;
        }
        let w = if K::PERSPECTIVE { *t } else { [0; 3] };
        let [cx, cy] = self.center;
        let sides = [
            (x, [x_offset, self.w(t_offset, 1)], cx, &scissor.columns),
            (y, [y_offset, self.w(t_offset, 2)], cy, &scissor.rows),
        ];
        sides.into_iter().any(|(row, offsets, center, pixels)| {
            let [offset, w_offset] = offsets;
            // The ends of the scissor are at most half a viewport plus 33 pixels from the viewport's center. `end` is
            // in units of 2^-19 of the guard band.
            [(pixels.start - 1, 1), (pixels.end + 1, -1)]
                .into_iter()
                .any(|(end, sign)| {
                    let end = (end << 8) - center;
                    let mut plane = [0; 3];
                    for (c, (&row, &w)) in plane.iter_mut().zip(row.iter().zip(&w)) {
                        *c = sign * (row - (product(w, end) >> GUARD_BITS) as i32);
                    }
                    let offset = offset - (w_offset >> GUARD_BITS) * i64::from(end);
                    is_outside(plane, i64::from(sign) * offset)
                })
        })
    }

    /// Whether the middle of a box is certain to be in the scissor. Most boxes in view need no other test.
    #[inline]
    fn shows_middle(&self, least: &[i32; 3], most: &[i32; 3], scissor: &Scissor) -> bool {
        let middle = [0, 1, 2].map(|axis| {
            let (least, most) = (least[axis], most[axis]);
            let half = most.wrapping_sub(least).cast_unsigned() >> 1;
            least.wrapping_add(half.cast_signed())
        });
        let [t, x, y] = wide::Row::add_dots(&self.rows, &middle, self.offsets);
        let [nearest, farthest] = self.ends;
        let is_between = |x: i64, w: i64, pixels: &Range<i32>, center: i32| {
            // An eighth of the upper half of x, and of the ends times w. Rounding takes less than 2. The scissor's ends are
            // at most 6177 pixels from the viewport's center.
            let x = Word::from(upper(x) >> 3);
            let end = |at: i32| high(upper(w).into(), Word::from((at << 8) - center) << 10);
            end(pixels.start) + 2 <= x && x + 2 <= end(pixels.end)
        };
        let [cx, cy] = self.center;
        (t + nearest) | (farthest - t) >= 0
            && is_between(x, self.w(t, 1), &scissor.columns, cx)
            && is_between(y, self.w(t, 2), &scissor.rows, cy)
    }

    /// The right shift that turns an interpolant of exponent 0 into a depth, where 2^16 is the near plane.
    #[inline]
    pub(crate) fn depth_shift(&self) -> DepthShift {
        DepthShift(if K::PERSPECTIVE {
            // 1/t = q · 2^(exponent + fraction − 94), and the depth is 2^16 / t.
            78 - i32::from(self.fractions[0])
        } else {
            // All exponents are 0.
            15
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use crate::view::Window;
    use crate::{Angle, Mesh, Scalar, Vec3, fx};
    use rand::Rng;

    /// A mantissa of a scaled row is rounded once, to nearest.
    #[test]
    fn scaled_rows_are_nearest() {
        cases(2000, |random| {
            let unit = BlockFloat::new(random.random_range(1..1 << 40), random.random_range(0..40));
            let unit = unit.rounded();
            let size = random.random_range(1..4096);
            let row = ProjectionRow {
                m: [(); 4].map(|()| random.random_range(-(1 << 30) + 1..1 << 30)),
                exp: random.random_range(-20..60),
                offset_exp: random.random_range(-20..60),
            };
            let (factor, _) = BlockFloat::new(product(unit.0, size), 0).rounded();
            let AffineRow { row: linear, .. } = scaled(&row, unit, size);
            for (m, linear) in row.m.into_iter().zip(linear) {
                let off = product(m, factor) - (i64::from(linear) << 29);
                assert!(off.abs() <= 1 << 28, "{m} · {factor}: {linear}");
            }
        });
    }

    /// Tests positions just inside and just outside of each plane.
    #[test]
    fn outcodes_change_at_each_plane() {
        let fov = Angle::from_degrees(60);
        let projection = Projection::perspective(fov, (320, 240), fx!(1), fx!(100)).unwrap();
        let mesh = Mesh::new(&[], &[]).unwrap();
        let viewport = Viewport::new(0, 0, 320, 240).unwrap();
        let view = Transform::IDENTITY;
        let projector = Projector::new(mesh.positions(), &projection, &view, &viewport);
        let [near, far] = projector.ends;
        let near = -near;
        let t = 2 * near;
        for (plane, inside, outside) in [
            (0, [near, 0, 0], [near - 1, 0, 0]),
            (1, [far, 0, 0], [far + 1, 0, 0]),
            (2, [t, -t - 8, 0], [t, -t - 9, 0]),
            (3, [t, t + 8, 0], [t, t + 9, 0]),
            (4, [t, 0, -t - 8], [t, 0, -t - 9]),
            (5, [t, 0, t + 8], [t, 0, t + 9]),
        ] {
            assert_eq!(projector.outcode(&inside), 0);
            assert_eq!(projector.outcode(&outside), 1 << plane);
        }
    }

    /// Positions in the near plane are visible and have the greatest depth, or one step less, however their coordinates
    /// are split between mesh and transform. Positions in front of the near plane are not visible.
    #[test]
    fn what_lies_in_the_near_plane_is_visible() {
        fn check<K: ProjectionKind>(projection: &Projection<K>, [x, y, split]: [Scalar; 3]) {
            let near = projection.near();
            let viewport = Viewport::new(0, 0, 320, 240).unwrap();
            let view = Transform::translate(Vec3::new(-x, -y, -near - split));
            let closer = projection.far() / 65_536 + Scalar::DELTA;
            let positions = [split, split + closer].map(|z| Vec3::new(x, y, z));
            let mesh = Mesh::new(&positions, &[]).unwrap();
            let projector = Projector::new(mesh.positions(), projection, &view, &viewport);
            let [inside, outside] = [0, 1].map(|index| {
                let mut vertex = ScreenVertex::UNSET;
                projector.project(index, None, &mut vertex);
                vertex
            });
            assert_eq!(inside.outcode, 0, "{projection:?} {positions:?}");
            let shift = projector.depth_shift().right_shift(inside.exponent);
            let depth = inside.q >> shift;
            assert!(
                (65_534..=65_535).contains(&depth),
                "{depth}: {projection:?} {positions:?}"
            );
            assert_ne!(outside.outcode, 0, "{projection:?} {positions:?}");
        }
        cases(1 << 12, |random| {
            let near = Scalar::from_bits(random.random_range(1 << 14..200 << 16));
            let far = near + Scalar::from_bits(random.random_range(1 << 16..200 << 16));
            let mut coordinate = || Scalar::from_bits(random.random_range(-64 << 16..64 << 16));
            let place = [coordinate(), coordinate(), coordinate()];
            let (angle, window) = (Angle::from_degrees(60), Window::centered(fx!(12), fx!(9)));
            // The near plane is exact to 2^-27 of its distance, so coordinates are no greater than this distance.
            let [x, y, split] = place.map(|at| at / 64);
            check(
                &Projection::perspective(angle, (4, 3), near, far).unwrap(),
                [x * near, y * near, split * near],
            );
            check(
                &Projection::oblique(angle, fx!(0.5), near, window, near, far).unwrap(),
                place,
            );
        });
    }

    /// The middle of a box counts as shown only if it is projected into the scissor; and of the middles that are, most
    /// count.
    #[test]
    fn a_middle_that_is_shown_is_in_the_scissor() {
        fn check<K: ProjectionKind>(
            projection: &Projection<K>,
            viewport: &Viewport,
            [a, b]: [Vec3; 2],
            counts: &mut [u32; 2],
        ) {
            let box_of_mesh = Bounds::new(a, b);
            let (least, most) = (box_of_mesh.least.to_bits(), box_of_mesh.most.to_bits());
            let middle = [0, 1, 2].map(|axis| {
                let sum = i64::from(least[axis]) + i64::from(most[axis]);
                (sum >> 1) as i32
            });
            let middle = [Vec3::from_bits(middle)];
            let mesh = Mesh::new(&middle, &[]).unwrap();
            let view = Transform::IDENTITY;
            let projector = Projector::new(mesh.positions(), projection, &view, viewport);
            let scissor = Scissor::new(viewport, 320, &(0..240));
            let mut at = ScreenVertex::UNSET;
            projector.project(0, None, &mut at);
            let [x, y] = at.screen.map(|at| at >> 8);
            let is_in =
                at.outcode == 0 && scissor.columns.contains(&x) && scissor.rows.contains(&y);
            let is_shown = projector.shows_middle(&least, &most, &scissor);
            assert!(
                is_in || !is_shown,
                "{projection:?} {viewport:?} {a:?} {b:?}"
            );
            counts[0] += u32::from(is_in);
            counts[1] += u32::from(is_shown);
        }
        let mut counts = [0; 2];
        cases(1 << 14, |random| {
            let near = Scalar::from_bits(random.random_range(1 << 14..4 << 16));
            let far = near + Scalar::from_bits(random.random_range(1 << 16..200 << 16));
            let side = |random: &mut crate::random::Random| random.random_range(1..400);
            let (x, y) = (
                random.random_range(-300..320),
                random.random_range(-300..240),
            );
            let viewport = Viewport::new(x, y, side(random), side(random)).unwrap();
            let cut = random.random_range(0..16);
            let corners = [(); 2].map(|()| {
                let [x, y, z] = random.random::<[i32; 3]>().map(|at| at >> (cut + 1));
                Vec3::from_bits([x, y, z])
            });
            let fov = Angle::from_degrees(random.random_range(5..120));
            let perspective = Projection::perspective(fov, (4, 3), near, far).unwrap();
            check(&perspective, &viewport, corners, &mut counts);
            let window = Window::centered(fx!(200), fx!(150));
            let parallel = Projection::orthographic(window, near, far).unwrap();
            check(&parallel, &viewport, corners, &mut counts);
        });
        let [inside, shown] = counts;
        assert!(inside > 500 && shown > inside / 2, "{shown} of {inside}");
    }
}
