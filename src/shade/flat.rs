//! Surfaces with one color for all faces, one color for each face, or one color for each part of a mesh.

use core::marker::PhantomData;

use embedded_graphics::pixelcolor::{PixelColor, Rgb888, RgbColor};

use super::{Fragment, Output, PerFace, PixelFormat, Precise, Shader};
use crate::mesh::{Part, Primitive};

/// A surface with one color for all pixels.
///
#[cfg_attr(doc, doc = page_picture!("flat", "Three rings, each in one color: only their outlines can be seen"))]
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::prelude::*;
/// use fixel::Window;
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [BinaryColor::Off; 32];
/// let mut canvas = Canvas::new(&mut pixels, 8, 4)?;
/// let half = Transform::scale(fx!(0.5));
/// canvas.draw(&SQUARE, &(mvp * half), &Flat::new(BinaryColor::On));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["........", "..####..", "..####..", "........"]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Flat<O> {
    color: O,
}

impl<C> Flat<C> {
    /// A shader with one color, given as red, green and blue, for a canvas of color `C`. Light and other adapters
    /// compute with the exact color; the canvas then rounds the result, or dithers it if `C` has fewer than 5 bits per
    /// channel.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
    /// use fixel::prelude::*;
    /// let sun = Light::new(vec3!(1, 2, 3), fx!(0.2), fx!(0.8))?;
    /// let clay = Flat::<Rgb565>::rgb(Rgb888::new(200, 120, 90)).lit(sun);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn rgb(color: impl Into<Rgb888>) -> Flat<Precise<C>>
    where
        C: PixelFormat,
    {
        Flat {
            color: Precise::from(color.into()).converted(),
        }
    }
}

impl<C: PixelColor> Flat<C> {
    /// A shader that gives all pixels this color.
    #[must_use]
    pub const fn new(color: C) -> Self {
        Self { color }
    }
}

impl<O: Output> Shader for Flat<O> {
    type Color = O;
    type Varyings = ();

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, _: &Primitive<'_>) -> [(); 3] {
        [(); 3]
    }

    #[inline]
    fn shade(&self, _: &Fragment, (): ()) -> Option<O> {
        Some(self.color)
    }
}

/// One color per triangle, in the order of the mesh's faces.
///
#[cfg_attr(doc, doc = page_picture!("face_colors", "A coarse ball whose triangles have different colors"))]
/// If edges are drawn, an edge has the color at [its index](crate::Primitive::edge). A triangle or edge whose index is
/// beyond the end of the list has the list's last color, and so has every point. If the list is empty, everything has
/// the default of the color type, which is black.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
/// use fixel::prelude::*;
/// use fixel::Window;
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 4, 4)?;
/// let colors = [Rgb565::RED, Rgb565::BLUE];
/// canvas.draw(&SQUARE, &mvp, &FaceColors::new(&colors));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "BBBB",
///     "RBBB",
///     "RRBB",
///     "RRRB",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct FaceColors<'a, C> {
    colors: &'a [C],
}

impl<'a, C: PixelColor + Default> FaceColors<'a, C> {
    /// A shader that gives each triangle or edge the color at its index in `colors`.
    #[must_use]
    pub const fn new(colors: &'a [C]) -> Self {
        Self { colors }
    }
}

impl<C: PixelColor + Default> Shader for FaceColors<'_, C> {
    type Color = C;
    type Varyings = PerFace<C>;

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [PerFace<C>; 3] {
        let index = primitive.face().or(primitive.edge());
        let color = index.and_then(|index| self.colors.get(index));
        let color = color.or(self.colors.last()).copied();
        [PerFace(color.unwrap_or_default()); 3]
    }

    #[inline]
    fn shade(&self, _: &Fragment, PerFace(color): PerFace<C>) -> Option<C> {
        Some(color)
    }
}

/// One color for each [`Part`] of a mesh; made by [`rgb`](Self::rgb).
///
#[cfg_attr(doc, doc = page_picture!("part_colors", "A ring with red and white parts"))]
/// Edges, points, and faces that belong to no part are white.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PartColors<'a, C = Rgb888> {
    parts: &'a [Part<'a>],
    color: PhantomData<C>,
}

impl<'a> PartColors<'a> {
    /// A shader of the parts' colors, for a canvas of color `C`. The parts must be in ascending order of their faces,
    /// as [`include_materials!`](crate::include_materials) makes them. The shader finds a triangle's part by binary
    /// search.
    ///
    /// Light and other adapters compute with the exact colors; the canvas then rounds the result, or dithers it if `C`
    /// has fewer than 5 bits per channel.
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
    pub const fn rgb<C>(parts: &'a [Part<'a>]) -> PartColors<'a, C> {
        PartColors {
            parts,
            color: PhantomData,
        }
    }
}

impl<C> PartColors<'_, C> {
    /// The color of a face.
    fn color(&self, face: usize) -> Rgb888 {
        // The face belongs to the part before the first part that starts after the face, or to no part.
        let after = self
            .parts
            .partition_point(|part| part.faces().start <= face);
        match after.checked_sub(1).and_then(|last| self.parts.get(last)) {
            Some(part) if face < part.faces().end => part.material.color,
            _ => Rgb888::WHITE,
        }
    }
}

impl<C: PixelFormat> Shader for PartColors<'_, C> {
    type Color = Precise<C>;
    type Varyings = PerFace<Precise<C>>;

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let color = primitive
            .face()
            .map_or(Rgb888::WHITE, |face| self.color(face));
        [PerFace(Precise::from(color).converted()); 3]
    }

    #[inline]
    fn shade(&self, _: &Fragment, PerFace(color): Self::Varyings) -> Option<Precise<C>> {
        Some(color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::shader::{IDENTITY, edge, face, shade};
    use crate::mesh::Material;
    use crate::{Mesh, Vec3};
    use embedded_graphics::pixelcolor::{Gray8, GrayColor};

    #[test]
    fn each_face_or_edge_has_its_own_color() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]; 4]).unwrap();
        let colors = [Gray8::new(10), Gray8::new(20), Gray8::new(30)];
        let shown = |colors: &[Gray8]| {
            [0, 1, 2, 3].map(|i| {
                let (shader, corners) = face(FaceColors::new(colors), &IDENTITY, &mesh, i);
                shade(&shader, corners[0]).luma()
            })
        };
        assert_eq!(shown(&colors), [10, 20, 30, 30]);
        assert_eq!(shown(&[]), [0; 4]);

        let mesh = mesh.with_edges(&[[0, 1], [1, 2], [2, 0], [0, 2]]).unwrap();
        let shown = |i| edge(FaceColors::new(&colors), &mesh, i).map(|PerFace(color)| color.luma());
        assert_eq!(
            [0, 1, 2, 3].map(shown),
            [[10; 2], [20; 2], [30; 2], [30; 2]]
        );
    }

    #[test]
    fn faces_have_the_color_of_their_part() {
        let colors = |parts: &[Part<'_>]| {
            let shader = PartColors::rgb::<Gray8>(parts);
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
