//! Hills in fog, drawn in bands. The program computes the hills and their normals, and colors them by height.

use embedded_graphics::{geometry::Size, pixelcolor::Rgb565, pixelcolor::Rgb888};
use fixel::{Index, prelude::*, shade::Gradient};

static WATER: Mesh = shape!(plane(1, 1));
/// The number of squares along a side.
const SIDE: usize = 32;
const CORNERS: usize = (SIDE + 1) * (SIDE + 1);

/// The height of the ground: waves of several lengths and directions.
fn ground_at(x: Scalar, z: Scalar) -> Scalar {
    let wave = |turns, height: Scalar| height * Angle::from_turns(turns).sin();
    wave(x / 11 + z / 31, fx!(1.1)) + wave(z / 9 - x / 23, fx!(0.9)) + wave((x + z) / 4, fx!(0.18))
}

/// The number of pixels of a band. Colors and depths of a band take 20 KiB; on a chip, they are statics.
const BAND: u32 = 320 * 16;

pub fn draw(display: &mut Canvas<'_, Rgb565, Native, LinearDepth>, ms: u64) -> Result<(), Error> {
    let Size { width, height } = display.frame_size();
    let projection = Projection::perspective(deg!(45), (width, height), fx!(0.5), fx!(60))?;
    let sway = Rate::millihertz(500).angle_at(ms);
    let aside = Vec3::new(fx!(2) * sway.sin(), fx!(0.8) * sway.cos(), fx!(0));
    let eye = vec3!(-8, 4.4, 13) + aside;
    let view = projection * Camera::look_at(eye, vec3!(0, -0.5, 0), Vec3::Y)?;
    let positions: [Vec3; CORNERS] = core::array::from_fn(|at| {
        let place = |at: usize| Scalar::from(at as u8) * 3 / 4 - fx!(12);
        let (x, z) = (place(at % (SIDE + 1)), place(at / (SIDE + 1)));
        Vec3::new(x, ground_at(x, z), z)
    });
    let faces: [[Index; 3]; 2 * SIDE * SIDE] = core::array::from_fn(|at| {
        let (row, column) = (at / 2 / SIDE, at / 2 % SIDE);
        let first = (row * (SIDE + 1) + column) as Index;
        let below = first + SIDE as Index + 1;
        [[first, below, below + 1], [first, below + 1, first + 1]][at % 2]
    });
    let mut normals = [Vec3::ZERO; CORNERS];
    let hills = Mesh::new(&positions, &faces)?.with_smooth_normals(&mut normals)?;
    let haze = Rgb565::new(20, 45, 27);
    let fog = Fog::linear(haze, fx!(14), fx!(44))?;
    let sun = Light::new(vec3!(3, 2, 1), fx!(0.25), fx!(0.75))?;
    let (grass, snow) = (Rgb888::new(60, 110, 40), Rgb888::new(250, 245, 230));
    let heights = Gradient::new((fx!(-0.6), grass), (fx!(1.8), snow))?;
    let ground = heights.lit(sun).in_fog(fog).dithered();
    let blue = Flat::rgb(Rgb888::new(50, 90, 140)).in_fog(fog);
    // Level water hides the ground below it.
    let lake = view * Transform::translate(vec3!(0, -0.9, 0)) * Transform::scale(fx!(12));

    let (mut colors, mut depths) = ([haze; BAND as usize], [0; BAND as usize]);
    let rows = BAND / width;
    for first_row in (0..height).step_by(rows as usize) {
        let pixels = (width * rows.min(height - first_row)) as usize;
        let band = Canvas::band(&mut colors[..pixels], width, height, first_row)?;
        let mut band = band.with_depth(&mut depths[..pixels])?;
        band.clear(haze);
        band.draw(&hills, &view, &ground);
        band.draw(&WATER, &lake, &blue);
        band.show(display)?;
    }
    Ok(())
}
