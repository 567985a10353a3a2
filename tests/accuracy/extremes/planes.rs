//! Triangles around the eye and at the near and far planes.
//!
//! Bounds: rounding moves a corner by up to half a subpixel along each axis, and the error of clip space moves it
//! further (`Scene::moved`). An edge moves by up to √2 times the sum. The bounds of values and depths are in `bounds`.

use std::f64::consts::TAU;

use fixel::prelude::*;

use super::scene::{ONCE, Random, TriangleView, worst};
use super::table::{Cases, picture};
use super::verdict::{MODES, Verdict};
use support::drawing::Drawing;
use support::random::sampled;

const NEAR: f64 = 0.25;

/// Triangles of many slopes. `behind` corners of each triangle are behind the near plane.
fn crossing(behind: usize) -> Verdict {
    worst((0..24).map(|step| {
        let s = f64::from(step);
        let ahead = [
            [-1.5, -0.5 - s / 40., -2.],
            [1.2, -0.9, -3. - s],
            [s / 20. - 0.5, 0.2, -1.5],
        ];
        let beyond = [
            [-0.7, -0.3, 0.1 + s],
            [0.8 + s / 4., 0.4, 3.],
            [0.1, 0.6, -0.125],
        ];
        let corner = |i: usize| if i < behind { beyond[i] } else { ahead[i] };
        TriangleView::ROOM.judge([corner(0), corner(1), corner(2)])
    }))
}

/// Triangles in planes that pass through the eye, or a little beside the eye. On the screen, each triangle is a line,
/// or covers everything.
fn through_the_eye() -> Verdict {
    let turns = (0..32).map(|step| (f64::from(step) / 32. * TAU).sin_cos());
    worst(turns.flat_map(|(sin, cos)| {
        [0., 1. / 65536., 0.25].map(|off| {
            let at = |along: f64, z: f64| [along * cos - off * sin, along * sin + off * cos, z];
            worst([
                TriangleView::ROOM.judge([at(-4., -8.), at(5., -6.), at(0.5, 7.)]),
                TriangleView::ROOM.judge([at(0., 0.), at(3., -8.), at(-4., -8.)]),
            ])
        })
    }))
}

/// Triangles with corners or sides on the near plane, and a triangle that lies in the near plane.
fn on_the_plane() -> Verdict {
    worst([
        TriangleView::ROOM.judge([[0., 0.1, -NEAR], [-2., -1., -4.], [2., -1., -5.]]),
        TriangleView::ROOM.judge([[-0.2, 0.1, -NEAR], [0.15, 0.12, -NEAR], [0.3, -1., -5.]]),
        TriangleView::ROOM.judge([[-0.2, 0.1, -NEAR], [0.15, 0.12, -NEAR], [0.1, -0.1, -NEAR]]),
    ])
}

/// The near plane is at the least distance, 2⁻¹⁶, and corners are 1 to 100 times as far away.
fn just_above_zero() -> Verdict {
    let unit = 1. / 65536.;
    let view = TriangleView {
        near: unit,
        far: 1.,
        ..TriangleView::ROOM
    };
    let mut random = Random(1);
    worst((0..sampled(200)).map(|_| {
        let mut corner = || {
            let w = (random.between(0., 100_f64.ln()).exp() + 0.5).floor() * unit;
            view.at(
                [random.between(-300., 300.), random.between(-200., 200.)],
                w,
            )
        };
        view.judge([corner(), corner(), corner()])
    }))
}

/// Floors from below the eye to the horizon. 1/w falls to a small fraction of its value at the nearest point.
fn grazing(near: f64, height: f64) -> Verdict {
    let view = TriangleView {
        near,
        far: 32_767.,
        ..TriangleView::ROOM
    };
    worst((-3..=3).map(|tilt| {
        let side = |y: f64| [32_000. * f64::from(tilt) / 8., y, -32_700.];
        worst([
            view.judge([
                [-2. * near, -height, -near],
                [2. * near, -height, -near],
                side(-height),
            ]),
            view.judge([[-2., -height, 1.], [2., -height, 1.], side(-height)]),
            // The floor reaches beyond the far plane and beyond a side of the guard band.
            view.judge([
                [-2., -height, 1.],
                [32_000., -height, -32_000.],
                side(-height - 1.),
            ]),
        ])
    }))
}

pub static CASES: Cases = Cases::new(|| {
    vec![
        picture("one of three corners behind the near plane", crossing(1)),
        picture("two of three corners behind the near plane", crossing(2)),
        picture(
            "triangles in a plane through the eye, or 2⁻¹⁶ beside the eye",
            through_the_eye(),
        ),
        picture(
            "corners, sides or whole triangles in the near plane",
            on_the_plane(),
        ),
        picture(
            "near plane at 2⁻¹⁶, corners 1 to 100 · 2⁻¹⁶ away",
            just_above_zero(),
        ),
        picture(
            "floor to the horizon, 1/w falls to 2⁻¹⁷ of its greatest value",
            grazing(0.25, 0.5),
        ),
        picture(
            "floor to the horizon, 1/w falls to 2⁻²¹ of its greatest value",
            grazing(1. / 64., 1. / 32.),
        ),
    ]
});

#[test]
fn triangles_are_clipped_where_the_model_clips_them() {
    assert_eq!(CASES.len(), 7);
}

/// Triangles behind the eye are not drawn, even if they are very near to it.
#[test]
fn triangles_behind_the_eye_are_not_drawn() {
    assert_eq!(crossing(3).pixels, 0);
}

/// Distances from 2⁻¹⁴ to 2¹⁵ in one triangle exceed the range of interpolants, so the far corner is drawn as if it
/// were nearer. A pixel then has the value of another position in the triangle, but not of a position outside it.
///
/// Where 1/w is least, it has 2048 units with an error of up to 40 units, and numerators have an error of 56½ units
/// (see `bounds`). So a value can exceed the corners' range by 56½/2008 of 2^bits. And 2^bits is at most four times the
/// greatest value at a corner.
/// greatest value at a corner.
#[test]
fn values_stay_between_those_of_the_corners() {
    let view = TriangleView {
        near: 1. / 16_384.,
        far: 32_767.,
        ..TriangleView::ROOM
    };
    let mut random = Random(13);
    for _ in 0..200 {
        let spread = random.between(12., 28.);
        let mut corner = |y: f64, part: f64| {
            let w = 2_f64.powf(-13.9 + part * spread + random.between(0., 0.7));
            view.at([random.between(-60., 60.), y], w)
        };
        // The far side of the triangle passes through the centers of a row.
        let scene = view.scene([corner(-30., 0.), corner(0.5, 1.), corner(0.5, 1.)], ONCE);
        for mode in MODES {
            let drawing = Drawing {
                size: scene.size,
                options: scene.options,
                mode,
                mesh: Mesh::new(&scene.positions, &scene.faces).unwrap(),
                mvp: scene.mvp,
            };
            let values = |vertex: &Corner<'_>| scene.texels[scene.index(vertex.position())];
            let (most, room) = (256 << 16, 4 * (256 << 16) / 35);
            for seen in drawing.all(&values) {
                for value in seen.values {
                    assert!(
                        (-room..=most + room).contains(&value),
                        "{seen:?} of {scene:?}"
                    );
                }
            }
        }
    }
}
