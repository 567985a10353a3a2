//! Parts of a mesh: consecutive faces of the mesh, with or without a material.

use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb888;

use super::Mesh;

/// The properties of a surface, as a model file states them. [`include_materials!`](crate::include_materials) makes it.
///
/// A material is only data: the program decides how to draw the surface. For example, the program can find a texture by
/// its name, draw a translucent part with [`Opacity`](crate::canvas::Opacity) after the opaque parts, and draw a part
/// that is seen from both sides with [`Cull::Nothing`](crate::Cull::Nothing).
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
/// use fixel::mesh::Material;
/// static GLASS: Material = Material { name: "glass", opacity: 80, ..Material::new(Rgb888::CYAN) };
/// assert_eq!((GLASS.texture, GLASS.two_sided), (None, true));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Material<'a> {
    /// The name; empty for faces without material.
    pub name: &'a str,
    /// The color where no texture is drawn.
    pub color: Rgb888,
    /// The texture's file name or, if the model contains the picture, the picture's name. If the material has a texture
    /// for the light that the surface sends out, this texture and the material's own texture or color are combined into
    /// a new picture. Its name is, for example, `image-5`, and `include_texture!(…, image = 5)` reads it.
    pub texture: Option<&'a str>,
    /// What the texture's alpha means.
    pub alpha: TextureAlpha,
    /// The opacity, from 0 (invisible) to 255 (opaque).
    pub opacity: u8,
    /// Light that the surface sends out by itself.
    pub emission: Rgb888,
    /// Whether faces are seen from behind, too.
    pub two_sided: bool,
    /// Whether the texture is clamped to its edge, along u and along v; otherwise, it repeats.
    pub clamp: [bool; 2],
    /// True if lights do not change the surface's colors. Draw such a surface without [`lit`](crate::Shader::lit).
    pub unlit: bool,
}

/// What the alpha of a texture means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TextureAlpha {
    /// Alpha has no meaning: the texture is opaque.
    Ignored,
    /// Texels with an alpha below this value are holes; all other texels are opaque. A conversion to
    /// [`Argb1555`](crate::texture::Argb1555) always uses 128 in place of this value.
    Cut(u8),
    /// Alpha is the opacity of a texel: see [`Argb4444`](crate::texture::Argb4444).
    Blended,
}

impl Material<'_> {
    /// An opaque surface of one color, seen from both sides.
    #[must_use]
    pub const fn new(color: Rgb888) -> Self {
        Self {
            name: "",
            color,
            texture: None,
            alpha: TextureAlpha::Ignored,
            opacity: 255,
            emission: Rgb888::new(0, 0, 0),
            two_sided: true,
            clamp: [false; 2],
            unlit: false,
        }
    }
}

/// Consecutive faces of a mesh that have the same material.
///
/// [`include_materials!`](crate::include_materials) makes a list of the parts for the mesh of a file. [`PartColors`]
/// draws all parts in their colors in one call; [`Mesh::part`](crate::Mesh::part) returns one part, to be drawn by
/// itself, for example with its texture.
///
/// [`PartColors`]: crate::shade::PartColors
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, Rgb888}, prelude::*};
/// use fixel::mesh::{Material, Part};
/// use fixel::prelude::*;
/// use fixel::Window;
/// use fixel::shade::PartColors;
/// static SQUARE: Mesh = shape!(plane(2, 1));
/// static SEA: Material = Material { texture: Some("sea.png"), ..Material::new(Rgb888::BLUE) };
/// static PARTS: [Part; 2] = [Part::new(0..2, Material::new(Rgb888::RED)), Part::new(2..4, SEA)];
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
/// for part in PARTS.iter().filter(|part| part.material.texture == Some("sea.png")) {
///     canvas.draw(&SQUARE.part(part.faces()), &mvp, &Flat::new(Rgb565::GREEN));
/// }
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["KKGG", "KKGG", "KKGG", "KKGG"]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Part<'a> {
    start: usize,
    end: usize,
    /// The material.
    pub material: Material<'a>,
}

impl<'a> Part<'a> {
    /// The faces in a range, with their material.
    #[must_use]
    pub const fn new(faces: Range<usize>, material: Material<'a>) -> Self {
        Self {
            start: faces.start,
            end: faces.end,
            material,
        }
    }

    /// The faces, for [`Mesh::part`](crate::Mesh::part).
    #[must_use]
    pub const fn faces(&self) -> Range<usize> {
        self.start..self.end
    }
}

impl Mesh<'_> {
    /// The mesh reduced to a range of its triangles; a range that reaches beyond the end is shortened. The part keeps
    /// all positions and attributes, drops the edges, and needs no new check. For shaders, the part's triangles keep
    /// the [indices](crate::Primitive::face) that they have in the whole mesh.
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
        let end = faces.end.min(self.faces.len());
        let range = faces.start.min(end)..end;
        Self {
            faces: self.faces.get(range.clone()).unwrap_or_default(),
            // The sum is at most the number of faces in the whole mesh.
            first_face: self.first_face.wrapping_add(range.start),
            edges: &[],
            uvs: self.uvs.part(&range),
            normals: self.normals.part(&range),
            colors: self.colors.part(&range),
            ..*self
        }
    }
}
