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
    /// Bits by which numerators are shifted down; up if negative.
    shift: i32,
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
        shift: 0,
        area: 0,
        inverse: 0,
    };

    /// The slope of a triangle whose doubled area, `area`, is positive: corners run clockwise as
    /// seen on a screen whose y points down.
    #[inline]
    pub(crate) fn new(corners: [[i32; 2]; 3], area: u64) -> Self {
        let [[x, y], b, c] = corners;
        Self::with([[b[0] - x, b[1] - y], [c[0] - x, c[1] - y]], [x, y], area)
    }

    /// The slope along a line of which `length` is the extent along x, in units of 1/256 pixel.
    ///
    /// As of a triangle with one side along the line and another of one unit down.
    #[inline]
    pub(crate) fn along(start: i32, length: u32) -> Self {
        Self::with(
            [[length.cast_signed(), 0], [0, 1]],
            [start, 128],
            u64::from(length),
        )
    }

    #[inline]
    fn with(sides: [[i32; 2]; 2], [x, y]: [i32; 2], area: u64) -> Self {
        let zeros = (area | 1).leading_zeros().cast_signed();
        let shift = 32 - zeros;
        let area = (area << zeros >> 32) as u32;
        Self {
            sides,
            to_center: [128 - (x & 255), 128 - (y & 255)],
            shift,
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

    /// A line's equation: the plane through the values at its ends, level across it.
    #[inline]
    pub(crate) fn line(&self, [a, b]: [i32; 2]) -> Plane {
        self.plane([a, b, a])
    }

    /// A numerator in the scale of the area. Bits shifted out at the top are beyond modulo 2⁶⁴;
    /// those at the bottom, of large triangles only, are below 2⁻²² of a unit of the value.
    #[inline]
    const fn scale(&self, numerator: i64) -> i64 {
        if self.shift > 0 {
            numerator >> self.shift
        } else {
            numerator << -self.shift
        }
    }

    /// numerator / area, to the nearest, for numerators of values within ±2³¹; others wrap.
    #[inline]
    pub(crate) const fn value(&self, numerator: i64) -> i32 {
        // numerator · inverse / 2^62, from the halves of the numerator.
        let inverse = self.inverse as i64;
        let high = (numerator >> 32) * inverse;
        let low = (numerator.cast_unsigned() as u32 as i64 * inverse) >> 32;
        ((high.wrapping_add(low).wrapping_add(1 << 29)) >> 30) as i32
    }
}
