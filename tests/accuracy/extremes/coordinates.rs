//! Coordinates and offsets up to the ends of the format, and triangles far larger than the screen.
//!
//! The bounds are the same as in [`planes`](super::planes). Clip space keeps 30 bits of the largest term of a sum. Let S
//! be the sum of the magnitudes of all coordinates and offsets. Then rounding moves a point at distance w by up to S/w ·
//! 2⁻¹⁶ · 0.15 pixels (`Scene::moved`), and its texels in proportion.

use super::scene::{Corners, Random, TriangleView, worst};
use super::table::{Cases, picture};
use super::verdict::Verdict;
use support::moves::{to, y};
use support::random::sampled;

/// Triangles as wide as the picture, and smaller triangles, at distances around four.
fn triangles(view: &TriangleView) -> Vec<Corners> {
    let mut random = Random(2);
    let corner = |random: &mut Random| {
        let at = [random.between(-120., 120.), random.between(-90., 90.)];
        let w = random.between(2., 8.);
        view.at(at, w)
    };
    (0..sampled(40))
        .map(|_| [0; 3].map(|_| corner(&mut random)))
        .collect()
}

/// A model that is far from its own origin, and that a translation moves in front of the eye.
fn placed(at: f64) -> Verdict {
    let view = TriangleView {
        moves: vec![to([-at, at, -at])],
        ..TriangleView::ROOM
    };
    let model = |[x, y, z]: [f64; 3]| [x + at, y - at, z + at];
    let triangles = triangles(&view).into_iter();
    worst(triangles.map(|corners| view.judge(corners.map(model))))
}

/// A model in front of a camera. The camera is turned, and far from the world's origin.
fn turned(at: f64) -> Verdict {
    let turn = 0.7_f64;
    let view = TriangleView {
        moves: vec![y(turn), to([-at, at / 2., at / 4.])],
        ..TriangleView::ROOM
    };
    let (sin, cos) = turn.sin_cos();
    let model = |[x, y, z]: [f64; 3]| {
        [
            cos * x - sin * z + at,
            y - at / 2.,
            sin * x + cos * z - at / 4.,
        ]
    };
    let triangles = triangles(&view).into_iter();
    worst(triangles.map(|corners| view.judge(corners.map(model))))
}

/// Distant triangles, seen with a focal length of 2000 pixels.
fn far_away(w: f64) -> Verdict {
    let view = TriangleView {
        focal: 2000.,
        far: 32_767.,
        ..TriangleView::ROOM
    };
    let mut random = Random(3);
    worst((0..sampled(40)).map(|_| {
        let mut corner = || {
            let at = [random.between(-120., 120.), random.between(-90., 90.)];
            view.at(at, w * random.between(0.5, 1.))
        };
        view.judge([corner(), corner(), corner()])
    }))
}

/// Triangles through the middle of the picture. The sides of a triangle are about `times` as long as the picture is
/// wide.
fn large(times: f64) -> Verdict {
    let view = TriangleView::ROOM;
    let mut random = Random(4);
    worst((0..sampled(60)).map(|_| {
        let turn = random.between(0., std::f64::consts::TAU);
        let corner = |third: f64, random: &mut Random| {
            let (sin, cos) = (turn + third * std::f64::consts::TAU / 3.).sin_cos();
            let reach = 160. * times * random.between(0.3, 0.6);
            view.at([reach * cos, reach * sin], random.between(0.5, 0.6))
        };
        let mut corners = [0., 1., 2.].map(|third| corner(third, &mut random));
        // In one half of the triangles, a side passes near the middle; in the other half, the middle is well inside the
        // triangle.
        if random.next() < 0.5 {
            let [a, b, _] = corners;
            corners[2] = [0, 1, 2].map(|i: usize| -(a[i] + b[i]) / 2. * 0.9);
            corners[2][2] = -0.7;
        }
        view.judge(corners)
    }))
}

/// Triangles with all corners in one region or in two regions, far outside the guard band or inside it.
fn beyond_the_guard_band() -> Verdict {
    let view = TriangleView::ROOM;
    let sides = [
        -3000., -2049., -2048., -2047., 0., 2047., 2048., 2049., 3000.,
    ];
    worst(sides.into_iter().flat_map(|x| {
        sides.map(|y| {
            let corners = [
                view.at([x, y], 4.),
                view.at([30., 20.], 3.),
                view.at([-40., 35.], 5.),
            ];
            view.judge(corners)
        })
    }))
}

pub static CASES: Cases = Cases::new(|| {
    vec![
        picture(
            "model 64 from its origin, moved in front of the eye",
            placed(64.),
        ),
        picture(
            "model 10⁴ from its origin, moved in front of the eye",
            placed(1e4),
        ),
        picture(
            "model 32,700 from its origin, moved in front of the eye",
            placed(32_700.),
        ),
        picture("camera 10⁴ from the world's origin, turned", turned(1e4)),
        picture(
            "camera 32,000 from the world's origin, turned",
            turned(32_000.),
        ),
        picture("10⁴ away, focal length 2000", far_away(1e4)),
        picture("32,767 away, focal length 2000", far_away(32_767.)),
        picture("triangles 100 times as large as the screen", large(100.)),
        picture(
            "triangles 10,000 times as large as the screen",
            large(10_000.),
        ),
        picture(
            "corners at and beyond the guard band",
            beyond_the_guard_band(),
        ),
    ]
});

#[test]
fn errors_of_large_numbers_are_within_their_bounds() {
    assert_eq!(CASES.len(), 10);
}
