//! Sized points. The pixels of a point are compared with exact integers, and sizes in world space with f64.

use crate::bands::{CASES, Frame, SIZE, XRecorder, counts, drawn, modeled, point};
use fixel::Window;
use fixel::prelude::*;
use rand::Rng;
use support::counter::{at_subpixel, pixel_projection};
use support::moves::number;
use support::random::{cases, within};
use support::reference::coverage::{Bounds, center, picture};

/// A square reaches half its size from the point in each direction. The square covers the centers inside it and on its
/// right and lower sides, but not on its left and upper sides. A disc covers the centers within half its size, and the
/// pixel that contains the point.
#[test]
fn points_are_the_models() {
    cases(CASES, |random| {
        let (point, is_round) = (point(random, SIZE), random.random());
        let most = if random.random() {
            300 << 16
        } else {
            (1 << 19) - 1
        };
        let bits = random.random_range(1..=most);
        let rows = random.random_range(1..40);
        let mvp = pixel_projection(SIZE);
        let positions = [at_subpixel(point)];
        let mesh = Mesh::new(&positions, &[]).unwrap();
        let size = Scalar::from_bits(bits);
        let style = if is_round {
            PointStyle::round(size)
        } else {
            PointStyle::square(size)
        }
        .unwrap();
        let draw = |frame: &mut Frame<'_>, recorder: &XRecorder<'_, '_>| {
            frame.draw(mesh.points(style), &mvp, recorder)
        };
        let seen = drawn(SIZE.1, &draw);
        let half = ((i64::from(bits) + 256) >> 9).clamp(128, 255 * 128);
        let model = modeled(&|pixel| {
            let [x, y] =
                [0, 1].map(|axis| i64::from(pixel[axis]) * 256 + 128 - i64::from(point[axis]));
            let is_own = [0, 1].map(|axis| point[axis].div_euclid(256)) == pixel;
            if is_round {
                is_own || x * x + y * y <= half * half
            } else {
                [x, y].iter().all(|&away| -half < away && away <= half)
            }
        });
        let inputs = || format!("{style:?} at {point:?}, {rows} rows");
        assert_eq!(
            picture(&counts(&seen), SIZE.0),
            picture(&model, SIZE.0),
            "{}",
            inputs()
        );
        assert_eq!(drawn(rows, &draw), seen, "{}", inputs());
        assert!(
            seen.iter()
                .all(|seen| seen.values == [positions[0].x.to_bits()]),
            "{}",
            inputs()
        );
        if bits == 1 << 16 && !is_round {
            assert_eq!(
                drawn(SIZE.1, &|frame, recorder| frame.draw(
                    mesh.points(PointStyle::PIXEL),
                    &mvp,
                    recorder
                )),
                seen
            );
        }
    });
}

/// Points with a size in world space. Half of the size on the screen is size · focal length / distance / 2 pixels or,
/// under a parallel projection, size · height of the frame / height of the window / 2 pixels.
#[test]
fn attenuated_points_are_the_models() {
    cases(CASES, |random| {
        loop {
            let ranges = [-2.0..2., -30.0..-0.6, 0.001..20., 0.5..2.];
            let [x, z, size, scale] = within(random, ranges).map(number);
            let positions = [Vec3::new(x, fx!(0), z)];
            let mesh = Mesh::new(&positions, &[]).unwrap();
            let is_round: bool = random.random();
            let style = if is_round {
                PointStyle::round(size)
            } else {
                PointStyle::square(size)
            }
            .unwrap()
            .attenuated();
            // The model's scale moves the point, but does not change the point's size.
            let model = Transform::scale(scale);
            let world = model.point(positions[0]);
            let distance = -f64::from(world.z.to_bits()) / 65536.;
            if distance <= 0.51 || distance >= 31. {
                continue;
            }
            let focal = Projection::from_focal_length(fx!(50), SIZE, fx!(0.5), fx!(32)).unwrap();
            let window =
                Projection::orthographic(Window::centered(fx!(9), fx!(4)), fx!(0.5), fx!(32))
                    .unwrap();
            let options = DrawOptions::new();
            let size = f64::from(size.to_bits()) / 65536.;
            let perspective = drawn(SIZE.1, &|frame, recorder| {
                frame.draw_with(&options, mesh.points(style), &(focal * model), recorder)
            });
            let parallel = drawn(SIZE.1, &|frame, recorder| {
                frame.draw_with(&options, mesh.points(style), &(window * model), recorder)
            });
            let screen = Viewport::new(0, 0, SIZE.0, SIZE.1).unwrap();
            let places = [
                screen.project(positions[0], &(focal * model)),
                screen.project(positions[0], &(window * model)),
            ];
            let halves = [size * 50. / distance / 2., size * 10. / 2.];
            for ((seen, place), half) in [perspective, parallel].iter().zip(places).zip(halves) {
                let Some(place) = place else {
                    assert!(seen.is_empty(), "{world:?}");
                    continue;
                };
                let half = half.clamp(0.5, 127.5);
                // Half of the size is rounded to the nearest 1/256. The crate divides by t, which is larger than w /
                // near by the fraction 2^-16.
                let room = 0.5 / 256. + half * 2e-5 + 1e-9;
                let counts = counts(seen);
                for (pixel, &count) in Bounds::new(SIZE.0, SIZE.1).pixels().zip(&counts) {
                    let at = center(pixel);
                    let place = [place.x, place.y].map(|x| f64::from(x.to_bits()) / 256.);
                    let away = [0, 1].map(|axis| at[axis] - place[axis]);
                    let is_own = place.map(|x| x.floor() as i32) == pixel;
                    let away = if is_round {
                        away[0].hypot(away[1])
                    } else {
                        away[0].abs().max(away[1].abs())
                    };
                    if away < half - room || is_own {
                        assert_eq!(count, 1, "{pixel:?}: {away} of {half}");
                    } else if away > half + room {
                        assert_eq!(count, 0, "{pixel:?}: {away} of {half}");
                    }
                }
            }
            break;
        }
    });
}
