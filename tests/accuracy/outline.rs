//! Outlines: the crate finds and draws the same creases and edges as the model, and lines leave no gap around a mesh.

use std::array;
use std::collections::HashMap;

use embedded_graphics::pixelcolor::Gray8;
use fixel::prelude::*;
use fixel::view::{Perspective, ProjectionKind};
use rand::Rng;
use rand::seq::IndexedRandom;
use support::counter::{BOTH_SIDES, Counter};
use support::random::{Random, cases, list};
use support::recorder::{Probe, record};
use support::reference::clip::{ClipVertex, DEPTH_PLANES, polygon};
use support::reference::coverage::area2_f64;
use support::reference::linear::Vec3 as Vector;
use support::reference::outline::{Edge, edges, is_drawn};
use support::reference::{projection, view};

static BOX: Mesh = shape!(cuboid(vec3!(1, 0.7, 0.4)));
static BALL: Mesh = shape!(sphere(12, 9));
static SMALL_BALL: Mesh = shape!(sphere(9, 6), quantized);
static CAN: Mesh = shape!(cylinder(7));
static RING: Mesh = shape!(torus(fx!(0.4), 14, 9));
static GROUND: Mesh = shape!(plane(3, 2));
static HOUSE: Mesh = include_mesh!("../models/house.obj");
static ISLAND: Mesh = include_mesh!("../../examples/assets/lighthouse.obj");

const SIZE: (u32, u32) = (72, 64);

const MESHES: [&Mesh; 7] = [&BOX, &BALL, &SMALL_BALL, &CAN, &RING, &GROUND, &HOUSE];

fn float(place: Vec3) -> Vector {
    place.to_bits().map(|bits| f64::from(bits) / 65536.)
}

fn triangles(mesh: &Mesh) -> Vec<[Vector; 3]> {
    let place = |index: u16| float(mesh.positions().get(index.into()).unwrap());
    mesh.faces().iter().map(|face| face.map(place)).collect()
}

/// A key of an edge, the same for both directions of the edge.
fn key(ends: [Vector; 2]) -> [[u64; 3]; 2] {
    let mut ends = ends.map(|end| end.map(|x| (x + 0.).to_bits()));
    ends.sort_unstable();
    ends
}

/// Memory for an outline with every side of every triangle of a mesh.
fn room(mesh: &Mesh) -> Vec<[u16; 4]> {
    vec![[0; 4]; 3 * mesh.faces().len()]
}

/// Compares the edges of an outline, its creases, and the faces beside its edges with the model.
fn check_edges(mesh: &Mesh, degrees: f64) {
    let mut room = room(mesh);
    let limit = Angle::try_from_degrees(degrees).unwrap();
    let outline = Outline::build(mesh, limit, &mut room).unwrap();
    let place = |index: u16| float(mesh.positions().get(index.into()).unwrap());
    // For each edge: whether it is a crease, and the third corners of its faces.
    let mut found: HashMap<_, Vec<(bool, Vec<Vector>)>> = HashMap::new();
    for (i, &[a, b, c, d]) in outline.edges().iter().enumerate() {
        let thirds = if d == a {
            vec![place(c)]
        } else {
            vec![place(c), place(d)]
        };
        let edge = (i < outline.creases(), thirds);
        found
            .entry(key([place(a), place(b)]))
            .or_default()
            .push(edge);
    }
    // Normals are scaled to 20 bits, so the angle between two normals has an error of at most 4 · 2^-19.
    let error = 4. / 524_288.;
    let triangles = triangles(mesh);
    for Edge { ends, faces, angle } in edges(&triangles) {
        let candidates = found.get_mut(&key(ends));
        let thirds = |face: usize| {
            triangles[face]
                .iter()
                .copied()
                .find(|place| !ends.contains(place))
                .unwrap()
        };
        let thirds: Vec<Vector> = faces.iter().map(|&face| thirds(face)).collect();
        let at = candidates.as_ref().and_then(|all| {
            all.iter().position(|(_, found)| {
                found.len() == thirds.len() && thirds.iter().all(|third| found.contains(third))
            })
        });
        let crease = at.map(|at| candidates.unwrap().remove(at).0);
        let flat = 1. / 1024.;
        match angle {
            None => assert_eq!(crease, Some(false), "a border is no crease"),
            Some(angle) if angle < flat - error => {
                assert_eq!(crease, Some(false), "an angle of {angle} is no crease");
            }
            Some(angle) if angle > flat + error => {
                let crease = crease.expect("an edge is missing");
                let limit = degrees.to_radians();
                if (angle - limit).abs() > error {
                    assert_eq!(crease, angle > limit, "angle {angle}, limit {limit}");
                }
            }
            Some(_) => {}
        }
    }
    assert!(
        found.values().all(Vec::is_empty),
        "edges that the model does not have"
    );
}

#[test]
fn edges_and_creases_are_the_models() {
    for mesh in MESHES.into_iter().chain([&ISLAND]) {
        for degrees in [0., 1., 20., 30., 59.9, 90., 90.1, 180.] {
            check_edges(mesh, degrees);
        }
    }
}

#[test]
fn an_outline_of_wrong_numbers_is_refused() {
    let mut room = room(&BOX);
    let error = Outline::build(&BOX, deg!(35), &mut room[1..]).unwrap_err();
    assert!(matches!(
        error,
        Error::Count {
            given: 36,
            max: 35,
            ..
        }
    ));
    let error = Outline::build(&BOX, Angle::from_bits((1 << 31) + 1), &mut room).unwrap_err();
    assert!(matches!(error, Error::Angle { .. }));
    assert!(Outline::new(&BOX, &[[0, 1, 2, 24]], 0).is_err());
    assert!(Outline::new(&BOX, &[[0, 1, 2, 23]], 2).is_err());
}

/// Positions anywhere in the format, and faces between any of them. Many faces are repeated or have no area.
fn soup(random: &mut Random) -> ([Vec3; 6], Vec<[u16; 3]>) {
    let far = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    let mut number = || match random.random_range(0..3) {
        0 => random.random_range(-3..3),
        1 => *far.choose(random).unwrap(),
        _ => random.random(),
    };
    let positions = array::from_fn(|_| Vec3::from_bits([number(), number(), number()]));
    let faces = list(random, 0..40, |random| {
        array::from_fn(|_| random.random_range(0..6))
    });
    (positions, faces)
}

/// No mesh causes a panic, and the two faces of each edge of an outline are faces of the mesh.
#[test]
fn any_mesh_has_an_outline() {
    cases(512, |random| {
        let (positions, faces) = soup(random);
        let mesh = Mesh::new(&positions, &faces).unwrap();
        let mut room = room(&mesh);
        let limit = Angle::from_bits(random.random_range(0..=1 << 31));
        let outline = Outline::build(&mesh, limit, &mut room).unwrap();
        let has = |corners: [u16; 3]| {
            let places = corners.map(|index| positions[usize::from(index)]);
            faces.iter().any(|face| {
                let face = face.map(|index| positions[usize::from(index)]);
                (0..3).any(|first| [0, 1, 2].map(|i| face[(first + i) % 3]) == places)
            })
        };
        for &[a, b, c, d] in outline.edges() {
            assert!(
                has([a, b, c]) && (d == a || has([b, a, d])),
                "{:?} of {faces:?} at {positions:?}",
                [a, b, c, d]
            );
        }
    });
}

/// A style for lines that always have a pixel, because they are wider than the diagonal of a pixel.
const WIDE: LineStyle = match LineStyle::wide(fx!(2)) {
    Ok(style) => style,
    Err(_) => LineStyle::HAIRLINE,
};

/// The ends of all edges of an outline that have pixels.
fn drawn<K: ProjectionKind>(
    options: &DrawOptions,
    mesh: &Mesh,
    outline: &Outline,
    mvp: &Mvp<K>,
) -> Vec<[Vector; 2]> {
    let mut colors = vec![Gray8::new(0); (SIZE.0 * SIZE.1) as usize];
    let mut canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
    let probe = Probe {
        values: &|corner: &Corner<'_>| corner.position().to_bits(),
        color: Some(Gray8::new(1)),
    };
    let mut result = fixel::Drawn::default();
    let record = record::<_, 3>(probe, |recorder| {
        result = canvas.draw_with(options, mesh.outline(outline, WIDE), mvp, recorder);
    });
    assert_eq!(result.submitted as usize, outline.edges().len());
    assert!(result.drawn as usize >= record.corners.len());
    let place = |bits: [i32; 3]| bits.map(|x| f64::from(x) / 65536.);
    record
        .corners
        .iter()
        .map(|(_, [a, b, _])| [place(*a), place(*b)])
        .collect()
}

/// The side that a face shows, computed from its plane; `None` if rounding can turn the face over or hide it.
fn side(triangle: [Vector; 3], view: &view::View) -> Option<i32> {
    let corners = triangle.map(|place| ClipVertex {
        position: view.clip(place),
        attributes: [],
        source: None,
    });
    // Clipping removes the parts of a face beyond the near and far planes and beyond the guard band.
    let guard = [
        [1., 0., 0., 56.],
        [-1., 0., 0., 56.],
        [0., 1., 0., 64.],
        [0., -1., 0., 64.],
    ];
    let planes: Vec<_> = DEPTH_PLANES.into_iter().chain(guard).collect();
    let corners = polygon(&corners, &planes);
    let Some((first, rest)) = corners.split_first() else {
        return Some(0);
    };
    let place = |corner: &ClipVertex<0>| view.on_screen(corner.position).screen;
    let areas = rest
        .windows(2)
        .map(|side| area2_f64(&[place(first), place(&side[0]), place(&side[1])]));
    let area: f64 = areas.sum();
    let size = corners
        .iter()
        .flat_map(|corner| place(corner).map(f64::abs))
        .fold(64., f64::max);
    // Each corner moves by up to 1/256 pixel along each axis, and a clipped face has at most nine corners.
    if area.abs() < 9. * 2. * size / 256. {
        return None;
    }
    Some(if area > 0. { -1 } else { 1 })
}

/// A random rotation, and then a translation to this distance in front of the eye.
fn pose(random: &mut Random, distance: f64) -> Transform {
    let [x, y, z] = random.random::<[u32; 3]>().map(Angle::from_bits);
    Transform::translate(Vec3::new(
        fx!(0),
        fx!(0),
        Scalar::try_from(-distance).unwrap(),
    )) * Transform::rotate_x(x)
        * Transform::rotate_y(y)
        * Transform::rotate_z(z)
}

const NEAR: f64 = 0.5;
const FAR: f64 = 4.;
const FOCAL: f64 = 60.;

fn projection(far: Scalar) -> Projection<Perspective> {
    Projection::from_focal_length(fx!(60), SIZE, fx!(0.5), far).unwrap()
}

/// The same edges are drawn as in the model, even where the near or the far plane clips a face. If all corners of both
/// faces are within the guard band, the model decides from the snapped corners, which is exact. Otherwise, the model
/// decides from the planes of the faces, and an edge is skipped if rounding can turn one of its faces over.
#[test]
fn drawn_edges_are_the_models() {
    cases(300, |random| {
        let mesh = *MESHES[..6].choose(random).unwrap();
        let distance = random.random_range(0.3..5.);
        let cull = *[Cull::Nothing, Cull::Back, Cull::Front]
            .choose(random)
            .unwrap();
        let mut room = room(mesh);
        let limit = Angle::from_degrees(random.random_range(0..180));
        let outline = Outline::build(mesh, limit, &mut room).unwrap();
        let pose = pose(random, distance);
        let mvp = projection(fx!(4)) * pose;
        let options = DrawOptions::new().with_cull(cull);
        let drawn = drawn(&options, mesh, &outline, &mvp);
        let view = view::View {
            eye: pose
                .to_matrix()
                .rows()
                .map(|row| row.map(|x| f64::from(x.to_bits()) / 65536.)),
            projection: projection::focal(FOCAL, SIZE, NEAR, FAR),
            viewport: view::Viewport::new(SIZE.0, SIZE.1),
        };
        let culled: &[i32] = match cull {
            Cull::Nothing => &[],
            Cull::Back => &[-1],
            Cull::Front => &[1],
        };
        let mut counter = Counter::new(SIZE);
        let mut drawn = drawn.into_iter();
        let mut next = drawn.next();
        let mut checked = 0;
        for (i, &[a, b, c, d]) in outline.edges().iter().enumerate() {
            let place = |index: u16| mesh.positions().get(index.into()).unwrap();
            let is_next = next == Some([float(place(a)), float(place(b))]);
            if is_next {
                next = drawn.next();
            }
            let mut side_of = |face: [u16; 3]| {
                let snapped: Option<Vec<_>> = face
                    .iter()
                    .map(|&index| counter.snapped(&mvp, place(index)))
                    .collect();
                if let Some(s) = snapped {
                    let [b, c] =
                        [1, 2].map(|to| [0, 1].map(|axis| i64::from(s[to][axis] - s[0][axis])));
                    return Some(-((b[0] * c[1] - b[1] * c[0]).signum() as i32));
                }
                side(face.map(|index| float(place(index))), &view)
            };
            let (left, right) = (
                side_of([a, b, c]),
                if d == a { Some(0) } else { side_of([b, a, d]) },
            );
            let (Some(left), Some(right)) = (left, right) else {
                continue;
            };
            let expected = is_drawn([left, right], i < outline.creases(), culled);
            // If fewer than two of an edge's pixels are in view, the edge can have no pixels, even if it belongs to the
            // outline.
            let mut on_screen = |index: u16| counter.snapped(&mvp, place(index));
            let is_inside = on_screen(a).zip(on_screen(b)).is_some_and(|(a, b)| {
                let inside =
                    |at: i32, size: u32| (2 << 8..(size - 2) << 8).contains(&at.cast_unsigned());
                let is_in_view = |[x, y]: [i32; 2]| inside(x, SIZE.0) && inside(y, SIZE.1);
                (is_in_view(a) || is_in_view(b)) && (0..2).any(|i| a[i].abs_diff(b[i]) >= 2 << 8)
            });
            assert!(
                is_next == expected || !is_next && !is_inside,
                "edge {} of {:?}: {} and {}",
                i,
                mesh.counts(),
                left,
                right
            );
            checked += u32::from(is_inside);
        }
        assert_eq!(next, None);
        assert!(
            checked > 0 || !(1.6..3.).contains(&distance),
            "nothing checked at a distance of {distance}"
        );
    });
}

/// Every pixel on the border of a closed mesh belongs to a line of the outline, or is beside a pixel of such a line.
#[test]
fn outlines_have_no_gaps() {
    cases(300, |random| {
        let mesh = *MESHES[..5].choose(random).unwrap();
        let distance = random.random_range(2.5..4.5);
        let mut room = room(mesh);
        let outline = Outline::build(mesh, deg!(180), &mut room).unwrap();
        let mvp = projection(fx!(9)) * pose(random, distance);
        let pixels = (SIZE.0 * SIZE.1) as usize;
        let (mut inside, mut lines) = (vec![Gray8::new(0); pixels], vec![Gray8::new(0); pixels]);
        let white = Flat::new(Gray8::new(1));
        Canvas::new(&mut inside, SIZE.0, SIZE.1).unwrap().draw_with(
            &BOTH_SIDES,
            mesh,
            &mvp,
            &white,
        );
        Canvas::new(&mut lines, SIZE.0, SIZE.1).unwrap().draw(
            mesh.outline(&outline, LineStyle::HAIRLINE),
            &mvp,
            &white,
        );
        let at = |picture: &[Gray8], x: usize, y: usize| {
            picture[y * SIZE.0 as usize + x] != Gray8::new(0)
        };
        for y in 1..SIZE.1 as usize - 1 {
            for x in 1..SIZE.0 as usize - 1 {
                let beside = [[x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]];
                if at(&inside, x, y) && beside.iter().any(|&[x, y]| !at(&inside, x, y)) {
                    let near = (y - 1..y + 2).any(|y| (x - 1..x + 2).any(|x| at(&lines, x, y)));
                    assert!(near, "no line at {x}, {y}");
                }
            }
        }
    });
}
