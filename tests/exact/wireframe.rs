//! A mesh's edges drawn over the mesh itself: no visible edge has gaps.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::Window;
use fixel::canvas::{Add, Biased, DepthTest, TestAndWrite, WriteOnly};
use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;

use crate::{List, Screen};
use support::random::cases;

const SIZE: (u32, u32) = (72, 64);
const PIXELS: usize = (SIZE.0 * SIZE.1) as usize;

const SURFACE: Gray8 = Gray8::new(1);
const EDGE: Gray8 = Gray8::new(2);

static BOX: Mesh = shape!(cuboid(vec3!(1, 0.7, 0.4)));
static BALL: Mesh = shape!(sphere(9, 6));
static CAN: Mesh = shape!(cylinder(7));

/// The edges of a convex mesh with a face that is visible from the eye.
///
/// A face seen nearly edge-on does not count, because the rounding of its corners decides whether it is visible.
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

/// Draws the shaded mesh, and then its edges over it.
fn over<K: ProjectionKind>(mesh: &Mesh, mvp: &Mvp<K>, test: impl DepthTest) -> Vec<Gray8> {
    let options = DrawOptions::new().with_depth_test(test);
    let draw = &mut |canvas: &mut Screen<'_, Gray8>| {
        canvas.draw_with(&options, mesh, mvp, &Flat::new(SURFACE));
        canvas.draw(mesh.edges(LineStyle::HAIRLINE), mvp, &Flat::new(EDGE));
    };
    crate::picture(SIZE, SIZE.1, (Gray8::BLACK, 0), draw).0
}

/// Draws only the edges, without depth. The edges are blended, so an edge lacks an end pixel if the edge does not pass
/// the pixel's center. (A face narrower than a pixel can hide an end of an edge there.)
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

/// The number of pixels that the visible edges should have, and how many of these pixels are not drawn.
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

/// Rotates the mesh, and moves it to this distance.
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

/// Draws the outlines of round meshes over the meshes, in many poses. `face` moves the depths of the faces, and `line`
/// moves the depths of the lines. Returns the number of pixels of the outlines, and how many of these pixels the mesh
/// hides.
fn hidden_outlines(face: impl DepthTest, line: impl DepthTest) -> [usize; 2] {
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
            let draw = &mut |canvas: &mut Screen<'_, Gray8>| {
                if is_hidden {
                    let options = DrawOptions::new().with_depth_test(face);
                    canvas.draw_with(&options, mesh, &mvp, &Flat::new(SURFACE));
                }
                let options = DrawOptions::new().with_depth_test(line);
                let lines = mesh.outline(&outline, LineStyle::HAIRLINE);
                canvas.draw_with(&options, lines, &mvp, &Flat::new(EDGE));
            };
            crate::picture(SIZE, SIZE.1, (Gray8::BLACK, 0), draw).0
        });
        for (sum, count) in sums.iter_mut().zip(missing(&over, &alone)) {
            *sum += count;
        }
    });
    sums
}

#[test]
fn silhouettes_of_round_meshes_have_hardly_any_gaps() {
    let [outlines, gaps] = hidden_outlines(TestAndWrite, Biased::in_front(TestAndWrite));
    assert!(gaps * 150 <= outlines, "{gaps} of {outlines}");
    // For contrast: there are more gaps without a depth bias, and if the bias moves the faces instead of the lines.
    let [outlines, gaps] = hidden_outlines(TestAndWrite, TestAndWrite);
    assert!(gaps * 3 > outlines, "{gaps} of {outlines}");
    let [outlines, gaps] = hidden_outlines(Biased::behind(TestAndWrite), TestAndWrite);
    assert!(gaps * 50 > outlines, "{gaps} of {outlines}");
}

/// A sheet leans back in all directions from a corner in the middle of the picture, and can reach beyond the picture.
/// The lines of its border move nearer by a multiple of the change of the sheet's depth per pixel. The lines move by
/// the same amount in a whole frame, in bands and from a list.
#[test]
fn outlines_move_as_the_faces_beside_them_are_steep() {
    static SHEET: Mesh = shape!(plane(1, 1));
    static BORDER: Outline = outline!(SHEET, deg!(30));
    const SLOPE: f64 = 3.0;
    cases(300, |random| {
        // Depth is linear in a parallel view: there are 65,536 steps from the near plane to the far plane.
        let size = random.random_range(3.0..20.0_f64);
        let window = Window::centered(
            Scalar::try_from(4.0 * f64::from(SIZE.0) / f64::from(SIZE.1)).unwrap(),
            fx!(4),
        );
        let depth = 60.0;
        let projection = Projection::orthographic(window, fx!(0), fx!(60)).unwrap();
        let (turn, lean) = (random.random_range(0..360), random.random_range(5..80));
        let model = Transform::translate(vec3!(0, 0, -30))
            * Transform::rotate_z(Angle::from_degrees(turn))
            * Transform::rotate_x(Angle::from_degrees(lean))
            * Transform::scale(Scalar::try_from(size).unwrap())
            * Transform::translate(vec3!(1, 0, 1));
        let mvp = projection * model;
        let draw = |test: Biased<WriteOnly>, band: u32, is_listed: bool| {
            let options = DrawOptions::new()
                .with_cull(Cull::Nothing)
                .with_depth_test(test);
            let lines = SHEET.outline(&BORDER, LineStyle::HAIRLINE);
            let mut list: List = DrawList::new();
            let listed = list.prepare(&options, SIZE, lines, &mvp).unwrap();
            let draw = &mut |canvas: &mut Screen<'_, Gray8>| {
                if is_listed {
                    canvas.draw_prepared(&listed, &Flat::new(EDGE)).unwrap();
                } else {
                    canvas.draw_with(&options, lines, &mvp, &Flat::new(EDGE));
                }
            };
            crate::picture(SIZE, band, (Gray8::BLACK, 0), draw).1
        };
        let plain = draw(Biased::new(WriteOnly, 0, fx!(0)), SIZE.1, false);
        let slope = Scalar::try_from(SLOPE).unwrap();
        let moved = draw(Biased::new(WriteOnly, 0, slope), SIZE.1, false);
        for (band, is_listed) in [(16, false), (SIZE.1, true), (8, true)] {
            assert!(moved == draw(Biased::new(WriteOnly, 0, slope), band, is_listed));
        }
        // The sheet's sides point along (1, 0, 0) and (0, 0, 1), and its normal along (0, 1, 0), leaned and turned. The
        // ratios of the normal's components give the change of depth on the sheet, per unit across and per unit down. A
        // side is longer along one axis, across or down; along the side, the change of depth is counted per unit of
        // this axis.
        let [lean, turn] = [lean, turn].map(|degrees| f64::from(degrees).to_radians());
        let turned = |[x, y, z]: [f64; 3]| {
            let (y, z) = (
                y * lean.cos() - z * lean.sin(),
                y * lean.sin() + z * lean.cos(),
            );
            [
                x * turn.cos() - y * turn.sin(),
                x * turn.sin() + y * turn.cos(),
                z,
            ]
            .map(f64::abs)
        };
        let [x, y, z] = turned([0.0, 1.0, 0.0]);
        let face = (x / z).max(y / z);
        let sides = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(|side| {
            let [x, y, z] = turned(side);
            face.max(z / x.max(y))
        });
        let pixel = 4.0 / f64::from(SIZE.1);
        let expected = sides.map(|steepness| SLOPE * steepness * pixel / depth * 65_536.0);
        // Both ends of the sheet's shorter side, `side` pixels long, are rounded by up to half of 1/256 pixel. The
        // change of depth is stored in a format with 11 bits after the first one, and is rounded down twice.
        let side = (2.0 * size).min(2.0) * lean.sin().min(lean.cos()) / pixel;
        let tolerance = expected[0].max(expected[1]) * (4.0 / 256.0 / side + 2.0 / 2048.0) + 2.0;
        let pixels = plain.iter().zip(&moved).filter(|(plain, _)| **plain > 0);
        let mut count = 0;
        for (&plain, &moved) in pixels {
            let change = f64::from(moved) - f64::from(plain);
            assert!(
                moved == 65_535
                    || expected
                        .iter()
                        .any(|expected| (change - expected).abs() <= tolerance),
                "{change} for {expected:?} ± {tolerance}"
            );
            count += 1;
        }
        assert!(count > 10);
    });
}

/// For contrast: without a depth bias, the mesh hides some pixels of its own edges.
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
    // Edges on the back stay hidden, except where they touch edges on the front.
    let hidden = alone(&BOX, BOX.edge_indices(), &mvp);
    assert!(missing(&drawn, &hidden)[1] > 30);
}
