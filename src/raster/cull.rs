//! Which faces are left out.

/// Which triangles are left out, by the way they face.
///
/// A triangle whose corners run counter-clockwise as seen faces the viewer.
///
/// ```
/// use fixel::prelude::*;
/// let both_sides: DrawOptions = DrawOptions::new().with_cull(Cull::Nothing);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cull {
    /// None: both sides are drawn.
    Nothing,
    /// Those seen from behind.
    #[default]
    Back,
    /// Those seen from the front.
    Front,
}

impl Cull {
    /// Whether a triangle is left out whose area is positive if its corners run clockwise as seen.
    #[inline]
    pub(crate) const fn leaves_out(self, area: i64) -> bool {
        match self {
            Self::Nothing => area == 0,
            Self::Back => area >= 0,
            Self::Front => area <= 0,
        }
    }
}
