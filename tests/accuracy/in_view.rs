//! Which boxes are in view: all boxes with a pixel, and no box that the model sees well outside the view.

use std::array::from_fn;

use embedded_graphics::pixelcolor::Gray8;
use fixel::Window;
use fixel::mesh::Bounds;
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;

use support::moves::{Move, exact, number, product, rounded};
use support::random::{Random, cases, within};
use support::reference::linear::point;
use support::reference::projection::{self, Projection as ModelProjection};
use support::reference::view::{View, Viewport as ModelViewport};

const SIZE: (u32, u32) = (64, 48);
/// A box that is this many pixels outside the view must count as out of view. One pixel is for the border of one pixel
/// around the view, and the rest is for rounding. Four moves have a relative error of 2.7e-8 (`relative`), times a
/// distance of at most 120 from the eye, times half of the guard band, 2,048 pixels. Coefficients of at most 3 are
/// rounded to 27 bits, and multiplied by at most 24 for the three coordinates of a corner. Together, these errors are
/// below 0.01 pixel at a distance of 1, so a distance below 1 counts as 1. In a parallel view, a unit is at most 512
/// pixels wide, and 120 units have an error of 0.0017 pixel.
const PIXELS: f64 = 1.01;
/// A box that is beyond the near or the far plane by this fraction of the plane's distance must count as out of view.
const PART: f64 = 0.0001;

pub fn corners(bounds: &Bounds) -> [Vec3; 8] {
    let [a, b] = [bounds.least, bounds.most];
    from_fn(|i| {
        let pick = |bit: usize, a: Scalar, b: Scalar| if i >> bit & 1 == 0 { a } else { b };
        Vec3::new(pick(0, a.x, b.x), pick(1, a.y, b.y), pick(2, a.z, b.z))
    })
}

/// The faces of a box, as triangles of its corners.
const FACES: [[u16; 3]; 12] = [
    [0, 1, 3],
    [0, 3, 2],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 3, 7],
    [2, 7, 6],
    [0, 2, 6],
    [0, 6, 4],
    [1, 3, 7],
    [1, 7, 5],
];
const EDGES: [[u16; 2]; 5] = [[0, 7], [1, 6], [2, 5], [3, 4], [0, 1]];

/// Whether a box has any pixel in the rows from `start` to `end`. The box is drawn as triangles, as edges and as
/// points.
fn has_pixels<K: ProjectionKind>(bounds: &Bounds, mvp: &Mvp<K>, [start, end]: [u32; 2]) -> bool {
    let positions = corners(bounds);
    let mesh = Mesh::new(&positions, &FACES)
        .unwrap()
        .with_edges(&EDGES)
        .unwrap();
    let options = DrawOptions::new().with_cull(Cull::Nothing);
    let mut pixels = vec![Gray8::new(0); (SIZE.0 * (end - start)) as usize];
    let mut canvas = Canvas::band(&mut pixels, SIZE.0, SIZE.1, start).unwrap();
    let white = Flat::new(Gray8::new(255));
    canvas.draw_with(&options, &mesh, mvp, &white);
    canvas.draw_with(&options, mesh.edges(LineStyle::HAIRLINE), mvp, &white);
    canvas.draw_with(&options, mesh.points(PointStyle::PIXEL), mvp, &white);
    pixels.iter().any(|&pixel| pixel != Gray8::new(0))
}

/// Whether all corners are well outside the same plane of the model's view.
fn is_out(bounds: &Bounds, view: &View, [start, end]: [u32; 2]) -> bool {
    let clips = corners(bounds).map(|corner| view.on_screen(view.clip(exact(corner))));
    let model = &view.projection;
    let half = [f64::from(SIZE.0) / 2., f64::from(SIZE.1) / 2.];
    let (rows, all) = ([f64::from(start), f64::from(end)], f64::from(SIZE.0));
    let slack = |w: f64| PIXELS * w.abs().max(1.);
    // x · half is w times the distance from the middle to the right, in pixels; −y · half is w times the distance down.
    let planes: [&dyn Fn(&support::reference::view::Projected) -> bool; 6] = [
        &|p| p.clip[0] * half[0] < -half[0] * p.w - slack(p.w),
        &|p| p.clip[0] * half[0] > (all - half[0]) * p.w + slack(p.w),
        &|p| -p.clip[1] * half[1] < (rows[0] - half[1]) * p.w - slack(p.w),
        &|p| -p.clip[1] * half[1] > (rows[1] - half[1]) * p.w + slack(p.w),
        &|p| p.distance < model.near - PART * model.near.abs().max(1.),
        &|p| p.distance > model.far + PART * model.far.abs().max(1.),
    ];
    planes.iter().any(|plane| clips.iter().all(plane))
}

/// The size of a box on the screen: the crate's size, the model's size, and the largest difference by rounding.
fn sizes<K: ProjectionKind>(
    (projection, model): (Projection<K>, ModelProjection),
    moves: &[Move],
    bounds: &Bounds,
) -> (u32, f64, f64) {
    let (transform, eye) = product(moves);
    let mvp = projection * transform;
    let screen = Viewport::new(0, 0, SIZE.0, SIZE.1).unwrap();
    let found = screen.size_on_screen(bounds, &mvp);

    let [a, b] = [bounds.least, bounds.most].map(|corner| point(&eye, exact(corner)));
    let diagonal = a
        .iter()
        .zip(b)
        .map(|(a, b)| (a - b).powi(2))
        .sum::<f64>()
        .sqrt();
    let ahead = -(a[2] + b[2]) / 2.;
    let per_unit = model.matrix[0][0] * f64::from(SIZE.0) / 2.;
    let (size, noise) = if K::PERSPECTIVE {
        // If the eye is almost on the sphere around the box, rounding decides whether the eye is inside the sphere.
        if (ahead - diagonal / 2.).abs() < 8. * 2_f64.powi(-16) {
            return (0, 0., 0.);
        }
        if ahead < diagonal / 2. {
            return (found, f64::INFINITY, 0.);
        }
        (
            diagonal * per_unit / ahead,
            per_unit / ahead * (1. + diagonal / ahead),
        )
    } else {
        (diagonal * per_unit, per_unit)
    };
    // Along each axis, corners have an error of half a unit plus 2^-27 of 2^6, and the distance has this error, too. A
    // margin of 2^-8 pixel is added.
    (found, size, noise * 4. * 2_f64.powi(-16) + 2_f64.powi(-8))
}

/// Whether the crate's size is the model's size, rounded down. `noise` is the largest difference by rounding.
fn is_size((found, size, noise): (u32, f64, f64)) -> bool {
    if found == u32::MAX || size == f64::INFINITY {
        return found == u32::MAX && size == f64::INFINITY;
    }
    f64::from(found) <= size + noise && f64::from(found) + 1. >= size - noise
}

/// Compares whether a box is in some rows, and its size, with the model.
fn check<K: ProjectionKind>(
    (projection, model): (Projection<K>, ModelProjection),
    moves: &[Move],
    bounds: &Bounds,
    rows: [u32; 2],
) {
    let (transform, eye) = product(moves);
    let mvp = projection * transform;
    let (width, height) = SIZE;
    let view = View {
        eye,
        projection: model,
        viewport: ModelViewport::new(width, height),
    };
    let mut pixels = vec![Gray8::new(0); (width * (rows[1] - rows[0])) as usize];
    let canvas = Canvas::band(&mut pixels, width, height, rows[0]).unwrap();
    let in_view = canvas.is_in_view(&DrawOptions::new(), bounds, &mvp);
    let has_pixels = has_pixels(bounds, &mvp, rows);
    assert!(
        in_view || !has_pixels,
        "{bounds:?} has pixels and is not in view"
    );
    let is_out = is_out(bounds, &view, rows);
    assert!(
        !in_view || !is_out,
        "{bounds:?} is well outside and is in view"
    );
    let sizes = sizes((projection, model), moves, bounds);
    assert!(is_size(sizes), "{sizes:?}");
}

fn moves(random: &mut Random) -> [Move; 4] {
    let place = within(random, [-40.0..40., -30.0..30., -60.0..5.]);
    [
        support::moves::to(place),
        Move::X(Angle::from_bits(random.random())),
        Move::Y(Angle::from_bits(random.random())),
        Move::Scale(rounded([random.random_range(0.2..3.); 3])),
    ]
}

fn bounds(random: &mut Random) -> Bounds {
    let [a, b] = from_fn(|_| rounded(from_fn(|_| random.random_range(-8.0..8.))));
    let small = random.random_range(0..4);
    let b = Vec3::from_bits(from_fn(|i| {
        let [a, b] = [a.to_bits()[i], b.to_bits()[i]];
        a + ((b - a) >> (2 * small))
    }));
    Bounds::new(a, b)
}

fn rows(random: &mut Random) -> [u32; 2] {
    let start = random.random_range(0..SIZE.1);
    [start, (start + random.random_range(1..=SIZE.1)).min(SIZE.1)]
}

#[test]
fn boxes_in_perspective_are_in_view_as_in_the_model() {
    cases(2000, |random| {
        let (moves, bounds, rows) = (moves(random), bounds(random), rows(random));
        let fov = random.random_range(20.0..120_f64);
        let fov = Angle::from_bits((fov / 360. * 2_f64.powi(32)) as u32);
        let [near, far] = [random.random_range(1.0..5.), 50.].map(number);
        let aspect = f64::from(SIZE.0) / f64::from(SIZE.1);
        let model = projection::perspective(
            support::moves::radians(fov),
            aspect,
            f64::from(near),
            f64::from(far),
        );
        let projection = Projection::perspective(fov, SIZE, near, far).unwrap();
        check((projection, model), &moves, &bounds, rows);
    });
}

#[test]
fn boxes_in_parallel_are_in_view_as_in_the_model() {
    cases(2000, |random| {
        let (moves, bounds, rows) = (moves(random), bounds(random), rows(random));
        // Widths, heights and depths have very different sizes, because each row of clip space has its own exponent.
        let [width, height, length] =
            within(random, [-3.0..6_f64, -3.0..6., -8.0..8.]).map(|size| number(size.exp2()));
        let window = Window::centered(width, height);
        let near = number(random.random_range(-20.0..20.));
        let far = near + length;
        let [l, r, b, t] = [window.left, window.right, window.bottom, window.top].map(f64::from);
        let model = projection::orthographic(l, r, b, t, f64::from(near), f64::from(far));
        let projection = Projection::orthographic(window, near, far).unwrap();
        check((projection, model), &moves, &bounds, rows);
    });
}

/// The diagonal of a box can be longer than the largest `Scalar`.
#[test]
fn the_largest_boxes_have_their_sizes() {
    let screen = Viewport::new(0, 0, 8, 8).unwrap();
    let [side, depth] = [30_000_f64, 5_000.];
    let bounds = Bounds::new(vec3!(-15000, -15000, -32000), vec3!(15000, 15000, -27000));
    let diagonal = (2. * side * side + depth * depth).sqrt();

    let window = Window::centered(fx!(500), fx!(500));
    let flat = Projection::orthographic(window, fx!(0), fx!(32767)).unwrap();
    let size = screen.size_on_screen(&bounds, &flat);
    assert_eq!(size, (diagonal * 8. / 500.) as u32);

    // The sphere around the box, with half of the diagonal as its radius, ends 8,000 units before the eye.
    let lens = Projection::perspective(deg!(90), (1, 1), fx!(1), fx!(32767)).unwrap();
    let size = screen.size_on_screen(&bounds, &lens);
    assert_eq!(size, (diagonal * 4. / 29_500.) as u32);

    // In this viewport, pixels are a quarter as high as wide, so the width counts.
    let tall = Viewport::new(0, 0, 8, 32).unwrap();
    assert_eq!(tall.size_on_screen(&bounds, &lens), size);
}
