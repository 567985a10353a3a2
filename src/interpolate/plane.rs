//! The plane equation of an interpolant, kept as a numerator over a common denominator.

use super::reciprocal::reciprocal;

/// The numerator of an interpolant, linear over the screen: its value at a pixel is numerator / denominator.
///
/// The denominator is twice the triangle's area scaled to 32 bits, and the numerators are scaled
/// alike, so they take 63 bits. Arithmetic on them wraps: within the triangle the result is in
/// range, and modulo 2⁶⁴ it does not matter by which way it was reached.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    base: i64,
    dx: i64,
    dy: i64,
}

impl Plane {
    /// Nothing to interpolate.
    pub(crate) const NONE: Self = Self {
        base: 0,
        dx: 0,
        dy: 0,
    };

    /// The numerator at the centre of the pixel `x` columns and `y` rows from the one that corner 0 lies in.
    #[inline]
    pub(crate) const fn at(&self, x: i32, y: i32) -> i64 {
        self.base
            .wrapping_add(self.dx.wrapping_mul(x as i64))
            .wrapping_add(self.dy.wrapping_mul(y as i64))
    }

    /// What one column to the right adds to the numerator.
    #[inline]
    pub(crate) const fn dx(&self) -> i64 {
        self.dx
    }
}

/// What the interpolants of a triangle have in common: its sides and its area.
///
/// Positions are in units of 1/256 pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slope {
    /// From corner 0 to corners 1 and 2.
    sides: [[i32; 2]; 2],
    /// From corner 0 to the centre of the pixel it lies in.
    to_center: [i32; 2],
    /// What numerators are multiplied with, 2^0 to 2^31, and then shifted down by.
    up: u32,
    down: u32,
    /// Twice the area in 32 bits, the top one set, and its reciprocal, 2⁶² / area.
    ///
    /// The area's last bit is left out of it. That is one error for all interpolants of a triangle,
    /// so their quotients do not know it.
    area: u32,
    inverse: i32,
}

impl Slope {
    /// Nothing to interpolate.
    pub(crate) const NONE: Self = Self {
        sides: [[0; 2]; 2],
        to_center: [0; 2],
        up: 1,
        down: 0,
        area: 0,
        inverse: 0,
    };

    /// The slope of a triangle of this doubled area, which is not 0: positive if corners run clockwise
    /// as seen on a screen whose y points down.
    #[inline]
    pub(crate) fn new([[x, y], b, c]: [[i32; 2]; 3], area: i64) -> Self {
        let zeros = area.unsigned_abs().leading_zeros();
        // Below 2^32 an area is shifted up, above down; numerators that are proportional to it likewise.
        let down = 32u32.saturating_sub(zeros);
        let up = zeros.saturating_sub(32);
        // An area that is negative makes the numerators so.
        let sign = if area < 0 { -1 } else { 1 };
        let area = (area.unsigned_abs() << (zeros & 63) >> 32) as u32;
        Self {
            sides: [b, c].map(|[to_x, to_y]| [(to_x - x) * sign, (to_y - y) * sign]),
            to_center: [128 - (x & 255), 128 - (y & 255)],
            up: 1 << (up & 31),
            down,
            area,
            inverse: reciprocal(area >> 1).cast_signed(),
        }
    }

    /// The plane through the values at the three corners, each within ±2³¹, apart by less than 2³¹.
    #[inline]
    pub(crate) fn plane(&self, [a, b, c]: [i32; 3]) -> Plane {
        let (b, c) = (i64::from(b.wrapping_sub(a)), i64::from(c.wrapping_sub(a)));
        let [[bx, by], [cx, cy]] = self.sides.map(|side| side.map(i64::from));
        // Differences take 31 bits and a sign, sides 20: with the sum 52 bits, by 256 60.
        let dx = b * cy - c * by;
        let dy = c * bx - b * cx;
        let [x, y] = self.to_center.map(i64::from);
        Plane {
            base: (i64::from(a) * i64::from(self.area)).wrapping_add(self.scale(dx * x + dy * y)),
            dx: self.scale(dx << 8),
            dy: self.scale(dy << 8),
        }
    }

    /// A numerator in the scale of the area. Bits shifted out at the top are beyond modulo 2⁶⁴;
    /// those at the bottom, of large triangles only, are below 2⁻²² of a unit of the value.
    #[inline]
    const fn scale(&self, numerator: i64) -> i64 {
        // As a product, which 32-bit cores are faster with than with a shift of 64 bits.
        numerator.wrapping_mul(self.up as i64) >> (self.down & 31)
    }

    /// numerator / area, to the nearest, for numerators of values within ±2³¹; others wrap.
    #[inline]
    pub(crate) const fn value(&self, numerator: i64) -> i32 {
        // numerator · inverse / 2^62, from the halves of the numerator.
        let high = (numerator >> 32) * self.inverse as i64;
        let low = numerator.cast_unsigned() as u32 as u64 * self.inverse.cast_unsigned() as u64;
        let low = (low >> 32).cast_signed();
        ((high.wrapping_add(low).wrapping_add(1 << 29)) >> 30) as i32
    }
}
