//! Rotations: about an axis, and from Euler angles and quaternions.

use micromath::Quaternion;

use super::Transform;
use crate::error::Error;
use crate::math::Vec3;
use crate::num::block::{self, BlockFloat};
use crate::num::float::Parts;
use crate::num::rsqrt::measure;
use crate::num::wide::product;
use crate::num::{Angle, Fraction, Scalar, reciprocal};

/// One, in units of 2^-29.
const ONE: i32 = 1 << 29;

impl Transform {
    /// Makes a rotation from rows in units of 2^-29. The largest entry must be about one.
    const fn from_rotation_rows(linear: [[i32; 3]; 3]) -> Self {
        Self {
            linear,
            ..Self::IDENTITY
        }
    }

    /// Makes the rotation about the x axis, from y toward z.
    ///
    /// The entries of the rotation matrix are accurate to 2.6e-9.
    #[must_use]
    pub const fn rotate_x(angle: Angle) -> Self {
        let [s, minus, c] = sin_cos_29(angle);
        Self::from_rotation_rows([[ONE, 0, 0], [0, c, minus], [0, s, c]])
    }

    /// Makes the rotation about the y axis, from z toward x; as accurate as [`rotate_x`](Self::rotate_x).
    #[must_use]
    pub const fn rotate_y(angle: Angle) -> Self {
        let [s, minus, c] = sin_cos_29(angle);
        Self::from_rotation_rows([[c, 0, s], [0, ONE, 0], [minus, 0, c]])
    }

    /// Makes the rotation about the z axis, from x toward y; as accurate as [`rotate_x`](Self::rotate_x).
    #[must_use]
    pub const fn rotate_z(angle: Angle) -> Self {
        let [s, minus, c] = sin_cos_29(angle);
        Self::from_rotation_rows([[c, minus, 0], [s, c, 0], [0, 0, ONE]])
    }

    /// Makes the rotation about an axis through the origin, counter-clockwise as seen from the axis's tip.
    ///
    /// The axis may have any length except zero. The entries of the rotation matrix are accurate to 3 · 2⁻²⁸. Its rows
    /// have length one and are orthogonal to within 1e-8, so a model that is turned in every frame [keeps its
    /// size](crate::guide::limits) for a long time.
    ///
    /// # Errors
    ///
    /// [`Error::NoDirection`] if the axis is zero.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let third = Transform::rotate(vec3!(1, 1, 1), Angle::from_degrees(120))?;
    /// assert_eq!(third.point(Vec3::X), Vec3::Y);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn rotate(axis: Vec3, angle: Angle) -> Result<Self, Error> {
        let axis = measure(axis.to_bits().map(i64::from)).ok_or(Error::ZERO_DIRECTION)?;
        let (sin, cos) = Angle::from_bits(angle.to_bits() >> 1).sin_cos();
        // A quaternion of any length makes a rotation without a scale. So the axis needs no unit length here: a length
        // that is off by a little would stretch the model, and a million products would add up the error. Mantissas have
        // 31 bits, the length has 32, and sine and cosine are at most 1, in units of 2^-30.
        let part = |a: i64, b: Fraction| BlockFloat::new(a * i64::from(b.to_bits()), 0);
        let [x, y, z] = axis.mantissas.map(|mantissa| part(mantissa.into(), sin));
        let length = axis.length(axis.up.cast_unsigned()).cast_signed();
        let mut parts = [0; 4];
        block::normalize(&mut parts, &[x, y, z, part(length, cos)]);
        Self::of_quaternion(parts)
    }

    /// Makes the rotation by yaw, pitch and roll, in the order YXZ. It is the product
    /// `rotate_y(yaw) * rotate_x(pitch) * rotate_z(roll)`.
    ///
    /// The roll about z is applied first, then the pitch about x, then the yaw about y. These axes are fixed.
    /// Equivalently, the model turns about its own y axis, then its own x axis, then its own z axis. A model that looks
    /// down −z turns left with a positive yaw, looks up with a positive pitch, and tilts counter-clockwise, seen from
    /// behind, with a positive roll.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let ahead = -Vec3::Z;
    /// let (quarter, none) = (Angle::QUARTER, Angle::ZERO);
    /// assert_eq!(Transform::from_euler(quarter, none, none).point(ahead), -Vec3::X);
    /// assert_eq!(Transform::from_euler(none, quarter, none).point(ahead), Vec3::Y);
    /// assert_eq!(Transform::from_euler(none, none, quarter).point(Vec3::X), Vec3::Y);
    /// ```
    #[must_use]
    pub fn from_euler(yaw: Angle, pitch: Angle, roll: Angle) -> Self {
        Self::rotate_y(yaw) * Self::rotate_x(pitch) * Self::rotate_z(roll)
    }

    /// Makes the rotation of a quaternion, given as `[x, y, z, w]` with the real part last.
    ///
    /// The parts may be in any common unit, because the quaternion is normalized. For a sensor's raw integers, use
    /// [`Scalar::from_bits`]. The entries of the rotation matrix are accurate to 2⁻²⁷.
    ///
    /// # Errors
    ///
    /// [`Error::ZeroQuaternion`] if all four parts are zero.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// // A third of a turn about (1, 1, 1), of length two.
    /// let third = Transform::from_quaternion([fx!(1); 4])?;
    /// assert_eq!(third.point(Vec3::X), Vec3::Y);
    /// assert_eq!(Transform::from_quaternion([fx!(0); 4]), Err(Error::ZeroQuaternion));
    /// # Ok::<(), Error>(())
    /// ```
    pub fn from_quaternion(quaternion: [Scalar; 4]) -> Result<Self, Error> {
        let mut parts = [0; 4];
        let numbers = quaternion.map(|part| BlockFloat::new(part.to_bits().into(), 0));
        block::normalize(&mut parts, &numbers);
        Self::of_quaternion(parts)
    }

    /// The rotation of a quaternion, given as mantissas `[x, y, z, w]`. All are below 2^30, and the largest is at least
    /// 2^29.
    ///
    /// The error of an entry is at most 2^-33 before it is rounded: the sum of two terms, each with a factor that is cut to
    /// 37 bits, and of a reciprocal with an error of 2^-37. Entries are rounded to 2^-30, and if one of them is 1, once
    /// more to 2^-29: by 1.5 · 2^-30 together.
    #[inline(never)]
    fn of_quaternion(parts: [i32; 4]) -> Result<Self, Error> {
        let mut norm = parts.iter().fold(0, |sum, &part| sum + product(part, part));
        if norm == 0 {
            return Err(Error::ZeroQuaternion);
        }
        // The norm is from 2^58 to 2^62.
        let mut up = 0;
        for by in [2, 1] {
            if norm < 1 << (62 - by) {
                norm <<= by;
                up += by;
            }
        }
        let inverse = inverse(norm);
        // 2^59 · part / norm, which is at most 2^30, with eight more bits.
        let scaled = |part: i32| {
            let scaled = times(part, inverse) << up;
            ((scaled >> 33) as i32, (scaled >> 25) as i32 & 0xff)
        };
        let [x, y, z, w] = parts;
        let [by_x, by_y, by_z] = [scaled(x), scaled(y), scaled(z)];
        // The terms of the entries are twice these products, in units of 2^-59.
        let [xx, yy, zz] = [times(x, by_x), times(y, by_y), times(z, by_z)];
        let [xy, xz, yz] = [times(x, by_y), times(x, by_z), times(y, by_z)];
        let [wx, wy, wz] = [times(w, by_x), times(w, by_y), times(w, by_z)];
        let rounded = |half: i64| ((half + (1 << 27)) >> 28) as i32;
        let one_less = |a: i64, b: i64| rounded((1 << 58) - a - b);
        let mut turn = Self::from_rotation_rows([
            [one_less(yy, zz), rounded(xy - wz), rounded(xz + wy)],
            [rounded(xy + wz), one_less(xx, zz), rounded(yz - wx)],
            [rounded(xz - wy), rounded(yz + wx), one_less(xx, yy)],
        ]);
        let entries = turn.linear.as_flattened_mut();
        // A mantissa has 30 bits.
        if entries
            .iter()
            .all(|entry| (1 - (1 << 30)..1 << 30).contains(entry))
        {
            turn.linear_exp = 30;
        } else {
            for entry in entries {
                *entry = (*entry + 1) >> 1;
            }
        }
        Ok(turn)
    }
}

/// Multiplies by a factor, given as its whole part and its fraction in units of 2^-8. The product is exact to 2^8.
#[inline]
fn times(part: i32, (whole, fraction): (i32, i32)) -> i64 {
    product(part, whole) + i64::from((part >> 8) * fraction)
}

/// Returns 2^92 / `norm`, the whole part and the fraction in units of 2^-8, for a norm from 2^61 to 2^62. The error is
/// at most 2 units of the fraction.
#[inline]
fn inverse(norm: i64) -> (i32, i32) {
    let (upper, lower) = ((norm >> 31) as i32, norm as i32 & i32::MAX);
    let whole = reciprocal(upper.cast_unsigned()).cast_signed();
    // The remainder 2^92 - whole · norm, in units of 2^31. The product whole · upper is at most 2^61, and below it by at
    // most upper. The fraction is remainder / upper, and needs only the upper halves of these numbers.
    let half = whole >> 16;
    let left = whole.wrapping_mul(upper).wrapping_neg() - ((half * (lower >> 16)) << 1);
    let fraction = ((left >> 16) * half) >> 21;
    (whole + (fraction >> 8), fraction & 0xff)
}

/// The rotation of a quaternion of any length, as [`from_quaternion`](Transform::from_quaternion) makes it. Firmware that
/// fuses the readings of a motion sensor can compute the quaternion with the crate [`micromath`].
///
/// The floats are converted exactly, by their bits: no float routine is linked.
///
/// # Errors
///
/// [`Error::NotFinite`] if a part is infinite or not a number; [`Error::ZeroQuaternion`] if all four parts are zero.
///
/// ```
/// use fixel::prelude::*;
/// use micromath::{Quaternion, vector::F32x3};
/// // A turn by 90 degrees about y.
/// let axis = F32x3 { x: 0.0, y: 1.0, z: 0.0 };
/// let turn = Transform::try_from(Quaternion::axis_angle(axis, core::f32::consts::FRAC_PI_2))?;
/// let ahead = turn.point(Vec3::Z);
/// assert!(ahead.distance(Vec3::X) < fx!(0.01)); // micromath's sine has errors of 1e-3
/// # Ok::<(), Error>(())
/// ```
impl TryFrom<Quaternion> for Transform {
    type Error = Error;

    fn try_from(quaternion: Quaternion) -> Result<Self, Error> {
        let (w, x, y, z) = quaternion.into();
        let mut parts = [x, y, z, w].map(|_| 0);
        let floats = [Parts::of(x)?, Parts::of(y)?, Parts::of(z)?, Parts::of(w)?];
        // The quaternion may have any unit: the largest part takes 30 bits.
        let most = floats
            .iter()
            .fold(1, |most, float| float.exponent.max(most));
        let mut size = 0;
        for (part, float) in parts.iter_mut().zip(&floats) {
            let down = (most - float.exponent).cast_unsigned().min(31);
            let magnitude = ((float.mantissa << 7 >> down) + 1) >> 1;
            size |= magnitude;
            *part = magnitude.cast_signed();
            if float.is_negative {
                *part = -*part;
            }
        }
        // The largest float has no top bit if it is below 2^-126.
        while size != 0 && size >> 29 == 0 {
            size <<= 1;
            parts = parts.map(|part| part << 1);
        }
        Self::of_quaternion(parts)
    }
}

/// Sine, minus sine and cosine, each rounded to units of 2^-29.
const fn sin_cos_29(angle: Angle) -> [i32; 3] {
    let (sin, cos) = angle.sin_cos();
    let (sin, cos) = (sin.to_bits(), cos.to_bits());
    [(sin + 1) >> 1, (1 - sin) >> 1, (cos + 1) >> 1]
}

#[cfg(test)]
mod tests {
    use super::super::tests::{Real, errors, multiply, power, real};
    use super::*;
    use crate::random::{cases, number};
    use core::f64::consts::TAU;
    use rand::Rng;

    /// The rotation by a quaternion of any length.
    fn rotation(quaternion: [i32; 4]) -> Real {
        let [x, y, z, w] = quaternion.map(f64::from);
        let norm = x * x + y * y + z * z + w * w;
        let rows = [
            [
                norm - 2.0 * (y * y + z * z),
                2.0 * (x * y - w * z),
                2.0 * (x * z + w * y),
            ],
            [
                2.0 * (x * y + w * z),
                norm - 2.0 * (x * x + z * z),
                2.0 * (y * z - w * x),
            ],
            [
                2.0 * (x * z - w * y),
                2.0 * (y * z + w * x),
                norm - 2.0 * (x * x + y * y),
            ],
        ];
        rows.map(|row| [row[0] / norm, row[1] / norm, row[2] / norm, 0.0])
    }

    /// The rotation about axis 0, 1 or 2, from the next axis toward the axis after that.
    fn about(axis: usize, angle: u32) -> Real {
        let (sin, cos) = (f64::from(angle) / power(32) * TAU).sin_cos();
        let mut m = [[0.0; 4]; 3];
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        m[axis][axis] = 1.0;
        (m[next][next], m[last][last]) = (cos, cos);
        (m[next][last], m[last][next]) = (-sin, sin);
        m
    }

    #[test]
    fn quaternions_are_good_to_27_bits() {
        cases(256, |random| {
            let quaternion = [(); 4].map(|()| number(random));
            match Transform::from_quaternion(quaternion.map(Scalar::from_bits)) {
                Err(error) => {
                    assert_eq!(error, Error::ZeroQuaternion);
                    assert_eq!(quaternion, [0; 4]);
                }
                Ok(t) => {
                    // Rounding the parts to 30 bits moves the quaternion by up to 2^-29 of its length, and entries by
                    // twice as much. The terms add 2^-33, and rounding the entries adds 1.5 · 2^-30.
                    let [linear, moved] = errors(&real(&t), &rotation(quaternion));
                    assert!(
                        linear <= power(-28) + 1.5 * power(-30) + power(-33),
                        "{linear:e}"
                    );
                    assert!(moved <= 0.0);
                }
            }
        });
    }

    /// Without the rounding of the parts, only the rounding of the entries is left. The parts are 30 bits themselves.
    #[test]
    fn quaternions_of_30_bits_are_rounded_twice_at_most() {
        cases(1024, |random| {
            let size = random.random_range(0..30);
            let mut parts =
                [(); 4].map(|()| random.random_range(-(1_i32 << 30) + 1..1 << 30) >> size);
            parts[random.random_range(0..4)] = random.random_range(1 << 29..1 << 30);
            let t = Transform::of_quaternion(parts).unwrap();
            let [linear, _] = errors(&real(&t), &rotation(parts));
            // An entry of 1 makes the last bit 2^-29.
            let rounding = if t.linear_exp == 29 { 1.5 } else { 0.5 };
            assert!(
                linear <= rounding * power(-30) + power(-33),
                "{parts:?}: {linear:e}"
            );
        });
    }

    #[test]
    fn inverses_are_exact_to_two_units() {
        cases(1024, |random| {
            let ends = [1 << 61, (1 << 61) + 1, (1 << 62) - 1];
            let norm = match random.random_range(0..8) {
                end @ 0..3 => ends[end],
                _ => random.random_range(1_i64 << 61..1 << 62),
            };
            let (whole, fraction) = inverse(norm);
            let found = i128::from(whole) << 8 | i128::from(fraction);
            assert!((0..256).contains(&fraction));
            let exact = (1_i128 << 100) / i128::from(norm);
            assert!((found - exact).abs() <= 2, "{norm}: {found} {exact}");
        });
    }

    #[test]
    fn euler_angles_turn_about_y_then_x_then_z() {
        cases(256, |random| {
            let angles = random.random::<[u32; 3]>();
            let [yaw, pitch, roll] = angles.map(Angle::from_bits);
            let t = Transform::from_euler(yaw, pitch, roll);
            let expected = multiply(
                &multiply(&about(1, angles[0]), &about(0, angles[1])),
                &about(2, angles[2]),
            );
            // The entries of the three factors have errors of up to 2.6e-9. Each error is multiplied by a row and by a
            // column of other rotations, with sums of at most √3 each. Two products are rounded to 2^-30.
            let [linear, _] = errors(&real(&t), &expected);
            assert!(linear <= 9.0 * 2.6e-9 + 2.0 * power(-30), "{linear:e}");
        });
    }

    /// A float of 24 bits is exact at every exponent, so the rotations are equal to the last bit.
    #[test]
    #[allow(clippy::cast_precision_loss)] // 24 bits
    fn quaternions_of_floats_are_those_of_integers_at_any_magnitude() {
        cases(256, |random| {
            let parts: [i32; 4] = [(); 4].map(|()| random.random::<i32>() >> 8);
            let exact = Transform::from_quaternion(parts.map(Scalar::from_bits));
            for exponent in [-120_i8, -40, 0, 100] {
                let unit = f32::exp2(exponent.into());
                let [x, y, z, w] = parts.map(|part| part as f32 * unit);
                let found = Transform::try_from(Quaternion::new(w, x, y, z));
                assert_eq!(found, exact, "{parts:?} times 2^{exponent}");
            }
        });
        // The least float, which has no leading bit.
        let least = Quaternion::new(0., f32::from_bits(1), 0., -f32::from_bits(1));
        let expected = Transform::from_quaternion([1, 0, -1, 0].map(Scalar::from_bits));
        assert_eq!(Transform::try_from(least), expected);
        // A part with a leading bit, and half of it, which has none.
        let [one, half] = [1 << 23, 1 << 22].map(f32::from_bits);
        let expected = Transform::from_quaternion([0, 1, 0, 2].map(Scalar::from_bits));
        let mixed = Quaternion::new(one, 0., half, 0.);
        assert_eq!(Transform::try_from(mixed), expected);
        for bad in [f32::NAN, f32::INFINITY] {
            let refused = Transform::try_from(Quaternion::new(1., 0., bad, 0.));
            assert_eq!(refused, Err(Error::NotFinite));
        }
        let refused = Transform::try_from(Quaternion::new(0., 0., 0., 0.));
        assert_eq!(refused, Err(Error::ZeroQuaternion));
    }

    #[test]
    fn quaternions_of_quarter_turns_are_exact() {
        for size in [1, -1, 3, 46_341, (1 << 30) - 1, i32::MAX, i32::MIN] {
            let from = |q: [i32; 4]| Transform::from_quaternion(q.map(Scalar::from_bits)).unwrap();
            assert_eq!(from([0, 0, 0, size]), Transform::IDENTITY, "{size}");
            let half = Transform::rotate_x(Angle::HALF);
            assert_eq!(from([size, 0, 0, 0]), half, "{size}");
            let quarter = Transform::rotate_y(Angle::QUARTER);
            assert_eq!(from([0, size, 0, size]), quarter, "{size}");
            let third = Transform::rotate(Vec3::from_ints(1, 1, 1), Angle::from_degrees(120));
            let found = from([size; 4]);
            assert_eq!(
                third.map(|t| t.point(Vec3::X)),
                Ok(found.point(Vec3::X)),
                "{size}"
            );
        }
    }
}
