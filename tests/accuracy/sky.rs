//! A sky compared with rays in f64. From all positions of the eye, a direction shows the same color, and the color
//! depends only on the direction's height. Half of the cameras show a mirror image.

use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb888};
use fixel::canvas::NoTest;
use fixel::prelude::*;
use fixel::shade::Gradient;
use rand::Rng;

use support::moves::exact;
use support::random::{Random, cases, within};
use support::reference::linear::{self, cross, normalized, subtract};
use support::reference::ray::hit;

const SIZE: u32 = 24;
/// The length in pixels of one unit at distance 1.
const FOCAL: f64 = 20.;
static DOME: Mesh = shape!(sphere(12, 8));

/// A random eye, and a target that is not straight above or below it.
fn look(random: &mut Random) -> Option<(Vec3, Vec3)> {
    let size = f64::from(random.random_range(0..14_i32)).exp2();
    let eye = within(random, [-1.0..1.0, -1.0..1.0, -1.0..1.0]).map(|at| at * size);
    let way = within(random, [-2.0..2.0, -2.0..2.0, -2.0..2.0]);
    let [eye, target] =
        [eye, std::array::from_fn(|i| eye[i] + way[i])].map(|at| Vec3::try_from(at).unwrap());
    let [x, _, z] = subtract(exact(target), exact(eye));
    (x.hypot(z) > 0.1).then_some((eye, target))
}

/// The triangles of the dome.
fn triangles() -> Vec<[linear::Vec3; 3]> {
    let positions: Vec<_> = DOME.positions().iter().map(exact).collect();
    let corners = |face: &[u16; 3]| face.map(|corner| positions[usize::from(corner)]);
    DOME.faces().iter().map(corners).collect()
}

/// The gray at a height, from 0 to 255.
fn gray(height: f64, [bottom, top]: [f64; 2], [low, high]: [u8; 2]) -> f64 {
    let share = ((height - bottom) / (top - bottom)).clamp(0., 1.);
    f64::from(low) + (f64::from(high) - f64::from(low)) * share
}

/// A gray can have an error of half a step by rounding, of 1/15 at the corners (the promise of [`Gradient`]), and of
/// 1/8 by interpolation (the promise of the modes). Corners on the screen are rounded to 1/256 pixel. This rounding
/// moves a pixel of the dome by up to 1/512 pixel, and the pixel's values a little more, because triangles are tilted.
/// The test allows a hundredth of a pixel in each direction. The camera's rotation has 30 bits, and adds no error.
#[test]
fn a_sky_shows_the_height_of_each_direction() {
    const TOLERANCE: f64 = 0.5 + 1. / 15. + 1. / 8.;
    let triangles = triangles();
    let projection =
        Projection::from_focal_length(fx!(20), (SIZE, SIZE), fx!(0.5), fx!(100)).unwrap();
    let mut judged = 0;
    cases(60, |random| {
        let Some((eye, target)) = look(random) else {
            return;
        };
        let bottom = random.random_range(-1.0..0.8_f64);
        let heights =
            [bottom, random.random_range(bottom + 0.1..1.)].map(|at| Scalar::try_from(at).unwrap());
        let colors: [u8; 2] = random.random();
        let sky = Gradient::new(
            (heights[0], Rgb888::new(colors[0], colors[0], colors[0])),
            (heights[1], Rgb888::new(colors[1], colors[1], colors[1])),
        )
        .unwrap();
        let camera = Camera::look_at(eye, target, Vec3::Y).unwrap();
        let side = if random.random() { 1 } else { -1 };
        let mirror = Transform::scale_axes(Vec3::from_ints(side, 1, 1));
        let camera = Camera::from_view(mirror * camera.view());
        let mut pixels = [Gray8::BLACK; (SIZE * SIZE) as usize];
        let mut canvas = Canvas::new(&mut pixels, SIZE, SIZE).unwrap();
        let behind = DrawOptions::new()
            .with_cull(Cull::Front)
            .with_depth_test(NoTest);
        let mvp = projection * camera.sky() * Transform::scale(fx!(10));
        canvas.draw_with(&behind, &DOME, &mvp, &sky);

        // The axes of the camera, as look-at defines them.
        let ahead = normalized(subtract(exact(target), exact(eye)));
        let right = normalized(cross(ahead, [0., 1., 0.]));
        let up = cross(right, ahead);
        let heights = heights.map(f64::from);
        let expected = |x: f64, y: f64| {
            let [u, v] = [
                (x - f64::from(SIZE) / 2.) / FOCAL,
                (f64::from(SIZE) / 2. - y) / FOCAL,
            ];
            let u = f64::from(side) * u;
            let direction = std::array::from_fn(|i| ahead[i] + u * right[i] + v * up[i]);
            let found = triangles
                .iter()
                .find_map(|&corners| Some((corners, hit(direction, corners)?)));
            // Because of rounding, a ray through an edge can miss both triangles.
            let (corners, parts) = found?;
            let shares = corners.into_iter().zip(parts);
            Some(
                shares
                    .map(|(corner, part)| part * gray(corner[1], heights, colors))
                    .sum::<f64>(),
            )
        };
        for (i, shown) in pixels.iter().enumerate() {
            let at = [i % SIZE as usize, i / SIZE as usize].map(|at| at as f64 + 0.5);
            let moves = [-0.01, 0.01];
            let around: Option<Vec<f64>> = moves
                .iter()
                .flat_map(|x| moves.map(|y| expected(at[0] + x, at[1] + y)))
                .collect();
            let Some(around) = around else { continue };
            let low = around.iter().copied().fold(f64::INFINITY, f64::min) - TOLERANCE;
            let high = around.iter().copied().fold(f64::NEG_INFINITY, f64::max) + TOLERANCE;
            let shown = f64::from(shown.luma());
            assert!(
                (low..=high).contains(&shown),
                "{shown} is not between {low} and {high} at {at:?}"
            );
            judged += 1;
        }
    });
    assert!(judged > 25_000, "{judged}");
}
