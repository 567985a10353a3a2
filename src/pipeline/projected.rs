//! A vertex on the screen, and how its depth is stored.

use crate::mesh::Index;

/// A vertex on the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projected {
    /// Column and row in units of 1/256 pixel, from the frame's top left.
    pub(crate) screen: [i32; 2],
    /// The interpolant of depth, 31 bits: 1/w with its top bit set, or depth itself.
    pub(crate) q: u32,
    /// 1/w is `q` · 2^`exponent` times a constant of the draw call; 0 under a parallel projection.
    pub(crate) exponent: u8,
    /// Which planes it is outside of; where it is, the rest has no meaning.
    pub(crate) outside: u8,
    /// Which of the positions it is; of a corner that clipping made nothing.
    pub(crate) index: Index,
}

impl Projected {
    /// A vertex that is not on the screen.
    pub(crate) const NONE: Self = Self {
        screen: [0; 2],
        q: 0,
        exponent: 0,
        outside: u8::MAX,
        index: 0,
    };

    /// Where the corners of a triangle are.
    // Taken apart by hand: optimised for size, a `map` over references makes arrays and loops of it.
    #[inline]
    pub(crate) const fn screens([a, b, c]: &[Self; 3]) -> [[i32; 2]; 3] {
        [a.screen, b.screen, c.screen]
    }
}

/// How interpolants become depths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthShift(pub(super) i32);

impl DepthShift {
    /// How far down an interpolant of this `exponent` is shifted to be a depth, 2^16 at the near plane: 15 to 47.
    ///
    /// At 47 the largest interpolant, below 2^31, is a depth below 2^-16, which no format tells from 0.
    #[inline]
    pub(crate) fn of(self, exponent: u8) -> u32 {
        (self.0 - i32::from(exponent)).clamp(15, 47).cast_unsigned()
    }
}
