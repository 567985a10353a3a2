//! The rectangle of a mesh on the screen: it contains every pixel that is drawn, and is as small as the model's box.

use std::array::from_fn;
use std::ops::Range;

use embedded_graphics::geometry::Dimensions;
use embedded_graphics::pixelcolor::Gray8;
use embedded_graphics::primitives::{PointsIter, Rectangle};
use fixel::mesh::Bounds;
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use fixel::{Thing, Window};
use rand::Rng;

use super::in_view::corners;
use support::moves::{self, Move, exact, number, product, rounded};
use support::random::{Random, cases, list, within};
use support::reference::projection::{self, Projection as ModelProjection};
use support::reference::view::{View, Viewport as ModelViewport};

const SIZE: (u32, u32) = (64, 48);
/// The guard band ends this many pixels from the viewport's center.
const GUARD: f64 = 2048.;

/// A mesh in a box, and where it is drawn.
struct Scene {
    positions: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
    bounds: Bounds,
    viewport: Viewport,
}

impl Scene {
    /// The mesh has corners of its box and other positions in it.
    fn new(random: &mut Random, bounds: Bounds) -> Self {
        let corners = corners(&bounds);
        let positions = list(random, 3..12, |random| {
            let corner = corners[random.random_range(0..8)].to_bits();
            let (least, most) = (bounds.least.to_bits(), bounds.most.to_bits());
            Vec3::from_bits(from_fn(|axis| match random.random_range(0..2) {
                0 => corner[axis],
                _ => random.random_range(least[axis]..=most[axis]),
            }))
        });
        let any = 0..positions.len() as u16;
        let faces = list(random, 1..8, |random| {
            [(); 3].map(|()| random.random_range(any.clone()))
        });
        // A viewport may reach beyond the frame.
        let viewport = if random.random() {
            Viewport::new(0, 0, SIZE.0, SIZE.1)
        } else {
            let [x, y] = [(); 2].map(|()| random.random_range(-20..40));
            let [width, height] = [(); 2].map(|()| random.random_range(1..90));
            Viewport::new(x, y, width, height)
        };
        Self {
            positions,
            faces,
            bounds,
            viewport: viewport.unwrap(),
        }
    }

    fn rectangle<K: ProjectionKind>(&self, mvp: &Mvp<K>, reach: u32) -> Option<Rectangle> {
        self.viewport.rectangle_on_screen(&self.bounds, mvp, reach)
    }

    /// Draws a thing, and checks that no pixel outside the rectangle has changed. Returns whether any pixel has.
    fn check<T: Thing<Gray8>, K: ProjectionKind>(
        &self,
        thing: T,
        mvp: &Mvp<K>,
        rectangle: Option<Rectangle>,
    ) -> bool {
        let mut pixels = vec![Gray8::new(0); (SIZE.0 * SIZE.1) as usize];
        let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
        let options = DrawOptions::new()
            .with_cull(Cull::Nothing)
            .with_viewport(self.viewport);
        canvas.draw_with(&options, thing, mvp, &Flat::new(Gray8::new(255)));
        let area = canvas.bounding_box();
        let mut changed = area
            .points()
            .zip(canvas.pixels())
            .filter(|(_, pixel)| *pixel != Gray8::new(0))
            .peekable();
        let is_drawn = changed.peek().is_some();
        for (at, _) in changed {
            assert!(
                rectangle.is_some_and(|rectangle| rectangle.contains(at)),
                "{at:?} is not in {rectangle:?}"
            );
        }
        is_drawn
    }

    /// Draws the mesh in all ways, and checks each. Returns whether its triangles have a pixel.
    fn check_all<K: ProjectionKind>(&self, random: &mut Random, mvp: &Mvp<K>) -> bool {
        let edges: Vec<_> = self.faces.iter().map(|&[a, b, _]| [a, b]).collect();
        let mesh = Mesh::new(&self.positions, &self.faces).unwrap();
        let mesh = mesh.with_edges(&edges).unwrap();
        let rectangle = self.rectangle(mvp, 0);
        let is_drawn = self.check(&mesh, mvp, rectangle);
        self.check(mesh.edges(LineStyle::HAIRLINE), mvp, rectangle);
        self.check(mesh.points(PointStyle::PIXEL), mvp, rectangle);
        // The reach is half of the width or of the size, rounded up.
        let half = random.random_range(128..1000);
        let width = Scalar::from_bits(half << 9);
        let rectangle = self.rectangle(mvp, half.cast_unsigned().div_ceil(256));
        let wide = LineStyle::wide(width).unwrap();
        self.check(mesh.edges(wide), mvp, rectangle);
        self.check(mesh.edges(wide.smooth()), mvp, rectangle);
        self.check(
            mesh.points(PointStyle::square(width).unwrap()),
            mvp,
            rectangle,
        );
        self.check(
            mesh.points(PointStyle::round(width).unwrap()),
            mvp,
            rectangle,
        );
        let sprites = Sprites::in_pixels(&self.positions, (width, width)).unwrap();
        let rectangle = self.rectangle(mvp, half.cast_unsigned().div_ceil(128));
        self.check(&sprites, mvp, rectangle);
        is_drawn
    }
}

/// The pixels between two positions, rounded outward.
fn outward([least, most]: [f64; 2]) -> Range<f64> {
    least.floor()..most.floor() + 1.
}

/// Checks that a rectangle is no larger than the box of the model, up to `slack` pixels on each side before it is
/// rounded.
fn check_size(
    scene: &Scene,
    corners: &[[f64; 2]; 8],
    slack: f64,
    rectangle: Option<Rectangle>,
) -> bool {
    let Some(Rectangle { top_left, size }) = rectangle else {
        return false;
    };
    let viewport = scene.viewport;
    let (from, to) = (viewport.top_left(), viewport.size());
    let axes = [
        (from.x, to.width, top_left.x, size.width),
        (from.y, to.height, top_left.y, size.height),
    ];
    for (axis, (start, length, found, found_length)) in axes.into_iter().enumerate() {
        let center = f64::from(start) + f64::from(length) / 2.;
        let ends = corners.iter().fold([f64::MAX, f64::MIN], |[a, b], corner| {
            let at = corner[axis].clamp(center - GUARD, center + GUARD);
            [a.min(at), b.max(at)]
        });
        let model = outward([ends[0] - slack, ends[1] + slack]);
        let (start, end) = (f64::from(start), f64::from(start) + f64::from(length));
        let found = f64::from(found)..f64::from(found) + f64::from(found_length);
        assert!(
            model.start.max(start) <= found.start && found.end <= model.end.min(end),
            "{found:?} is larger than {model:?} in {viewport:?}"
        );
    }
    true
}

/// What the rectangles of a test were.
#[derive(Debug, Default)]
struct Counts {
    drawn: u32,
    small: u32,
    cut: u32,
    none: u32,
}

/// Compares a scene's rectangle with pixels and model.
fn check<K: ProjectionKind>(
    random: &mut Random,
    (projection, model): (Projection<K>, ModelProjection),
    moves: &[Move],
    bounds: Bounds,
    counts: &mut Counts,
) {
    let (transform, eye) = product(moves);
    let mvp = projection * transform;
    let scene = Scene::new(random, bounds);
    counts.drawn += u32::from(scene.check_all(random, &mvp));

    let rectangle = scene.rectangle(&mvp, 0);
    let (corner, size) = (scene.viewport.top_left(), scene.viewport.size());
    let view = View {
        eye,
        projection: model,
        viewport: ModelViewport {
            x: corner.x,
            y: corner.y,
            width: size.width,
            height: size.height,
        },
    };
    let corners = corners(&bounds).map(|corner| view.project(exact(corner)));
    let ahead = corners.map(|corner| corner.distance);
    let [nearest, farthest] = [f64::min, f64::max].map(|of: fn(f64, f64) -> f64| {
        let [first, rest @ ..] = ahead;
        rest.into_iter().fold(first, of)
    });
    counts.none += u32::from(rectangle.is_none());
    if K::PERSPECTIVE && nearest < model.near * 1.0001 {
        counts.cut += u32::from(rectangle.is_some());
        return;
    }
    // Half of this is promised, and the other half is for the model's own error of up to 0.01 pixel (see `in_view`).
    let slack = 2. / 16.;
    if !K::PERSPECTIVE || farthest < 50. * nearest {
        let corners = corners.map(|corner| corner.screen);
        counts.small += u32::from(check_size(&scene, &corners, slack, rectangle));
    }
}

fn moves(random: &mut Random) -> [Move; 4] {
    let [x, y, z] = within(random, [-0.5..0.5, -0.4..0.4, -40.0..1.]);
    let place = [x * z, y * z, z];
    [
        moves::to(place),
        Move::X(Angle::from_bits(random.random())),
        Move::Y(Angle::from_bits(random.random())),
        Move::Scale(rounded([random.random_range(0.2..3.); 3])),
    ]
}

fn bounds(random: &mut Random) -> Bounds {
    let [a, b] = from_fn(|_| rounded(from_fn(|_| random.random_range(-8.0..8.))));
    let small = 2 * random.random_range(0..4);
    let b = from_fn(|i| a.to_bits()[i] + ((b.to_bits()[i] - a.to_bits()[i]) >> small));
    Bounds::new(a, Vec3::from_bits(b))
}

#[test]
fn no_pixel_is_outside_in_perspective() {
    let mut counts = Counts::default();
    cases(6000, |random| {
        let (moves, bounds) = (moves(random), bounds(random));
        let fov = random.random_range(20.0..120_f64);
        let fov = Angle::from_bits((fov / 360. * 2_f64.powi(32)) as u32);
        let [near, far] =
            [random.random_range(0.1..5.), random.random_range(10.0..50.)].map(number);
        let aspect = f64::from(SIZE.0) / f64::from(SIZE.1);
        let model =
            projection::perspective(moves::radians(fov), aspect, f64::from(near), f64::from(far));
        let projection = Projection::perspective(fov, SIZE, near, far).unwrap();
        check(random, (projection, model), &moves, bounds, &mut counts);
    });
    println!("perspective: {counts:?}");
    let Counts {
        drawn,
        small,
        cut,
        none,
    } = counts;
    assert!(drawn > 500 && small > 1000 && cut > 300 && none > 300);
}

#[test]
fn no_pixel_is_outside_in_parallel() {
    let mut counts = Counts::default();
    cases(6000, |random| {
        let (moves, bounds) = (moves(random), bounds(random));
        let [width, height, length] =
            within(random, [2.0..7_f64, 2.0..7., 3.0..7.]).map(|size| number(size.exp2()));
        let window = Window::centered(width, height);
        let near = number(random.random_range(-20.0..40.));
        let far = near + length;
        let [l, r, b, t] = [window.left, window.right, window.bottom, window.top].map(f64::from);
        let model = projection::orthographic(l, r, b, t, f64::from(near), f64::from(far));
        let projection = Projection::orthographic(window, near, far).unwrap();
        check(random, (projection, model), &moves, bounds, &mut counts);
    });
    println!("parallel: {counts:?}");
    assert!(counts.drawn > 300 && counts.small > 1000 && counts.none > 300);
}

/// Positions anywhere, a near plane at any distance: clipping is then too coarse for an error of a fraction of a pixel.
#[test]
fn no_pixel_is_outside_at_the_ends_of_the_formats() {
    let mut drawn = 0;
    cases(6000, |random| {
        let cut = random.random_range(0..24);
        let mut wild = |cut: i32| Vec3::from_bits(random.random::<[i32; 3]>().map(|v| v >> cut));
        let (bounds, place) = (Bounds::new(wild(cut), wild(cut)), wild(cut));
        // At the origin, the eye is in the box or close to it.
        let place = if place.z < fx!(0) { place } else { Vec3::ZERO };
        let turn = Transform::rotate_x(Angle::from_bits(random.random()))
            * Transform::rotate_y(Angle::from_bits(random.random()));
        let place = Transform::translate(place) * turn;
        let scene = Scene::new(random, bounds);
        let near = 1 << random.random_range(4..31 - cut);
        let far = i64::from(near) << random.random_range(1..20);
        let [near, far] =
            [i64::from(near), far.min(i32::MAX.into())].map(|bits| Scalar::from_bits(bits as i32));
        let perspective = Projection::perspective(deg!(70), SIZE, near, far).unwrap();
        let size = Scalar::from_bits(1 << random.random_range(26 - cut..31 - cut));
        let parallel = Projection::orthographic(Window::centered(size, size), near, far).unwrap();
        drawn += u32::from(scene.check_all(random, &(perspective * place)));
        drawn += u32::from(scene.check_all(random, &(parallel * place)));
    });
    println!("wild: {drawn}");
    assert!(drawn > 500);
}

/// All points of a line of sight have the same place on the screen, here 1/512 pixel left of a column. Their rounded
/// places differ by 1/256 pixel, so they are in two columns.
#[test]
fn no_pixel_is_outside_if_a_box_is_a_line_of_sight() {
    let mut columns = [0; 2];
    cases(1000, |random| {
        let column = random.random_range(1..SIZE.0.cast_signed());
        // At the near plane, a unit is a pixel.
        let left = fx!(1) / 512 - fx!(1) * column;
        let window = Window {
            left,
            right: left + fx!(64),
            bottom: fx!(-24.5),
            top: fx!(23.5),
        };
        let near = number(random.random_range(1.0..40.));
        let projection = Projection::frustum(window, near, fx!(30000)).unwrap();
        let ends = [(); 4].map(|()| {
            let distance = random.random_range(4..29_000);
            Vec3::new(fx!(0), fx!(0), -near - Scalar::from_bits(distance << 16))
        });
        let mesh = Mesh::new(&ends[..2], &[]).unwrap();
        let scene = Scene {
            positions: ends.to_vec(),
            faces: vec![],
            bounds: mesh.bounds(),
            viewport: Viewport::new(0, 0, SIZE.0, SIZE.1).unwrap(),
        };
        let mvp = projection.into();
        let bounds = scene.bounds;
        let inside = ends.map(|end| end.z.clamp(bounds.least.z, bounds.most.z));
        let inside = inside.map(|z| Vec3::new(fx!(0), fx!(0), z));
        let mesh = Mesh::new(&inside, &[]).unwrap();
        scene.check(
            mesh.points(PointStyle::PIXEL),
            &mvp,
            scene.rectangle(&mvp, 0),
        );
        for point in inside {
            let at = scene.viewport.project(point, &mvp).unwrap();
            columns[usize::from(at.x.floor() == column)] += 1;
        }
    });
    assert!(columns.iter().all(|&count| count > 100), "{columns:?}");
}

/// A box without width that points to the eye, and is cut at a distance that is a tiny part of its length: the cut is
/// then wrong by a part of a pixel.
#[test]
fn no_pixel_is_outside_if_a_cut_is_coarse() {
    let mut drawn = 0;
    cases(4000, |random| {
        let near = random.random_range(100..1000);
        let far = near * random.random_range(2..6);
        let [near_end, far_end] = [near + random.random_range(0..near / 2), 32_000 << 16];
        let (least, most) = ([0, 0, -far_end], [0, 0, -near_end]);
        let bounds = Bounds::new(Vec3::from_bits(least), Vec3::from_bits(most));
        let mut angle =
            || Angle::from_bits(random.random_range(-1 << 28..1_i32 << 28).cast_unsigned());
        let turn = Transform::rotate_x(angle()) * Transform::rotate_y(angle());
        let scene = Scene {
            faces: vec![[0, 7, 1], [3, 4, 6]],
            positions: corners(&bounds).to_vec(),
            bounds,
            viewport: Viewport::new(0, 0, SIZE.0, SIZE.1).unwrap(),
        };
        let [near, far] = [near, far].map(Scalar::from_bits);
        let projection = Projection::perspective(deg!(70), SIZE, near, far).unwrap();
        let mvp = projection * turn;
        let _ = scene.check_all(random, &mvp);
        drawn += u32::from(scene.rectangle(&mvp, 0).is_some());
    });
    assert!(drawn > 1000, "{drawn}");
}
