//! Speeds of rotation: from turns per minute and milliseconds to an angle.

use crate::num::Angle;

/// A speed of rotation.
///
/// The unit is a thousandth of a turn per minute. A negative rate turns clockwise.
///
/// ```
/// use fixel::{Angle, Rate};
/// let rate = Rate::rpm(10);
/// assert_eq!(rate.angle_at(1_500), Angle::from_degrees(90));
/// // Exact to the last bit, even after 30 days.
/// assert_eq!(rate.angle_at(30 * 24 * 3_600_000 + 1_500), Angle::from_degrees(90));
/// // One turn per second: sin(2πt).
/// assert_eq!(Rate::hertz(1).angle_at(250).sin(), fixel::Fraction::ONE);
/// ```
///
/// If the rate changes over time, add the angle by which each frame turns. Each angle is rounded down by less than 2⁻³²
/// of a turn, so the sum of a million angles is too small by less than a tenth of a degree.
///
/// ```
/// use fixel::{Angle, Rate, deg};
/// let mut angle = Angle::ZERO;
/// for (rate, frame_ms) in [(Rate::rpm(10), 1_500), (Rate::rpm(-5), 750)] {
///     angle += rate.angle_at(frame_ms);
/// }
/// assert_eq!(angle, deg!(67.5));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rate(i64);

/// One turn, in the unit of a rate times a time: a thousandth of a turn per minute times a millisecond.
const TURN: u32 = 60_000_000;

impl Rate {
    /// Makes a rate from turns per minute.
    #[must_use]
    pub const fn rpm(turns: i32) -> Self {
        Self(turns as i64 * 1_000)
    }

    /// Makes a rate from turns per second.
    #[must_use]
    pub const fn hertz(turns: i32) -> Self {
        Self(turns as i64 * 60_000)
    }

    /// Makes a rate from thousandths of a turn per second.
    #[must_use]
    pub const fn millihertz(thousandths: i32) -> Self {
        Self(thousandths as i64 * 60)
    }

    /// Returns the angle reached after `ms` milliseconds, starting from 0.
    ///
    /// The result is exact for any time, except that it is rounded down to a multiple of 2⁻³² of a turn. Whole turns
    /// are dropped.
    #[must_use]
    pub const fn angle_at(self, ms: u64) -> Angle {
        angle(self.phase(ms))
    }

    /// Returns the fraction of a turn after `ms` milliseconds, in units of 1/[`TURN`]; exact.
    const fn phase(self, ms: u64) -> u32 {
        // Whole turns are removed from both factors first: each factor is then below 2^26.
        let speed = rest(self.0.unsigned_abs());
        let phase = rest(speed as u64 * rest(ms) as u64);
        if self.0 < 0 && phase > 0 {
            TURN - phase
        } else {
            phase
        }
    }
}

/// Divides `high` · 2^32 + `low` by [`TURN`]; returns the quotient and the remainder.
///
/// `high` must be below `TURN`. The function divides bit by bit, because it runs once per frame, and a 64-bit division
/// routine would cost more flash than its speed is worth.
const fn divide(high: u32, low: u32) -> (u32, u32) {
    let (mut quotient, mut rest) = (low, high);
    let mut bit = 0;
    while bit < u32::BITS {
        // `rest` stays below 2^27.
        rest = rest << 1 | quotient >> 31;
        quotient <<= 1;
        if rest >= TURN {
            rest -= TURN;
            quotient |= 1;
        }
        bit += 1;
    }
    (quotient, rest)
}

/// Returns `value` modulo [`TURN`].
const fn rest(value: u64) -> u32 {
    let (high, low) = ((value >> 32) as u32, value as u32);
    divide(high % TURN, low).1
}

/// Converts a fraction of a turn, in units of 1/[`TURN`], to an angle; rounds down.
const fn angle(phase: u32) -> Angle {
    Angle::from_bits(divide(phase, 0).0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::Rng;

    use crate::random::{cases, list};

    /// The bits of an angle of milli · ms / 60,000,000 turns, computed in 128 bits.
    fn exact(milli: i32, ms: u64) -> u32 {
        let turns = i128::from(milli) * i128::from(ms);
        let bits = (turns.rem_euclid(60_000_000) << 32) / 60_000_000;
        u32::try_from(bits).unwrap()
    }

    #[test]
    fn units_of_rates_agree() {
        assert_eq!(Rate::rpm(60), Rate::hertz(1));
        assert_eq!(Rate::hertz(1), Rate::millihertz(1_000));
        assert_eq!(Rate::rpm(1).angle_at(15_000), Angle::QUARTER);
        assert_eq!(Rate::rpm(-1).angle_at(15_000), -Angle::QUARTER);
        assert_eq!(Rate::hertz(i32::MIN).angle_at(u64::MAX).to_bits(), {
            let turns = i128::from(i32::MIN) * i128::from(u64::MAX);
            u32::try_from((turns.rem_euclid(1_000) << 32) / 1_000).unwrap()
        });
    }

    #[test]
    fn angles_are_exact_at_any_time() {
        cases(256, |random| {
            let (milli, ms) = random.random();
            assert_eq!(
                Rate(i64::from(milli)).angle_at(ms).to_bits(),
                exact(milli, ms)
            );
        });
    }

    /// The sum of the angles of frames loses less than a unit of 2^-32 turn in each frame, and gains nothing.
    #[test]
    fn each_frame_of_a_sum_loses_less_than_a_unit() {
        cases(256, |random| {
            let rate = Rate(random.random::<i32>().into());
            let frames = list(random, 1..200, |random| {
                if random.random() {
                    random.random_range(0..100)
                } else {
                    random.random::<u32>().into()
                }
            });
            let (mut now, mut sum) = (0, Angle::ZERO);
            for (frame, ms) in frames.into_iter().enumerate() {
                now += ms;
                sum += rate.angle_at(ms);
                let lost = (rate.angle_at(now) - sum).to_bits();
                assert!(lost as usize <= frame, "{lost} in frame {frame}");
            }
        });
    }
}
