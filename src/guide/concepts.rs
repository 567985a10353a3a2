//! The terms of this crate, in the order in which a program meets them: what you give a draw call, and what the call
//! does.
//!
//! 1. [The parts of a program](#the-parts-of-a-program)
//! 2. [Numbers](#numbers)
//! 3. [Mesh](#mesh)
//! 4. [Transform, camera, projection](#transform-camera-projection)
//! 5. [Shader](#shader)
//! 6. [Options](#options)
//! 7. [Canvas](#canvas)
//! 8. [Depth](#depth)
//! 9. [Band](#band)
//! 10. [When the scene is wrong](#when-the-scene-is-wrong)
//!
//! # The parts of a program
//!
#![doc = include_str!("diagrams/pipeline.svg")]
//!
//! Give a draw call a mesh (the shape), a model-view-projection (where the shape and the eye are, and the angle of
//! view) and a shader (the colors). The call writes pixels to a canvas (your memory). All four are plain values of your
//! program. The canvas is the only state between draw calls.
//!
//! ```
//! use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
//! use fixel::prelude::*;
//!
//! static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1))); // in flash; from −1 to 1 along each axis
//!
//! fn main() -> Result<(), Error> {
//!     // The memory is yours: on a microcontroller, statics.
//!     let mut colors = [Rgb565::BLACK; 160 * 120];
//!     let mut depths = [0; 160 * 120];
//!     let mut canvas = Canvas::new(&mut colors, 160, 120)?.with_depth(&mut depths)?;
//!
//!     let size = canvas.frame_size();
//!     let projection = Projection::perspective(deg!(45), size, fx!(0.5), fx!(50))?;
//!     let camera = Camera::look_at(vec3!(0, 2, 5), Vec3::ZERO, Vec3::Y)?;
//!     let turn = Transform::rotate_y(deg!(30));
//!     let sun = Light::new(vec3!(-1, 3, 2), fx!(0.3), fx!(0.7))?; // toward the sun; ambient, diffuse
//!     let surface = Flat::new(Rgb565::YELLOW).lit(sun);
//!
//!     canvas.clear(Rgb565::BLUE);
//!     let drawn = canvas.draw(&CUBE, &(projection * camera * turn), &surface);
//!     assert_eq!(drawn.submitted, 12); // triangles
//!     Ok(())
//! }
//! ```
//!
//! A constructor returns an [`Error`](crate::Error) if a value makes no sense; the error names the value and its limit.
//! `draw` and `draw_with` cannot fail, so they return no error.
//!
//! # Numbers
//!
//! Drawing uses no floats. Write numbers with these macros, and the compiler converts them to fixed point:
//!
//! | you write | you get | range, resolution |
//! |---|---|---|
//! | `fx!(0.25)` | [`Scalar`](crate::Scalar): a coordinate, a distance, a brightness | ±32,768 in steps of 1/65,536 |
//! | `vec3!(0, 1.5, 4)` | [`Vec3`](crate::Vec3): three scalars | as for `Scalar` |
//! | `vec2!(0.5, 1)` | [`Vec2`](crate::Vec2): two texture coordinates (1 is the whole width or height of the texture) | ±2048 in steps of 10⁻⁶ |
//! | `deg!(62.5)` | [`Angle`](crate::Angle): a fraction of a turn | one turn, in steps of 10⁻⁷ degrees |
//!
//! A literal beyond the range does not compile. To convert floats and integers that are known only at run time, use
//! `Scalar::try_from`, `TexCoord::try_from` (one texture coordinate), `Vec3::try_from`, or a constructor of
//! [`Angle`](crate::Angle):
//!
//! ```
//! use fixel::prelude::*;
//!
//! let height = Scalar::try_from(1.75_f32)?; // Err beyond ±32,768, and for NaN
//! assert_eq!(height, fx!(1.75));
//! assert!(Scalar::try_from(40_000).is_err());
//!
//! // Numbers and vectors saturate at the end of the range: nothing wraps around, nothing panics.
//! assert_eq!(fx!(200) * fx!(200), Scalar::MAX);
//! assert_eq!((vec3!(30000, 0, 0) * fx!(2)).x, Scalar::MAX);
//!
//! // Angles wrap at a whole turn.
//! assert_eq!(deg!(350) + deg!(20), deg!(10));
//! assert_eq!(Angle::from_turns(fx!(0.25)), deg!(90));
//! assert_eq!(deg!(225) - deg!(270) * fx!(0.5), deg!(90)); // the needle of a gauge, at half of its scale
//! assert_eq!(Angle::from_radians(fx!(1)).to_string(), "57.2958 degrees");
//!
//! // An angle computed from the time is exact, even after years: errors do not add up.
//! let spin = Rate::rpm(10).angle_at(1_500); // 1.5 seconds
//! assert_eq!(spin, deg!(90));
//! # Ok::<(), Error>(())
//! ```
//!
//! Choose the unit of length so that your scene is between a tenth of a unit and a few thousand units in size: for
//! example, a meter for a garden, or a centimeter for a machine. The page [Limits](crate::guide::limits) says how
//! accurate the picture is with larger coordinates.
//!
//! The module [`num`](crate::num) says how each operation on these numbers rounds.
//!
//! # Mesh
//!
//! A [`Mesh`](crate::Mesh) borrows positions, faces (the indices of three positions for each triangle), and optionally
//! texture coordinates, normals, colors and edges. `shape!` and `include_mesh!` make a mesh at compile time, so the
//! mesh is in flash. A `static` mesh of your own slices is in flash, too:
//!
//! ```
//! use fixel::prelude::*;
//!
//! static ROOF: Mesh = Mesh::checked(Mesh::new(
//!     &[vec3!(-1, 0, 0), vec3!(1, 0, 0), vec3!(0, 1, 0)],
//!     &[[0, 1, 2]], // counter-clockwise, seen from outside
//! ));
//! assert_eq!(ROOF.faces().len(), 1);
//! ```
//!
//! The order of a triangle's corners determines which side is its front:
//!
#![doc = include_str!("diagrams/winding.svg")]
//!
//! If you see the inside of a model, the corners of its triangles run clockwise when seen from outside. Swap two
//! corners of each triangle, or draw with [`Cull::Front`](crate::Cull::Front).
//!
//! # Transform, camera, projection
//!
#![doc = include_str!("diagrams/axes.svg")]
//!
//! - A [`Transform`](crate::Transform) places a model in the world. `a * b` applies `b` first.
//! - A [`Camera`](crate::Camera) says where the eye is and where the eye looks. The camera moves and turns the world so
//!   that the eye is at the origin and looks along −z.
//! - A [`Projection`](crate::Projection) sets the angle of view, and the distances of the near and the far plane. Only
//!   surfaces between these planes are drawn. [`perspective`](crate::Projection::perspective) takes the vertical angle
//!   of view, from the bottom of the picture to its top.
//!
#![doc = include_str!("diagrams/eye.svg")]
//!
//! The product of projection, camera and model transform is the [`Mvp`](crate::Mvp), the model-view-projection. Read
//! `projection * camera * model` from right to left: a point first goes through the model's transform.
//!
//! ```
//! use fixel::prelude::*;
//!
//! // Counter-clockwise, seen from the tip of the axis.
//! let quarter = Transform::rotate_z(deg!(90));
//! let right = Transform::translate(vec3!(2, 0, 0));
//! assert_eq!((right * quarter).point(Vec3::X), vec3!(2, 1, 0)); // turned, then moved
//! assert_eq!((quarter * right).point(Vec3::X), vec3!(0, 3, 0)); // moved, then turned
//!
//! // A forearm at the end of an upper arm: each transform is relative to the transform on its left.
//! let shoulder = Transform::rotate_z(deg!(90));
//! let elbow = Transform::translate(vec3!(1, 0, 0)) * Transform::rotate_z(deg!(90));
//! assert_eq!((shoulder * elbow).point(vec3!(1, 0, 0)), vec3!(-1, 1, 0));
//! ```
//!
//! # Shader
//!
//! A [`Shader`](crate::Shader) gives each pixel its color. Some shaders are surfaces: [`Flat`](crate::Flat) has one
//! color, [`Gouraud`](crate::Gouraud) interpolates vertex colors, and [`Textured`](crate::Textured) shows a texture.
//! The pixels of a texture are called texels. Methods such as `lit`, `in_fog` and `map` wrap a surface in an adapter
//! that changes its colors. Stack as many adapters as you need. Each adapter changes the color that it gets from the
//! adapter before it, so apply light before fog. The module [`shade`](crate::shade) lists all surfaces and adapters.
//! The compiler fuses a surface and its adapters into one loop. Shaders that you do not name add no code.
//!
//! ```
//! use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
//! use fixel::prelude::*;
//!
//! static SKIN: [[Rgb565; 2]; 2] =
//!     [
//!         [Rgb565::WHITE, Rgb565::RED],
//!         [Rgb565::RED, Rgb565::WHITE],
//!     ];
//!
//! fn surface() -> Result<impl ShaderFor<Rgb565>, Error> {
//!     // The direction points to the sun.
//!     let sun = Light::new(vec3!(-1, 3, 2), fx!(0.3), fx!(0.7))?;
//!     let fog = Fog::linear(Rgb565::WHITE, fx!(5), fx!(40))?;
//!     Ok(Textured::new(&SKIN).lit(sun).in_fog(fog))
//! }
//! assert!(surface().is_ok());
//! ```
//!
//! # Options
//!
//! [`Canvas::draw`](crate::Canvas::draw) leaves out back faces (culling), tests depth, interpolates in correct
//! perspective, and replaces the colors on the canvas. For other settings, give [`draw_with`](crate::Canvas::draw_with)
//! your own [`DrawOptions`](crate::DrawOptions):
//!
//! ```
//! use fixel::mode::Fast;
//! use fixel::prelude::*;
//! use fixel::canvas::{Opacity, TestOnly};
//!
//! let glass = DrawOptions::new()
//!     .with_cull(Cull::Nothing) // both sides
//!     .with_depth_test(TestOnly) // hides nothing that is drawn later
//!     .with_blending(Opacity(96)); // of 255
//! // On a Cortex-M0+: faster, with an error of about a quarter of a texel.
//! let walls = DrawOptions::new().with_mode(Fast::within(fx!(0.25)));
//! assert_eq!(glass.cull, Cull::Nothing);
//! assert_eq!(walls.cull, Cull::Back);
//! ```
//!
//! A *mode* decides how exactly textures and colors follow perspective: see [Choosing a mode](crate::guide::modes).
//! Modes, depth tests and blendings are types: those that you do not name add no code. Culling and viewport are values,
//! which can change at run time.
//!
//! # Canvas
//!
//! A [`Canvas`](crate::Canvas) is a picture in your memory: its size, its colors, and optionally a depth buffer. Give
//! it a slice of colors, and it stores colors unchanged. Give it a slice of arrays, such as `[u8; 2]`, and it stores
//! the bytes of each color in the order that the display expects. A canvas is only a few references and numbers, so you
//! can make a new one for each frame.
//!
//! A canvas is a `DrawTarget`, so embedded-graphics can draw text and shapes over the picture.
//! [`show`](crate::Canvas::show) copies the picture to another `DrawTarget`. [`as_bytes`](crate::Canvas::as_bytes)
//! returns the bytes of the picture for a DMA channel. If your display has several pixels in a byte,
//! [`show`](crate::Canvas::show) or [`pages`](crate::Canvas::pages) packs them.
//!
//! # Depth
//!
//! With a depth buffer, triangles can be drawn in any order: at each pixel, you see the nearest triangle. For each
//! pixel, the buffer stores in two bytes how near the visible surface is:
//!
#![doc = include_str!("diagrams/depth.svg")]
//!
//! `clear` sets all depths to 0, which means infinitely far. Half of the 65,536 depths are for surfaces between the
//! near plane and twice the near plane's distance; few are left for distant surfaces. Therefore:
//!
//! **Put the near plane as far from the eye as the scene allows, and the far plane at most 500 times as far away as the
//! near plane.** Then the nearer of two surfaces hides the other wherever their distances from the eye differ by 1 % or
//! more. If the near plane is too close, distant surfaces show through those in front of them, and no error says so:
//! with the planes at 0.01 and 100, a square at a distance of 90 does not hide a square that is 3 units behind it and
//! drawn later. For a ratio far/near of up to 65,536, use
//! [`with_depth_format::<FloatDepth>`](crate::Canvas::with_depth_format). It takes the same memory as `with_depth`, but
//! a frame takes up to a third more instructions (in modes [`Fast`](crate::mode::Fast) and
//! [`Affine`](crate::mode::Affine) on a Cortex-M0+, up to four fifths more).
//!
//! The limit of 500 leaves some room: [the step between two depths](crate::guide::mathematics::pixels#a-depth-step)
//! grows to 1 % of the distance only at 655 times the near plane's distance. The far plane has no influence on the
//! stored depths: it only cuts off what lies beyond it.
//!
//! Without a depth buffer, draw the scene from back to front. A [`DrawList`](crate::DrawList) can sort its triangles in
//! this order.
//!
//! # Band
//!
//! A frame of 320x240 pixels takes 300 KiB with depth. If that is too much, draw the frame in bands, a few rows at a
//! time:
//!
#![doc = include_str!("diagrams/band.svg")]
//!
//! ```
//! use embedded_graphics::pixelcolor::{Rgb565, RgbColor, raw::BigEndian};
//! use fixel::prelude::*;
//!
//! static BALL: Mesh = shape!(sphere(12, 8));
//!
//! fn send(_first_row: u32, _bytes: &[u8]) {
//!     // Send the bytes, and wait until they are sent: the next band is drawn into the same memory.
//! }
//!
//! fn frame(mvp: &Mvp) -> Result<(), Error> {
//!     // On a microcontroller, statics. A color is two bytes, in the order of the display.
//!     let mut colors = [[0; 2]; 320 * 40];
//!     let mut depths = [0; 320 * 40];
//!     for first_row in (0..240).step_by(40) {
//!         let band = Canvas::<Rgb565, BigEndian>::band(&mut colors, 320, 240, first_row)?;
//!         let mut band = band.with_depth(&mut depths)?;
//!         band.clear(Rgb565::BLACK);
//!         band.draw(&BALL, mvp, &Flat::new(Rgb565::YELLOW));
//!         send(first_row, band.as_bytes());
//!     }
//!     Ok(())
//! }
//! # let projection = Projection::perspective(deg!(45), (320, 240), fx!(0.5), fx!(50))?;
//! # frame(&(projection * Transform::translate(vec3!(0, 0, -4))))?;
//! # Ok::<(), Error>(())
//! ```
//!
//! Together, the bands give the same picture as the whole frame, bit for bit. But each band transforms the whole mesh
//! again. If that takes too long, use a [`DrawList`](crate::DrawList), which transforms the mesh once per frame. The
//! program on the page [Firmware](crate::guide::firmware) uses two bands: it draws one while the other is sent.
//!
//! # When the scene is wrong
//!
//! A draw call returns [`Drawn`](crate::Drawn), which says how many triangles were drawn, culled or clipped, and which
//! attributes the mesh lacks. Print it first:
//!
//! | what you see | what to check |
//! |---|---|
//! | nothing, and [`submitted`](crate::Drawn::submitted) is 0 | the mesh has no faces. For lines: if [`missing.edges`](crate::mesh::Missing::edges) is true, the mesh has no edges; add them with [`with_edges`](crate::Mesh::with_edges), or draw an [`outline`](crate::Mesh::outline) |
//! | nothing, and all triangles are [`culled`](crate::Drawn::culled) | their corners are in clockwise order: see [Mesh](#mesh) |
//! | nothing, and all triangles are [`outside`](crate::Drawn::outside) the view | the mesh is behind the camera, nearer than the near plane, beyond the far plane, or beside the picture. [`mvp.model_view().point(p)`](crate::Mvp::model_view) is a point in eye space, where a visible z lies between −near and −far. [`Viewport::project`](crate::Viewport::project) is its position on the screen, which may be outside the picture |
//! | nothing, and some triangles are culled and the others outside | the mesh is just beside the picture, and its [bounds](crate::Mesh::with_bounds) are not known; or its triangles are smaller than a pixel |
//! | nothing, although triangles are drawn | the depth buffer still has the depths of the last frame: call `clear` before each frame |
//! | the inside of objects | the corners of triangles are in clockwise order: see [Mesh](#mesh) |
//! | one color in place of a texture or of vertex colors | [`missing`](crate::Drawn::missing): the mesh lacks texture coordinates or colors |
//! | lit surfaces are dark | the direction of a [`Light`](crate::Light) points to the light, in world space; surfaces that face away from the light have only the light's ambient brightness |
//! | a mirror image is lit from the wrong side | mirror the camera, not the model: [`Camera::mirrored`](crate::Camera::mirrored) |
//! | a spot or a highlight has jagged edges, or is missing | light is computed at the corners of triangles: make the mesh finer |
//! | distant surfaces flicker through each other | move the near plane away from the eye, to 1/500 of the far plane's distance or farther: see [Depth](#depth) |
//! | edges of surfaces are jagged | call [`Canvas::smooth_edges`](crate::Canvas::smooth_edges) after drawing |
//! | lines on a surface are broken | draw the surface with [`Biased::behind`](crate::canvas::Biased::behind), slightly behind its true depth; or draw its [outline](crate::Mesh::outline) with [`Biased::in_front`](crate::canvas::Biased::in_front) |
//!
//! The page [Firmware](crate::guide::firmware#when-the-picture-is-wrong) has a similar table for faults of displays.
#![cfg_attr(doc, doc = include_str!("tables.html"))]
