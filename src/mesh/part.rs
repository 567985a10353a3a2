//! Parts of a mesh: runs of its faces, by themselves or with their materials.

use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb888;

use super::Mesh;

/// A run of a mesh's faces that have one material: a color, and perhaps the name of a texture.
///
/// [`include_materials!`](crate::include_materials) makes a list of them for the mesh of a file. [`PartColors`] draws
/// all parts in their colors in one call; [`Mesh::part`](crate::Mesh::part) returns one part, to be drawn by itself,
/// for example with its texture.
///
/// [`PartColors`]: crate::shade::PartColors
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, Rgb888}, prelude::*};
/// use fixel::mesh::Part;
/// use fixel::prelude::*;
/// use fixel::shade::PartColors;
/// static SQUARE: Mesh = shape!(plane(2, 1));
/// static PARTS: [Part; 2] = [
///     Part::new(0..2, Rgb888::RED),
///     Part::new(2..4, Rgb888::BLUE).with_texture("blue.tga"),
/// ];
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 4, 4)?;
/// canvas.draw(&SQUARE, &mvp, &PartColors::rgb(&PARTS));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["RRBB", "RRBB", "RRBB", "RRBB"]);
///
/// canvas.clear(Rgb565::BLACK);
/// for part in PARTS.iter().filter(|part| part.texture() == Some("blue.tga")) {
///     canvas.draw(&SQUARE.part(part.faces()), &mvp, &Flat::new(Rgb565::GREEN));
/// }
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["KKGG", "KKGG", "KKGG", "KKGG"]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Part<'a> {
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) color: Rgb888,
    pub(super) material: &'a str,
    /// Empty if there is none.
    pub(super) texture: &'a str,
}

impl<'a> Part<'a> {
    /// A run of faces with a color. Its material has no name and no texture.
    #[must_use]
    pub const fn new(faces: Range<usize>, color: Rgb888) -> Self {
        Self {
            start: faces.start,
            end: faces.end,
            color,
            material: "",
            texture: "",
        }
    }

    /// Names the material.
    #[must_use]
    pub const fn with_material(self, material: &'a str) -> Self {
        Self { material, ..self }
    }

    /// Names the texture, usually by its file; an empty name stands for none.
    #[must_use]
    pub const fn with_texture(self, texture: &'a str) -> Self {
        Self { texture, ..self }
    }

    /// The faces, for [`Mesh::part`](crate::Mesh::part).
    #[must_use]
    pub const fn faces(&self) -> Range<usize> {
        self.start..self.end
    }

    /// The material's color.
    #[must_use]
    pub const fn color(&self) -> Rgb888 {
        self.color
    }

    /// The material's name; empty for faces without material.
    #[must_use]
    pub const fn material(&self) -> &'a str {
        self.material
    }

    /// The name of the material's texture.
    #[must_use]
    pub const fn texture(&self) -> Option<&'a str> {
        if self.texture.is_empty() {
            None
        } else {
            Some(self.texture)
        }
    }
}

impl Mesh<'_> {
    /// The mesh reduced to a range of its triangles; a range beyond the end is cut. It keeps all positions and
    /// attributes, drops the edges, and needs no new check.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// // Two of twelve triangles.
    /// assert_eq!(BOX.part(4..6).faces().len(), 2);
    /// assert_eq!(BOX.part(11..99).faces(), &BOX.faces()[11..]);
    /// ```
    #[must_use]
    pub fn part(&self, faces: Range<usize>) -> Self {
        let range = self.part_range(&faces);
        Self {
            faces: self.faces.get(range.clone()).unwrap_or_default(),
            edges: &[],
            uvs: self.uvs.part(&range),
            normals: self.normals.part(&range),
            colors: self.colors.part(&range),
            ..*self
        }
    }

    /// A range of triangles, cut at the end of the list.
    pub(super) fn part_range(&self, faces: &Range<usize>) -> Range<usize> {
        let end = faces.end.min(self.faces.len());
        faces.start.min(end)..end
    }
}
