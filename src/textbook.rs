//! Formulas of perspective as textbooks write them, for learning, tests and preparation.
//!
//! Drawing does not use this module, because it computes the same numbers in a faster way. A program that does not use
//! the module does not contain its code. [Mathematics](crate::guide::mathematics) derives the formulas.
//!
//! | formula | in the guide |
//! |---|---|
//! | [`Segment`]: depth, fractions and attributes along a segment in perspective | [a segment](crate::guide::mathematics::lines#a-segment) |
//! | [`perspective_transform`]: the part of a projection's matrix that makes distant things small | [a matrix](crate::guide::mathematics::projection#a-matrix) |
//! | [`speed`]: how fast the picture of a moving point moves | [lines](crate::guide::mathematics::lines) |
#![cfg_attr(doc, doc = include_str!("guide/tables.html"))]

use crate::math::{Matrix4, Vec3};
use crate::num::{Fraction, Scalar};

/// A segment in space, given by the distances of its two ends ahead of the eye.
///
#[cfg_attr(doc, doc = include_str!("guide/diagrams/foreshortening.svg"))]
///
/// A distance is −z in eye space, or the homogeneous coordinate w. If one end is farther away than the other, the
/// nearer half of the segment looks longer, so the middle of the picture does not show the middle of the segment. On
/// the screen, 1/w and a/w are linear for every attribute a, but w and a themselves are not.
/// [Mathematics](crate::guide::mathematics::lines#a-segment) derives the formulas below.
///
/// Fractions run from 0 at the start to 1 at the end. Results are rounded to nearest, half away from zero.
///
/// ```
/// use fixel::textbook::Segment;
/// use fixel::{fx, Fraction};
/// let segment = Segment::new(fx!(1), fx!(4)).unwrap();
/// let half = Fraction::ONE / 2;
/// assert_eq!(segment.distance(half), Some(fx!(1.6)));
/// assert_eq!(segment.in_space(half), Some(Fraction::ONE / 5));
/// assert_eq!(segment.on_screen(Fraction::ONE / 5), Some(half));
/// assert_eq!(segment.attribute(fx!(10), fx!(20), half), Some(fx!(12)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Segment {
    start: Scalar,
    end: Scalar,
}

const ONE: i128 = 1 << 30;

/// Divides, rounded to nearest (half away from zero); `None` unless the denominator is above zero and
/// the quotient fits in 32 bits.
fn divide(numerator: i128, denominator: i128) -> Option<i32> {
    if denominator <= 0 {
        return None;
    }
    let half = denominator / 2 * numerator.signum();
    i32::try_from((numerator + half) / denominator).ok()
}

fn bits(value: Scalar) -> i128 {
    value.to_bits().into()
}

impl Segment {
    /// Makes a segment from the distances of its ends; `None` unless both are above 0, ahead of the eye.
    #[must_use]
    pub const fn new(start: Scalar, end: Scalar) -> Option<Self> {
        if start.to_bits() > 0 && end.to_bits() > 0 {
            Some(Self { start, end })
        } else {
            None
        }
    }

    /// Returns the weights of the two ends at a fraction q of the picture: (1 − q)/w₀ and q/w₁, both
    /// times w₀·w₁·2^46.
    fn weights(self, on_screen: Fraction) -> (i128, i128) {
        let q = i128::from(on_screen.to_bits());
        ((ONE - q) * bits(self.end), q * bits(self.start))
    }

    /// Returns the distance w at a fraction q of the segment's picture: 1/w = 1/w₀ + q·(1/w₁ − 1/w₀), where w₀ and w₁
    /// are the distances of the start and the end.
    ///
    /// `None` if the distance is out of range, or if the line of sight does not meet the segment's line ahead of the
    /// eye. The second case happens only for fractions below 0 or above 1.
    #[must_use]
    pub fn distance(self, on_screen: Fraction) -> Option<Scalar> {
        let (a, b) = self.weights(on_screen);
        divide(bits(self.start) * bits(self.end) * ONE, a + b).map(Scalar::from_bits)
    }

    /// Converts q, a fraction of the way along the segment's picture, to t, the fraction of the way along the segment
    /// in space: t = q·w₀ / (w₁ − q·(w₁ − w₀)), where w₀ and w₁ are the distances of the start and the end.
    ///
    /// `None` if the fraction is out of range, or if the line of sight does not meet the segment's line ahead of the
    /// eye.
    #[must_use]
    pub fn in_space(self, on_screen: Fraction) -> Option<Fraction> {
        let (a, b) = self.weights(on_screen);
        divide(b * ONE, a + b).map(Fraction::from_bits)
    }

    /// Converts t, a fraction of the way along the segment in space, to q, the fraction of the way along the segment's
    /// picture: q = t·w₁ / (w₀ + t·(w₁ − w₀)), where w₀ and w₁ are the distances of the start and the end.
    ///
    /// `None` if the point is not ahead of the eye, or if q is out of range.
    #[must_use]
    pub fn on_screen(self, in_space: Fraction) -> Option<Fraction> {
        // The inverse is the same formula with the distances exchanged.
        let swapped = Self {
            start: self.end,
            end: self.start,
        };
        swapped.in_space(in_space)
    }

    /// Interpolates an attribute that is `a` at the start and `b` at the end, at a fraction q of the segment's picture:
    /// lerp(a/w₀, b/w₁, q) / lerp(1/w₀, 1/w₁, q), where w₀ and w₁ are the distances of the start and the end.
    ///
    /// `None` if the result is out of range, or if the line of sight does not meet the segment's line ahead of the eye.
    #[must_use]
    pub fn attribute(self, a: Scalar, b: Scalar, on_screen: Fraction) -> Option<Scalar> {
        let (at_start, at_end) = self.weights(on_screen);
        divide(bits(a) * at_start + bits(b) * at_end, at_start + at_end).map(Scalar::from_bits)
    }
}

/// Returns how fast the picture of a moving point moves on the near plane, at time `t`.
///
/// At time t, the point is at `point` + t · `velocity` in eye space. The result is rounded to nearest (half away from
/// zero).
///
/// The x component is −n·(vₓ·Pz − Pₓ·vz) / (Pz + vz·t)², where n is `near`, P is `point`, and v is `velocity`. The y
/// component has y in place of x. `None` if the point is not ahead of the eye at time t, or if a component is out of
/// range.
///
/// ```
/// use fixel::textbook::speed;
/// use fixel::{fx, vec3, Vec3};
/// // A train on a track below the eye, on its way into the distance.
/// let (track, ahead) = (vec3!(0, -1, -1), -Vec3::Z);
/// assert_eq!(speed(fx!(1), track, ahead, fx!(0)), Some([fx!(0), fx!(1)]));
/// assert_eq!(speed(fx!(1), track, ahead, fx!(3)), Some([fx!(0), fx!(0.0625)]));
/// ```
#[must_use]
pub fn speed(near: Scalar, point: Vec3, velocity: Vec3, t: Scalar) -> Option<[Scalar; 2]> {
    // `z` is in units of 2^-32, and has at most 64 bits.
    let z = (bits(point.z) << 16) + bits(velocity.z) * bits(t);
    if z >= 0 {
        return None;
    }
    let part = |p: Scalar, v: Scalar| {
        // `top` is in units of 2^-48, and z² in units of 2^-64. A left shift by 32 bits makes the quotient a number of
        // units of 2^-16.
        let top = -bits(near) * (bits(v) * bits(point.z) - bits(p) * bits(velocity.z));
        // The magnitude of `top` is at most 2^94.
        divide(top << 32, z * z).map(Scalar::from_bits)
    };
    Some([part(point.x, velocity.x)?, part(point.y, velocity.y)?])
}

/// Returns the perspective transform onto the near plane, which maps (x, y, z) to (−n·x/z, −n·y/z, −(n + f) − n·f/z),
/// with n = `near` and f = `far`.
///
/// The transform maps a frustum to a box as wide and high as the frustum's window on the near plane; the near and far
/// planes stay at −n and −f. To get a projection's whole matrix, scale and move this box to the range from −1 to 1. The
/// product n·f is rounded to nearest; the product and the sum n + f saturate.
///
/// ```
/// use fixel::textbook::perspective_transform;
/// use fixel::{fx, vec3};
/// let transform = perspective_transform(fx!(2), fx!(10));
/// assert_eq!(transform.project(vec3!(1, 1, -5)), Some(vec3!(0.4, 0.4, -8))); // 12 − 20/5
/// ```
#[must_use]
pub fn perspective_transform(near: Scalar, far: Scalar) -> Matrix4 {
    let (zero, one) = (Scalar::ZERO, Scalar::ONE);
    Matrix4::new([
        [near, zero, zero, zero],
        [zero, near, zero, zero],
        [zero, zero, near + far, near * far],
        [zero, zero, -one, zero],
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use rand::Rng;

    #[test]
    fn no_input_panics() {
        cases(256, |random| {
            let w = random.random::<[i32; 2]>();
            let f = random.random::<i32>();
            let v = random.random::<[i32; 8]>();
            let s = Scalar::from_bits;
            if let Some(segment) = Segment::new(s(w[0]), s(w[1])) {
                let f = Fraction::from_bits(f);
                let _ = (
                    segment.distance(f),
                    segment.in_space(f),
                    segment.on_screen(f),
                );
                let _ = segment.attribute(s(v[0]), s(v[1]), f);
            }
            let velocity = Vec3::from_bits([v[3], v[4], v[5]]);
            let _ = speed(
                s(v[6]),
                Vec3::from_bits([v[0], v[1], v[2]]),
                velocity,
                s(v[7]),
            );
        });
    }

    /// The exact quotient is about 2^-33 of a unit below 1443359354.5 units.
    #[test]
    fn speed_is_rounded_once() {
        let point = Vec3::from_bits([-1_733_925_641, 0, -1_742_648_317]);
        let velocity = Vec3::from_bits([618_897_721, 0, -i32::MAX]);
        let found = speed(Scalar::MAX, point, velocity, Scalar::from_bits(28_391));
        assert_eq!(found.unwrap()[0].to_bits(), 1_443_359_354);
    }

    #[test]
    fn the_ends_of_the_formats_do_not_panic() {
        let far = Vec3::from_bits([i32::MIN; 3]);
        let mixed = Vec3::from_bits([i32::MAX, i32::MAX, i32::MIN]);
        for near in [Scalar::MAX, Scalar::MIN, Scalar::DELTA] {
            for t in [Scalar::MAX, Scalar::MIN, Scalar::ZERO] {
                let _ = (speed(near, far, mixed, t), speed(near, mixed, far, t));
            }
        }
        let s = Segment::new(Scalar::MAX, Scalar::DELTA).unwrap();
        for q in [Fraction::MIN, Fraction::MAX, Fraction::ONE, Fraction::ZERO] {
            let _ = (s.distance(q), s.in_space(q), s.on_screen(q));
            let _ = s.attribute(Scalar::MIN, Scalar::MAX, q);
        }
    }
}
