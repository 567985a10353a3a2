//! A mesh's edges drawn over the mesh itself: no visible edge has gaps.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::canvas::{Add, Biased, DepthTest, TestAndWrite};
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;

use crate::common::random::cases;

const SIZE: (u32, u32) = (72, 64);
const PIXELS: usize = (SIZE.0 * SIZE.1) as usize;

const SURFACE: Gray8 = Gray8::new(1);
const EDGE: Gray8 = Gray8::new(2);

static BOX: Mesh = shape!(cuboid(vec3!(1, 0.7, 0.4)));
static BALL: Mesh = shape!(sphere(9, 6));
static CAN: Mesh = shape!(cylinder(7));

/// The edges of a convex mesh that have a face visible from the eye.
///
/// A face seen nearly edge-on does not count: because corners are rounded, it may or may not be visible.
fn visible_edges(
    mesh: &Mesh,
    from_eye: impl Fn([f64; 3]) -> [f64; 3],
    pose: &Transform,
) -> Vec<[u16; 2]> {
    let position = |index: u16| mesh.positions().get(index.into()).unwrap();
    let seen = |face: &&[u16; 3]| {
        let [a, b, c] = face.map(|index| pose.point(position(index)).to_bits().map(f64::from));
        let side = |to: [f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
        let (b, c) = (side(b), side(c));
        let normal = [
            b[1] * c[2] - b[2] * c[1],
            b[2] * c[0] - b[0] * c[2],
            b[0] * c[1] - b[1] * c[0],
        ];
        let ray = from_eye(a);
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        dot(normal, ray) < -0.002 * (dot(normal, normal) * dot(ray, ray)).sqrt()
    };
    let faces: Vec<_> = mesh.faces().iter().filter(seen).collect();
    let beside = |&[from, to]: &[u16; 2]| {
        faces.iter().any(|face| {
            let has = |end: u16| face.iter().any(|&index| position(index) == position(end));
            has(from) && has(to)
        })
    };
    mesh.edge_indices().iter().copied().filter(beside).collect()
}

/// Draws the shaded mesh, then its edges over it.
fn over<K: ProjectionKind>(mesh: &Mesh, mvp: &Mvp<K>, test: impl DepthTest) -> Vec<Gray8> {
    let (mut colors, mut depths) = (vec![Gray8::BLACK; PIXELS], vec![0; PIXELS]);
    let canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    canvas.draw_with(
        &DrawOptions::new().with_depth(test),
        mesh,
        mvp,
        &Flat::new(SURFACE),
    );
    canvas.draw(mesh.edges(LineStyle::HAIRLINE), mvp, &Flat::new(EDGE));
    colors
}

/// Draws only the edges, without depth. Blended, they lack the pixels of ends whose centers they do not pass: there, a
/// face narrower than a pixel may be before the end.
fn alone<K: ProjectionKind>(mesh: &Mesh, edges: &[[u16; 2]], mvp: &Mvp<K>) -> Vec<Gray8> {
    let mesh = mesh.with_edges(edges).unwrap();
    let mut colors = vec![Gray8::BLACK; PIXELS];
    let mut canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
    let options = DrawOptions::new().with_blending(Add);
    canvas.draw_with(
        &options,
        mesh.edges(LineStyle::HAIRLINE),
        mvp,
        &Flat::new(EDGE),
    );
    colors
}

fn picture(pixels: &[Gray8]) -> String {
    let rows = pixels.chunks(SIZE.0 as usize);
    let character = |color: &Gray8| ['.', '-', '#'][usize::from(color.luma())];
    let row = |row: &[Gray8]| row.iter().map(character).chain(['\n']).collect::<String>();
    rows.map(row).collect()
}

/// The number of pixels that the visible edges should have, and how many of them are not drawn.
fn missing(drawn: &[Gray8], expected: &[Gray8]) -> [usize; 2] {
    let edge = expected.iter().filter(|&&color| color == EDGE).count();
    let missing = |&(a, b): &(&Gray8, &Gray8)| *b == EDGE && *a != EDGE;
    [edge, drawn.iter().zip(expected).filter(missing).count()]
}

/// Checks that these edges, drawn over the mesh, have no gaps.
fn check<K: ProjectionKind>(mesh: &Mesh, edges: &[[u16; 2]], mvp: &Mvp<K>) {
    let drawn = over(mesh, mvp, Biased::behind(TestAndWrite));
    let expected = alone(mesh, edges, mvp);
    let [edge, gaps] = missing(&drawn, &expected);
    assert!(
        edge > 0 && gaps == 0,
        "{gaps} gaps\n{}\n{}",
        picture(&drawn),
        picture(&expected)
    );
}

/// Rotates the mesh, and places it at this distance.
fn pose([x, y, z]: [u32; 3], distance: Scalar) -> Transform {
    Transform::translate(Vec3::new(fx!(0), fx!(0), -distance))
        * Transform::rotate_x(Angle::from_bits(x))
        * Transform::rotate_y(Angle::from_bits(y))
        * Transform::rotate_z(Angle::from_bits(z))
}

#[test]
fn edges_over_the_mesh_have_no_gaps() {
    cases(1500, |random| {
        let mesh = [BOX, BALL, CAN][random.random_range(0..3)];
        let distance = Scalar::try_from(random.random_range(3.0..9.0)).unwrap();
        let pose = pose(random.random(), distance);
        let near = Scalar::try_from(random.random_range(0.05..0.5)).unwrap();
        let perspective = Projection::perspective(deg!(50), SIZE, near, fx!(20)).unwrap();
        let edges = visible_edges(&mesh, |at| at, &pose);
        check(&mesh, &edges, &(perspective * pose));

        let window = Window::centered(fx!(4), fx!(4));
        let parallel = Projection::orthographic(window, fx!(0), fx!(20)).unwrap();
        let edges = visible_edges(&mesh, |_| [0., 0., -1.], &pose);
        check(&mesh, &edges, &(parallel * pose));
    });
}

/// The outlines of round meshes over the meshes themselves, in many poses: the number of pixels, and how many of them the
/// mesh hides if its depths are moved by `test`.
fn hidden_outlines(test: impl DepthTest) -> [usize; 2] {
    static ROUND_BALL: Mesh = shape!(sphere(24, 16));
    static ROUND_CAN: Mesh = shape!(cylinder(24));
    static MESHES: [(&Mesh, Outline); 2] = [
        (&ROUND_BALL, outline!(ROUND_BALL, deg!(60))),
        (&ROUND_CAN, outline!(ROUND_CAN, deg!(30))),
    ];
    let mut sums = [0; 2];
    cases(200, |random| {
        let (mesh, outline) = MESHES[random.random_range(0..2)];
        let distance = Scalar::try_from(random.random_range(3.0..9.0)).unwrap();
        let projection = Projection::perspective(deg!(50), SIZE, fx!(1), fx!(20)).unwrap();
        let mvp = projection * pose(random.random(), distance);
        let [alone, over] = [false, true].map(|is_hidden| {
            let (mut colors, mut depths) = ([Gray8::BLACK; PIXELS], [0; PIXELS]);
            let canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
            let mut canvas = canvas.with_depth(&mut depths).unwrap();
            if is_hidden {
                let options = DrawOptions::new().with_depth(test);
                canvas.draw_with(&options, mesh, &mvp, &Flat::new(SURFACE));
            }
            canvas.draw(
                mesh.outline(&outline, LineStyle::HAIRLINE),
                &mvp,
                &Flat::new(EDGE),
            );
            colors
        });
        for (sum, count) in sums.iter_mut().zip(missing(&over, &alone)) {
            *sum += count;
        }
    });
    sums
}

#[test]
fn silhouettes_of_round_meshes_have_hardly_any_gaps() {
    let [outlines, gaps] = hidden_outlines(Biased::behind_outlines(TestAndWrite));
    assert!(gaps * 250 <= outlines, "{gaps} of {outlines}");
    let [outlines, gaps] = hidden_outlines(Biased::behind(TestAndWrite));
    assert!(gaps * 50 > outlines, "{gaps} of {outlines}");
}

/// For contrast: without a depth bias, the mesh hides some pixels of its edges.
#[test]
fn edges_over_a_mesh_without_bias_have_gaps() {
    let pose = pose([200_000_000, 500_000_000, 0], fx!(2.5));
    let mvp =
        Projection::perspective(Angle::from_degrees(50), SIZE, fx!(0.25), fx!(20)).unwrap() * pose;
    let expected = alone(&BOX, &visible_edges(&BOX, |at| at, &pose), &mvp);
    let [edge, gaps] = missing(&over(&BOX, &mvp, TestAndWrite), &expected);
    assert!(edge > 150 && gaps > 10, "{gaps} of {edge}");
    let drawn = over(&BOX, &mvp, Biased::behind(TestAndWrite));
    assert_eq!(missing(&drawn, &expected), [edge, 0]);
    // The edges behind stay hidden, except where they touch those in front.
    let hidden = alone(&BOX, BOX.edge_indices(), &mvp);
    assert!(missing(&drawn, &hidden)[1] > 30);
}
