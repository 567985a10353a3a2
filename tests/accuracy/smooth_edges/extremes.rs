//! Extreme meshes and frames: nothing panics, and only visible edges change pixels.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;
use fixel::Window;
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;
use rand::seq::IndexedRandom;
use support::random::{Random, cases, list, number, sampled};

use super::{Noise, is_mixed_once, viewport};

/// A coordinate: in or near the view, far beyond it, on a grid of half pixels, or within a few units of another.
fn coordinate(random: &mut Random) -> i32 {
    match random.random_range(0..5) {
        0 => random.random_range(-4 << 16..4 << 16),
        1 => random.random_range(-60..60) << 15,
        2 => random.random_range(-3..3),
        3 => number(random),
        _ => *[i32::MIN, -1, 0, 1 << 16, i32::MAX].choose(random).unwrap(),
    }
}

/// Smooths a random mesh with extreme positions, on a frame of any shape. Returns whether an edge was visible, and how
/// many pixels have changed.
fn check_extreme<K: ProjectionKind>(
    random: &mut Random,
    size: (u32, u32),
    projection: Projection<K>,
) -> (bool, usize) {
    let positions = list(random, 3..9, |random| {
        Vec3::from_bits([(); 3].map(|()| coordinate(random)))
    });
    let count = positions.len() as u16;
    let faces = list(random, 1..12, |random| {
        [(); 3].map(|()| random.random_range(0..count))
    });
    let mesh = Mesh::new(&positions, &faces).unwrap();
    let mut room = vec![[0; 4]; 3 * faces.len()];
    let crease = Angle::from_degrees(*[0, 30, 180].choose(random).unwrap());
    let outline = Outline::build(&mesh, crease, &mut room).unwrap();
    let mirror = *[fx!(1), fx!(-1)].choose(random).unwrap();
    let mvp = projection
        * Transform::translate(vec3!(0, 0, -2))
        * Transform::scale_axes(Vec3::new(mirror, fx!(1), fx!(1)));
    let cull = *[Cull::Back, Cull::Front, Cull::Nothing]
        .choose(random)
        .unwrap();
    let options = viewport(random).with_cull(cull);

    let pixels = (size.0 * size.1) as usize;
    let mut colors = vec![Rgb888::new(7, 90, 200); pixels];
    let depth = *[0, 0, 0, 30_000, 0xffff].choose(random).unwrap();
    let mut depths = vec![depth; pixels];
    let canvas = Canvas::new(&mut colors, size.0, size.1).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    canvas.draw_with(&options, &mesh, &mvp, &Noise(5));
    let before: Vec<_> = canvas.pixels().collect();
    let drawn = canvas.smooth_edges(&options, &mesh, &outline, &mvp);
    let window = options
        .viewport
        .map(|window| Rectangle::new(window.top_left(), window.size()));
    let mut changed = 0;
    for (at, (&was, is)) in before.iter().zip(canvas.pixels()).enumerate() {
        if was == is {
            continue;
        }
        changed += 1;
        let width = size.0 as usize;
        assert!(
            is_mixed_once(&before, width, at, is),
            "pixel {at}: {was:?} became {is:?}"
        );
        let [x, y] = [at % width, at / width].map(|at| (at as u32).cast_signed());
        assert!(
            window.is_none_or(|window| window.contains(Point::new(x, y))),
            "outside the viewport"
        );
    }
    assert!(
        drawn.drawn > 0 || changed == 0,
        "pixels change, but no edge is visible"
    );

    // Without depths, only a panic can be noticed.
    let mut canvas = Canvas::new(&mut colors, size.0, size.1).unwrap();
    canvas.smooth_edges(&options, &mesh, &outline, &mvp);
    // An outline without edges changes nothing.
    let before: Vec<_> = canvas.pixels().collect();
    let none = Outline::new(&mesh, &[], 0).unwrap();
    assert_eq!(
        canvas.smooth_edges(&options, &mesh, &none, &mvp).submitted,
        0
    );
    assert!(canvas.pixels().eq(before));
    (drawn.drawn > 0, changed)
}

/// Nothing panics, only visible edges change pixels, each changed pixel is mixed once, and none outside of the viewport.
#[test]
fn no_mesh_is_too_extreme() {
    let (mut visible, mut changed) = (0, 0);
    cases(sampled(20_000), |random| {
        let size = *[
            (1, 1),
            (1, 40),
            (40, 1),
            (2, 2),
            (1, 2048),
            (2048, 1),
            (66, 52),
            (66, 52),
        ]
        .choose(random)
        .unwrap();
        let window = Window::centered(fx!(6), fx!(4));
        let far = *[fx!(2.5), fx!(9), fx!(30_000)].choose(random).unwrap();
        let (is_visible, pixels) = match random.random_range(0..4) {
            0 => check_extreme(
                random,
                size,
                Projection::perspective(deg!(60), (3, 2), fx!(0.5), far).unwrap(),
            ),
            1 => check_extreme(
                random,
                size,
                Projection::perspective(deg!(160), (3, 2), fx!(0.01), far).unwrap(),
            ),
            2 => check_extreme(
                random,
                size,
                Projection::orthographic(window, fx!(-1), far).unwrap(),
            ),
            _ => check_extreme(
                random,
                size,
                Projection::oblique(deg!(30), fx!(0.5), fx!(-1), window, fx!(-1), far).unwrap(),
            ),
        };
        visible += u32::from(is_visible);
        changed += pixels;
    });
    assert!(visible > 500 && changed > 10_000, "{visible} and {changed}");
}
