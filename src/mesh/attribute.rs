//! Attributes of a mesh: texture coordinates, normals and colors, in full precision or in 8 or 16 bits.

use core::hash::{Hash, Hasher};
use core::ops::Range;

use super::index::{Index, Indices};
use crate::math::{Vec2, Vec3};

/// The values of one attribute. Without `faces` of its own, an attribute is indexed like the positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Attribute<'a, T: Copy> {
    pub(super) values: Values<'a, T>,
    pub(super) faces: Option<&'a [[Index; 3]]>,
}

impl<'a, T: Copy> Attribute<'a, T> {
    pub(super) const NONE: Self = Self::of_lists((&[], &[]));

    /// Makes an attribute of lists that are known to fit the mesh. If the list of faces is empty, there is one value
    /// per position.
    pub(super) const fn of_lists((values, faces): (&'a [T], &'a [[Index; 3]])) -> Self {
        Self::of((Values::Full(values), faces))
    }

    /// Like [`of_lists`](Self::of_lists), for values that may have fewer bits.
    pub(super) const fn of((values, faces): (Values<'a, T>, &'a [[Index; 3]])) -> Self {
        let faces = if faces.is_empty() { None } else { Some(faces) };
        Self { values, faces }
    }

    /// The attribute for a range of the faces; the range must not reach beyond the last face.
    pub(super) fn part(&self, range: &Range<usize>) -> Self {
        Self {
            values: self.values,
            faces: self.faces.and_then(|faces| faces.get(range.clone())),
        }
    }

    /// The index of the value at `corner` (0, 1 or 2) of a primitive.
    #[inline]
    pub(super) fn index(&self, indices: Indices, corner: usize) -> Option<usize> {
        let indices = match self.faces {
            None => indices.corners,
            Some(faces) => *faces.get(indices.face()?)?,
        };
        Some(usize::from(*indices.get(corner)?))
    }

    /// The value at a corner of a primitive.
    #[inline]
    pub(super) fn at(&self, indices: Indices, corner: usize) -> Option<T> {
        self.values.get(self.index(indices, corner)?)
    }

    /// Like [`at`](Self::at), but for an attribute that always has full precision; this function takes less code.
    #[inline]
    pub(super) fn full_at(&self, indices: Indices, corner: usize) -> Option<T> {
        match self.values {
            Values::Full(values) => values.get(self.index(indices, corner)?).copied(),
            Values::Small(_) => None,
        }
    }
}

/// The values of an attribute, in full precision or in fewer bits.
#[derive(Clone, Copy, Debug)]
pub(super) enum Values<'a, T> {
    Full(&'a [T]),
    /// This variant holds a reference, so that it does not make every mesh larger.
    Small(&'a Small<'a, T>),
}

/// Values in fewer bits.
#[derive(Clone, Copy, Debug)]
pub struct Small<'a, T> {
    stored: Stored<'a>,
    len: usize,
    /// A function pointer, so that only programs with values in fewer bits contain the code that unpacks them.
    unpack: fn(&Stored<'_>, usize) -> Option<T>,
}

#[derive(Clone, Copy, Debug)]
enum Stored<'a> {
    Normals(&'a [[i8; 3]]),
    Bytes(&'a [[u8; 2]], UvGrid),
    Words(&'a [[u16; 2]], UvGrid),
}

impl<'a, T: Copy> Values<'a, T> {
    /// The values of a list in fewer bits; an empty list becomes an empty list in full precision.
    pub(super) const fn small(values: &'a Small<'a, T>) -> Self {
        match values.len {
            0 => Self::Full(&[]),
            _ => Self::Small(values),
        }
    }

    pub(super) const fn len(&self) -> usize {
        match self {
            Self::Full(values) => values.len(),
            Self::Small(values) => values.len,
        }
    }

    /// The value at an index; `None` past the end.
    #[inline]
    pub(super) fn get(&self, index: usize) -> Option<T> {
        match self {
            Self::Full(values) => values.get(index).copied(),
            Self::Small(values) => (values.unpack)(&values.stored, index),
        }
    }

    pub(super) fn iter(self) -> impl Iterator<Item = T> + use<'a, T> {
        (0..self.len()).map_while(move |index| self.get(index))
    }
}

impl<T: Copy + Eq> Eq for Values<'_, T> {}

impl<T: Copy + PartialEq> PartialEq for Values<'_, T> {
    /// Whether both lists contain the same values in the same order.
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

impl<T: Copy + Hash> Hash for Values<'_, T> {
    /// Hashes the values, because equality does not depend on how many bits they have.
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_usize(self.len());
        self.iter().for_each(|value| value.hash(state));
    }
}

impl<'a> Small<'a, Vec3> {
    /// A list of normals that [`normal_of_8`] made.
    #[must_use]
    pub const fn normals(normals: &'a [[i8; 3]]) -> Self {
        Self {
            stored: Stored::Normals(normals),
            len: normals.len(),
            unpack: |stored, index| match stored {
                Stored::Normals(normals) => {
                    let [x, y, z] = *normals.get(index)?;
                    let up = |x| i32::from(x) << UP;
                    Some(Vec3::from_bits([up(x), up(y), up(z)]))
                }
                _ => None,
            },
        }
    }
}

impl<'a> Small<'a, Vec2> {
    /// Texture coordinates in steps of a grid.
    #[must_use]
    pub const fn uvs_of_8(uvs: &'a [[u8; 2]], grid: UvGrid) -> Self {
        Self {
            stored: Stored::Bytes(uvs, grid),
            len: uvs.len(),
            unpack: |stored, index| match stored {
                Stored::Bytes(uvs, grid) => {
                    let [u, v] = *uvs.get(index)?;
                    Some(grid.uv([u.into(), v.into()]))
                }
                _ => None,
            },
        }
    }

    /// Texture coordinates in steps of a grid.
    #[must_use]
    pub const fn uvs_of_16(uvs: &'a [[u16; 2]], grid: UvGrid) -> Self {
        Self {
            stored: Stored::Words(uvs, grid),
            len: uvs.len(),
            unpack: |stored, index| match stored {
                Stored::Words(uvs, grid) => Some(grid.uv(*uvs.get(index)?)),
                _ => None,
            },
        }
    }
}

/// A grid of texture coordinates in equal steps, from the least coordinate to the greatest, along u and along v. Point
/// n is at `origin` + n · `step`, in units of 2⁻²⁰.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct UvGrid {
    origin: [i32; 2],
    step: [u32; 2],
}

impl UvGrid {
    /// The grid from the least to the greatest of these texture coordinates, with `most` steps along u and along v.
    #[must_use]
    pub const fn around(uvs: &[Vec2], most: u16) -> Self {
        let (mut origin, mut step) = ([0; 2], [0; 2]);
        let mut axis = 0;
        while axis < 2 && !uvs.is_empty() {
            let (mut low, mut high) = (i32::MAX, i32::MIN);
            let mut at = 0;
            while at < uvs.len() {
                let bits = uvs[at].to_bits()[axis];
                low = if bits < low { bits } else { low };
                high = if bits > high { bits } else { high };
                at += 1;
            }
            origin[axis] = low;
            step[axis] = high.abs_diff(low).div_ceil(most as u32);
            axis += 1;
        }
        Self { origin, step }
    }

    /// The nearest point of the grid, in steps.
    #[must_use]
    pub const fn nearest(&self, uv: Vec2) -> [u16; 2] {
        let mut steps = [0; 2];
        let mut axis = 0;
        while axis < 2 {
            let from_origin = uv.to_bits()[axis].abs_diff(self.origin[axis]);
            let step = self.step[axis];
            if step > 0 {
                // The cast loses nothing: `around` chose the step so that `most` steps, a `u16`, reach from the least
                // coordinate to the greatest, so the result is at most `most`.
                steps[axis] = ((from_origin as u64 + step as u64 / 2) / step as u64) as u16;
            }
            axis += 1;
        }
        steps
    }

    /// The texture coordinate at a point of the grid. (A step is rounded up by less than a unit of 2⁻²⁰. So the last
    /// point may lie beyond the greatest coordinate, by less than one unit for each step.)
    fn uv(&self, [u, v]: [u16; 2]) -> Vec2 {
        let bits = |axis: usize, steps: u16| {
            let beyond = u64::from(steps) * u64::from(self.step[axis]);
            let wide = i64::from(self.origin[axis]) + beyond.cast_signed();
            wide.min(i32::MAX.into()) as i32
        };
        Vec2::from_bits([bits(0, u), bits(1, v)])
    }
}

/// The magnitude of the largest component of a stored normal.
const LONGEST: i64 = 127;
/// The left shift from a stored component to the bits of a `Scalar`: 127 becomes 65,024, which is about 1.
const UP: u32 = 9;

/// A normal with 8 bits per component: the largest component becomes 127 or −127, and the others are rounded to
/// nearest, halves up.
#[must_use]
pub const fn normal_of_8(normal: Vec3) -> [i8; 3] {
    let bits = normal.to_bits();
    let mut most = 0;
    let mut axis = 0;
    while axis < 3 {
        let size = (bits[axis] as i64).abs();
        most = if size > most { size } else { most };
        axis += 1;
    }
    let mut short = [0; 3];
    let mut axis = 0;
    while axis < 3 && most > 0 {
        let twice = 2 * LONGEST * bits[axis] as i64 + most;
        short[axis] = twice.div_euclid(2 * most) as i8;
        axis += 1;
    }
    short
}
