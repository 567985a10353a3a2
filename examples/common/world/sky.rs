//! The sky: colors by height and direction, stars, and a moon.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::Index;
use fixel::canvas::{Add, DepthBuffer, NoTest, Storage};
use fixel::mode::Mode;
use fixel::prelude::*;

use super::textures::{HALO, MOON};

/// The color of everything in thick air.
pub const HAZE: Rgb888 = Rgb888::new(92, 70, 100);

const SLICES: u32 = 12;
const STACKS: u32 = 14;
const BALL: Mesh = shape!(sphere(SLICES, STACKS))
    .without_edges()
    .without_uvs()
    .without_normals();
const CORNERS: usize = ((SLICES + 1) * (STACKS + 1)) as usize;
/// The faces above the horizon, which are drawn. All rows have two faces for each slice, but the first and the last have
/// one.
const ABOVE: usize = (SLICES * (STACKS - 1)) as usize;

/// The color in a direction of length 1: dark blue above, purple haze in the east, and the afterglow of the sun in the
/// west. Below the horizon, everything is mirrored.
const fn color(direction: Vec3) -> Rgb888 {
    let [x, y, _] = direction.to_bits();
    // From 0 to 256: `west` from east to west, and `low` from the zenith down to the horizon.
    let west = (0x1_0000 - x) >> 9;
    let low = 256 - (y.unsigned_abs() >> 8) as i32;
    // `haze` is (low/256)². The glow decreases with the square of `haze`, so the glow reaches less high than the haze.
    let haze = (low * low) >> 8;
    let glow = (((haze * haze) >> 8) * ((west * west) >> 8)) >> 8;
    Rgb888::new(
        (16 + ((haze * 70 + glow * 165) >> 8)) as u8,
        (20 + ((haze * 46 + glow * 62) >> 8)) as u8,
        (58 + ((haze * 48 - glow * 44) >> 8)) as u8,
    )
}

static DOME: Mesh = {
    static COLORS: [Rgb888; CORNERS] = {
        let mut colors = [HAZE; CORNERS];
        let mut at = 0;
        while at < CORNERS {
            if let Some(point) = BALL.positions().get(at) {
                colors[at] = color(point);
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

/// Draws the sky. Everything is nearer, and is to be drawn later. The view is the view of a [camera in the middle of the
/// sky](Camera::sky).
pub fn draw(
    canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
    options: &DrawOptions<impl Mode>,
    view: &Mvp,
) -> Result<(), Error> {
    let behind = options.with_depth_test(NoTest).with_cull(Cull::Nothing);
    let dome = *view * Transform::scale(fx!(30));
    canvas.draw_with(&behind, &DOME.part(0..ABOVE), &dome, &Gouraud::new());

    let shining = behind.with_blending(Add);
    let stars = Sprites::in_pixels(&STARS.0, (fx!(1), fx!(1)))?.with_colors(&STARS.1)?;
    canvas.draw_with(&shining, &stars, &dome, &Gouraud::new());

    let halo = Textured::new(&HALO).clamped();
    canvas.draw_with(
        &shining,
        &Sprites::new(&[MOON_AT], (fx!(9.5), fx!(9.5)))?,
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

/// The water's surface between its edges `least` and `most` is a grid of rectangles: their number along a side.
const GRID: usize = 4;
const POINTS: usize = (GRID + 1) * (GRID + 1);

static GRID_FACES: [[Index; 3]; 2 * GRID * GRID] = {
    let mut faces = [[0; 3]; 2 * GRID * GRID];
    let mut at = 0;
    while at < GRID * GRID {
        let first = (at / GRID * (GRID + 1) + at % GRID) as Index;
        let below = first + GRID as Index + 1;
        faces[2 * at] = [first, below, below + 1];
        faces[2 * at + 1] = [first, below + 1, first + 1];
        at += 1;
    }
    faces
};

/// Draws what the water between two corners of its surface mirrors of the sky. Everything is to be drawn later.
pub fn mirror(
    canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
    options: &DrawOptions<impl Mode>,
    view: &Mvp,
    eye: Vec3,
    [least, most]: [Vec3; 2],
) -> Result<(), Error> {
    let part = (most - least) / fx!(const GRID as u32);
    let points: [Vec3; POINTS] = core::array::from_fn(|at| {
        let (row, column) = ((at / (GRID + 1)) as i32, (at % (GRID + 1)) as i32);
        least + Vec3::new(part.x * column, part.y, part.z * row)
    });
    let colors = points.map(|point| color((point - eye).normalized().unwrap_or(Vec3::Y)));
    let mesh = Mesh::new(&points, &GRID_FACES)?.with_colors(&colors, None)?;
    canvas.draw_with(
        &options.with_depth_test(NoTest),
        &mesh,
        view,
        &Gouraud::new(),
    );
    Ok(())
}
