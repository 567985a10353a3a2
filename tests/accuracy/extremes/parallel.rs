//! Positions and depths of points under parallel projections, compared with f64: for all windows and planes that the
//! constructors accept, from 2⁻¹⁶ to 65,536 wide, and for windows and planes with extremely different scales.
//!
//! Each row of clip space has 29-bit coefficients and its own exponent. The errors of x, of y and of the depth
//! therefore depend only on the scale of their own row. [`View::error`] and [`View::depth_error`] derive the bounds.

use std::array;

use fixel::Window;
use fixel::prelude::*;
use fixel::view::Parallel;
use rand::Rng;

use super::table::{Cases, figure};
use super::verdict::Worst;
use support::drawing::{Drawing, Spot};
use support::mode::Mode;
use support::moves::{Move, exact, number, product, radians, rounded, size};
use support::random::{Random, cases, list, within};
use support::reference::linear::{Matrix, length, point};
use support::reference::projection::{self, Projection as ModelProjection};
use support::reference::view::{View as ModelView, Viewport as ModelViewport};

/// Half of the guard band's width, in pixels.
const GUARD: f64 = 2048.;
/// The smallest relative change of a mantissa, which has 30 bits.
const UNIT: f64 = 1. / 1_073_741_824.;
/// The largest coordinate.
const MOST: f64 = 32_767.999;

/// A parallel view, both the crate's and the model's.
struct View {
    projection: Projection<Parallel>,
    model: ModelProjection,
    window: Window,
    /// An oblique projection leaves the plane at this distance in place. Points behind this plane move in x and y by
    /// `shear` times their distance from the plane. `ratio` is the ratio of the projection.
    plane: f64,
    ratio: f64,
    shear: [f64; 2],
    moves: Vec<Move>,
    viewport: Viewport,
}

/// The errors of a point, each with its bound: of x and y in pixels, without the rounding to 1/256 pixel, and of the
/// depth in steps, without the rounding down. `None` if the point is clipped.
type Errors = Option<[Worst; 3]>;

impl View {
    fn orthographic(window: Window, near: Scalar, far: Scalar) -> Self {
        Self::new(
            Projection::orthographic(window, near, far),
            [
                window.left,
                window.right,
                window.bottom,
                window.top,
                near,
                far,
            ]
            .map(f64::from),
            window,
            (0., 0., 0.),
        )
    }

    fn oblique(
        angle: Angle,
        ratio: Scalar,
        plane: Scalar,
        window: Window,
        [near, far]: [Scalar; 2],
    ) -> Self {
        Self::new(
            Projection::oblique(angle, ratio, plane, window, near, far),
            [
                window.left,
                window.right,
                window.bottom,
                window.top,
                near,
                far,
            ]
            .map(f64::from),
            window,
            (radians(angle), f64::from(ratio), f64::from(plane)),
        )
    }

    fn new(
        projection: Result<Projection<Parallel>, Error>,
        [l, r, b, t, n, f]: [f64; 6],
        window: Window,
        (angle, ratio, plane): (f64, f64, f64),
    ) -> Self {
        // The model's oblique projection always leaves the plane through the eye in place, so here the window is moved.
        let shear = [ratio * angle.cos(), ratio * angle.sin()];
        let [x, y] = shear.map(|shear| plane * shear);
        Self {
            projection: projection.unwrap(),
            model: projection::oblique(angle, ratio, (l + x, r + x, b + y, t + y), n, f),
            window,
            plane,
            ratio: ratio.abs(),
            shear,
            moves: Vec::new(),
            viewport: Viewport::new(0, 0, 320, 240).unwrap(),
        }
    }

    /// Along x (axis 0) or y (axis 1): the two edges of the window, and the size of the viewport in pixels.
    fn axis(&self, axis: usize) -> (f64, f64, f64) {
        let (window, size) = (&self.window, self.viewport.size());
        let (low, high, pixels) = match axis {
            0 => (window.left, window.right, size.width),
            _ => (window.bottom, window.top, size.height),
        };
        (low.into(), high.into(), pixels.into())
    }

    /// The point of eye space with the normalized device coordinates `at`. `way` is its fraction of the distance from
    /// the near plane to the far plane.
    fn eye(&self, at: [f64; 2], way: f64) -> [f64; 3] {
        let distance = self.model.near + way * (self.model.far - self.model.near);
        let [x, y] = [0, 1].map(|i: usize| {
            let (low, high, _) = self.axis(i);
            f64::midpoint(low, high)
                + at[i] * (high - low) / 2.
                + self.shear[i] * (distance - self.plane)
        });
        [x, y, -distance]
    }

    /// The sum of the lengths by which a row's coefficients are multiplied. Without moves, coefficients that are
    /// exactly 0 do not count.
    fn lengths(&self, axis: usize, p: Vec3) -> f64 {
        if !self.moves.is_empty() {
            return 3_f64.sqrt() * size(&self.moves, p);
        }
        let row = self.model.matrix[axis].into_iter().zip(exact(p));
        row.map(|(m, x)| if m == 0. { 0. } else { x.abs() }).sum()
    }

    /// The bound of the error of x or y in pixels, without rounding to 1/256 pixel.
    ///
    /// Errors are relative to M · S. M is the bound of the row's coefficients, in pixels. S is the sum of all lengths
    /// that add up to the coordinate: the point's coordinates, as the transforms move them; the window's distance from
    /// the line of sight; and the distance of an oblique projection's plane. In units of 2⁻³⁰:
    /// - A coefficient is a quotient (1.3) that is rounded to a mantissa (1). The coefficient of z is also a product
    ///   with a sine (4.1).
    /// - The offset is a quotient and a product of a coefficient and a distance (8.4), and is rounded to a mantissa
    ///   (1).
    /// - The viewport's scale rounds coefficients (1). The product with the view rounds coefficients to 29 bits (2). If
    ///   an offset is so large that coefficients keep fewer bits, they are rounded by 2⁻⁴⁴ of the offset, and
    ///   multiplied by up to 3 · 2¹⁵: 6 of the offset.
    /// - Each move has its own errors (3): see [`relative`](support::moves::relative).
    ///
    /// So an offset has an error of at most 15.4. A product with a coefficient has an error of 9.4 and 6. 16 is a bound
    /// of both. A coefficient has at most 40 fraction bits, in units of the guard band: half of the last bit is 2⁻³⁰
    /// pixel.
    fn error(&self, axis: usize, p: Vec3) -> f64 {
        let (low, high, pixels) = self.axis(axis);
        let most = pixels / (high - low) * self.ratio.max(1.);
        let lengths = self.lengths(axis, p) + f64::midpoint(low, high).abs() + self.plane.abs();
        UNIT * ((3 * self.moves.len() + 16) as f64 * most * lengths
            + 3_f64.sqrt() * length(exact(p)))
    }

    /// The bound of the error of a depth in steps, before it is rounded down.
    ///
    /// The derivation is as in [`error`](Self::error). Both terms of (far − distance) / (far − near) have the same
    /// factor, so the factor's error counts only once, relative to the sum (4.3). The product with the view is rounded
    /// (2). If an offset is large, coefficients keep fewer bits (6).
    fn depth_error(&self, p: Vec3) -> f64 {
        let most = 65536. / (self.model.far - self.model.near);
        let lengths = self.lengths(2, p) + self.model.far.abs();
        let of_sum = (3 * self.moves.len() + 8) as f64 * most * lengths;
        UNIT * (of_sum + 4.3 * 65536. + 3_f64.sqrt() * length(exact(p)) * 32.)
    }

    /// Compares the crate's points with the model's points.
    fn compare(&self, points: &[Vec3]) -> Vec<Errors> {
        let (transform, eye) = product(&self.moves);
        let drawing = Drawing {
            size: (1, 1),
            options: DrawOptions::new().with_viewport(self.viewport),
            mode: Mode::Exact,
            mesh: Mesh::new(&[], &[]).unwrap(),
            mvp: self.projection * transform,
        };
        let spots = drawing.spots(points);
        points
            .iter()
            .zip(spots)
            .map(|(&p, spot)| self.errors(p, spot, eye))
            .collect()
    }

    /// The bounds that the page of limits promises for the errors of x, y and the depth, with up to six moves. (A bound
    /// of x or y is at most √3 · 34 · 2⁻³⁰ of the lengths times the scale; a bound of the depth is at most √3 · 26 ·
    /// 2⁻³⁰ of them.)
    fn promised(&self, p: Vec3) -> [f64; 3] {
        let of_point = size(&self.moves, p);
        let [x, y] = [0, 1].map(|axis| {
            let (low, high, pixels) = self.axis(axis);
            let lengths = of_point + f64::midpoint(low, high).abs() + self.plane.abs();
            5.5e-8 * pixels / (high - low) * self.ratio.max(1.) * lengths + 1e-4
        });
        let depth = (of_point + self.model.far.abs()) / (self.model.far - self.model.near);
        [x, y, 0.0035 * (1. + depth)]
    }

    fn errors(&self, p: Vec3, spot: Option<Spot>, eye: Matrix) -> Errors {
        let viewport = ModelViewport {
            x: self.viewport.top_left().x,
            y: self.viewport.top_left().y,
            width: self.viewport.size().width,
            height: self.viewport.size().height,
        };
        let middle = viewport.screen([0.; 2]);
        let view = ModelView {
            eye,
            projection: self.model,
            viewport,
        };
        let wanted = view.project(exact(p)).screen;
        let depth = self.model.depth(-point(&eye, exact(p))[2]);
        let bounds = [0, 1].map(|axis| self.error(axis, p));
        let depth_bound = self.depth_error(p);
        let mut promised = bounds.iter().chain([&depth_bound]).zip(self.promised(p));
        assert!(
            promised.all(|(bound, promised)| *bound <= promised),
            "{bounds:?}, {depth_bound} of {p:?}"
        );
        // How far the point is inside the planes, divided by the bounds.
        let beside =
            [0, 1].map(|axis: usize| (GUARD - (wanted[axis] - middle[axis]).abs()) / bounds[axis]);
        let between = [65535. - depth, depth].map(|steps| steps / depth_bound);
        let inside = beside
            .into_iter()
            .chain(between)
            .fold(f64::INFINITY, f64::min);
        let Some(Spot {
            x,
            y,
            depth: stored,
        }) = spot
        else {
            assert!(
                inside < 1.,
                "{p:?} is at {wanted:?} and {depth}, and was clipped"
            );
            return None;
        };
        // The crate's near plane is nearer by 2⁻¹⁹, which is an eighth of a step.
        assert!(
            depth < 65535.126 + depth_bound
                && depth > -depth_bound
                && beside.iter().all(|by| *by > -1.),
            "{p:?} is at {wanted:?} and {depth}, and was not clipped"
        );
        let mut errors = [Worst::default(); 3];
        let [of_x, of_y, of_depth] = &mut errors;
        for (axis, (worst, got)) in [(of_x, x), (of_y, y)].into_iter().enumerate() {
            // Positions in the last column and row of the guard band end 1/256 pixel before the edge of the band.
            let wanted_here = wanted[axis].min(middle[axis] + GUARD - 1. / 256.);
            let by = (f64::from(got) / 256. - wanted_here).abs() - 1. / 512.;
            worst.add(by.max(0.), bounds[axis], || {
                format!("{p:?} at {wanted:?} along {axis}")
            });
        }
        let stored = f64::from(stored);
        let by = (stored - depth).max(depth - stored - 1.).max(0.);
        of_depth.add(by, depth_bound, || format!("{p:?} at {depth}"));
        Some(errors)
    }

    /// Transforms a point of eye space back to model space, and rounds it; `None` if the result is beyond the format.
    fn point(&self, eye: [f64; 3]) -> Option<Vec3> {
        let back = self.moves.iter().fold(eye, |at, step| {
            let inverse = match *step {
                Move::To(offset) => return array::from_fn(|i| at[i] - exact(offset)[i]),
                Move::Scale(factors) => return array::from_fn(|i| at[i] / exact(factors)[i]),
                Move::X(angle) => Move::X(-angle),
                Move::Y(angle) => Move::Y(-angle),
                Move::Z(angle) => Move::Z(-angle),
            };
            point(&inverse.matrix(), at)
        });
        back.iter().all(|x| x.abs() < MOST).then(|| rounded(back))
    }
}

/// A random length from 2^`least` to 2^`most`. Its logarithm is evenly distributed.
fn any_length(random: &mut Random, least: f64, most: f64) -> f64 {
    random.random_range(least..most).exp2()
}

/// A random number: 0, or a number of either sign from less than a unit to the ends of the format.
fn any_number(random: &mut Random) -> f64 {
    let length = any_length(random, -17., 15.);
    match random.random_range(0..5) {
        0 => 0.,
        1 | 2 => -length,
        _ => length,
    }
}

/// The ends of a random interval of any size, anywhere.
fn interval(random: &mut Random) -> [Scalar; 2] {
    loop {
        let (middle, half) = (any_number(random), any_length(random, -17., 15.));
        let [low, high] = [middle - half, middle + half].map(|x| number(x.clamp(-MOST, MOST)));
        if low < high {
            return [low, high];
        }
    }
}

/// A random view: any window, planes, angles and viewport, with or without a camera and a model's transform.
fn any_view(random: &mut Random) -> View {
    let ([left, right], [bottom, top], planes) =
        (interval(random), interval(random), interval(random));
    let window = Window {
        left,
        right,
        bottom,
        top,
    };
    let [near, far] = planes;
    let angle = Angle::from_bits(random.random());
    let mut view = match random.random_range(0..5) {
        0 | 1 => View::orthographic(window, near, far),
        2 => View::oblique(angle, fx!(1), near, window, planes),
        3 => View::oblique(angle, fx!(0.5), near, window, planes),
        _ => {
            let [ratio, plane] = [any_number(random), any_number(random)].map(number);
            View::oblique(angle, ratio, plane, window, planes)
        }
    };
    let (x, y) = (
        random.random_range(-4096..=4096),
        random.random_range(-4096..=4096),
    );
    let [width, height] = [(); 2].map(|()| any_length(random, 0., 12.) as u32);
    view.viewport = Viewport::new(x, y, width, height).unwrap();
    let step = |random: &mut Random| {
        let angle = Angle::from_bits(random.random());
        match random.random_range(0..5) {
            0 => Move::To(rounded(array::from_fn(|_| any_number(random)))),
            1 => Move::X(angle),
            2 => Move::Y(angle),
            3 => Move::Z(angle),
            _ => Move::Scale(rounded(within(random, [0.2..3., 0.2..3., -3.0..-0.2]))),
        }
    };
    view.moves = if random.random() {
        list(random, 0..5, step)
    } else {
        Vec::new()
    };
    view
}

/// Random points inside a view and near it.
fn points(random: &mut Random, view: &View, count: usize) -> Vec<Vec3> {
    let mut at = || {
        // Half of the points are in the viewport. The other half are anywhere in the guard band, or a little beyond it.
        let mut reach = [1.; 2];
        if random.random() {
            reach = [0, 1].map(|axis| 2.1 * GUARD / view.axis(axis).2);
        }
        let at = reach.map(|reach| random.random_range(-reach..reach));
        view.point(view.eye(at, random.random_range(-0.01..1.01)))
    };
    (0..count).filter_map(|_| at()).collect()
}

/// A hundredth of a pixel or of a step. Errors are judged only if their bound is at most this, because a larger bound
/// would not test the formats.
const FINE: f64 = 0.01;

#[test]
fn points_in_any_parallel_view_are_the_models() {
    let mut all = [Worst::default(); 3];
    let (mut judged, mut used) = ([0; 3], [0.; 3]);
    cases(20_000, |random| {
        let view = any_view(random);
        let points = points(random, &view, 10);
        for errors in view.compare(&points).into_iter().flatten() {
            for (i, errors) in errors.into_iter().enumerate() {
                if errors.bound <= FINE {
                    judged[i] += 1;
                    used[i] = f64::max(used[i], errors.measured / errors.bound);
                    all[i].merge(errors);
                }
            }
        }
    });
    println!("{judged:?} with a bound of up to {FINE}: {used:.3?} of the bounds, at most {all:?}");
    // With ten other seeds, 81,400 to 83,400 positions along each axis and 52,700 to 53,700 depths had bounds this
    // small.
    let least = [75_000, 75_000, 49_000];
    assert!(
        judged
            .iter()
            .zip(least)
            .all(|(&judged, least)| judged > least),
        "{judged:?}"
    );
}

/// Views with extremely different scales of x, y and depth: half of the window's width and height, and the distances of
/// the planes.
const VIEWS: [(&str, [f64; 2], [f64; 2]); 6] = [
    ("±48, far − near 0.001", [48., 36.], [10., 10.001]),
    ("±1000, far − near 0.01", [1000., 750.], [0., 0.01]),
    ("±1000, far − near 2⁻¹⁶", [1000., 750.], [0., 1. / 65536.]),
    ("±1, far 30,000", [1., 0.75], [0., 30_000.]),
    ("±0.01, far 30,000", [0.01, 0.0075], [0., 30_000.]),
    (
        "±10,000 by ±0.01, far − near 1",
        [10_000., 0.01],
        [10., 11.],
    ),
];

/// The largest error of a position and the largest error of a depth, for points all over one of [`VIEWS`].
fn worst_of([width, height]: [f64; 2], [near, far]: [f64; 2]) -> [Worst; 2] {
    let window = Window::centered(number(2. * width), number(2. * height));
    let view = View::orthographic(window, number(near), number(far));
    let mut random = super::scene::Random(9);
    let at = |_| {
        let at = [random.between(-1., 1.), random.between(-1., 1.)];
        view.point(view.eye(at, random.next()))
    };
    let points: Vec<Vec3> = (0..20_000).filter_map(at).collect();
    let (mut position, mut depth) = (Worst::default(), Worst::default());
    let mut judged = 0;
    for [x, y, of_depth] in view.compare(&points).into_iter().flatten() {
        position.merge(x);
        position.merge(y);
        depth.merge(of_depth);
        judged += 1;
    }
    // Points between the planes are rounded to multiples of 2⁻¹⁶. If the planes are only 2⁻¹⁶ apart, half of the points
    // lie in the near plane, and the other half in the far plane. All points are visible.
    assert!(judged > 19_000, "{judged}");
    [position, depth]
}

pub static CASES: Cases = Cases::new(|| {
    let rows = VIEWS.map(|(name, window, planes)| {
        let [position, depth] = worst_of(window, planes);
        [
            figure(
                &format!("parallel view, window {name}: positions"),
                "pixels",
                position,
            ),
            figure(
                &format!("parallel view, window {name}: depths"),
                "steps",
                depth,
            ),
        ]
    });
    rows.into_iter().flatten().collect()
});

#[test]
fn parallel_views_of_different_scales_are_within_their_bounds() {
    assert_eq!(CASES.len(), 2 * VIEWS.len());
}
