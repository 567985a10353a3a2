//! The project's own scene: a lighthouse on its island in the sea, and a line of text.
//!
//! `no_std`, and small enough for a microcontroller's flash: 1,144 triangles, 40 KiB of textures.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::{Alignment, Text};
use embedded_graphics::Drawable;
use fixel::prelude::*;
use fixel::shade::{Converted, Levels, Light, Texture, Textured};
use fixel::target::{DepthBuffer, Storage};
use fixel::view::{Aspect, Kind, Perspective};
use fixel::{Drawn, Vec2};

/// The island and what stands on it; texture coordinates fit [`SKIN`].
pub static ISLAND: Mesh = include_obj!("../assets/lighthouse.obj");
/// The texture of the island.
pub static SKIN: Texture<Rgb565, 128, 128> =
    Texture::from_raw(include_bytes!("../assets/lighthouse.rgb565"));

/// The sea: a level square about the island.
pub static SEA: Mesh = {
    const POSITIONS: [Vec3; 4] = [
        vec3!(-40, 0, -40),
        vec3!(-40, 0, 40),
        vec3!(40, 0, 40),
        vec3!(40, 0, -40),
    ];
    const UVS: [Vec2; 4] = [vec2!(0, 0), vec2!(0, 20), vec2!(20, 20), vec2!(20, 0)];
    match Mesh::new(&POSITIONS, &[[0, 1, 2], [0, 2, 3]]) {
        Ok(mesh) => Mesh::checked(mesh.with_uvs(&UVS, None)),
        error => Mesh::checked(error),
    }
};
/// The texture of the sea, which repeats.
pub static WAVES: Texture<Rgb565, 64, 64> = Texture::from_raw(include_bytes!("../assets/sea.rgb565"));

/// A lens that has the whole lighthouse in the picture.
///
/// # Errors
///
/// None for a picture of a possible size.
pub fn lens(size: impl Into<Aspect>) -> Result<Projection<Perspective>, Error> {
    Projection::perspective(Angle::from_degrees(38), size, fx!(1), fx!(60))
}

/// Before the island, a little above it.
///
/// # Errors
///
/// None: its numbers are constant.
pub fn camera() -> Result<Camera, Error> {
    Camera::look_at(vec3!(3.4, 3.1, 8.4), vec3!(0.35, 1.72, 0), Vec3::Y)
}

/// The afternoon sun, from the right.
///
/// # Errors
///
/// None: its numbers are constant.
pub fn sun() -> Result<Light, Error> {
    Light::new(vec3!(5, 5, 4), fx!(0.4), fx!(0.6))
}

/// Fills the canvas with a sky: blue above, pale towards the horizon.
pub fn sky<C, O, D>(canvas: &mut Canvas<'_, C, O, D>)
where
    C: Levels,
    O: Storage<C>,
    D: DepthBuffer,
{
    canvas.clear(C::from_rgb(Rgb888::new(0, 0, 0), Point::zero()));
    let frame = canvas.frame_size();
    let rows = canvas.rows().clone();
    // The height is at least 1, products fit: at most 2048 · 256.
    let mix = |from: u32, to: u32, y: u32| (from * (frame.height - y) + to * y) / frame.height;
    let colors = rows.clone().flat_map(|y| {
        #[allow(clippy::cast_possible_truncation)] // between two bytes
        let color = Rgb888::new(
            mix(96, 236, y) as u8,
            mix(156, 232, y) as u8,
            mix(214, 216, y) as u8,
        );
        (0..frame.width).map(move |x| {
            C::from_rgb(color, Point::new(x.cast_signed(), y.cast_signed()))
        })
    });
    let area = Rectangle::new(
        Point::new(0, rows.start.cast_signed()),
        Size::new(frame.width, rows.end - rows.start),
    );
    let Ok(()) = canvas.fill_contiguous(&area, colors);
}

/// Draws sea and island; `chain` takes them to the picture.
///
/// # Errors
///
/// None: the light's numbers are constant.
pub fn draw<C, K, O, D>(
    canvas: &mut Canvas<'_, C, O, D>,
    chain: &Chain<K>,
) -> Result<[Drawn; 2], Error>
where
    C: Levels,
    K: Kind,
    O: Storage<C>,
    D: DepthBuffer,
{
    let sea = canvas.draw(&SEA, chain, &Converted::new(Textured::new(&WAVES)));
    let skin = Textured::new(&SKIN).lit(sun()?);
    let island = canvas.draw(&ISLAND, chain, &Converted::new(skin));
    Ok([sea, island])
}

/// Writes what this is into the lower left corner.
pub fn caption<C, O, D>(canvas: &mut Canvas<'_, C, O, D>)
where
    C: Levels,
    O: Storage<C>,
    D: DepthBuffer,
{
    let bottom = canvas.frame_size().height.cast_signed();
    for (offset, grey) in [(1, 0), (0, 255)] {
        let color = C::from_rgb(Rgb888::new(grey, grey, grey), Point::zero());
        let at = Point::new(5 + offset, bottom - 6 + offset);
        let style = MonoTextStyle::new(&FONT_6X10, color);
        let text = Text::with_alignment("fixel: drawn with integers only", at, style, Alignment::Left);
        let Ok(_) = text.draw(canvas);
    }
}
