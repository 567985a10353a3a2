//! Depths in each format, for increasing ratios of the far plane's distance to the near plane's distance.

use std::array::from_fn;
use std::fs;
use std::path::{Path, PathBuf};

use embedded_graphics::pixelcolor::Gray8;
use fixel::canvas::{DepthBuffer, FloatDepth, WideFloatDepth};
use fixel::prelude::*;
use fixel::view::Perspective;
use rand::Rng;

use crate::triangle::Triangle;
use support::bounds;
use support::drawing::Raw;
use support::mode::Mode;
use support::moves::{number, rounded};
use support::random::{Random, cases, sampled, within};

const SIZE: (u32, u32) = (64, 48);
/// The length in pixels of one unit at distance 1.
const FOCAL: f64 = 40.;

/// A point of eye space at a position on the picture and a distance.
fn unproject([x, y]: [f64; 2], w: f64) -> Vec3 {
    let middle = [f64::from(SIZE.0) / 2., f64::from(SIZE.1) / 2.];
    let at = [(x - middle[0]) * w / FOCAL, (middle[1] - y) * w / FOCAL, -w];
    rounded(at)
}

fn projection(near: f64, far: f64) -> Projection<Perspective> {
    let [focal, near, far] = [FOCAL, near, far].map(number);
    Projection::from_focal_length(focal, SIZE, near, far).unwrap()
}

/// A rectangle larger than the picture, with these distances at its left and right sides.
fn wall([left, right]: [f64; 2]) -> [Vec3; 4] {
    let [wide, high] = [f64::from(SIZE.0), f64::from(SIZE.1)];
    [
        unproject([-1., high + 1.], left),
        unproject([wide + 1., high + 1.], right),
        unproject([wide + 1., -1.], right),
        unproject([-1., -1.], left),
    ]
}

/// Draws a wall, and then a wall that is farther away by the fraction `gap`. Returns the number of pixels that show the
/// farther wall.
fn wrong<D: DepthBuffer>(
    mode: Mode,
    mut canvas: Canvas<'_, Gray8, Native, D>,
    projection: Projection<Perspective>,
    distances: [f64; 2],
    gap: f64,
) -> usize {
    canvas.clear(Gray8::new(0));
    for (gray, scale) in [(1, 1.), (2, 1. + gap)] {
        let positions = wall(distances.map(|w| w * scale));
        let mesh = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        mode.draw(
            &mut canvas,
            &DrawOptions::new(),
            &mesh,
            &projection.into(),
            // This shader has varyings, so each mode interpolates.
            &Raw(Some(Gray8::new(gray))),
        );
    }
    assert!(canvas.pixels().all(|pixel| pixel != Gray8::new(0)));
    let wrong = |pixel: &Gray8| *pixel == Gray8::new(2);
    canvas.pixels().filter(wrong).count()
}

/// Distances that begin with `first`. Each is `factor` times as large as the one before it.
fn series(first: f64, factor: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(first), move |w| Some(w * factor)).take_while(|&w| w < 32_768.)
}

/// Draws two walls in a mode and a depth format. Returns the number of pixels that show the farther wall.
fn wrong_in<F: DepthBuffer>(
    mode: Mode,
    projection: Projection<Perspective>,
    distances: [f64; 2],
    gap: f64,
) -> usize {
    let mut colors = [Gray8::new(0); 64 * 48];
    let mut depths = [0; 64 * 48];
    let canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
    let canvas = canvas.with_depth_format::<F>(&mut depths).unwrap();
    wrong(mode, canvas, projection, distances, gap)
}

/// Whether a format is certain to tell two walls apart. The format's steps are the fraction `step` of the distance.
fn is_certain(step: f64, near_end: f64, slant: f64, gap: f64) -> bool {
    // A vertex has an error of 2^-17 in space, and of 1/512 pixel on the screen, where w changes by up to a sixteenth
    // per pixel. So twice 2^-17 / near_end and twice 1/8192 must stay well below the gap minus a step.
    gap - step - 2. / 8192. * (slant - 1.) / 3. > 3e-5 / near_end
}

/// Walls are a hundredth or a thousandth apart, face the eye or slant, and stand at all distances up to the far plane.
/// With floating-point depth, each wall hides the wall behind it, as far as the format reaches. With linear depth, each
/// wall hides the wall behind it if a step is finer than the gap.
#[test]
fn surfaces_behind_stay_hidden() {
    for (near, ratio) in [
        (0.25, 10.),
        (0.25, 100.),
        (0.25, 1e3),
        (0.25, 1e4),
        (0.25, 65_536.),
        (1. / 32., 1e6),
    ] {
        let projection = projection(near, near * ratio);
        for gap in [0.01, 0.001] {
            let (mut walls, mut linear_fails, mut float_fails) = (0, 0, 0);
            for slant in [1., 4.] {
                // All distances, and distances with a power of two between the two walls, so that the walls' 1/w have
                // different exponents.
                let near_ends = series(1.02 * near, 1.37).chain(series(1.99 * near, 2.));
                // The farther wall must lie in front of the far plane, because all linear depths are 0 there.
                let is_before = |w: &f64| w * slant * (1. + gap) < 0.99 * near * ratio;
                for near_end in near_ends.filter(is_before) {
                    let distances = [near_end, near_end * slant];
                    // In the last step of its range, the format stores depths as 0.
                    let float_reaches = distances[1] * (1. + gap) < 65_500. * near;
                    let mut fails = false;
                    for mode in Mode::PERSPECTIVE {
                        let pixels = wrong_in::<FloatDepth>(mode, projection, distances, gap);
                        fails |= pixels > 0;
                        assert!(
                            pixels == 0
                                || !float_reaches
                                || !is_certain(1. / 4096., near_end, slant, gap),
                            "{mode:?}: {pixels} wrong pixels at {distances:?}, gap {gap}"
                        );
                        let pixels = wrong_in::<WideFloatDepth>(mode, projection, distances, gap);
                        assert!(
                            pixels == 0 || !is_certain(1. / 2048., near_end, slant, gap),
                            "wide, {mode:?}: {pixels} wrong pixels at {distances:?}, gap {gap}"
                        );
                    }
                    let pixels = wrong_in::<LinearDepth>(Mode::Newton, projection, distances, gap);
                    let steps = 65535. * near / distances[1] * (1. - 1. / (1. + gap));
                    assert!(
                        pixels == 0 || steps < 1.5,
                        "linear: {distances:?}, {steps} steps"
                    );
                    walls += 1;
                    linear_fails += usize::from(pixels > 0);
                    float_fails += usize::from(fails);
                }
            }
            println!(
                "far/near {ratio}, gap {gap}: {walls} walls, linear wrong at {linear_fails}, float at {float_fails}"
            );
            // Relative to the wall's distance, a step of linear depth is 1/65535 of the wall's distance / the near
            // plane's distance.
            let is_too_much = ratio > 2. * 65535. * gap;
            assert!(
                linear_fails > 0 || !is_too_much,
                "far/near {ratio}, gap {gap}"
            );
            assert!(float_fails > 0 || ratio < 2. * 65_536.);
        }
    }
}

/// The greatest far/near with the default format, by the rule in the guide (concepts, Depth).
const MOST: f64 = 500.;

/// With planes that keep the rule, walls 1 % apart hide each other at all distances and in all modes. The farthest pair
/// differs by 65535 / 500 · (1.01 − 1) = 1.31 steps of depth, and two depths that differ by more than a step and their
/// errors of 0.003 are stored as different numbers. Twice the ratio would not do: there, the difference is 0.66 steps, so
/// that a third of the pairs have equal depths.
#[test]
fn walls_hide_each_other_under_the_rule_for_the_planes() {
    for near in [1. / 64., 0.2, 0.5, 10.] {
        let projection = projection(near, near * MOST);
        for slant in [1., 4.] {
            // The farther wall ends at the far plane, or before it. Its vertices are rounded to 2^-17.
            let last = near * MOST / slant / 1.01 - 0.001;
            for w in series(1.02 * near, 1.21)
                .take_while(|&w| w < last)
                .chain([last])
            {
                for mode in Mode::PERSPECTIVE {
                    let distances = [w, w * slant];
                    let pixels = wrong_in::<LinearDepth>(mode, projection, distances, 0.01);
                    assert_eq!(pixels, 0, "{mode:?}, near {near}: {distances:?}");
                }
            }
        }
        let double = self::projection(near, near * MOST * 2.);
        let wrong = (0..10).any(|at| {
            let w = near * MOST * 2. * (0.98 - 0.002 * f64::from(at));
            wrong_in::<LinearDepth>(Mode::Newton, double, [w, w], 0.01) > 0
        });
        assert!(wrong, "near {near}: the rule could allow twice the ratio");
    }
}

/// The example in the guide of planes that break the rule.
#[test]
fn a_near_plane_too_close_shows_hidden_squares() {
    let (projection, distance, gap) = (projection(0.01, 100.), [90., 90.], 3. / 90.);
    let wrong = wrong_in::<LinearDepth>(Mode::Newton, projection, distance, gap);
    assert_eq!(wrong, 64 * 48);
    let wrong = wrong_in::<FloatDepth>(Mode::Newton, projection, distance, gap);
    assert_eq!(wrong, 0);
}

/// All source files in a folder, but not `trade`, which measures modes on triangles of all depths and draws without a
/// depth buffer.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("trade") && !path.ends_with("target") {
            sources(&path, found);
        } else if path
            .extension()
            .is_some_and(|end| end == "rs" || end == "md")
        {
            found.push(path);
        }
    }
}

/// The distances of the near and the far plane in each perspective projection of a text that names both as literals.
/// Unit tests at the end of a file do not count.
fn planes(text: &str) -> Vec<[f64; 2]> {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let calls = ["::perspective(", "::from_focal_length("].into_iter();
    let calls = calls.flat_map(|name| text.split(name).skip(1));
    let planes = calls.filter_map(|call| {
        let mut open = 1;
        let end = call.find(|letter| {
            open += i32::from(letter == '(') - i32::from(letter == ')');
            open == 0
        })?;
        let mut numbers = call[..end].rsplit("fx!(").map(|rest| {
            let number = rest.split(')').next().unwrap_or_default();
            number.replace('_', "").parse().ok()
        });
        let [far, near] = [numbers.next()??, numbers.next()??];
        Some([near, far])
    });
    planes.collect()
}

/// All examples in the README, in the documentation and in the programs keep the rule, except those that are refused.
#[test]
fn examples_keep_the_rule_for_the_planes() {
    let project = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = vec![project.join("README.md")];
    sources(&project.join("src"), &mut files);
    sources(&project.join("examples"), &mut files);
    let mut count = 0;
    for file in files {
        for [near, far] in planes(&fs::read_to_string(&file).unwrap()) {
            count += 1;
            assert!(
                far <= near * MOST || near <= 0.,
                "{}: the far plane at {far} is more than {MOST} times as far away as the near plane at {near}",
                file.display()
            );
        }
    }
    // At the time of writing, there are 120. If there are far fewer, the scan no longer understands the programs.
    assert!(count > 80, "{count} projections found");
}

/// The code of a depth in a format with `exponent_bits` bits of exponent. The code is not yet rounded down.
fn code(depth: f64, exponent_bits: i32) -> f64 {
    let steps = 2_f64.powi(16 - exponent_bits);
    let exponent = depth.log2().floor();
    // Depths just below 2^16, at the near plane, have the last code.
    steps * (exponent - 17. + 2_f64.powi(exponent_bits) + depth / exponent.exp2())
}

/// The distance of the near plane in the tests of triangles.
const NEAR: f64 = 1. / 64.;

/// A triangle in any part of the range up to `farthest`. The ratio of its corners' distances is at most 8,192.
///
/// 1/w is linear on the screen, so almost all pixels of a triangle are about as near as its near end, where the error of
/// 1/w is far less than a step. Therefore, two of three triangles have two far corners, with pixels along the line
/// between them. A small triangle's line leads along the centers of pixels. A large triangle's line crosses the picture
/// from top to bottom, and its near corner is often far outside the picture.
fn triangle(random: &mut Random, farthest: f64) -> Triangle<Perspective, 0> {
    let nearest = random.random_range(0.0..(farthest / 2000. * 32_768.).log2());
    let octaves = random.random_range(0.0..13_f64);
    let at = |octaves: f64| (NEAR * 1.02 * octaves.exp2()).min(farthest);
    let (near, far) = (at(nearest), at(nearest + octaves));
    let positions = match random.random_range(0..3) {
        0 => from_fn(|_| {
            let place = within(random, [-8.0..72., -8.0..56.]);
            unproject(place, at(nearest + octaves * random.random_range(0.0..1.)))
        }),
        1 => {
            let center = f64::from(random.random_range(20..44)) + 0.5;
            let [x, y] = within(random, [-20.0..20., -6.0..6.]);
            let [top, bottom] = within(random, [-0.02..0.02, -0.02..0.02]).map(|x| center + x);
            [
                unproject([center + x, 24. + y], near),
                unproject([top, 16.], far),
                unproject([bottom, 32.], far),
            ]
        }
        _ => {
            // Coordinates stay below 32,768.
            let reach = 2000_f64.min(32_000. * FOCAL / near);
            let [x, y] = within(random, [-reach..reach, -reach..reach]);
            let [top, bottom] = within(random, [0.0..64., 0.0..64.]);
            [
                unproject([32. + x, 24. + y], near),
                unproject([top, -16.], far),
                unproject([bottom, 64.], far),
            ]
        }
    };
    let w = positions.map(|p| -f64::from(p.z));
    Triangle {
        size: SIZE,
        mvp: projection(NEAR, 32_000.).into(),
        positions,
        values: [],
        w,
        depth: w.map(|w| 65535. * NEAR / w),
    }
}

/// Draws triangles in every mode. Each depth must be the model's depth, rounded down to a step. The error of
/// interpolation is allowed. Up to `reach` times as far away as the near end of a triangle, this error must be at most
/// half a step.
fn depths_are_the_models<F: DepthBuffer>(exponent_bits: i32, farthest: f64, reach: f64) {
    let (mut pixels, mut far, mut most, mut closest) = (0, 0, 0_f64, 0_f64);
    cases(sampled(2000), |random| {
        let triangle = triangle(random, farthest);
        let Some(screen) = triangle.screen() else {
            return;
        };
        let model = triangle.model(screen);
        let nearest = triangle.w.into_iter().fold(f64::MAX, f64::min);
        for mode in Mode::PERSPECTIVE {
            let depths = triangle.depths::<F>(mode);
            for at in &model {
                let [x, y] = at.pixel.map(|at| usize::try_from(at).unwrap());
                let stored = f64::from(depths[y * SIZE.0 as usize + x]);
                // 1/w has an error relative to the nearest corner's 1/w. With e bits of exponent, a code has 16 - e
                // bits of mantissa, and its step is between 2^-(17 - e) and 2^-(16 - e) of the depth.
                let error =
                    2_f64.powi(17 - exponent_bits) * bounds::inverse_w(triangle.w) * at.w / nearest;
                let wanted = code(at.depth, exponent_bits);
                assert!(
                    stored <= wanted.max(0.) + error && wanted < stored + 1. + error,
                    "{mode:?}: {:?} at {:?}: depth {stored} is not {wanted}, within {error}",
                    triangle.positions,
                    at.pixel
                );
                pixels += 1;
                let beyond = (stored - wanted.max(0.)).max(wanted - stored - 1.);
                closest = closest.max(beyond / error);
                // The documentation states figures for triangles within this range.
                if at.w <= reach * nearest {
                    most = most.max(beyond);
                }
                far += u32::from(at.w > reach / 4. * nearest);
            }
        }
    });
    println!(
        "{pixels} depths with {exponent_bits} bits of exponent, {far} of them far: {most:.3} outside their step at \
         most, {closest:.3} of the bound"
    );
    assert!(
        pixels > sampled(200_000) && far > sampled(2000) && most <= 0.5,
        "{pixels} pixels, {far} far, {most}"
    );
    // Some depths come near the bound, so that an error of twenty times as many units fails.
    assert!(closest > 0.05, "{closest}");
}

#[test]
fn float_depths_are_the_models() {
    depths_are_the_models::<FloatDepth>(4, 2000., 3000.);
}

/// Distances are up to two million times the near plane's distance.
#[test]
fn wide_float_depths_are_the_models() {
    depths_are_the_models::<WideFloatDepth>(5, 31_000., 6000.);
}
