//! The macros that put files into flash. The package in the folder assets/macros expands them.

/// A mesh from a model file, read by the compiler and stored in flash: OBJ, STL, PLY, glTF or GLB.
///
/// ```standalone_crate
/// use fixel::prelude::*;
/// static MODEL: Mesh = include_mesh!("../tests/models/house.obj");
/// assert_eq!(MODEL.faces().len(), 14);
///
/// // With 16-bit positions, which take half the flash: see Mesh::quantized.
/// static SMALL: Mesh = include_mesh!("../tests/models/house.obj", quantized);
/// assert_eq!(SMALL.positions().len(), MODEL.positions().len());
///
/// // With small attributes, too.
/// static SMALLEST: Mesh = include_mesh!("../tests/models/house.obj", quantized_8);
/// assert_eq!(SMALLEST.positions(), SMALL.positions());
///
/// // The faces of one material, twice as large.
/// static ROOF: Mesh = include_mesh!("../tests/models/house.obj", part = "tiles", scale = 2);
/// assert_eq!(ROOF.faces().len(), 4);
/// ```
///
/// The path is relative to the source file. The program is compiled again when the model's file changes, or when a file
/// that the model names changes. A file that cannot be read stops compilation, with a message that names the file and
/// the line or the byte. If the macro replaces or leaves out something, such as a normal that is not a number, the
/// compiler prints a warning, one for each kind. The compiler also warns if a few faces are so far away that the others
/// are too small to see; `object` or `part` can leave out the distant faces. `#[allow(deprecated)]` on the `static`
/// silences these warnings.
///
/// | option | meaning |
/// |---|---|
/// | `quantized` | [positions of 16 bits](crate::mesh#less-flash) |
/// | `quantized_16`, `quantized_8` | the same, with [normals of 8 bits and texture coordinates of 16 or 8](crate::mesh#less-flash) |
/// | `normals` | normals for corners that have none. Each is the mean of the faces' normals around the point, weighted by area. Faces that meet the corner's face at more than 60 degrees do not count. In an OBJ file, the faces of the same smoothing group count instead; with smoothing switched off, only the face itself |
/// | `uvs` | texture coordinates for triangles that have none: each triangle is projected to the side of the model's bounding box that it faces most |
/// | `object = "name"` | only the faces of the object with this name: a glTF mesh, or an OBJ object or group |
/// | `part = "name"` | only the faces of the material with this name |
/// | `file_order` | faces and positions in the order of the file: for a [table of your own](trait@crate::Shader) with one value for each of them, or to draw without a depth buffer in that order |
/// | `center` | the middle of the whole model's bounding box is moved to the origin, before `scale`: for models far from the origin. Parts and objects of one file still fit together |
/// | `scale = 0.01` | positions are multiplied by this number |
/// | `up = z` | z points up in the file; the model is turned so that y points up. `up = z` is the default for STL, and `up = y` for other formats |
///
/// The macro reorders faces and positions if the mesh then takes less time to draw. Faces stay in the part of their
/// material, and faces that are not opaque keep their order. Files with the same faces get the same order, so they can
/// be [`Keyframes`](crate::mesh::Keyframes). Positions that no face uses are left out. Positions are rounded to the
/// nearest [`Scalar`](crate::Scalar), and texture coordinates to the nearest [`TexCoord`](crate::TexCoord). A mesh has
/// at most 65,536 positions. Polygons, including concave ones, are cut into triangles;
/// [`Mesh::edges`](crate::Mesh::edges) are the sides of the polygons. The colors of vertices are interpolated as sRGB.
/// If only some corners have texture coordinates, and there is no option `uvs`, all other corners get (0, 0). Corners
/// without a normal get the normal of their triangle.
///
/// ```compile_fail
/// use fixel::prelude::*;
/// static MODEL: Mesh = include_mesh!("../tests/models/house.mtl");
/// ```
#[cfg_attr(doc, doc = include_str!("guide/tables.html"))]
#[macro_export]
macro_rules! include_mesh {
    ($($input:tt)*) => {
        $crate::__assets! { mesh $crate $($input)* }
    };
}

/// The parts of a model's mesh with their materials, read by the compiler and stored in flash: a `&'static` list of
/// [`Part`](crate::mesh::Part)s for the mesh that [`include_mesh!`] makes from the same file.
///
/// A part is a run of faces with one [`Material`](crate::mesh::Material). An OBJ file names its MTL files itself. Faces
/// without a material form a white part without a name. The compiler warns about textures that are not found.
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::mesh::Part;
/// use fixel::prelude::*;
/// use fixel::shade::PartColors;
/// static HOUSE: Mesh = include_mesh!("../tests/models/house.obj");
/// static PARTS: &[Part] = include_materials!("../tests/models/house.obj");
/// assert_eq!(PARTS.len(), 2);
/// let [walls, roof] = [PARTS[0].material, PARTS[1].material];
/// assert_eq!((walls.name, walls.texture), ("brick", Some("brick.tga")));
/// assert_eq!((roof.name, PARTS[1].faces()), ("tiles", 10..14));
///
/// let projection = Projection::perspective(deg!(60), (4, 3), fx!(0.5), fx!(100))?;
/// let mvp = projection * Camera::look_at(vec3!(3, 2, 5), vec3!(0, 1, 0), Vec3::Y)?;
/// let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
/// let mut pixels = [Rgb565::BLACK; 32 * 24];
/// let mut canvas = Canvas::new(&mut pixels, 32, 24)?;
/// // All parts in one call ...
/// canvas.draw(&HOUSE, &mvp, &PartColors::rgb(PARTS).lit_faces(sun));
/// // ... or one by one.
/// for part in PARTS {
///     canvas.draw(&HOUSE.part(part.faces()), &mvp, &Flat::rgb(part.material.color).lit_faces(sun));
/// }
/// # Ok::<(), Error>(())
/// ```
#[macro_export]
macro_rules! include_materials {
    ($($input:tt)*) => {
        $crate::__assets! { materials $crate $($input)* }
    };
}

/// The [`Outline`](crate::mesh::Outline) of the mesh that [`include_mesh!`] makes from the same file with the same
/// options, found by the compiler and stored in flash.
///
/// ```standalone_crate
/// use fixel::mesh::Outline;
/// use fixel::prelude::*;
/// static HOUSE: Mesh = include_mesh!("../tests/models/house.obj");
/// static EDGES: Outline = include_outline!("../tests/models/house.obj", crease = 35);
/// assert!(EDGES.creases() > 0);
/// ```
///
/// The options `object`, `part`, `file_order`, `center`, `scale` and `up` are the same as for the mesh. An edge is a
/// crease if its two faces meet at more than the angle `crease`, in degrees from 0 to 180 (by default, 30). 30 to 45
/// degrees suit most models. [`Outline::build`](crate::mesh::Outline::build) describes which edges are found.
#[macro_export]
macro_rules! include_outline {
    ($($input:tt)*) => {
        $crate::__assets! { outline $crate $($input)* }
    };
}

/// A texture from a picture file, read by the compiler and stored in flash: PNG, JPEG, BMP, TGA, GIF or WebP, or a
/// picture that a model contains.
///
/// The expected type decides the result:
///
/// - a [`Texture`](crate::Texture);
/// - rows of the picture's size, such as `[[Rgb565; 64]; 64]`, which are faster to draw;
/// - the texels alone, such as `&[Rgb565]`;
/// - for a picture of at most 256 colors, an [`Indexed`](crate::texture::Indexed) texture with indices in a
///   `Texture<u8>` or in rows, or the indices alone;
/// - with the option `mipmap`, a [`Mipmap`](crate::texture::Mipmap).
///
/// The color may be any color of embedded-graphics, or it may be [`Argb4444`](crate::texture::Argb4444) or
/// [`Argb1555`](crate::texture::Argb1555), which keep the picture's alpha. Each channel is rounded to its nearest step.
/// Gray is the BT.601 luma (0.299 red + 0.587 green + 0.114 blue). Only the texels are stored in flash, not the file.
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::{Gray8, Rgb565};
/// use fixel::prelude::*;
/// use fixel::texture::Indexed;
/// static SKIN: Texture<Rgb565> = include_texture!("texture/samples/brick.bmp");
/// assert_eq!((SKIN.width(), SKIN.height()), (8, 4));
///
/// // In another color; with the size in the type; with the file's table of 256 colors or fewer; in another size.
/// static GRAY: Texture<Gray8> = include_texture!("texture/samples/brick.bmp");
/// static FAST: [[Rgb565; 8]; 4] = include_texture!("texture/samples/brick.tga");
/// static TILES: Indexed<Texture<u8>, Rgb565> = include_texture!("texture/samples/tiles.bmp");
/// static SMALL: Texture<Rgb565> = include_texture!("texture/samples/brick.bmp", size = "4x2");
/// assert_eq!(Texture::from_rows(&FAST), SKIN);
/// assert_eq!((GRAY.texels().len(), TILES.indices.texels().len(), SMALL.width()), (32, 8, 4));
/// ```
///
/// | option | meaning |
/// |---|---|
/// | `size = "256x256"` | the picture is resampled to this size; width and height must be powers of two, at most 32,768 |
/// | `raw = rgb565` | the bytes of all texels, row by row, for [`Raw`](crate::texture::Raw): a `&'static [u8; N]`; also `bgr565`, `rgb555`, `rgb666`, `rgb888` and so on. The high byte comes first; with `rgb565_le`, the low byte comes first |
/// | `mipmap` | all levels of a mipmap, each the mean of the picture's pixels |
/// | `image = 1` | which picture of a model, counted from 0. If a texture says how much light a surface sends out, one picture contains both the surface and this light; such pictures come after the file's own |
///
/// The path is relative to the source file. A picture of more than two million pixels needs the attribute
/// `#![allow(long_running_const_eval)]` at the top of the program. An array must have the size of the picture. The
/// array in this example has another size, so the example does not compile:
///
/// ```compile_fail
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// static FAST: [[Rgb565; 4]; 8] = include_texture!("texture/samples/brick.bmp");
/// ```
#[cfg_attr(doc, doc = include_str!("guide/tables.html"))]
#[macro_export]
macro_rules! include_texture {
    ($($input:tt)*) => {
        $crate::__assets! { texture $crate $($input)* }
    };
}

/// The notes of the reader are warnings of the compiler, which `#[allow(deprecated)]` silences.
///
/// ```compile_fail
/// #![deny(warnings)]
/// use fixel::prelude::*;
/// pub static MODEL: Mesh = include_mesh!("../tests/models/bad_normal.obj");
/// # fn main() {}
/// ```
///
/// ```
/// #![deny(warnings)]
/// use fixel::prelude::*;
/// #[allow(deprecated)]
/// pub static MODEL: Mesh = include_mesh!("../tests/models/bad_normal.obj");
/// # fn main() {}
/// ```
#[cfg(doctest)]
struct Warnings;
