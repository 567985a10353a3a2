//! Time of a scene: from rotations a minute to an angle.

use crate::Angle;

/// A speed of rotation.
///
/// In thousandths of a turn a minute; hertz are turns a second. Negative turns clockwise.
///
/// ```
/// use fixel::{Angle, Rate};
/// let rate = Rate::rpm(10);
/// assert_eq!(rate.angle_at(1_500), Angle::from_degrees(90));
/// // After 30 days, still to the last bit.
/// assert_eq!(rate.angle_at(30 * 24 * 3_600_000 + 1_500), Angle::from_degrees(90));
/// // f(t) = sin(2πt), once a second.
/// assert_eq!(Rate::hertz(1).angle_at(250).sin(), fixel::Unit::ONE);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rate {
    /// In units of 1/1000 turn a minute.
    milli_rpm: i64,
}

/// Thousandths of a turn a minute, times milliseconds, in one turn.
const TURN: u32 = 60_000_000;

impl Rate {
    /// So many turns a minute.
    #[must_use]
    pub const fn rpm(turns: i32) -> Self {
        Self {
            milli_rpm: turns as i64 * 1_000,
        }
    }

    /// So many thousandths of a turn a minute.
    ///
    /// ```
    /// use fixel::{Angle, Rate};
    /// // A record player: 33⅓, within a hundred-thousandth.
    /// assert_eq!(Rate::milli_rpm(33_333).angle_at(60_000_000), Angle::ZERO);
    /// ```
    #[must_use]
    pub const fn milli_rpm(thousandths: i32) -> Self {
        Self {
            milli_rpm: thousandths as i64,
        }
    }

    /// So many turns a second.
    #[must_use]
    pub const fn hertz(turns: i32) -> Self {
        Self {
            milli_rpm: turns as i64 * 60_000,
        }
    }

    /// So many thousandths of a turn a second.
    #[must_use]
    pub const fn millihertz(thousandths: i32) -> Self {
        Self {
            milli_rpm: thousandths as i64 * 60,
        }
    }

    /// The angle turned through in `ms` milliseconds, from 0 on.
    ///
    /// Exact for any time whatever: whole turns drop out before the one rounding, down to a
    /// multiple of 2⁻³² of a turn.
    #[must_use]
    pub const fn angle_at(self, ms: u64) -> Angle {
        angle(self.phase(ms))
    }

    /// A turning thing that is moved on frame by frame, by the time since the last.
    #[must_use]
    pub const fn spin(self) -> Spin {
        Spin {
            rate: self,
            phase: 0,
        }
    }

    /// The fraction of a turn after `ms` milliseconds, in units of 1/[`TURN`]: exact.
    const fn phase(self, ms: u64) -> u32 {
        // Both factors may be reduced by whole turns first; each is then below 2^26.
        let speed = rest(self.milli_rpm.unsigned_abs());
        let phase = rest(speed as u64 * rest(ms) as u64);
        if self.milli_rpm < 0 && phase > 0 {
            TURN - phase
        } else {
            phase
        }
    }
}

/// `high` · 2^32 + `low` divided by [`TURN`], and what is left over; `high` is below it.
///
/// Bit by bit, as it is done once a frame: the code of a 64-bit division would cost more flash than
/// its speed is worth.
const fn divide(high: u32, low: u32) -> (u32, u32) {
    let (mut quotient, mut rest) = (low, high);
    let mut bit = 0;
    while bit < u32::BITS {
        // Below 2^27.
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

/// What is left over of `value` when whole turns are dropped.
const fn rest(value: u64) -> u32 {
    let (high, low) = ((value >> 32) as u32, value as u32);
    divide(high % TURN, low).1
}

/// The angle of a fraction of a turn, in units of 1/[`TURN`].
const fn angle(phase: u32) -> Angle {
    Angle::from_bits(divide(phase, 0).0)
}

/// An angle that turns at a [`Rate`] and is moved on by the time between frames.
///
/// What a frame's angle loses in rounding is carried to the next: however the time is cut into
/// frames, the angle is that of [`Rate::angle_at`] to the last bit.
///
/// ```
/// use fixel::Rate;
/// let rate = Rate::rpm(7);
/// let mut spin = rate.spin();
/// for frame_ms in [16, 17, 33, 16, 1, 250] {
///     spin.advance(frame_ms);
/// }
/// assert_eq!(spin.angle(), rate.angle_at(333));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Spin {
    rate: Rate,
    /// Fraction of a turn, in units of 1/[`TURN`].
    phase: u32,
}

impl Spin {
    /// Moves on by `ms` milliseconds; gives the new angle.
    pub const fn advance(&mut self, ms: u64) -> Angle {
        self.phase = (self.phase + self.rate.phase(ms)) % TURN;
        self.angle()
    }

    /// The angle now.
    #[must_use]
    pub const fn angle(&self) -> Angle {
        angle(self.phase)
    }

    /// Turns at another rate from now on, from the angle that has been reached.
    pub const fn set_rate(&mut self, rate: Rate) {
        self.rate = rate;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The bits of the angle of milli · ms / 60,000,000 turns, in integers without bounds that
    /// matter.
    fn exact(milli: i32, ms: u64) -> u32 {
        let turns = i128::from(milli) * i128::from(ms);
        let bits = (turns.rem_euclid(60_000_000) << 32) / 60_000_000;
        u32::try_from(bits).unwrap()
    }

    #[test]
    fn rates_are_what_they_say() {
        assert_eq!(Rate::rpm(60), Rate::hertz(1));
        assert_eq!(Rate::milli_rpm(60_000), Rate::millihertz(1_000));
        assert_eq!(Rate::rpm(1).angle_at(15_000), Angle::QUARTER);
        assert_eq!(Rate::rpm(-1).angle_at(15_000), -Angle::QUARTER);
        assert_eq!(Rate::hertz(i32::MIN).angle_at(u64::MAX).to_bits(), {
            let turns = i128::from(i32::MIN) * i128::from(u64::MAX);
            u32::try_from((turns.rem_euclid(1_000) << 32) / 1_000).unwrap()
        });
    }

    proptest! {
        #[test]
        fn angles_are_exact_for_ever(milli in any::<i32>(), ms in any::<u64>()) {
            prop_assert_eq!(Rate::milli_rpm(milli).angle_at(ms).to_bits(), exact(milli, ms));
        }

        #[test]
        fn frames_do_not_drift(
            milli in any::<i32>(),
            frames in proptest::collection::vec(
                prop_oneof![0_u64..100, any::<u32>().prop_map(u64::from)],
                0..200,
            ),
        ) {
            let rate = Rate::milli_rpm(milli);
            let mut spin = rate.spin();
            let mut now = 0;
            for ms in frames {
                now += ms;
                prop_assert_eq!(spin.advance(ms), rate.angle_at(now));
            }
        }
    }
}
