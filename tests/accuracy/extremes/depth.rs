//! Ranges of depth: far/near from 10 to 10⁶, and two surfaces 1 % apart.
//!
//! Surfaces at a distance w that are one step of the depth buffer apart are w²/(65,535 · near) apart in space. So up to
//! 655 times the near plane's distance, for any far plane, two surfaces that are 1 % of w apart differ by at least one
//! step, and the nearer surface shows. Farther away, the visible surface is behind the nearest one by less than a step
//! plus the errors of two depths (`bounds::DEPTH`).

use fixel::prelude::*;
use fixel::view::Perspective;

use super::scene::{Random, TriangleView, worst};
use super::table::{Cases, figure, picture};
use super::verdict::{Verdict, Worst};
use support::bounds;
use support::drawing::Drawing;
use support::mode::Mode;
use support::moves::{exact, rounded};
use support::random::sampled;
use support::reference::coverage::Bounds;
use support::reference::linear::{Vec3 as Vector, cross, dot, subtract};

/// Ratios of far to near, each with the distances of a near plane and a far plane.
const RATIOS: [(&str, f64, f64); 6] = [
    ("10", 4., 40.),
    ("10²", 4., 400.),
    ("10³", 4., 4000.),
    ("10⁴", 2., 20_000.),
    ("10⁵", 0.25, 25_000.),
    ("10⁶", 0.031_25, 31_250.),
];
/// The distance of the farther surface, divided by the distance of the nearer surface.
const APART: f64 = 1.01;

fn view(near: f64, far: f64) -> TriangleView {
    TriangleView {
        near,
        far,
        ..TriangleView::ROOM
    }
}

/// Triangles that reach from the near to the far plane.
fn reaching(view: &TriangleView) -> Verdict {
    let mut random = Random(5);
    worst((0..sampled(100)).map(|_| {
        let end = (view.far / view.near).ln() - 1e-3;
        let corner = |part: f64, random: &mut Random| {
            let w = view.near * (1e-3 + part * end).exp();
            view.at([random.between(-60., 60.), random.between(-50., 50.)], w)
        };
        // The second corner is anywhere between the near and far planes, or in the far plane.
        let parts = [0., (random.next() * 2.).min(1.), 1.];
        view.judge(parts.map(|part| corner(part, &mut random)))
    }))
}

/// The 1/w at a pixel, in the plane through three corners.
fn inverse_w(corners: [Vec3; 3], view: &TriangleView, [x, y]: [i32; 2]) -> f64 {
    let [a, b, c]: [Vector; 3] = corners.map(exact);
    let normal = cross(subtract(b, a), subtract(c, a));
    let at = |pixel: i32, size: u32| (f64::from(pixel) + 0.5 - f64::from(size) / 2.) / view.focal;
    dot(normal, [at(x, view.size.0), -at(y, view.size.1), -1.]) / dot(normal, a)
}

/// Draws two surfaces at about the distance `w`, in either order. Returns how far the visible surface is behind the
/// nearest surface, in steps, and whether the farther surface shows anywhere.
fn behind(view: &TriangleView, w: f64) -> (Worst, bool) {
    let mut all = Worst::default();
    let mut hidden = false;
    for tilt in [-0.2, 0., 0.3] {
        let corners = [[-60., -50.], [90., -40.], [-20., 80.]];
        let surface = |times: f64| {
            let depth = |[x, _]: [f64; 2]| w * times * (1. + tilt * x / 100.);
            corners.map(|at| rounded(view.at(at, depth(at))))
        };
        let surfaces = [surface(1.), surface(APART)];
        let scene = view.scene([[0.; 3]; 3], [[0; 2]; 3]);
        let mvp: Mvp<Perspective> = scene.mvp;
        for order in [[0, 1], [1, 0]] {
            let positions: Vec<Vec3> = order.iter().flat_map(|&i: &usize| surfaces[i]).collect();
            let drawing = Drawing {
                size: view.size,
                options: scene.options,
                mode: Mode::Newton,
                mesh: Mesh::new(&positions, &[[0, 1, 2], [3, 4, 5]]).unwrap(),
                mvp,
            };
            let pixels = Bounds::new(view.size.0, view.size.1).pixels();
            for (pixel, face) in pixels.zip(drawing.faces()) {
                let Some(surface) = face.map(|face| order[face]) else {
                    continue;
                };
                let depths = surfaces.map(|s| 65535. * view.near * inverse_w(s, view, pixel));
                // Compare only well inside the nearer surface, where it certainly covers the pixel.
                let error = (depths[0].max(depths[1]) - depths[surface]).max(0.);
                if surface == 1 && is_inside(pixel, corners, view) {
                    hidden = true;
                    let bound = 1. + 2. * bounds::depth([w, 2. * w, 2. * w]);
                    all.add(error, bound, || format!("{pixel:?} at {w} of {view:?}"));
                }
            }
        }
    }
    if all.bound == 0. {
        all.bound = 1. + 2. * bounds::DEPTH;
    }
    (all, hidden)
}

/// Whether a pixel is at least one pixel inside a triangle on the screen.
fn is_inside([x, y]: [i32; 2], corners: [[f64; 2]; 3], view: &TriangleView) -> bool {
    let p = [
        f64::from(x) + 0.5 - f64::from(view.size.0) / 2.,
        f64::from(view.size.1) / 2. - f64::from(y) - 0.5,
    ];
    [0, 1, 2].iter().all(|&i: &usize| {
        let (a, b) = (corners[i], corners[(i + 1) % 3]);
        let side = [b[0] - a[0], b[1] - a[1]];
        (side[0] * (p[1] - a[1]) - side[1] * (p[0] - a[0])) / side[0].hypot(side[1]) > 1.
    })
}

/// The largest number of steps by which the visible surface is behind the nearest surface, at distances from the near
/// plane to the far plane.
fn order(view: &TriangleView) -> Worst {
    let mut worst = Worst::default();
    let mut w = view.near * 1.5;
    while w < view.far / 1.5 {
        let (steps, hidden) = behind(view, w);
        worst.merge(steps);
        // The farthest pixel is at a distance of 1.3 w.
        if w * 1.3 * APART < 650. * view.near {
            assert!(!hidden, "the surface 1 % farther shows at {w} of {view:?}");
        }
        w *= 1.7;
    }
    worst
}

pub static CASES: Cases = Cases::new(|| {
    let pictures = RATIOS.map(|(name, near, far)| {
        picture(
            &format!("near to far in one triangle, far/near {name}"),
            reaching(&view(near, far)),
        )
    });
    let orders = RATIOS.map(|(name, near, far)| {
        let case = format!(
            "surfaces 1 % apart: depth of the drawn surface behind the nearest, far/near {name}"
        );
        figure(&case, "steps", order(&view(near, far)))
    });
    pictures.into_iter().chain(orders).collect()
});

#[test]
fn the_nearer_surface_shows_while_steps_are_fine_enough() {
    assert_eq!(CASES.len(), 12);
}
