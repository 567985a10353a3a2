//! A floor of tiles: on the left without mipmaps, on the right with them.

use embedded_graphics::pixelcolor::{Rgb565, WebColors};
use fixel::canvas::{LinearDepth, Native};
use fixel::prelude::*;
use fixel::shade::Mipmapped;
use fixel::texture::{Mipmap, MipmapArray};

/// Four tiles with dark joints, of 16x16 texels. The levels are made at compile time.
static TILES: MipmapArray<Rgb565, 16, 16, { Mipmap::<Rgb565>::len(16, 16) }> =
    MipmapArray::rgb565(&{
        let mut bytes = [0; 16 * 16 * 2];
        let mut at = 0;
        while at < bytes.len() {
            let (row, column) = (at / 2 / 16, at / 2 % 16);
            let color: [u8; 2] = match (row % 8, column % 8) {
                (0, _) | (_, 0) => [0x39, 0x08],
                _ if (row / 8 + column / 8) % 2 == 0 => [0xff, 0x18],
                _ => [0xdc, 0x0c],
            };
            [bytes[at], bytes[at + 1]] = color;
            at += 2;
        }
        bytes
    });

/// Half of the floor, 60 units wide and 60 long, with a repeat of the texture on each unit.
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

    let tiles = TILES.as_mipmap();
    canvas.draw(&HALF, &left, &Textured::new(tiles));
    // The level depends on a pixel's size: on the projection and the frame's size.
    let mipmapped = Mipmapped::new(tiles, &projection, canvas.frame_size())?;
    canvas.draw(&HALF, &right, &mipmapped.trilinear());
    Ok(())
}
