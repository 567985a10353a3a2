//! Angles.

use core::fmt;

use crate::Unit;

/// An angle as a fraction of a turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Angle(u32);

impl Angle {
    /// The angle of so many 2⁻³² of a turn.
    #[must_use]
    pub const fn from_bits(bits: u32) -> Self {
        Self(bits)
    }

    /// In units of 2⁻³² of a turn.
    #[must_use]
    pub const fn to_bits(self) -> u32 {
        self.0
    }

    /// The sine. (Stands in for the real one until branches meet.)
    #[must_use]
    #[allow(clippy::all, clippy::pedantic)]
    pub const fn sin(self) -> Unit {
        const SINE: [(i32, u32); 6] = [
            (1_686_629_713, 30),
            (-1_387_197_331, 31),
            (1_369_108_436, 34),
            (-643_440_516, 37),
            (704_746_150, 42),
            (-60_272_190, 44),
        ];
        const ONE: u32 = 1 << 30;
        let signed = self.0 as i32;
        let mut x = signed.unsigned_abs();
        if x > ONE {
            x = 2 * ONE - x;
        }
        let x = x as i64;
        let squared = (x * x + (1 << 29)) >> 30;
        let mut i = SINE.len() - 1;
        let mut sum = SINE[i].0 as i64;
        while i > 0 {
            let shift = SINE[i].1 + 30 - SINE[i - 1].1;
            i -= 1;
            sum = SINE[i].0 as i64 + ((sum * squared + (1 << (shift - 1))) >> shift);
        }
        let sine = ((sum * x + (1 << 29)) >> 30) as i32;
        Unit::from_bits(if signed < 0 { -sine } else { sine })
    }

    /// The cosine.
    #[must_use]
    pub const fn cos(self) -> Unit {
        Self(self.0.wrapping_add(1 << 30)).sin()
    }
}

impl fmt::Display for Angle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}
