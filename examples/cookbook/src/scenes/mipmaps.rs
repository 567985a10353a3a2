//! A floor of tiles: on the left without mipmaps, on the right with them.

use embedded_graphics::pixelcolor::{Rgb565, WebColors};
use fixel::prelude::*;
use fixel::texture::Mipmap;

/// A texel of a texture of 16x16 texels. The texture shows four tiles with dark joints.
fn tile(row: usize, column: usize) -> Rgb565 {
    match (row % 8, column % 8) {
        (0, _) | (_, 0) => Rgb565::new(7, 8, 8),
        _ if row / 8 == column / 8 => Rgb565::new(31, 56, 24),
        _ => Rgb565::new(27, 32, 12),
    }
}

/// Half of the floor, 60 units wide and 60 long. The texture repeats on each unit.
static HALF: Mesh = {
    const CORNERS: [Vec3; 4] = [
        vec3!(0, 0, 0),
        vec3!(60, 0, 0),
        vec3!(60, 0, -60),
        vec3!(0, 0, -60),
    ];
    const UVS: [Vec2; 4] = [vec2!(0, 60), vec2!(60, 60), vec2!(60, 0), vec2!(0, 0)];
    Mesh::checked(Mesh::checked(Mesh::new(&CORNERS, &[[0, 1, 2], [0, 2, 3]])).with_uvs(&UVS, None))
};

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(60), canvas.frame_size(), fx!(0.25), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 2, 0), vec3!(0, 0.2, -6), Vec3::Y)?;
    let left = projection * camera * Transform::translate(vec3!(-60, 0, 0));
    let right = projection * camera;
    canvas.clear(Rgb565::CSS_LIGHT_SKY_BLUE);

    // The levels are made in memory; include_texture!("tiles.png", mipmap) makes them at compile time.
    let mut texels = [Rgb565::default(); Mipmap::<Rgb565>::len(16, 16)];
    for (at, texel) in texels[..16 * 16].iter_mut().enumerate() {
        *texel = tile(at / 16, at % 16);
    }
    let tiles = Textured::new(Mipmap::build(&mut texels, 16, 16)?);
    canvas.draw(&HALF, &left, &tiles);
    // The level depends on the size of a pixel, so `mipmapped` needs the projection and the frame's size.
    let mipmapped = tiles.mipmapped(&projection, canvas.frame_size())?;
    canvas.draw(&HALF, &right, &mipmapped.trilinear());
    Ok(())
}
