//! The plane equation of an interpolant, kept as a numerator over a common denominator.

use crate::num::reciprocal;
use crate::num::wide::{product, shifted, short_difference, times_short, upper};

/// An interpolant over a triangle: its value at every pixel center, to within one unit.
///
/// If the triangle is [near](Basis::is_near), which means small and not a sliver, the value is `start` plus a number
/// of steps. In other triangles, the steps would accumulate too much rounding, and the value is a quotient. Its
/// numerator is linear over the screen; its denominator is twice the triangle's area, scaled to 32 bits. The
/// numerators are scaled by the same factor, so they take 63 bits. Their arithmetic wraps: the result within the
/// triangle is in range, and modulo 2⁶⁴ intermediate values do not matter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gradient {
    /// Change from one column to the next, rounded to the nearest unit.
    pub(crate) step: i32,
    /// Change from one row to the next, rounded to the nearest unit; near triangles only.
    row: i32,
    /// Value at the center of the pixel that contains corner 0; near triangles only.
    start: i32,
    /// Numerator at the center of that pixel, and its change per column and per row; other triangles, and `precise`.
    numerator: i64,
    dx: i64,
    dy: i64,
}

impl Gradient {
    /// Nothing to interpolate.
    pub(crate) const NONE: Self = Self {
        step: 0,
        row: 0,
        start: 0,
        numerator: 0,
        dx: 0,
        dy: 0,
    };

    /// The value `x` columns and `y` rows from the pixel that contains corner 0; near triangles only.
    #[inline]
    pub(crate) const fn near(&self, x: i32, y: i32) -> i32 {
        let moved = self.step.wrapping_mul(x);
        moved
            .wrapping_add(self.row.wrapping_mul(y))
            .wrapping_add(self.start)
    }
}

/// The data that all interpolants of a triangle share: its sides and its area.
///
/// Positions are in units of 1/256 pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Basis {
    /// From corner 0 to corners 1 and 2.
    sides: [[i32; 2]; 2],
    /// From corner 0 to the center of the pixel that contains it.
    to_center: [i32; 2],
    /// Scale of the numerators: they are multiplied by `up`, 2^0 to 2^31, and then shifted right by `down`.
    up: u32,
    down: u32,
    /// Left shift of a near triangle's numerators, 8 to 31, since a pixel is 256 units. 0 for other triangles.
    near: u32,
    /// Twice the area in 32 bits, with the top bit set, and its reciprocal, 2⁶² / area.
    ///
    /// The reciprocal ignores the area's last bit. The same relative error scales all interpolants of a triangle and
    /// cancels in their quotients.
    area: u32,
    inverse: i32,
}

/// Limit for the columns plus the rows of a near triangle: half a unit of rounding for each comes to 32 units.
const NEAR: i32 = 64;

impl Basis {
    /// Nothing to interpolate.
    pub(crate) const NONE: Self = Self {
        sides: [[0; 2]; 2],
        to_center: [0; 2],
        up: 1,
        down: 0,
        near: 1,
        area: 0,
        inverse: 0,
    };

    /// The basis of a triangle with these corners and this doubled area, which is not 0. The area is positive if the
    /// corners run clockwise on a screen whose y points down.
    #[inline]
    pub(crate) fn new([[x, y], b, c]: [[i32; 2]; 3], area: i64) -> Self {
        let size = |a: i32, b: i32, c: i32| a.max(b).max(c) - a.min(b).min(c);
        let [wide, high] = [size(x, b[0], c[0]), size(y, b[1], c[1])];
        // A pixel may lie one column or row beyond the corner that it is next to.
        let is_small = wide + high <= (NEAR - 2) << 8;
        // Twice the area is then below 2^28.
        let small_area = (area as i32).unsigned_abs();
        // A gradient per pixel is at most 256 · range · extent / area, where the range of the values is below 2^31
        // and the extent is one of these. So it is below 2^31, too.
        let is_thick = small_area >> 8 >= wide.max(high).cast_unsigned();
        let (near, up, down, size) = if is_small && is_thick {
            let zeros = (small_area | 1).leading_zeros();
            (
                (zeros + 8) & 31,
                1 << (zeros & 31),
                0,
                small_area << (zeros & 31),
            )
        } else {
            let size = area.unsigned_abs();
            let zeros = size.leading_zeros();
            // An area below 2^32 is shifted left, a greater one right. Numerators are proportional to the area and
            // scale alike.
            let up = 1 << (zeros.saturating_sub(32) & 31);
            let down = 32u32.saturating_sub(zeros);
            (0, up, down, (size << (zeros & 63) >> 32) as u32)
        };
        // The area is stored without its sign, so the sides take it over.
        let sign = if area < 0 { -1 } else { 1 };
        Self {
            near,
            sides: [b, c].map(|[to_x, to_y]| [(to_x - x) * sign, (to_y - y) * sign]),
            to_center: [128 - (x & 255), 128 - (y & 255)],
            up,
            down,
            area: size,
            inverse: reciprocal(size >> 1).cast_signed(),
        }
    }

    /// Whether the triangle is near: so small, and so little of a sliver, that gradients rounded to the nearest unit
    /// suffice.
    #[inline]
    pub(crate) const fn is_near(&self) -> bool {
        self.near != 0
    }

    /// The change of `values` per column and per row, times twice the area in units of one pixel by 1/256 pixel.
    ///
    /// Values lie within ±2³¹ and differ by less than 2³¹.
    #[inline]
    fn gains(&self, [a, b, c]: [i32; 3]) -> [i64; 2] {
        let (b, c) = (b.wrapping_sub(a), c.wrapping_sub(a));
        let [[bx, by], [cx, cy]] = self.sides;
        // Differences take 31 bits and a sign, sides 20 bits, so the results take 52 bits.
        [
            product(b, cy) - product(c, by),
            product(c, bx) - product(b, cx),
        ]
    }

    /// [`gains`](Self::gains) for a near triangle, whose sides take 14 bits.
    #[inline]
    fn short_gains(&self, [a, b, c]: [i32; 3]) -> [i64; 2] {
        let (b, c) = (b.wrapping_sub(a), c.wrapping_sub(a));
        let [[bx, by], [cx, cy]] = self.sides;
        [
            short_difference(b, cy, c, by),
            short_difference(c, bx, b, cx),
        ]
    }

    /// Lays a plane through the values at the corners.
    #[inline]
    pub(crate) fn lay(&self, values: [i32; 3], gradient: &mut Gradient) {
        if self.is_near() {
            self.lay_near(values, gradient);
        } else {
            self.lay_far(values, gradient);
        }
    }

    #[inline(never)]
    fn lay_near(&self, values: [i32; 3], gradient: &mut Gradient) {
        // Gradients are below 2^31 and areas below 2^32, so the products take 63 bits.
        let gains = self
            .short_gains(values)
            .map(|gain| shifted(gain, self.near));
        let [step, row] = gains.map(|gain| self.value(gain));
        // The center is at most half a pixel away, and the error of the gradients is half a unit per pixel.
        let [x, y] = self.to_center;
        let moved = moved(step, x).wrapping_add(moved(row, y));
        let [corner, ..] = values;
        gradient.step = step;
        gradient.row = row;
        gradient.start = corner.wrapping_add(moved);
    }

    #[inline(never)]
    fn lay_far(&self, values: [i32; 3], gradient: &mut Gradient) {
        let [dx, dy] = self.gains(values);
        let [x, y] = self.to_center.map(i64::from);
        let moved = self.scale(dx * x + dy * y);
        let [corner, ..] = values;
        let corner = i64::from(corner) * i64::from(self.area);
        // Times 256, they take 60 bits.
        let [dx, dy] = [dx, dy].map(|gain| self.scale(gain << 8));
        gradient.step = self.value(dx);
        gradient.numerator = corner.wrapping_add(moved);
        gradient.dx = dx;
        gradient.dy = dy;
    }

    /// Computes only the numerator, for any triangle, as [`precise`](Self::precise) needs it.
    pub(crate) fn lay_numerator(&self, values: [i32; 3], gradient: &mut Gradient) {
        let mut far = Gradient::NONE;
        self.lay_far(values, &mut far);
        *gradient = Gradient {
            step: gradient.step,
            row: gradient.row,
            start: gradient.start,
            ..far
        };
    }

    /// 2^`up` times the value `x` columns and `y` rows from the pixel that contains corner 0, to the nearest unit.
    pub(crate) fn precise(&self, gradient: &Gradient, [x, y]: [i32; 2], up: u32) -> i32 {
        let moved = times_short(gradient.dx, x).wrapping_add(times_short(gradient.dy, y));
        self.value(gradient.numerator.wrapping_add(moved) << (up & 31))
    }

    /// The greatest change of the value from a pixel to the next, across or down.
    pub(crate) fn steepness(&self, gradient: &Gradient) -> u32 {
        let row = if self.is_near() {
            gradient.row
        } else {
            self.value(gradient.dy)
        };
        gradient.step.unsigned_abs().max(row.unsigned_abs())
    }

    /// The value `x` columns and `y` rows from the pixel that contains corner 0, for triangles that are not near.
    #[inline(never)]
    pub(crate) fn far(&self, gradient: &Gradient, x: i32, y: i32) -> i32 {
        let Gradient {
            numerator, dx, dy, ..
        } = gradient;
        // The guard band is at most 4096 pixels wide and high.
        let moved = times_short(*dx, x).wrapping_add(times_short(*dy, y));
        self.value(numerator.wrapping_add(moved))
    }

    /// Scales a numerator like the area. Bits shifted out at the top do not count modulo 2⁶⁴. Bits shifted out at the
    /// bottom, in large triangles only, are below 2⁻²² of a unit of the value.
    #[inline]
    const fn scale(&self, numerator: i64) -> i64 {
        // A product, because 32-bit cores compute it faster than a shift of 64 bits.
        numerator.wrapping_mul(self.up as i64) >> (self.down & 31)
    }

    /// numerator / area, rounded to nearest, for values within ±2³¹; others wrap.
    #[inline]
    fn value(&self, numerator: i64) -> i32 {
        // numerator · inverse / 2^62, from the halves of the numerator.
        let high = product((numerator >> 32) as i32, self.inverse);
        let low = upper(
            numerator.cast_unsigned() as u32,
            self.inverse.cast_unsigned(),
        );
        ((high.wrapping_add(low.into()).wrapping_add(1 << 29)) >> 30) as i32
    }
}

/// gradient · `part` / 256, for a `part` of magnitude up to 128, with an error below one unit.
#[inline]
const fn moved(gradient: i32, part: i32) -> i32 {
    (gradient >> 8) * part + (((gradient & 0xff) * part + 128) >> 8)
}
