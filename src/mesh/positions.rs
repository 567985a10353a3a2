//! A mesh's positions, of 32 or of 16 bits.

use super::Index;
use crate::{Error, Vec3};

/// The positions of a mesh, of 32 bits a component or of 16.
///
/// Those of 16 bits, [`Mesh::short`](crate::Mesh::short), take half the flash: 6 bytes in place of 12. Each component is a
/// whole number of 2^-`fraction`, and so a [`Scalar`](crate::Scalar) without loss; what such a mesh draws is, bit for bit,
/// what one of these `Scalar`s draws.
///
/// ```
/// use fixel::prelude::*;
/// static BALL: Mesh = shape!(sphere(8, 6));
/// let top = BALL.positions().get(0);
/// assert_eq!(top, Some(vec3!(0, 1, 0)));
/// assert!(BALL.positions().iter().all(|p| p.y <= 1));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Positions<'a> {
    list: List<'a>,
}

#[derive(Clone, Copy, Debug)]
enum List<'a> {
    Long(&'a [Vec3]),
    Short {
        positions: &'a [[i16; 3]],
        /// How far up a component is shifted to be one of 16 fraction bits.
        up: u32,
    },
}

/// Fraction bits of a `Scalar`.
const FRACTION: u32 = 16;

impl<'a> Positions<'a> {
    pub(crate) const fn long(positions: &'a [Vec3]) -> Self {
        Self {
            list: List::Long(positions),
        }
    }

    /// Of one point.
    pub(crate) const fn of_one(point: &'a Vec3) -> Self {
        Self::long(core::slice::from_ref(point))
    }

    /// Those in units of 2^-`fraction`.
    pub(crate) const fn short(positions: &'a [[i16; 3]], fraction: u32) -> Result<Self, Error> {
        if fraction > FRACTION {
            return Err(Error::Parts {
                of: "fraction bits",
                given: fraction,
                min: 0,
                max: FRACTION,
            });
        }
        let up = FRACTION - fraction;
        Ok(Self {
            list: List::Short { positions, up },
        })
    }

    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self.list {
            List::Long(positions) => positions.len(),
            List::Short { positions, .. } => positions.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// One of them.
    #[must_use]
    pub const fn get(&self, index: usize) -> Option<Vec3> {
        if index >= self.len() {
            return None;
        }
        Some(match self.list {
            List::Long(positions) => positions[index],
            List::Short { positions, up } => {
                let [x, y, z] = positions[index];
                Vec3::from_bits([(x as i32) << up, (y as i32) << up, (z as i32) << up])
            }
        })
    }

    /// All of them, in order.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Vec3> + use<'a> {
        let all = *self;
        // None is left out: each index is of one.
        (0..all.len()).map(move |index| all.get(index).unwrap_or_default())
    }

    /// Whether they are of 16 bits.
    #[inline]
    pub(crate) const fn are_short(&self) -> bool {
        matches!(self.list, List::Short { .. })
    }

    /// One of them as it is transformed; the origin for an index that no checked list holds.
    #[inline]
    pub(crate) fn place(&self, index: Index) -> Place<'a> {
        let index = usize::from(index);
        match self.list {
            List::Long(positions) => Place::Long(positions.get(index).unwrap_or(&Vec3::ZERO)),
            List::Short { positions, up } => Place::Short {
                position: *positions.get(index).unwrap_or(&[0; 3]),
                up,
            },
        }
    }

    /// One of them; the origin for an index that no checked list holds.
    #[inline(never)]
    pub(crate) fn at(&self, index: Index) -> Vec3 {
        Vec3::from_bits(self.place(index).to_bits())
    }
}

impl Eq for Positions<'_> {}

impl PartialEq for Positions<'_> {
    /// Whether they are the same points.
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

/// A position on its way to be transformed.
#[derive(Clone, Copy)]
pub(crate) enum Place<'a> {
    Long(&'a Vec3),
    Short { position: [i16; 3], up: u32 },
}

impl Place<'_> {
    /// In units of 2^-16.
    #[inline]
    pub(crate) fn to_bits(self) -> [i32; 3] {
        match self {
            Self::Long(position) => position.to_bits(),
            // Sixteen bits, by up to sixteen.
            Self::Short { position, up } => position.map(|x| i32::from(x) << (up & 31)),
        }
    }
}

/// The most fraction bits, up to 16, with which every component fits into 16 bits; 0 also if one does not fit without any,
/// being 32767.5 or more.
pub(crate) const fn finest(positions: Positions<'_>) -> u32 {
    let mut fraction = FRACTION;
    let mut at = 0;
    while let Some(position) = positions.get(at) {
        let [x, y, z] = position.to_bits();
        while fraction > 0 && !(fits(x, fraction) && fits(y, fraction) && fits(z, fraction)) {
            fraction -= 1;
        }
        at += 1;
    }
    fraction
}

/// A component in units of 2^-`fraction`, to the nearest.
const fn units(bits: i32, fraction: u32) -> i64 {
    let down = FRACTION - fraction;
    // Half a unit is added to twice as many.
    (bits as i64 * 2 + (1 << down)) >> (down + 1)
}

const fn fits(bits: i32, fraction: u32) -> bool {
    let units = units(bits, fraction);
    units == units as i16 as i64
}

/// The nearest that 16 bits hold.
pub(crate) const fn rounded(bits: i32, fraction: u32) -> i16 {
    let units = units(bits, fraction);
    if units > i16::MAX as i64 {
        i16::MAX
    } else {
        // None is below the least.
        units as i16
    }
}
