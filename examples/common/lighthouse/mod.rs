//! The project's own scene: a lighthouse on an island in the sea, and a line of text.
//!
//! `no_std`, and small enough for the flash of a microcontroller: 1,176 triangles, 40 KiB of textures.
//!
//! | file | contents |
//! |---|---|
//! | `mod` | the island, which a macro puts into flash, and the functions that draw it |
//! | `scenery` | sea, sky, textures, camera, light, shaders, caption |
//!
//! The simulator includes only `scenery`, and reads the island when it runs.

mod scenery;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{PixelColor, Rgb888, RgbColor};
use fixel::Drawn;
use fixel::canvas::{Biased, DepthBuffer, Storage, TestAndWrite};
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::shade::{Flat, PixelFormat};
use fixel::view::ProjectionKind;

pub use scenery::*;

/// The island with the lighthouse. Its texture is [`SKIN`].
pub static ISLAND: Mesh = include_mesh!("../../assets/lighthouse.obj");
/// The outline of the island against sky and sea. No edge is a crease.
pub static SILHOUETTES: Outline = include_outline!("../../assets/lighthouse.obj", crease = 180);

/// Draws the sea and the island. `mvp` transforms them to the picture. If the format has only black and white, it is
/// night, and the silhouettes are white.
///
/// # Errors
///
/// None: the light's numbers are constant.
pub fn draw<C: PixelFormat>(
    canvas: &mut Canvas<'_, C, impl Storage<C>, impl DepthBuffer>,
    options: &DrawOptions<impl Mode>,
    mvp: &Mvp<impl ProjectionKind>,
) -> Result<[Drawn; 2], Error> {
    if !is_mono::<C>() {
        return Ok(surfaces(canvas, options, mvp, (&waves(), &skin()?)));
    }
    let drawn = surfaces(canvas, options, mvp, (&crests(), &stretched()?));
    let white = Flat::new(C::from_rgb(Rgb888::WHITE, Point::zero()));
    let in_front = options.with_depth_test(Biased::in_front(TestAndWrite));
    let silhouettes = ISLAND.outline(&SILHOUETTES, LineStyle::HAIRLINE);
    canvas.draw_with(&in_front, silhouettes, mvp, &white);
    Ok(drawn)
}

/// Draws the sea and the island, each with its shader.
#[inline]
pub fn surfaces<C: PixelColor>(
    canvas: &mut Canvas<'_, C, impl Storage<C>, impl DepthBuffer>,
    options: &DrawOptions<impl Mode>,
    mvp: &Mvp<impl ProjectionKind>,
    (sea, island): (&impl ShaderFor<C>, &impl ShaderFor<C>),
) -> [Drawn; 2] {
    let sea = canvas.draw_with(options, &SEA, mvp, sea);
    [sea, canvas.draw_with(options, &ISLAND, mvp, island)]
}
