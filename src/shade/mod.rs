//! Shaders: from interpolated values to a color.
//!
#![cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#![cfg_attr(doc, doc = page_picture!("shaders", "Balls: flat, by face, by vertex, textured; lit by face, lit, shiny, a cartoon"))]
//! A surface gives each pixel a color. The last column of the table gives the number of values that the surface
//! interpolates.
//!
//! | surface | color of a pixel | varyings |
//! |---|---|---|
//! | [`Flat`] | one color for all | 0 |
//! | [`FaceColors`] | one color per triangle | 0 |
//! | [`PartColors`] | one color per material | 0 |
//! | [`Gouraud`] | the mesh's vertex colors | 3, or 1 for gray |
//! | [`Gradient`] | a mixture of two colors by height | 3, or 1 for gray |
//! | [`Textured`] | the nearest texel or a blend; the texture repeats or is clamped, and may be reduced where it is far away | 2 |
//! | [`DepthView`] | depth as gray | 0 |
//! | [`NormalView`] | the direction of the normal as a color | 3, or 1 for gray |
//!
//! An adapter changes a surface. Adapters can be stacked in any order and number. Adapters compute in [full
//! precision](Precise), and the canvas rounds or dithers the result once.
//!
//! | adapter | color of a pixel | more varyings |
//! |---|---|---|
//! | [`.lit(light)`](Shader::lit) | the surface × the light, which is computed at the vertices | 1; 3 for colored light, 1 more for highlights |
//! | [`.lit_faces(light)`](Shader::lit_faces) | the surface × the light, which is computed in the triangle's middle | 0 |
//! | [`.tinted()`](Shader::tinted) | the surface × the mesh's vertex colors | 3, or 1 for gray |
//! | [`.in_fog(fog)`](Shader::in_fog) | the surface, fading to the fog's color with distance | 1 |
//! | [`.map(effect)`](Shader::map) | a function of the surface's color | 0 |
//! | [`.dithered()`](Shader::dithered) | the surface, dithered even if its format has many bits | 0 |
//! | [`.converted()`](Shader::converted) | the surface in another color format, dithered if that format has fewer than 5 bits per channel | 0 |
//!
//! [`.lit(light)`](Shader::lit) and [`.lit_faces(light)`](Shader::lit_faces) accept the lights in this table. Arrays,
//! slices and tuples of lights are lights, too; so is a type of yours that implements [`Lighting`].
//!
//! | light | |
//! |---|---|
//! | [`Light`] | the sun and the sky: parallel rays, and light from all sides |
//! | [`PointLight`] | a lamp that shines in all directions, up to a range |
//! | [`SpotLight`] | a lamp that shines in a cone |
//! | [`.colored(color)`](Lighting::colored) | any light, in a color |
//! | [`.two_sided(viewer)`](Lighting::two_sided) | any light, also on the backs of triangles |
//! | [`.shiny(viewer, exponent, strength)`](Lighting::shiny) | one of the first three, with highlights |
//!
//! # A shader in a struct
//!
//! Keep the parts of a shader in your struct: textures, lights, fog. A method of the struct builds the shader in each
//! draw call, which takes only a few instructions. Then you need not write the shader's type:
//!
//! ```
//! use embedded_graphics::pixelcolor::Rgb565;
//! use fixel::prelude::*;
//!
//! static WALL: Mesh = shape!(cuboid(vec3!(4, 2, 0.5)));
//!
//! struct Scene {
//!     bricks: Texture<'static, Rgb565>,
//!     sun: Light,
//!     fog: Fog<Rgb565>,
//! }
//!
//! impl Scene {
//!     fn wall(&self) -> impl ShaderFor<Rgb565> {
//!         Textured::new(self.bricks).bilinear().lit(self.sun).in_fog(self.fog)
//!     }
//!
//!     fn draw(&self, canvas: &mut Canvas<Rgb565, Native, LinearDepth>, view: &Mvp) {
//!         canvas.draw(&WALL, view, &self.wall());
//!     }
//! }
//! ```
//!
//! A struct may also have a type parameter, `struct Model<S> { shader: S }`; the page of [`Shader`] has an example. You
//! must write the shader's type only to store a shader in a `static` or in a resource of RTIC. This module has the
//! types. In the table, `S` is the type of the surface, `L` of the light, and `C` of the color:
//!
//! | made by | type |
//! |---|---|
//! | `surface.lit(light)`, `surface.lit_faces(light)` | `Lit<S, L>`, `FaceLit<S, L>` |
//! | `surface.tinted()` | `Tinted<S>` |
//! | `surface.in_fog(fog)` | `InFog<S, C>`, or `InFog<S, C, ExponentialFog>` |
//! | `surface.map(effect)` | `Map<S, F>`; as `F`, write `fn(&Fragment, C) -> Option<C>` |
//! | `surface.dithered()`, `surface.converted()` | `Dithered<S>`, `Converted<S, C>` |
//! | `light.colored(color)`, `light.shiny(…)`, `light.two_sided(viewer)` | `Colored<L>`, `Shiny<L>`, `TwoSided<L>` |
//! | [`Fog::linear`], [`Fog::exponential`] | `Fog<C>`, `Fog<C, ExponentialFog>` |
//! | methods of `Textured` | see [`Textured`](Textured#the-type) |
//!
//! ```
//! use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
//! use fixel::prelude::*;
//! use fixel::shade::{Colored, Converted, Dithered, ExponentialFog, FaceLit, InFog, Lit, Map, Shiny, Tinted, TwoSided};
//!
//! struct Shaders {
//!     lit: Lit<Flat<Rgb565>, Colored<Shiny<Light>>>,
//!     hazy: InFog<FaceLit<Tinted<Flat<Rgb565>>, TwoSided<Light>>, Rgb565, ExponentialFog>,
//!     gray: Dithered<Converted<Flat<Rgb565>, Rgb565>>,
//!     inverted: Map<Flat<Rgb565>, fn(&Fragment, Rgb565) -> Option<Rgb565>>,
//! }
//! # fn shaders(red: Flat<Rgb565>, sun: Light, eye: Viewer, haze: Fog<Rgb565, ExponentialFog>) -> Result<Shaders, Error> {
//! # Ok(Shaders {
//! #     lit: red.lit(sun.shiny(eye, 8, fx!(1))?.colored(RgbColor::WHITE)),
//! #     hazy: red.tinted().lit_faces(sun.two_sided(eye)).in_fog(haze),
//! #     gray: red.converted().dithered(),
//! #     inverted: red.map(|_, color| Some(Rgb565::new(31 - color.r(), 63 - color.g(), 31 - color.b()))),
//! # })
//! # }
//! ```

mod adapters;
mod flat;
mod fog;
mod format;
mod gouraud;
mod gradient;
mod lanes;
mod light;
mod lit;
mod mipmapped;
mod output;
mod precise;
mod ramp;
mod shader;
mod texel;
mod textured;
mod varyings;
mod views;

#[doc(hidden)]
pub use adapters::{Adapted, Converted, Dithered, Effect, Map, Tint, Tinted};
pub use flat::{FaceColors, Flat, PartColors};
pub use fog::{Density, ExponentialFog, Fog, LinearFog};
#[doc(hidden)]
pub use fog::{Fogged, InFog};
pub(crate) use format::fraction;
pub use format::{Channels, PixelFormat};
pub use gouraud::Gouraud;
pub use gradient::Gradient;
pub use lanes::Lanes;
pub(crate) use lanes::MOST as MOST_VARYINGS;
pub use light::{
    Colored, Illumination, Lamp, Light, Lighting, PointLight, Shiny, SpotLight, SurfacePoint,
    TwoSided, Viewer,
};
#[doc(hidden)]
pub use lit::{ByFace, ByVertex, FaceLit, Lit};
pub use mipmapped::Mipmapped;
pub use output::{ColorOf, Output, PreciseOf, Translucent};
pub use precise::Precise;
pub use shader::{Fragment, Shader, ShaderFor};
pub use texel::Texel;
pub use textured::{Masked, Textured};
pub use varyings::{PerFace, Texels, Tolerance, Varyings, Within};
pub use views::{DepthView, NormalView};
