//! 3D scenes in microcontroller framebuffers, in fixed point.
//!
//! `fixel` (fixed + pixel) projects, clips, rasterizes and shades triangles, lines and points with integers only.
//! Textures and colors are correct in perspective. Give fixel slices of your memory, and it draws there. The crate is
//! `no_std`, and has no allocation and no `unsafe`. On emulated Cortex-M0+, M3, M4, M23, M33 and RISC-V cores, programs
//! draw the same bits as on your computer.
//!
#![cfg_attr(
    all(doc, feature = "assets"),
    doc = concat!(
        "<img alt=\"A garden at dusk, with an inn, lamps and a pond\" width=\"320\" height=\"240\" src=\"",
        fixel_macros::picture_uri!("world.png"),
        "\">\n\n"
    )
)]
#![cfg_attr(doc, doc = include_str!("guide/diagrams/pipeline.svg"))]
// On a phone, a wide table scrolls. Without this style, rustdoc breaks code in its cells at any letter.
#![cfg_attr(doc, doc = include_str!("guide/tables.html"))]
//!
//! The [guide] leads from [concepts](guide::concepts) to [firmware](guide::firmware). If you know OpenGL, tgx,
//! embedded-3dgfx or small3dlib, begin with [what differs from them](guide::coming_from). If you know linear algebra
//! but no graphics, begin with the [mathematics](guide::mathematics). To work on the crate itself, begin with [the path
//! of a pixel](#the-path-of-a-pixel): it names the functions behind the diagram above.
//!
//! # A picture
//!
//! ```standalone_crate
//! use embedded_graphics::mock_display::MockDisplay;
//! use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_4X6};
//! use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
//! use embedded_graphics::{Drawable, geometry::Point, text::Text};
//! use fixel::prelude::*;
//!
//! const WIDTH: u32 = 64;
//! const HEIGHT: u32 = 48;
//!
//! // Built by the compiler, stored in flash. For your own: include_mesh!("model.glb").
//! static MODEL: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
//! static SKIN: [[Rgb565; 2]; 2] =
//!     [[Rgb565::WHITE, Rgb565::BLUE], [Rgb565::BLUE, Rgb565::WHITE]];
//!
//! fn frame(now_ms: u64, display: &mut MockDisplay<Rgb565>) -> Result<(), Error> {
//!     let projection = Projection::perspective(
//!         deg!(60), (WIDTH, HEIGHT), fx!(0.5), fx!(50))?; // Err if near is 0
//!     let camera = Camera::look_at(vec3!(0, 1.5, 4), Vec3::ZERO, Vec3::Y)?;
//!     let spin = Transform::rotate_y(Rate::rpm(10).angle_at(now_ms)); // time in, angle out
//!     let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
//!
//!     let mut color = [Rgb565::BLACK; (WIDTH * HEIGHT) as usize]; // your memory
//!     let mut depth = [0; (WIDTH * HEIGHT) as usize];
//!     let mut canvas = Canvas::new(&mut color, WIDTH, HEIGHT)?.with_depth(&mut depth)?;
//!     canvas.clear(Rgb565::BLACK);
//!     let mvp = projection * camera * spin;
//!     let drawn = canvas.draw(&MODEL, &mvp, &Textured::new(&SKIN).lit(sun)); // cannot fail
//!     assert_eq!((drawn.submitted, drawn.drawn), (12, 6)); // triangles: the top and two sides
//!
//!     // A canvas is an embedded-graphics DrawTarget, and copies itself to another one.
//!     let style = MonoTextStyle::new(&FONT_4X6, Rgb565::YELLOW);
//!     Text::new("Hello", Point::new(1, 6), style).draw(&mut canvas)?;
//!     canvas.show(display)?;
//!     Ok(())
//! }
//!
//! let mut display = MockDisplay::new(); // in place of a panel's driver
//! frame(600, &mut display).unwrap();
//! # let is = |x, y, color| assert_eq!(display.get_pixel(Point::new(x, y)), Some(color));
//! # // The four texels meet in the middle of a side, white above to the left and blue to the right.
//! # let [left, right] = [20, 28].map(|x| display.get_pixel(Point::new(x, 21)).unwrap());
//! # assert!(left.r() > 8 && left.r() == left.b());
//! # assert!(right.r() == 0 && right.g() == 0 && right.b() > 8);
//! # is(1, 40, Rgb565::BLACK);
//! # assert!((0..24).any(|x| display.get_pixel(Point::new(x, 3)) == Some(Rgb565::YELLOW)));
//! ```
//!
#![cfg_attr(doc, doc = page_picture!("first", "The program's scene on 240x160 pixels: a checkered cube, and a text"))]
//! Import items of embedded-graphics one by one: its prelude has an `Angle` and a `Transform`, too, and they would
//! conflict with fixel's.
//!
//! # Parts
//!
//! | part | made by<br>used as |
//! |---|---|
//! | [`Mesh`] | [`include_mesh!`], [`shape!`], [`mesh::Shape`], slices of your own<br>first argument of [`Canvas::draw`] |
//! | [`Outline`]: edges with their faces, for silhouettes and creases | [`outline!`], [`Outline::build`]<br>argument of [`Mesh::outline`], which draws lines, and of [`Canvas::smooth_edges`], which smooths jagged edges |
//! | [`Mvp`], the model-view-projection | `projection * camera * spin` of a [`Projection`], a [`Camera`] and [`Transform`]s<br>second argument |
//! | [`Shader`] | [`shade`], or ten lines of your own<br>third argument |
//! | [`DrawOptions`]: culling, viewport, interpolation mode, depth test, blending | [`DrawOptions::new`]<br>first argument of [`Canvas::draw_with`] |
//! | [`DrawList`]: triangles or edges transformed once for all bands | [`DrawList::new`], [`prepare`](DrawList::prepare)<br>argument of [`Canvas::draw_prepared`] |
//! | [`Object`]s: meshes with their transforms and materials | [`Object::new`]<br>argument of [`DrawList::prepare`] |
//! | [`Sprites`]: billboards, particles, upright or turned | [`Sprites::new`], [`Sprites::in_pixels`]<br>first argument of [`Canvas::draw`] |
//! | Lines and points | [`Mesh::edges`], [`Mesh::outline`], [`Mesh::points`] with a [`LineStyle`] or [`PointStyle`]<br>first argument of [`Canvas::draw`] |
//! | [`Viewport`]: where the picture is | [`Viewport::new`], [`Canvas::viewport`]<br>without a canvas, tells where a point or a mesh is on the screen: [`Viewport::project`], [`rectangle_on_screen`](Viewport::rectangle_on_screen) |
//! | [`Ray`] of a pixel | [`Viewport::ray`]<br>[`Ray::hit`] finds the face of a mesh that is seen at this pixel |
//! | [`Canvas`]: colors, depth, rows | [`Canvas::new`], [`Canvas::band`], over your slices<br>the picture for a display: [`Canvas::show`] or [`Canvas::as_bytes`] |
//!
//! # Spaces
//!
//! | space | axes | units | type |
//! |---|---|---|---|
//! | model | right-handed, counter-clockwise triangles face outwards | the mesh's, [`Scalar`] | [`Mesh`] |
//! | world | right-handed, y up; lights are here | yours, [`Scalar`] | [`Transform`] |
//! | eye | right-handed: x right, y up, looking along −z | the world's | [`Camera`] |
//! | clip | x right, y up, w = −z of eye space, or 1 under a parallel projection; a point is visible if −w ≤ x ≤ w, −w ≤ y ≤ w and it lies between the near and the far plane | homogeneous, 64 bits inside the crate | [`Projection`] |
//! | screen | x right, y down from the frame's top left corner; pixel centers at halves | pixels, [`Subpixel`](num::Subpixel): 1/256 | [`Viewport`] |
//! | depth | 65535 at the near plane, falling toward 0 with distance: greater is nearer | floor(65535 · near / w); under a parallel projection linear in the distance | [`Fragment::depth`] |
//! | texture | u right, v down from the top left corner | one repeat, [`TexCoord`] | [`Corner::uv`] |
//!
//! The module [`num`] lists all number formats with their range and resolution.
//!
//! # Promises
//!
//! 1. **No floating point, no allocation, no `unsafe`.** Only a few constructors accept floats, for convenience. They
//!    convert an `f32` with integer instructions: for example, [`Angle::try_from_radians`] turns a sensor's float into
//!    an angle.
//! 2. **Same bits everywhere.** Results do not depend on the target's word length or instructions: the host and the
//!    board draw the same picture.
//! 3. **No panics.** No accepted value can cause a panic or a write outside the canvas. Constructors refuse what cannot
//!    be drawn, and return an [`Error`] that names the value and the limit. [`guide::limits`] gives the ranges in which
//!    accuracy is promised, and says what happens beyond them.
//! 4. **Watertight.** Triangles that share an edge cover each pixel center exactly once, even if they are clipped. A
//!    center exactly on the edge belongs to the triangle on the right of the edge or, if the edge is level, to the
//!    triangle below it: [the top-left rule](guide::mathematics::triangles#a-shared-edge).
//! 5. **Bands equal frames.** A frame drawn in bands equals the frame drawn whole, bit for bit.
//! 6. **Pay for what you use.** Depth, storage, color, shading and interpolation mode are type parameters. Parts that
//!    your program does not use add no code. The feature `assets`, on by default, provides the macros that read files.
//!    A program that includes no files compiles faster with `default-features = false`. The feature `defmt`, off by
//!    default, implements `defmt::Format` for the types that a program may want to log, for example [`Error`], [`Vec3`]
//!    and [`Drawn`].
//!
//! # Drawing to a display
//!
//! With colors of 16 bits, a frame of 320x240 takes 150 KiB for colors and 150 KiB for depths. If you have less memory,
//! draw the scene band by band into the same memory, and send each band to the display when it is finished.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{BinaryColor, Rgb888}};
//! use fixel::prelude::*;
//!
//! static BALL: Mesh = shape!(sphere(12, 8));
//! const WIDTH: u32 = 16;
//! const HEIGHT: u32 = 12;
//! const ROWS: u32 = 4;
//!
//! let projection = Projection::perspective(deg!(60), (WIDTH, HEIGHT), fx!(1), fx!(10))?;
//! let mvp = projection * Transform::translate(vec3!(0, 0, -2.5));
//! let sun = Light::new(vec3!(1, 2, 3), fx!(0), fx!(1))?;
//! let white = Flat::rgb(Rgb888::new(255, 255, 255)).lit(sun);
//! let mut display = MockDisplay::new();
//! let mut color = [BinaryColor::Off; (WIDTH * ROWS) as usize];
//! let mut depth = [0; (WIDTH * ROWS) as usize];
//! for first_row in (0..HEIGHT).step_by(ROWS as usize) {
//!     let band = Canvas::band(&mut color, WIDTH, HEIGHT, first_row)?;
//!     let mut band = band.with_depth(&mut depth)?;
//!     band.clear(BinaryColor::Off);
//!     band.draw(&BALL, &mvp, &white);
//!     band.show(&mut display)?; // or DMA from band.as_bytes() of a canvas of bytes
//! }
//! display.assert_pattern(&[
//!     "................",
//!     "................",
//!     ".....#.###......",
//!     "....########....",
//!     ".....#.#.###....",
//!     "....#.######....",
//!     ".....#.#.#.#....",
//!     "....#.#.###.....",
//!     ".......#.#......",
//!     "......#.#.#.....",
//!     "................",
//!     "................",
//! ]);
//! # Ok::<(), Error>(())
//! ```
//!
//! In this example, every band transforms the whole mesh again. If that takes too long, fill a [`DrawList`] once per
//! frame with [`DrawList::prepare`], and let every band draw from the list with [`Canvas::draw_prepared`].
//!
//! For DMA, let the canvas store bytes in the order of the bus: give a `Canvas<Rgb565, BigEndian>` a slice of `[u8;
//! 2]`, and send the bytes that [`Canvas::as_bytes`] returns. The [guide for firmware](guide::firmware) leads from
//! `cargo new` to a picture on an SPI panel, and covers memory, bands, DMA, two cores and clocks.
//!
//! # Speed against accuracy
//!
//! Each draw call has a [`Mode`](mode::Mode), which decides how exactly textures and colors follow perspective. The
//! [guide to modes](guide::modes) says which mode suits which scene and core, and derives the error bounds. The
//! [benchmarks](guide::benchmarks) say what drawing costs. The [cookbook](guide::cookbook) has small scenes that each
//! show one idea.
//!
//! # Versions
//!
//! - **Pictures.** Versions that Cargo treats as compatible (such as 0.1.0 and 0.1.7) draw the same bits. Checksums in
//!   the tests enforce this. Any change to a picture, even an improvement, requires a new minor version, and the
//!   changelog says what differs. The exception is a bug that breaks a promise above: it is fixed at once, even if
//!   pictures change.
//! - **Compiler.** The crate compiles with Rust 1.88. Only a new minor version may require a later compiler. That
//!   compiler is then at least six months old.
//! - **Dependencies.** `fixed` and `embedded-graphics` appear in the interface. An incompatible new version of either
//!   requires a new minor version of this crate.
//!
//! # The path of a pixel
//!
//! These functions carry out the stages in the diagram at the top of this page. Each stands below its caller:
//!
//! ```text
//! Canvas::draw_with                   options, a thing, its Mvp, a shader    pipeline/
//! └─ run::draw                        in code that exists once               pipeline/
//!    └─ run::triangle                 culled, whole, or clipped              pipeline/
//!       ├─ VertexCache::refresh       projected for a neighbor, or now       pipeline/
//!       │  └─ Projector::project      model → clip space → screen            pipeline/
//!       └─ Rasterizer::draw_whole     inside the scissor?                    raster/
//!          └─ Rasterizer::triangle    in blocks of rows                      raster/
//!             ├─ scan_convert         top-left rule, row by row              raster/
//!             ├─ Blit::set_up         once, if a row has pixels              span/
//!             │  ├─ Adapted::varyings what the shader wants interpolated     shade/
//!             │  └─ Setup::set_up     the planes of 1/w and of the varyings  span/
//!             └─ Blit::draw           row by row, in spans                   span/
//!                ├─ Pixels::visible   depth test                             span/
//!                └─ Pixels::shade     color, blending, store                 span/
//!                   ├─ Adapted::shade varyings → color                       shade/
//!                   └─ Native::store  as a color; others as bytes            canvas/
//! ```
//!
//! The column on the right names the folder. In this example, the shader is an `Adapted`, which `.lit(light)` makes,
//! and the canvas stores colors in the format `Native`. `Blit::draw` cuts each row into spans of up to 64 pixels, and
//! draws each span by a kernel, one of four loops over pixels: straight, pieces, Newton or divide. The [mode] chooses
//! the kernel for each span.
//!
//! Each folder depends only on the folders before it in this list: `num`, `math`, `view`, `mesh`, `texture`, `shade`,
//! `canvas`, `raster`, `span`, `pipeline`. Inside the crate, an import names the folder that owns an item
//! (`crate::num::Scalar`, not `crate::Scalar`), so the imports show this order.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

#[cfg(test)]
mod fixtures;
#[cfg(test)]
#[path = "../tests/support/random.rs"]
mod random;

/// Embeds a picture in the documentation: under the title after `#`, or on an item's page, so that the picture is shown
/// wherever the page is. `cargo run -p cookbook -- --renew` draws the picture of a page at the size of a small display,
/// and browsers show each of its pixels as a square.
#[cfg(all(any(doc, doctest), feature = "assets"))]
macro_rules! page_picture {
    (# $title:literal, $($name:literal),+) => {
        concat!(
            "# ",
            $title,
            "\n\n![",
            $title,
            "](",
            fixel_macros::picture_uri!("" $($name)+ ".png"),
            ")\n\n"
        )
    };
    ($name:literal, $shows:literal) => {
        concat!(
            "\n\n<img alt=\"",
            $shows,
            "\" title=\"",
            $shows,
            "\" width=\"240\" height=\"160\" style=\"image-rendering: pixelated\" src=\"",
            fixel_macros::picture_uri!("pages/" $name ".png"),
            "\">\n\n\n"
        )
    };
}

/// Without the feature `assets`, the documentation has no pictures.
#[cfg(all(any(doc, doctest), not(feature = "assets")))]
macro_rules! page_picture {
    (# $title:literal, $($name:literal),+) => {
        concat!("# ", $title, "\n\n")
    };
    ($name:literal, $shows:literal) => {
        ""
    };
}

#[cfg(feature = "assets")]
mod assets_macros;
mod error;
#[cfg(any(doc, doctest))]
pub mod guide;
#[cfg(feature = "defmt")]
mod log;
pub mod math;
pub mod mesh;
mod message;
pub mod num;
mod pipeline;
mod raster;
mod sealed;
pub mod shade;
mod span;
pub mod textbook;

/// How textures, colors and other varyings are interpolated: the trait [`Mode`](mode::Mode) and its five
/// implementations.
///
/// Mathematics explains [why each pixel needs the reciprocal of 1/w](crate::guide::mathematics::pixels#an-attribute),
/// and [how the faster modes avoid a division](crate::guide::mathematics::fixed_point#fixed-point) at every pixel.
///
#[cfg_attr(doc, doc = page_picture!("modes", "A floor of two triangles: bent by Affine, straight by the default mode"))]
pub mod mode {
    pub use crate::span::{Affine, Compact, Exact, Fast, Mode, Newton};
}

pub mod canvas;
pub mod texture;
pub mod view;

#[cfg(feature = "assets")]
#[doc(hidden)]
pub use fixel_macros::assets as __assets;

pub use error::Error;
#[doc(hidden)]
pub use pipeline::Thing;
pub use pipeline::{
    DrawList, DrawOptions, Drawn, FacesOrEdges, Hit, Object, Prepared, Ray, ScreenPoint, ShadeList,
};
pub use raster::{Cull, LineStyle, PointStyle};

// These items are documented in their modules.
#[doc(no_inline)]
pub use {
    canvas::Canvas,
    math::{Matrix4, Transform, Vec2, Vec3},
    mesh::{Corner, Index, Mesh, Outline, Primitive, Sprites},
    num::{Angle, Fraction, Rate, Scalar, TexCoord},
    shade::{
        DepthView, FaceColors, Flat, Fog, Fragment, Gouraud, Lamp, Light, Lighting, NormalView,
        PixelFormat, PointLight, Shader, ShaderFor, SpotLight, Textured, Viewer,
    },
    texture::Texture,
    view::{Camera, Mvp, Projection, Viewport, Window},
};

/// Compiles the program in the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The items that most programs import in order to draw.
///
/// The prelude of embedded-graphics has its own `Angle` and `Transform`. If a program imports both preludes and uses
/// one of these two items, it must also import that item by name:
///
/// ```
/// use embedded_graphics::prelude::*;
/// use fixel::prelude::*;
/// use fixel::{Angle, Transform};
/// # use embedded_graphics::pixelcolor::Rgb565;
///
/// let spin = Transform::rotate_y(Angle::from_degrees(30));
/// let corner = Point::new(3, 4) + Size::new(1, 1);
/// # let (_, _, _) = (spin, corner, Rgb565::BLACK);
/// ```
pub mod prelude {
    #[doc(no_inline)]
    pub use crate::canvas::{LinearDepth, Native};
    #[doc(no_inline)]
    pub use crate::{
        Angle, Camera, Canvas, Corner, Cull, DrawList, DrawOptions, Drawn, Error, FaceColors, Flat,
        Fog, Fragment, Gouraud, Lamp, Light, Lighting, LineStyle, Mesh, Mvp, Object, Outline,
        PixelFormat, PointLight, PointStyle, Projection, Rate, Ray, Scalar, Shader, ShaderFor,
        SpotLight, Sprites, TexCoord, Texture, Textured, Transform, Vec2, Vec3, Viewer, Viewport,
    };
    #[doc(no_inline)]
    pub use crate::{deg, fx, outline, shape, vec2, vec3};
    #[cfg(feature = "assets")]
    #[doc(no_inline)]
    pub use crate::{include_materials, include_mesh, include_outline, include_texture};
}
