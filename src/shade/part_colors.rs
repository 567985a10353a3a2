//! The colors of a mesh's materials.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::{Converted, Fragment, PerFace, Shader};
use crate::mesh::{Part, Primitive};

/// The color of each [`Part`] of a mesh; made by [`rgb`](Self::rgb).
///
#[cfg_attr(doc, doc = page_picture!("part_colors", "A ring with red and white parts"))]
/// Faces in no part are white, and so are edges and points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PartColors<'a> {
    parts: &'a [Part<'a>],
}

impl<'a> PartColors<'a> {
    /// A shader of the parts' colors, for a canvas of color `C`. Parts must be in the order of their faces, as
    /// [`include_materials!`](crate::include_materials) makes them. A triangle finds its part by binary search.
    ///
    /// Light dims a color first; then it is rounded, or dithered if `C` is coarse.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
    /// use fixel::mesh::{Material, Part};
    /// use fixel::prelude::*;
    /// use fixel::shade::PartColors;
    /// let [red, blue] = [Rgb888::RED, Rgb888::BLUE].map(Material::new);
    /// let parts = [Part::new(0..10, red), Part::new(10..12, blue)];
    /// let sun = Light::new(vec3!(1, 2, 3), fx!(0.2), fx!(0.8))?;
    /// let shader = PartColors::rgb::<Rgb565>(&parts).lit_faces(sun);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn rgb<C>(parts: &'a [Part<'a>]) -> Converted<Self, C> {
        Converted::new(Self { parts })
    }

    /// The color of a face.
    fn color(&self, face: usize) -> Rgb888 {
        // The last part that does not start after the face.
        let after = self
            .parts
            .partition_point(|part| part.faces().start <= face);
        match after.checked_sub(1).and_then(|last| self.parts.get(last)) {
            Some(part) if face < part.faces().end => part.material().color,
            _ => Rgb888::WHITE,
        }
    }
}

impl Shader for PartColors<'_> {
    type Color = Rgb888;
    type Varyings = PerFace<Rgb888>;

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [PerFace<Rgb888>; 3] {
        let color = primitive
            .face()
            .map_or(Rgb888::WHITE, |face| self.color(face));
        [PerFace(color); 3]
    }

    #[inline]
    fn shade(&self, _: &Fragment, PerFace(color): PerFace<Rgb888>) -> Option<Rgb888> {
        Some(color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Material;

    #[test]
    fn faces_have_the_color_of_their_part() {
        let colors = |parts: &[Part<'_>]| {
            let shader = PartColors { parts };
            [0, 1, 2, 3, 4, usize::MAX].map(|face| shader.color(face))
        };
        let (red, blue, white) = (Rgb888::RED, Rgb888::BLUE, Rgb888::WHITE);
        let parts = [(1..2, red), (2..4, blue)];
        let parts = parts.map(|(faces, color)| Part::new(faces, Material::new(color)));
        assert_eq!(colors(&parts), [white, red, blue, blue, white, white]);
        assert_eq!(colors(&[]), [white; 6]);
        // A list in the wrong order does not cause a panic.
        let _ = colors(&[parts[1], parts[0]]);
    }
}
