//! Face culling.

/// Which triangles are not drawn, depending on the side that they show.
///
/// A triangle shows its front if its corners run counter-clockwise on the screen.
///
/// ```
/// use fixel::prelude::*;
/// let both_sides: DrawOptions = DrawOptions::new().with_cull(Cull::Nothing);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cull {
    /// No triangles: both sides are drawn.
    Nothing,
    /// Triangles seen from behind.
    #[default]
    Back,
    /// Triangles seen from the front.
    Front,
}

impl Cull {
    /// Whether a triangle is culled; `area` is positive if its corners run clockwise on the screen.
    #[inline]
    pub(crate) const fn leaves_out(self, area: i64) -> bool {
        match self {
            Self::Nothing => area == 0,
            Self::Back => area >= 0,
            Self::Front => area <= 0,
        }
    }
}
