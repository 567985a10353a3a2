//! The painter's order compared with distances in f64.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::Window;
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;

use support::counter::BOTH_SIDES;
use support::random::{Random, cases, list};
use support::recorder::{Recorder, record};

const SIZE: (u32, u32) = (40, 30);
const NEAR: f64 = 1.;
const FAR: f64 = 64.;

/// The triangles that `draw` draws, in drawing order. Triangles without pixels are not included.
fn drawn(draw: impl FnOnce(&Recorder<'_, Flat<Gray8>, 0>)) -> Vec<usize> {
    let record = record(Flat::new(Gray8::BLACK), draw);
    let mut faces: Vec<usize> = record.corners.iter().map(|(face, _)| *face).collect();
    // A shader is asked once for each part of a clipped triangle, so a face can occur several times in a row.
    faces.dedup();
    faces
}

/// Triangles in eye space.
#[derive(Clone, Debug)]
struct Scene {
    corners: Vec<[f64; 3]>,
    faces: Vec<[u16; 3]>,
}

impl Scene {
    /// The positions of the corners, divided by `unit`.
    fn positions(&self, unit: f64) -> Vec<Vec3> {
        let mut positions = Vec::new();
        for corner in &self.corners {
            positions.push(Vec3::try_from(corner.map(|x| x / unit)).unwrap());
        }
        positions
    }

    /// The drawing order of the triangles. Checks that the same triangles are drawn without sorting.
    fn order<K: ProjectionKind>(&self, projection: &Projection<K>) -> Vec<usize> {
        let positions = self.positions(1.);
        let mesh = Mesh::new(&positions, &self.faces).unwrap();
        let mut list: DrawList<40, 400> = DrawList::new();
        let mut pixels = [Gray8::BLACK; (SIZE.0 * SIZE.1) as usize];
        let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
        let mut draw = |is_sorted| {
            let prepared = if is_sorted {
                list.prepare_back_to_front(&BOTH_SIDES, SIZE, &mesh, projection)
            } else {
                list.prepare(&BOTH_SIDES, SIZE, &mesh, projection)
            };
            let prepared = prepared.unwrap();
            drawn(|recorder| _ = canvas.draw_prepared(&prepared, recorder).unwrap())
        };
        let (all, order) = (draw(false), draw(true));
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, all);
        order
    }

    /// The drawing order if the triangles belong to three objects. Every third triangle belongs to the same object.
    fn order_of_objects<K: ProjectionKind>(&self, projection: &Projection<K>) -> Vec<usize> {
        // The objects have different units, so they are transformed in different formats.
        let units = [1., 4., 1. / 16.];
        let positions = units.map(|unit| self.positions(unit));
        let faces: [Vec<[u16; 3]>; 3] =
            std::array::from_fn(|i| self.faces.iter().copied().skip(i).step_by(3).collect());
        let meshes: [Mesh<'_>; 3] =
            std::array::from_fn(|i| Mesh::new(&positions[i], &faces[i]).unwrap());
        let mut objects: [Object<usize, &Mesh<'_>>; 3] = std::array::from_fn(|i| {
            let model = Transform::scale(Scalar::try_from(units[i]).unwrap());
            Object::new(&meshes[i], model, i)
        });
        let mut list: DrawList<40, 400> = DrawList::new();
        let mut pixels = [Gray8::BLACK; (SIZE.0 * SIZE.1) as usize];
        let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
        let mut draw = |is_sorted| {
            let scene = if is_sorted {
                list.prepare_back_to_front(&BOTH_SIDES, SIZE, &mut objects, projection)
            } else {
                list.prepare(&BOTH_SIDES, SIZE, &mut objects, projection)
            };
            let scene = scene.unwrap();
            let mut all = Vec::new();
            for (&object, triangles) in scene.parts(&canvas).unwrap() {
                let order =
                    drawn(|recorder| _ = canvas.draw_prepared(&triangles, recorder).unwrap());
                all.extend(order.iter().map(|face| 3 * face + object));
            }
            all
        };
        let (mut all, order) = (draw(false), draw(true));
        let mut sorted = order.clone();
        all.sort_unstable();
        sorted.sort_unstable();
        assert_eq!(sorted, all);
        order
    }

    /// The distance of a triangle's farthest corner, after clipping to the far plane.
    fn farthest(&self, face: usize) -> f64 {
        let distances = self.faces[face].map(|index| -self.corners[usize::from(index)][2]);
        distances.into_iter().fold(0., f64::max).min(FAR)
    }

    /// Checks that no triangle is drawn before a triangle that is farther away by more than `tolerance`. Triangles at
    /// equal distances must keep the order of the mesh.
    fn check(&self, order: &[usize], objects: usize, tolerance: &dyn Fn(f64) -> f64) {
        for pair in order.windows(2) {
            let [first, second] = [self.farthest(pair[0]), self.farthest(pair[1])];
            assert!(
                first + tolerance(first) >= second,
                "{pair:?}: {first} is drawn before {second}"
            );
            #[allow(clippy::float_cmp)] // two distances of one corner, or cut by the far plane
            let is_equal = first == second;
            let is_one_object = pair[0] % objects == pair[1] % objects;
            assert!(
                !(is_equal && is_one_object) || pair[0] < pair[1],
                "{pair:?}: both at {first}, out of order"
            );
        }
    }
}

/// Triangles with distances that are often equal, or differ by as little as the order can resolve. The near or the far
/// plane clips some triangles.
fn scene(random: &mut Random) -> Scene {
    let corners = list(random, 3..30, |random| {
        let [x, y, z, step] = [-160..160, -160..160, 0..120, 0..4]
            .map(|range| f64::from(random.random_range::<i32, _>(range)));
        [x / 16., y / 16., -(z * 0.625 + step / 16384.)]
    });
    let count = corners.len() as u16;
    let faces = list(random, 1..40, |random| {
        [(); 3].map(|()| random.random_range(0..count))
    });
    Scene { corners, faces }
}

#[test]
fn farther_triangles_come_first_in_perspective() {
    cases(256, |random| {
        let scene = scene(random);
        let projection = Projection::perspective(deg!(60), SIZE, fx!(1), fx!(64)).unwrap();
        // 1/w is truncated to 26 bits, and the first of these bits is set. Rounding the reciprocal and the projection's
        // coefficients at most doubles this error.
        let tolerance = |w| w * 2_f64.powi(-24);
        scene.check(&scene.order(&projection), 1, &tolerance);
        scene.check(&scene.order_of_objects(&projection), 3, &tolerance);
    });
}

#[test]
fn farther_triangles_come_first_in_parallel() {
    cases(256, |random| {
        let scene = scene(random);
        let window = Window::centered(fx!(12), fx!(9));
        let projection = Projection::orthographic(window, fx!(1), fx!(64)).unwrap();
        // A step is 2^-26 of the distance between the planes. The rounding of coefficients adds less than another step.
        let step = (FAR - NEAR) * 2_f64.powi(-25);
        scene.check(&scene.order(&projection), 1, &|_| step);
        scene.check(&scene.order_of_objects(&projection), 3, &|_| step);
    });
}

/// Triangles at the same distance keep the order of the mesh. Triangles that are farther away are drawn first.
#[test]
fn triangles_at_equal_distances_keep_their_order() {
    let corner = |x: f64, z: f64| [[x, 0., z], [x + 1., 0., z], [x, 1., z]];
    let mut scene = Scene {
        corners: Vec::new(),
        faces: Vec::new(),
    };
    for i in 0..33_u16 {
        let z = if i % 3 == 1 { -9. } else { -8. };
        scene.corners.extend(corner(f64::from(i % 5), z));
        scene.faces.push([0, 1, 2].map(|corner| 3 * i + corner));
    }
    let behind = (0..33).filter(|i| i % 3 == 1);
    let before = (0..33).filter(|i| i % 3 != 1);
    let expected: Vec<usize> = behind.chain(before).collect();
    let projection = Projection::perspective(deg!(60), SIZE, fx!(1), fx!(64)).unwrap();
    assert_eq!(scene.order(&projection), expected);
    let window = Window::centered(fx!(12), fx!(9));
    let projection = Projection::orthographic(window, fx!(1), fx!(64)).unwrap();
    assert_eq!(scene.order(&projection), expected);
}
