//! The sky: colors by height and direction, stars, and a moon.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::canvas::{Add, DepthBuffer, Storage, TestOnly};
use fixel::mode::Mode;
use fixel::prelude::*;

use super::textures::{HALO, MOON};

/// The color of everything in thick air.
pub const HAZE: Rgb888 = Rgb888::new(92, 70, 100);

const BALL: Mesh = shape!(sphere(12, 14))
    .without_edges()
    .without_uvs()
    .without_normals();
const CORNERS: usize = 13 * 15;

/// Dark blue above, purple haze in the east, and the afterglow of the sun in the west. The part below the horizon shows
/// in the water.
static DOME: Mesh = {
    static COLORS: [Rgb888; CORNERS] = {
        let mut colors = [HAZE; CORNERS];
        let mut at = 0;
        while at < CORNERS {
            if let Some(point) = BALL.positions().get(at) {
                let [x, y, _] = point.to_bits();
                // From 0 to 256: `west` from east to west, and `low` from the zenith down to the horizon.
                let west = (0x1_0000 - x) >> 9;
                let low = 256 - (y.unsigned_abs() >> 8) as i32;
                // `haze` is (low/256)². The glow decreases with the square of `haze`, so the glow reaches less high
                // than the haze.
                let haze = (low * low) >> 8;
                let glow = (((haze * haze) >> 8) * ((west * west) >> 8)) >> 8;
                colors[at] = Rgb888::new(
                    (16 + ((haze * 70 + glow * 165) >> 8)) as u8,
                    (20 + ((haze * 46 + glow * 62) >> 8)) as u8,
                    (58 + ((haze * 48 - glow * 44) >> 8)) as u8,
                );
            }
            at += 1;
        }
        colors
    };
    Mesh::checked(BALL.with_colors(&COLORS, None))
};

const COUNT: usize = 120;

/// The directions and the brightness of stars.
static STARS: ([Vec3; COUNT], [Rgb888; COUNT]) = {
    let mut stars = ([Vec3::ZERO; COUNT], [HAZE; COUNT]);
    let mut at = 0;
    while at < COUNT {
        // Multiples of irrational numbers, modulo 1, spread the stars evenly.
        let turn = Angle::from_bits((at as u32).wrapping_mul(2_654_435_769));
        let (sin, cos) = turn.sin_cos();
        let height = 9_000 + (at * 49_471 % 0x1_0000) as i32;
        stars.0[at] = Vec3::from_bits([sin.to_bits() >> 14, height, cos.to_bits() >> 14]);
        let light = 70 + (at * 97 % 160) as u8;
        stars.1[at] = Rgb888::new(light - 20, light - 25, light);
        at += 1;
    }
    stars
};

/// The direction of the moon.
const MOON_AT: Vec3 = vec3!(9.5, 10.2, -26);

/// Draws the sky behind everything that was drawn before. The view is the view of a [camera in the
/// middle of the sky](Camera::sky).
pub fn draw(
    canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
    options: &DrawOptions<impl Mode>,
    view: &Mvp,
) -> Result<(), Error> {
    let behind = options.with_depth_test(TestOnly).with_cull(Cull::Nothing);
    let dome = *view * Transform::scale(fx!(30));
    canvas.draw_with(&behind, &DOME, &dome, &Gouraud::new());

    let shining = behind.with_blending(Add);
    let stars = Sprites::in_pixels(&STARS.0, (fx!(1), fx!(1)))?.with_colors(&STARS.1)?;
    canvas.draw_with(&shining, &stars, &dome, &Gouraud::new());

    let halo = Textured::new(&HALO).clamped();
    canvas.draw_with(
        &shining,
        &Sprites::new(&[MOON_AT], (fx!(11), fx!(11)))?,
        view,
        &halo,
    );
    let moon = Textured::new(&MOON).clamped();
    canvas.draw_with(
        &behind,
        &Sprites::new(&[MOON_AT], (fx!(2.6), fx!(2.6)))?,
        view,
        &moon,
    );
    Ok(())
}
