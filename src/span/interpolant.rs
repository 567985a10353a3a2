//! The plane equations of interpolants.

use crate::num::reciprocal;
use crate::num::wide::{DIVIDES, product, times_30, times_short, unsigned_product};
use crate::raster::{Patch, ScreenVertex};

/// A number that is linear on the screen, such as 1/w or a varying over w: a plane over a triangle, which gives the
/// number's value at every pixel center. The error is at most 33¾ units in a small plane, 67½ units in a
/// [coarse](Basis::is_coarse) plane, and 2½ units in a wide plane.
///
/// Small triangles have small planes, of 32 bits: a value is `start` plus a number of steps. In large triangles and
/// thin slivers, too many rounding errors would add up from step to step. So these triangles have wide planes, with 30
/// bits more.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interpolant {
    /// Change from one column to the next, rounded to the nearest unit.
    pub(crate) step: i32,
    /// Change from one row to the next, rounded to the nearest unit; small planes only.
    pub(crate) row: i32,
    /// Value at the center of pixel (0, 0), modulo 2³²; small planes only.
    start: i32,
    pub(crate) wide: WidePlane,
    pub(crate) is_small: bool,
}

/// The value at the center of pixel (0, 0), plus half a unit, and its change per column and per row, in units of 2⁻³⁰.
/// Because of the half unit, rounding down gives the nearest unit.
///
/// All three numbers are modulo 2⁶⁴. A value within the triangle takes 62 bits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WidePlane {
    start: i64,
    dx: i64,
    dy: i64,
}

/// The value at the center of pixel (0, 0) and its change per column and per row, modulo 2³².
#[derive(Clone, Copy, Debug)]
pub(crate) struct SmallPlane {
    step: i32,
    row: i32,
    start: i32,
}

impl SmallPlane {
    /// The sum of this plane and 2^16 times the plane `upper`. If the value of this plane is from 0 to 2^16 − 1, it is
    /// the lower half of the sum's value, and the value of `upper` is the upper half.
    #[inline]
    pub(super) const fn paired(self, upper: Self) -> Self {
        Self {
            step: self.step.wrapping_add(upper.step << 16),
            row: self.row.wrapping_add(upper.row << 16),
            start: self.start.wrapping_add(upper.start << 16),
        }
    }
}

impl Interpolant {
    /// An interpolant before the first triangle: 0 everywhere.
    pub(crate) const NONE: Self = Self {
        step: 0,
        row: 0,
        start: 0,
        wide: WidePlane::NONE,
        is_small: false,
    };

    #[inline]
    pub(super) fn set(&mut self, SmallPlane { step, row, start }: SmallPlane) {
        self.is_small = true;
        self.step = step;
        self.row = row;
        self.start = start;
    }

    /// A plane with the same value everywhere.
    #[inline]
    pub(super) fn set_level(&mut self, start: i32) {
        let (step, row) = (0, 0);
        self.set(SmallPlane { step, row, start });
    }

    /// The value at a pixel.
    #[inline]
    pub(crate) fn at(&self, x: i32, y: i32) -> i32 {
        if self.is_small {
            self.small_at(x, y)
        } else {
            self.wide.at(x, y)
        }
    }

    /// The change per row, rounded to the nearest unit.
    pub(crate) const fn row(&self) -> i32 {
        if self.is_small {
            self.row
        } else {
            rounded(self.wide.dy)
        }
    }

    /// The value of a small plane at a pixel.
    #[inline]
    pub(crate) const fn small_at(&self, x: i32, y: i32) -> i32 {
        let row = self.start.wrapping_add(self.row.wrapping_mul(y));
        row.wrapping_add(self.step.wrapping_mul(x))
    }
}

/// The data that all small planes of a triangle share.
///
/// Positions are in units of 1/256 pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Basis {
    /// The vector from corner 0 to the center of pixel (0, 0).
    to_center: [i32; 2],
    /// The change of the barycentric weights of corners 1 and 2, per column and per row, in units of 2^(`up` - 32).
    weights: [[i32; 2]; 2],
    up: u32,
    /// Values with a range below this limit make a small plane; 0 if the triangle has coarse planes only.
    limit: u32,
    /// The same limit for coarse planes.
    coarse_limit: u32,
}

/// The data that all wide planes of a triangle share.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WideBasis {
    /// The vector from corner 0 to the center of pixel (0, 0).
    to_center: [i32; 2],
    /// The vectors from corner 0 to corners 1 and 2, times the sign of the area. The area itself is stored without its
    /// sign.
    sides: [[i32; 2]; 2],
    /// Twice the area is 2^-`shift` times a number of 32 bits with the top bit set, and `inverse` is 2⁶² / number.
    ///
    /// The reciprocal ignores the number's last bit. This scales all interpolants of a triangle by the same relative
    /// error, so the error cancels in their quotients.
    shift: i32,
    inverse: i32,
}

/// The magnitude of a number, or one less if the number is negative.
#[inline]
pub(super) const fn magnitude(value: i32) -> i32 {
    value ^ value >> 31
}

/// Limit for the width plus the height of a small triangle, in units of 1/256 pixel.
///
/// Let b and c be the shifted differences between corners, below 2^30. A step to the next column or row has an error of
/// at most ¾ unit: ½ unit from its own rounding, and (|b| + |c|) · 2^-33 units, at most ¼, from the rounding of the
/// weights. From the first corner to the center of any pixel of the triangle there are at most 43 steps. The rounding
/// of `start` adds ½ unit. The reciprocal of the area has an error of 2^-30, which adds less than a unit, because
/// ranges are below 2^30. The sum is 33¾ units. A coarse plane has twice the steps, so its error is less than 67½
/// units.
const SMALL: i32 = 43 << 8;

/// The most bits by which the differences between corners are shifted left.
const MOST_UP: u32 = 7;

impl Basis {
    /// The basis of a shape that has no small plane.
    pub(super) const NONE: Self = Self {
        to_center: [0; 2],
        weights: [[0; 2]; 2],
        up: 0,
        limit: 0,
        coarse_limit: 0,
    };

    /// Starts a triangle; `None` if its shape allows no small plane. With `has_coarse`, some of its planes may be
    /// [coarse](Self::is_coarse).
    #[inline]
    pub(crate) fn new(patch: &Patch<'_>, has_coarse: bool) -> Option<Self> {
        let [[x, y], [bx, by], [cx, cy]] = ScreenVertex::screens(patch.vertices);
        let [wide, high] = patch.size;
        if wide + high > SMALL << u32::from(has_coarse) {
            return None;
        }
        if patch.is_point() {
            // A point: all planes are level.
            return Some(Self {
                limit: u32::MAX,
                coarse_limit: u32::MAX,
                ..Self::NONE
            });
        }
        // Here, twice the area is below 2^27. Let r be 2^62 / (area · 2^zeros), and s = side · 2^(zeros + 8 - up). Then
        // s · r / 2^30 is side · 2^(40 - up) / area, the change of a weight per pixel in units of 2^(up - 32). `up` is
        // chosen so that s has 30 bits. The result has 31 bits.
        let area = patch.area as i32;
        let zeros = area.unsigned_abs().leading_zeros();
        let most = wide.max(high).cast_unsigned();
        let up = (zeros + 10).saturating_sub(most.leading_zeros());
        if up > MOST_UP {
            return None;
        }
        let inverse = reciprocal(area.unsigned_abs() << (zeros & 31) >> 1);
        let sign = if area < 0 { -1 } else { 1 };
        let left = sign << ((zeros + 8 - up) & 31);
        let weight = |side: i32| times_30(side * left, inverse);
        let coarse_limit = 1 << (30 - up);
        Some(Self {
            to_center: [128 - x, 128 - y],
            weights: [
                [weight(cy - y), weight(x - cx)],
                [weight(y - by), weight(bx - x)],
            ],
            up,
            limit: if wide + high <= SMALL {
                coarse_limit
            } else {
                0
            },
            coarse_limit,
        })
    }

    /// Whether these values make a small plane: their differences from the first value are below the limit, which is a
    /// power of two or, for a point, has all bits set.
    #[inline]
    pub(crate) const fn has_small(&self, [a, b, c]: [i32; 3]) -> bool {
        let most = magnitude(b.wrapping_sub(a)) | magnitude(c.wrapping_sub(a));
        self.is_small(most.cast_unsigned())
    }

    /// Whether values with this range (greatest minus least) make a small plane.
    #[inline]
    pub(crate) const fn is_small(&self, range: u32) -> bool {
        range < self.limit
    }

    /// Whether values with this range make a coarse plane: a small plane for a triangle of up to twice the width and
    /// height. A coarse plane has up to twice the error.
    #[inline]
    pub(crate) const fn is_coarse(&self, range: u32) -> bool {
        range < self.coarse_limit
    }

    /// A plane through 2^`raised` times the values at the corners. The range of these products must be
    /// [small](Self::is_small) or [coarse](Self::is_coarse).
    #[cfg_attr(for_size, inline(never))]
    pub(crate) fn small(&self, [a, b, c]: [i32; 3], raised: u32) -> SmallPlane {
        let up = self.up + raised;
        let (b, c) = (
            b.wrapping_sub(a) << (up & 31),
            c.wrapping_sub(a) << (up & 31),
        );
        let [[b_step, b_row], [c_step, c_row]] = self.weights;
        // The shifted differences are below 2^30, the weights below 2^31.
        let gain = |weight_b: i32, weight_c: i32| {
            ((product(b, weight_b) + product(c, weight_c) + (1 << 31)) >> 32) as i32
        };
        let (step, row) = (gain(b_step, c_step), gain(b_row, c_row));
        let start = (a << (raised & 31)).wrapping_add(moved([step, row], self.to_center));
        SmallPlane { step, row, start }
    }

    /// Sets up a plane through the values at the corners: a small plane if their differences allow it, otherwise a wide
    /// plane.
    /// `wide` is the basis of the triangle's wide planes, once it has one.
    #[inline]
    pub(crate) fn set_up(
        &self,
        values: [i32; 3],
        (patch, wide): (&Patch<'_>, &mut Option<WideBasis>),
        interpolant: &mut Interpolant,
    ) {
        if self.has_small(values) {
            interpolant.set(self.small(values, 0));
        } else {
            wide.get_or_insert_with(|| WideBasis::new(patch))
                .set_up(values, interpolant);
        }
    }
}

impl WideBasis {
    /// Starts a triangle of any shape.
    #[inline(never)]
    pub(crate) fn new(patch: &Patch<'_>) -> Self {
        let [[x, y], [bx, by], [cx, cy]] = ScreenVertex::screens(patch.vertices);
        let sign = if patch.area < 0 { -1 } else { 1 };
        let area = patch.area.unsigned_abs();
        let zeros = area.leading_zeros();
        let number = (area << (zeros & 63) >> 32) as u32;
        Self {
            to_center: [128 - x, 128 - y],
            sides: [
                [(bx - x) * sign, (by - y) * sign],
                [(cx - x) * sign, (cy - y) * sign],
            ],
            shift: zeros.cast_signed() - 32,
            inverse: reciprocal(number >> 1).cast_signed(),
        }
    }

    /// The change of `values` per column and per row, multiplied by twice the area. The unit of this area is one pixel
    /// by 1/256 pixel.
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

    /// Sets up a wide plane through the values at the corners.
    #[inline(never)]
    pub(crate) fn set_up(&self, values: [i32; 3], interpolant: &mut Interpolant) {
        let [dx, dy] = self.gains(values);
        let [x, y] = self.to_center;
        // `moved` is the change from the corner to the center of the pixel that contains the corner.
        let [part_x, part_y] = [x, y].map(|way| i64::from(((way + 127) & 255) - 127));
        let moved = self.quotient(dx * part_x + dy * part_y);
        // The gains times 256 take 60 bits.
        let [dx, dy] = [dx, dy].map(|gain| self.quotient(gain << 8));
        let [columns, rows] = [x, y].map(|way| (way + 127) >> 8);
        let rest = times_short(dx, columns).wrapping_add(times_short(dy, rows));
        let [corner, ..] = values;
        interpolant.is_small = false;
        interpolant.step = rounded(dx);
        interpolant.wide = WidePlane {
            start: (i64::from(corner) << 30)
                .wrapping_add(HALF)
                .wrapping_add(moved)
                .wrapping_add(rest),
            dx,
            dy,
        };
    }
    /// `numerator` / area in units of 2^-30, rounded down, modulo 2⁶⁴.
    #[inline(never)]
    fn quotient(self, numerator: i64) -> i64 {
        // The result is numerator · inverse · 2^(shift - 32). The product takes 91 bits, so it is computed from the
        // halves of the numerator.
        let inverse = self.inverse.cast_unsigned();
        let (high, low) = ((numerator >> 32) as i32, numerator.cast_unsigned() as u32);
        let lower = unsigned_product(low, inverse);
        let upper = product(high, self.inverse) + i64::from((lower >> 32) as u32);
        let lower = u64::from(lower as u32);
        let up = self.shift.cast_unsigned();
        if self.shift < 0 {
            upper >> (up.wrapping_neg() & 31)
        } else {
            (upper << (up & 31)).wrapping_add((lower << (up & 31) >> 32).cast_signed())
        }
    }
}

impl WidePlane {
    /// A plane before the first triangle: 0 everywhere.
    const NONE: Self = Self {
        start: 0,
        dx: 0,
        dy: 0,
    };

    /// The value at a pixel plus half a unit, in units of 2^-30.
    #[inline]
    fn value_30(&self, x: i32, y: i32) -> i64 {
        // Columns and rows of a canvas have 11 bits, so the masks change nothing. They tell the compiler that the
        // numbers have no sign: then it multiplies in fewer instructions.
        let row = self.start.wrapping_add(times_short(self.dy, y & 0x7fff));
        row.wrapping_add(times_short(self.dx, x & 0x7fff))
    }

    /// The value at a pixel.
    #[inline]
    pub(crate) fn at(&self, x: i32, y: i32) -> i32 {
        (self.value_30(x, y) >> 30) as i32
    }

    /// 2^`up` times the value at a pixel, rounded to the nearest unit.
    pub(crate) fn precise(&self, [x, y]: [i32; 2], up: u32) -> i32 {
        rounded(self.value_30(x, y).wrapping_sub(HALF) << (up & 31))
    }
}

/// Half a unit, in units of 2^-30.
const HALF: i64 = 1 << 29;

/// A value in units of 2^-30, rounded to the nearest unit, modulo 2³².
#[inline]
const fn rounded(fine: i64) -> i32 {
    (fine.wrapping_add(HALF) >> 30) as i32
}

/// The change of a value along the vector [x, y], in units of 1/256 pixel; rounded to the nearest unit, modulo 2³².
#[inline]
const fn moved([step, row]: [i32; 2], [x, y]: [i32; 2]) -> i32 {
    if DIVIDES {
        return ((product(step, x) + product(row, y) + 128) >> 8) as i32;
    }
    // This path avoids products of 64 bits: it multiplies the lower 8 bits of the steps and the upper bits separately.
    // x and y take 21 bits, so the sum of their products with 8 bits takes 30 bits.
    let fine = (step & 0xff) * x + (row & 0xff) * y;
    let coarse = (step >> 8)
        .wrapping_mul(x)
        .wrapping_add((row >> 8).wrapping_mul(y));
    coarse.wrapping_add((fine + 128) >> 8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::vertex;
    use crate::random::{Random, cases, number};
    use crate::raster::{area, first_center};
    use rand::Rng;

    #[test]
    fn quotients_keep_all_bits() {
        cases(2000, |random| {
            let (numerator, inverse) = (number(random), random.random_range(1 << 30..i32::MAX));
            let numerator = i64::from(numerator) << random.random_range(0..32)
                | i64::from(random.random::<u16>());
            let shift = random.random_range(-31..32);
            let wide = WideBasis {
                to_center: [0; 2],
                sides: [[0; 2]; 2],
                shift,
                inverse,
            };
            let exact = (i128::from(numerator) * i128::from(inverse)) >> (32 - shift);
            assert_eq!(
                wide.quotient(numerator),
                exact as i64,
                "{numerator}, {wide:?}"
            );
        });
    }

    /// The least and the greatest coordinate of corners, along an axis.
    fn ends(screen: [[i32; 2]; 3], axis: usize) -> [i32; 2] {
        let all = screen.map(|corner| corner[axis]);
        [*all.iter().min().unwrap(), *all.iter().max().unwrap()]
    }

    /// Sets up a plane through `values` at three places on the screen; with `is_coarse`, the plane may be coarse. `None`
    /// if the places are in a line.
    fn plane(screen: [[i32; 2]; 3], values: [i32; 3], is_coarse: bool) -> Option<Interpolant> {
        let vertices = screen.map(vertex);
        let area = area(&screen);
        let patch = Patch {
            vertices: vertices.each_ref(),
            barycentric: None,
            size: [0, 1].map(|axis| {
                let [least, most] = ends(screen, axis);
                most - least
            }),
            area,
        };
        let basis = Basis::new(&patch, is_coarse).unwrap_or(Basis::NONE);
        let mut interpolant = Interpolant::NONE;
        if area != 0 {
            let range = values.iter().max().unwrap() - values.iter().min().unwrap();
            if is_coarse && basis.is_coarse(range.cast_unsigned()) {
                interpolant.set(basis.small(values, 0));
            } else {
                let wide = (&patch, &mut None);
                basis.set_up(values, wide, &mut interpolant);
            }
        }
        (area != 0).then_some(interpolant)
    }

    /// The value of the plane through `values` at the center of a pixel, in hundredths of a unit.
    fn hundredths(screen: [[i32; 2]; 3], values: [i32; 3], pixel: [i32; 2]) -> i128 {
        let [a, b, c] = screen.map(|place| place.map(i128::from));
        let [x, y] = pixel.map(|at| i128::from(256 * at + 128));
        let cross = |p: [i128; 2], q: [i128; 2]| p[0] * q[1] - q[0] * p[1];
        let from_a = |p: [i128; 2]| [p[0] - a[0], p[1] - a[1]];
        let (to_b, to_c, to_pixel) = (from_a(b), from_a(c), from_a([x, y]));
        let area = cross(to_b, to_c);
        let weights = [cross(to_pixel, to_c), cross(to_b, to_pixel)];
        let [first, second, third] = values.map(i128::from);
        let sum = (second - first) * weights[0] + (third - first) * weights[1];
        100 * first + 100 * sum / area
    }

    /// The pixels whose centers are in a triangle, or on its border.
    fn pixels(screen: [[i32; 2]; 3]) -> impl Iterator<Item = [i32; 2]> {
        let centers = move |axis| {
            let [least, most] = ends(screen, axis);
            first_center(least)..first_center(most)
        };
        let all = centers(0).flat_map(move |x| centers(1).map(move |y| [x, y]));
        all.filter(move |[x, y]| {
            let center = [256 * x + 128, 256 * y + 128];
            let [a, b, c] = screen;
            let areas =
                [[center, b, c], [a, center, c], [a, b, center]].map(|corners| area(&corners));
            areas.iter().all(|area| *area >= 0) || areas.iter().all(|area| *area <= 0)
        })
    }

    /// Random values with a magnitude of up to 30 bits and a range that may be small.
    fn values(random: &mut Random) -> [i32; 3] {
        let [most, range] = [30, 31].map(|bits| 1 << random.random_range(0..bits) >> 1);
        let base = random.random_range(-most..=most);
        [(); 3].map(|()| base + random.random_range(0..=range))
    }

    /// A wide plane's reciprocal has an error of 2^-30, which is at most two units of a range below 2^31. Rounding adds
    /// ½ unit.
    #[test]
    fn small_planes_are_within_33_coarse_ones_within_67_and_wide_ones_within_two_units() {
        cases(4000, |random| {
            let is_coarse = random.random();
            let at = [(); 2].map(|()| random.random_range(-(2048_i32 << 8)..2048 << 8));
            let size = random.random_range(4_u32..15);
            let parts =
                [(); 2].map(|()| [(); 2].map(|()| random.random_range(-1_i32 << 14..=1 << 14)));
            let values = values(random);
            let [x, y] = at;
            let place = |part: [i32; 2]| {
                [
                    x + (part[0] >> (14 - size.min(14))),
                    y + (part[1] >> (14 - size.min(14))),
                ]
            };
            let screen = [at, place(parts[0]), place(parts[1])];
            let Some(interpolant) = plane(screen, values, is_coarse) else {
                return;
            };
            let most = match (interpolant.is_small, is_coarse) {
                (false, _) => 250,
                (true, false) => 3375,
                (true, true) => 6750,
            };
            for [x, y] in pixels(screen) {
                let value = if interpolant.is_small {
                    interpolant.small_at(x, y)
                } else {
                    let fine = interpolant
                        .wide
                        .start
                        .wrapping_add(interpolant.wide.dx.wrapping_mul(x.into()))
                        .wrapping_add(interpolant.wide.dy.wrapping_mul(y.into()));
                    (fine >> 30) as i32
                };
                let error = 100 * i128::from(value) - hundredths(screen, values, [x, y]);
                assert!(
                    error.abs() <= most,
                    "{error} / 100 at {x}, {y}: {interpolant:?}"
                );
            }
        });
    }

    /// Tests shapes and ranges just inside and just outside of each limit.
    #[test]
    fn triangles_and_ranges_up_to_the_limits_have_small_planes() {
        let is_small = |screen, values| plane(screen, values, false).unwrap().is_small;
        let is_coarse = |screen, values| plane(screen, values, true).unwrap().is_small;
        let square = |side: i32| [[0, 0], [side, 0], [0, side]];
        // The width plus the height is 43 pixels, then a little more.
        assert!(is_small(square(SMALL / 2), [0, 1 << 29, 0]));
        assert!(!is_small(square(SMALL / 2 + 1), [0, 1 << 29, 0]));
        assert!(is_coarse(square(SMALL), [0, 1 << 29, 0]));
        assert!(!is_coarse(square(SMALL + 1), [0, 1 << 29, 0]));
        // A range of 30 bits.
        assert!(is_small(square(4096), [-(1 << 29), (1 << 29) - 1, 0]));
        assert!(!is_small(square(4096), [-(1 << 29), 1 << 29, 0]));
        // Slivers ten pixels long. The thinner a sliver is, the smaller the range of its values must be.
        let sliver = |high: i32| [[0, 127], [2560, 127], [0, 127 + high]];
        for (high, bits) in [
            (2560, 30),
            (512, 29),
            (256, 28),
            (128, 27),
            (16, 24),
            (8, 23),
        ] {
            assert!(is_small(sliver(high), [0, (1 << bits) - 1, 0]), "{high}");
            assert!(!is_small(sliver(high), [0, 1 << bits, 0]), "{high}");
        }
        assert!(!is_small(sliver(4), [0, 1, 0]));
    }
}
