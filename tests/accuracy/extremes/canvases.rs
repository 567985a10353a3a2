//! Canvases from one pixel to the largest, and viewports in and around them.
//!
//! The bounds are the same as in [`planes`](super::planes): they depend neither on the size of the canvas nor on the
//! position of the viewport.

use fixel::prelude::*;

use super::scene::{Random, TriangleView, worst};
use super::table::{Cases, picture};
use super::verdict::Verdict;

/// Draws triangles all over a viewport and beyond it.
fn on(size: (u32, u32), viewport: Option<Viewport>, count: usize) -> Verdict {
    let (width, height) = viewport.map_or(size, |viewport| {
        (viewport.size().width, viewport.size().height)
    });
    let view = TriangleView {
        size,
        viewport,
        // The focal length is the smaller side, except on the smallest canvases.
        focal: f64::from(width.min(height).max(8)),
        ..TriangleView::ROOM
    };
    let [wide, high] = [width, height].map(|size| f64::from(size) * 0.7);
    let mut random = Random(8);
    worst((0..count).map(|_| {
        let mut corner = || {
            let at = [random.between(-wide, wide), random.between(-high, high)];
            view.at(at, random.between(1., 4.))
        };
        view.scene([corner(), corner(), corner()], super::scene::ONCE)
            .judge()
    }))
}

/// Viewports of 64x48 around a canvas of 40x30, partly on the canvas or wholly outside it.
fn beside() -> Verdict {
    let places = [
        (-20, -10),
        (20, 15),
        (-63, -47),
        (39, 29),
        (-12, 29),
        (-4096, 0),
        (0, 4096),
        (40, 0),
        (0, -48),
    ];
    worst(places.map(|(x, y)| {
        let verdict = on((40, 30), Some(Viewport::new(x, y, 64, 48).unwrap()), 60);
        let is_off = x <= -64 || y <= -48 || x >= 40 || y >= 30;
        assert_eq!(verdict.pixels == 0, is_off, "{x}, {y}");
        verdict
    }))
}

/// The largest viewport, at several places around a small canvas.
fn largest_viewport() -> Verdict {
    let places = [(0, 0), (-4056, -4066), (-2048, -2048), (-4095, -1000)];
    worst(places.map(|(x, y)| on((40, 30), Some(Viewport::new(x, y, 4096, 4096).unwrap()), 60)))
}

pub static CASES: Cases = Cases::new(|| {
    vec![
        picture("canvas 1x1", on((1, 1), None, 200)),
        picture("canvas 1x240", on((1, 240), None, 100)),
        picture("canvas 320x1", on((320, 1), None, 100)),
        picture("canvas 33x17", on((33, 17), None, 100)),
        picture("canvas 2048x3", on((2048, 3), None, 20)),
        picture("canvas 3x2048", on((3, 2048), None, 20)),
        picture("canvas 2048x2048, its corners", corners_of_the_largest()),
        picture("viewport partly or wholly outside the canvas", beside()),
        picture("viewport 4096x4096, canvas 40x30", largest_viewport()),
    ]
});

/// In the largest canvas: triangles of a few pixels in the corners, and a thin triangle along the diagonal.
fn corners_of_the_largest() -> Verdict {
    let view = TriangleView {
        size: (2048, 2048),
        focal: 1024.,
        ..TriangleView::ROOM
    };
    let ends = [-1024_f64, 1024.];
    let corners = ends.into_iter().flat_map(|x| ends.map(|y| [x, y]));
    let judged = corners.map(|[x, y]| {
        let at = |along: f64, across: f64, w: f64| {
            view.at([x - x.signum() * along, y - y.signum() * across], w)
        };
        view.judge([at(0., 0., 1.), at(9.3, 2., 2.), at(3., 12.4, 1.5)])
    });
    let thin = view.judge([
        view.at([-1024., 1024.], 1.),
        view.at([1024., -1020.], 4.),
        view.at([1024., -1024.], 3.),
    ]);
    worst(judged.chain([thin]))
}

#[test]
fn errors_on_any_canvas_and_in_any_viewport_are_within_their_bounds() {
    assert_eq!(CASES.len(), 9);
}
