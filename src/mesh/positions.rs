//! A mesh's positions, with 32-bit or 16-bit components.

use core::hash::{Hash, Hasher};

use super::Bounds;
use super::index::Index;
use crate::error::{Error, check_count, check_length, ok};
use crate::math::Vec3;

/// The positions of a mesh, with 32-bit or 16-bit components; [`Mesh::positions`](crate::Mesh::positions) returns
/// them.
///
/// The 16-bit positions of [`Mesh::quantized`](crate::Mesh::quantized) take half the flash: 6 bytes instead of 12. Each
/// component is a whole number of units of 2^-`fraction`, with at most 16 fraction bits, so a [`Scalar`](crate::Scalar)
/// holds it exactly. A mesh of 16-bit positions draws the same pixels, bit for bit, as a mesh of `Scalar`s with the
/// same values.
///
/// ```
/// use fixel::prelude::*;
/// static BALL: Mesh = shape!(sphere(8, 6));
/// let top = BALL.positions().get(0);
/// assert_eq!(top, Some(vec3!(0, 1, 0)));
/// assert!(BALL.positions().iter().all(|p| p.y <= fx!(1)));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Positions<'a> {
    list: List<'a>,
    /// A box around all positions, if it is known.
    #[cfg(not(for_size))]
    bounds: Option<Bounds>,
}

/// The positions alone.
#[derive(Clone, Copy, Debug)]
pub(crate) enum List<'a> {
    Long(&'a [Vec3]),
    Short {
        positions: &'a [[i16; 3]],
        /// The left shift that turns a component into the bits of a `Scalar`.
        up: u32,
    },
}

impl<'a> List<'a> {
    /// The position at an index, in its stored format; the origin if the index is out of range, which cannot happen
    /// with a checked list.
    #[inline]
    pub(crate) fn stored(&self, index: Index) -> StoredPosition<'a> {
        let index = usize::from(index);
        match *self {
            Self::Long(positions) => {
                StoredPosition::Long(positions.get(index).unwrap_or(&Vec3::ZERO))
            }
            Self::Short { positions, up } => StoredPosition::Short {
                position: *positions.get(index).unwrap_or(&[0; 3]),
                up,
            },
        }
    }
}

/// Fraction bits of a `Scalar`.
const FRACTION: u32 = 16;

impl<'a> Positions<'a> {
    /// Positions with 32-bit components.
    #[doc(hidden)]
    #[must_use]
    pub const fn long(positions: &'a [Vec3]) -> Self {
        Self::of(List::Long(positions))
    }

    const fn of(list: List<'a>) -> Self {
        Self {
            list,
            #[cfg(not(for_size))]
            bounds: None,
        }
    }

    /// These positions with a box around them, which is kept unless the program is optimized for size.
    #[cfg_attr(for_size, allow(unused_mut, unused_variables))]
    pub(super) const fn with_bounds(mut self, bounds: Bounds) -> Self {
        #[cfg(not(for_size))]
        {
            self.bounds = Some(bounds);
        }
        self
    }

    /// The box around all positions, if it is known; never in a program that is optimized for size.
    #[inline]
    pub(crate) const fn known_bounds(&self) -> Option<&Bounds> {
        #[cfg(for_size)]
        return None;
        #[cfg(not(for_size))]
        self.bounds.as_ref()
    }

    /// A single point.
    pub(crate) const fn of_one(point: &'a Vec3) -> Self {
        Self::long(core::slice::from_ref(point))
    }

    /// Positions in units of 2^-`fraction`.
    #[doc(hidden)]
    pub const fn quantized(positions: &'a [[i16; 3]], fraction: u32) -> Result<Self, Error> {
        ok!(check_count(
            "fraction bits",
            fraction as usize,
            [0, FRACTION as usize]
        ));
        let up = FRACTION - fraction;
        Ok(Self::of(List::Short { positions, up }))
    }

    /// The number of positions.
    #[must_use]
    pub const fn len(&self) -> usize {
        match self.list {
            List::Long(positions) => positions.len(),
            List::Short { positions, .. } => positions.len(),
        }
    }

    /// Whether there are no positions.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The position at an index; `None` past the end.
    #[must_use]
    pub const fn get(&self, index: usize) -> Option<Vec3> {
        if index >= self.len() {
            return None;
        }
        Some(Vec3::from_bits(self.bits(index as Index)))
    }

    /// All positions, in order.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Vec3> + use<'a> {
        let all = *self;
        // Every index is in range, so the default is never used.
        (0..all.len()).map(move |index| all.get(index).unwrap_or_default())
    }

    /// The positions alone.
    #[inline]
    pub(crate) const fn list(self) -> List<'a> {
        self.list
    }

    /// The bits of the position at an index in range. The function makes few calls, because calls take much of the
    /// compiler's time.
    pub(super) const fn bits(&self, index: Index) -> [i32; 3] {
        match self.list {
            List::Long(positions) => positions[index as usize].to_bits(),
            List::Short { positions, up } => {
                let [x, y, z] = positions[index as usize];
                [(x as i32) << up, (y as i32) << up, (z as i32) << up]
            }
        }
    }

    /// The position at an index; the origin if the index is out of range, which cannot happen with a checked list.
    #[inline(never)]
    pub(crate) fn at(&self, index: Index) -> Vec3 {
        Vec3::from_bits(self.list.stored(index).to_bits())
    }

    /// See [`Mesh::quantized_positions`](crate::Mesh::quantized_positions).
    pub(super) const fn quantized_positions<const N: usize>(
        &self,
    ) -> Result<([[i16; 3]; N], u32), Error> {
        ok!(check_length("positions", N, self.len()));
        let fraction = finest(*self);
        let mut short = [[0; 3]; N];
        let mut at = 0;
        while let Some(position) = self.get(at) {
            let [x, y, z] = position.to_bits();
            short[at] = [
                rounded(x, fraction),
                rounded(y, fraction),
                rounded(z, fraction),
            ];
            at += 1;
        }
        Ok((short, fraction))
    }
}

impl Eq for Positions<'_> {}

impl PartialEq for Positions<'_> {
    /// Whether both lists contain the same points in the same order.
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

impl Hash for Positions<'_> {
    /// Hashes the points, because equality does not depend on how many bits they have.
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_usize(self.len());
        self.iter().for_each(|position| position.hash(state));
    }
}

/// A position about to be transformed, still in its stored format.
#[derive(Clone, Copy)]
pub(crate) enum StoredPosition<'a> {
    Long(&'a Vec3),
    Short { position: [i16; 3], up: u32 },
}

impl StoredPosition<'_> {
    /// The position in units of 2^-16.
    #[inline]
    pub(crate) fn to_bits(self) -> [i32; 3] {
        match self {
            Self::Long(position) => position.to_bits(),
            // The shifted component fits into 32 bits, because it has 16 bits and is shifted by at most 16.
            Self::Short { position, up } => position.map(|x| i32::from(x) << (up & 31)),
        }
    }
}

/// The greatest number of fraction bits, up to 16, with which every component fits into 16 bits. If a component is
/// 32767.5 or more, no number of fraction bits is small enough, and the result is 0.
const fn finest(positions: Positions<'_>) -> u32 {
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

/// A component in units of 2^-`fraction`, rounded to nearest.
const fn units(bits: i32, fraction: u32) -> i64 {
    let down = FRACTION - fraction;
    // Both terms are doubled, because half a unit may be half a bit.
    (bits as i64 * 2 + (1 << down)) >> (down + 1)
}

const fn fits(bits: i32, fraction: u32) -> bool {
    let units = units(bits, fraction);
    units == units as i16 as i64
}

/// The nearest number of units that fits into 16 bits.
const fn rounded(bits: i32, fraction: u32) -> i16 {
    let units = units(bits, fraction);
    if units > i16::MAX as i64 {
        i16::MAX
    } else {
        // Components are at least −32768, so no component lies below the range.
        units as i16
    }
}
