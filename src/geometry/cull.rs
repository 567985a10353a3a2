//! Which faces are left out.

/// Which triangles are left out, by the way they face.
///
/// A triangle whose corners run counter-clockwise as seen faces the viewer.
///
/// ```
/// use fixel::prelude::*;
/// let both_sides: Pass = Pass::new().cull(Cull::Nothing);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cull {
    /// None: both sides are drawn.
    Nothing,
    /// Those seen from behind.
    #[default]
    Back,
    /// Those seen from the front.
    Front,
}
