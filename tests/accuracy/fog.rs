//! Fog at every pixel of a plane, compared with the formula in f64.

use embedded_graphics::pixelcolor::{Gray8, GrayColor, PixelColor, Rgb565, RgbColor};
use fixel::prelude::*;
use fixel::texture::Blend;
use rand::Rng;

use support::random::{cases, within};
use support::reference::fog::{exponential, linear};

const SIZE: u32 = 48;
/// The length in pixels of one unit at distance 1.
const FOCAL: f64 = 24.;

/// A plane through (0, 0, −distance) that leans to the right and upward: 1/z is linear on the screen.
#[derive(Clone, Copy, Debug)]
struct Plane {
    distance: f64,
    lean: [f64; 2],
}

impl Plane {
    /// The distance at a position on the screen, in pixels; infinite beyond the horizon.
    fn at(&self, x: f64, y: f64) -> f64 {
        let half = f64::from(SIZE) / 2.;
        let [u, v] = [(x - half) / FOCAL, (half - y) / FOCAL];
        let share = 1. + self.lean[0] * u + self.lean[1] * v;
        if share <= 0. {
            f64::INFINITY
        } else {
            self.distance / share
        }
    }

    /// The corners of a triangle in the plane. The triangle contains the picture.
    fn corners(&self) -> Option<[Vec3; 3]> {
        let corner = |u: f64, v: f64| {
            let share = 1. + self.lean[0] * u + self.lean[1] * v;
            let z = self.distance / share;
            (share > 0.05).then(|| Vec3::try_from([u * z, v * z, -z]).ok())?
        };
        Some([corner(-1.5, -1.5)?, corner(4., -1.5)?, corner(-1.5, 4.)?])
    }
}

/// Draws the plane in black with white fog. Returns the brightness of each pixel, from 0 to 1.
fn white<C: Blend + PixelColor + 'static>(
    shader: impl ShaderFor<C>,
    corners: &[Vec3; 3],
    black: C,
    luma: impl Fn(C) -> f64,
) -> Vec<f64> {
    let mesh = Mesh::new(corners, &[[0, 1, 2]]).unwrap();
    let projection =
        Projection::from_focal_length(fx!(24), (SIZE, SIZE), fx!(0.01), fx!(4000)).unwrap();
    let mut pixels = vec![black; (SIZE * SIZE) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIZE, SIZE).unwrap();
    canvas.draw_with(
        &DrawOptions::new().with_cull(Cull::Nothing),
        &mesh,
        &projection,
        &shader,
    );
    pixels.into_iter().map(luma).collect()
}

/// Checks the fog of each pixel. `left` returns the part of the surface that shows at a distance. Because corners are
/// rounded to 1/256 pixel, a range of distances is allowed. The blended color can have an error of half a step of the
/// weight, plus half a step of the color, plus 1/256 (the tolerance of interpolation), plus 58 units of 2^-14 by
/// rounding (57 at a pixel in `Newton`, and one at a corner), plus `more`.
fn check(
    plane: &Plane,
    shown: &[f64],
    steps: f64,
    weights: f64,
    more: f64,
    left: impl Fn(f64) -> f64,
) {
    let tolerance = 0.5 / steps + 0.5 / weights + 1. / 256. + 58. / 16_384. + more;
    for (i, shown) in shown.iter().enumerate() {
        let at = [i % SIZE as usize, i / SIZE as usize].map(|at| at as f64 + 0.5);
        // A corner that is rounded by 1/512 pixel tilts the plane a little.
        let moves = [-0.01, 0.01];
        let expected = moves
            .into_iter()
            .flat_map(|x| moves.map(|y| 1. - left(plane.at(at[0] + x, at[1] + y))));
        let (low, high) = expected.fold((1_f64, 0_f64), |(low, high), white| {
            (low.min(white), high.max(white))
        });
        assert!(
            (low - tolerance..=high + tolerance).contains(shown),
            "{shown} is not between {low} and {high} at {at:?}"
        );
    }
}

#[test]
fn fog_is_correct_in_perspective_at_every_pixel() {
    cases(400, |random| {
        let distance = random.random_range(0.5..60_f64);
        let lean = within(random, [-0.54..0.54, -0.54..0.54]);
        let near = random.random_range(0.1..1.5_f64);
        let length = random.random_range(0.1..3_f64);
        let density = random.random_range(0.0..3_f64);
        let plane = Plane { distance, lean };
        let Some(corners) = plane.corners() else {
            return;
        };
        let [near, far] = [near, near + length].map(|at| Scalar::try_from(at * distance).unwrap());
        let left = |z: f64| linear(z, f64::from(near), f64::from(far));
        let gray = |color: Gray8| f64::from(color.luma()) / 255.;

        let fog = Fog::linear(Gray8::WHITE, near, far).unwrap();
        let shown = white(
            Flat::new(Gray8::BLACK).in_fog(fog),
            &corners,
            Gray8::BLACK,
            gray,
        );
        check(&plane, &shown, 255., 256., 0., left);

        let fog = Fog::linear(Rgb565::WHITE, near, far).unwrap();
        let shown = white(
            Flat::new(Rgb565::BLACK).in_fog(fog),
            &corners,
            Rgb565::BLACK,
            |color| f64::from(color.g()) / 63.,
        );
        check(&plane, &shown, 63., 32., 0., left);

        // The parabola has an error of at most 0.0019, and its products have an error of 3 units of 2^-14. The density
        // has steps of 2^-16, and the logarithm's factor has an error of 3e-5.
        let density = Scalar::try_from(density / distance).unwrap();
        let fog = Fog::exponential(Gray8::WHITE, density).unwrap();
        let shown = white(
            Flat::new(Gray8::BLACK).in_fog(fog),
            &corners,
            Gray8::BLACK,
            gray,
        );
        check(&plane, &shown, 255., 256., 0.0022, |z| {
            exponential(z, f64::from(density))
        });
    });
}
