//! A vertex on the screen.

use crate::mesh::Index;
use crate::num::wide::dot;

/// The least 1/w: smaller numbers are clamped to it. The rounding error in a span (at most 40 units) is below 1/32 of
/// this number, and the scales of varyings leave room for an error of 1/32.
///
/// The clamp changes only corners that are more than half a million times as far away as the nearest corner.
pub(crate) const LEAST_WEIGHT: u32 = 1 << 11;

/// The greatest 1/w: greater numbers are clamped to it. Rounding may add 40 units, and the sum stays below 2^31.
pub(crate) const MOST_WEIGHT: u32 = (1 << 31) - 64;

/// A vertex on the screen, or the clipping planes outside of which it lies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenVertex {
    /// Column and row in units of 1/256 pixel, from the frame's top left.
    pub(crate) screen: [i32; 2],
    /// The interpolant of depth, 31 bits: 1/w with its top bit set or, under a parallel projection, the depth itself.
    pub(crate) q: u32,
    /// 1/w is `q` · 2^`exponent` times a constant of the draw call. Under a parallel projection, the exponent is 0.
    pub(crate) exponent: u8,
    /// One bit for each plane outside of which the vertex lies. The other fields are valid only if the outcode is 0.
    pub(crate) outcode: u8,
    /// Index of the mesh's position; 0 for a vertex that clipping created.
    pub(crate) index: Index,
}

impl ScreenVertex {
    /// All bits 0: a vertex that is not projected yet.
    pub(crate) const UNSET: Self = Self {
        screen: [0; 2],
        q: 0,
        exponent: 0,
        outcode: 0,
        index: 0,
    };

    /// The screen positions of three vertices.
    // Destructured by hand, because a `map` over references compiles to arrays and loops if the optimization is for
    // size.
    #[inline]
    pub(crate) const fn screens([a, b, c]: [&Self; 3]) -> [[i32; 2]; 3] {
        [a.screen, b.screen, c.screen]
    }

    /// The `q` of three vertices, brought to one exponent, and this exponent.
    #[inline]
    pub(crate) fn weights([a, b, c]: [&Self; 3]) -> ([u32; 3], u8) {
        if a.exponent == b.exponent && b.exponent == c.exponent {
            return ([a.q, b.q, c.q], a.exponent);
        }
        let exponent = a.exponent.max(b.exponent).max(c.exponent);
        let shifted = |vertex: &Self| {
            let down = u32::from(exponent - vertex.exponent);
            (vertex.q >> down.min(31)).max(LEAST_WEIGHT)
        };
        ([shifted(a), shifted(b), shifted(c)], exponent)
    }
}

/// A point of a triangle: the barycentric weights of the second and the third corner, in units of 2⁻³⁰. The weight of
/// the first corner is 1 minus these two weights.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Barycentric(pub(crate) [i32; 2]);

impl Barycentric {
    /// The corners themselves.
    pub(crate) const CORNERS: [Self; 3] = [Self([0, 0]), Self([1 << 30, 0]), Self([0, 1 << 30])];

    /// The weights in the memory of a vertex, so that a list of vertices can hold them.
    #[inline]
    pub(crate) const fn stored(self) -> ScreenVertex {
        ScreenVertex {
            screen: self.0,
            ..ScreenVertex::UNSET
        }
    }

    /// The weights that were [`stored`](Self::stored).
    #[inline]
    pub(crate) const fn from_stored(vertex: &ScreenVertex) -> Self {
        Self(vertex.screen)
    }

    /// The value, at this point, of a varying that has these values at the corners. The result is rounded to the
    /// nearest unit. The weights are rounded, too.
    #[inline(never)]
    pub(crate) fn mix(self, values: &[i32; 3]) -> i32 {
        let [b, c] = self.0;
        // The weights add up to 2^30, and b and c add up to at most 2^30 plus a few units.
        let mixed = (dot(values, &[(1 << 30) - b - c, b, c]) + (1 << 29)) >> 30;
        mixed.clamp(i32::MIN.into(), i32::MAX.into()) as i32
    }
}

/// A corner of a clipped polygon or an end of a line, and its place in the mesh's triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ClippedVertex {
    pub(crate) vertex: ScreenVertex,
    pub(crate) barycentric: Barycentric,
}

/// The right shift that turns an interpolant of exponent 0 into a depth; a greater exponent shifts less.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthShift(pub(crate) i32);

impl DepthShift {
    /// The right shift, 15 to 47, that turns an interpolant with this `exponent` into a depth. A depth of 2^16 is the
    /// near plane.
    ///
    /// A shift of 47 turns even the largest interpolant, below 2^31, into a depth below 2^-16. No format can tell this
    /// depth from 0.
    #[inline]
    pub(crate) fn right_shift(self, exponent: u8) -> u32 {
        (self.0 - i32::from(exponent)).clamp(15, 47).cast_unsigned()
    }
}
