//! Properties of every shape: closed, facing outwards, with unit normals and texture coordinates within 0..1.

use std::collections::{BTreeMap, BTreeSet};
use std::vec::Vec;

use super::Shape;
use crate::mesh::Indices;
use crate::mesh::{Buffers, Mesh};
use crate::{Error, Scalar, Vec2, Vec3};
use crate::{fx, shape, vec3};

type Point = [i32; 3];

/// A pear on a foot: smooth, except for an edge above and below the foot's rim and for a tip at the top.
const PEAR: &[(Scalar, Scalar)] = &[
    (fx!(0), fx!(2)),
    (fx!(0), fx!(2)),
    (fx!(0.4), fx!(1.2)),
    (fx!(0.9), fx!(0.3)),
    (fx!(0.5), fx!(-0.6)),
    (fx!(0.5), fx!(-0.6)),
    (fx!(0.8), fx!(-0.7)),
    (fx!(0.8), fx!(-0.7)),
    (fx!(0), fx!(-0.7)),
];
/// Two cones that touch with their tips.
const HOURGLASS: &[(Scalar, Scalar)] = &[
    (fx!(0), fx!(1)),
    (fx!(1), fx!(1)),
    (fx!(1), fx!(1)),
    (fx!(0), fx!(0)),
    (fx!(1), fx!(-1)),
    (fx!(1), fx!(-1)),
    (fx!(0), fx!(-1)),
];
/// A ring with the section of a drop: a loop that is smooth where it begins, with an edge on its inside.
const DROP: &[(Scalar, Scalar)] = &[
    (fx!(1), fx!(0.5)),
    (fx!(1.5), fx!(0)),
    (fx!(1), fx!(-0.5)),
    (fx!(0.3), fx!(0)),
    (fx!(0.3), fx!(0)),
    (fx!(1), fx!(0.5)),
];
/// The inside of a bowl, and its outside.
const BOWL: &[(Scalar, Scalar)] = &[
    (fx!(0), fx!(-0.5)),
    (fx!(0.8), fx!(0)),
    (fx!(1), fx!(1)),
    (fx!(1), fx!(1)),
    (fx!(1.1), fx!(1)),
    (fx!(1.1), fx!(1)),
    (fx!(0.9), fx!(-0.2)),
    (fx!(0), fx!(-0.7)),
];

static SHAPES: [(&str, Mesh); 18] = [
    ("cube", shape!(cuboid(vec3!(1, 1, 1)))),
    ("box", shape!(cuboid(vec3!(0.5, 2, 30_000)))),
    ("sphere", shape!(sphere(32, 32))),
    ("smallest sphere", shape!(sphere(3, 2))),
    ("odd sphere", shape!(sphere(7, 5))),
    ("torus", shape!(torus(fx!(0.3), 24, 12))),
    ("smallest torus", shape!(torus(fx!(0.9), 3, 3))),
    ("cylinder", shape!(cylinder(20))),
    ("prism", shape!(cylinder(3))),
    ("plane", shape!(plane(3, 5))),
    ("cone", shape!(cone(17))),
    ("smallest cone", shape!(cone(3))),
    ("disc", shape!(disc(9))),
    ("pear", shape!(lathe(12, PEAR))),
    ("hourglass", shape!(lathe(7, HOURGLASS))),
    ("drop", shape!(lathe(10, DROP))),
    ("bowl", shape!(lathe(11, BOWL))),
    (
        "largest",
        shape!(lathe(
            3,
            &[
                (fx!(0), fx!(32_767)),
                (fx!(32_767), fx!(-32_768)),
                (fx!(0), fx!(-32_768))
            ]
        )),
    ),
];

fn points(mesh: &Mesh) -> Vec<Point> {
    mesh.positions().iter().map(Vec3::to_bits).collect()
}

/// The directed sides of all triangles, by position, and how often each occurs.
fn sides(mesh: &Mesh) -> BTreeMap<(Point, Point), usize> {
    let points = points(mesh);
    let mut sides = BTreeMap::new();
    for face in mesh.faces() {
        let corners = face.map(|i| points[usize::from(i)]);
        for k in 0..3 {
            assert_ne!(corners[k], corners[(k + 1) % 3], "degenerate triangle");
            *sides.entry((corners[k], corners[(k + 1) % 3])).or_insert(0) += 1;
        }
    }
    sides
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn float(v: Vec3) -> [f64; 3] {
    v.to_bits().map(|x| f64::from(x) / 65536.0)
}

#[test]
fn surfaces_are_closed_and_have_the_right_euler_characteristic() {
    for (name, mesh) in &SHAPES {
        let sides = sides(mesh);
        let open = matches!(*name, "plane" | "disc");
        for (&(a, b), &count) in &sides {
            assert_eq!(count, 1, "{name}");
            assert!(open || sides.contains_key(&(b, a)), "{name}: open side");
        }
        let vertices: BTreeSet<_> = mesh.faces().iter().flatten().collect();
        let points = points(mesh);
        let vertices: BTreeSet<_> = vertices.iter().map(|&&i| points[usize::from(i)]).collect();
        let edges: BTreeSet<_> = sides.keys().map(|&(a, b)| (a.min(b), a.max(b))).collect();
        let euler = (vertices.len() + mesh.faces().len()).cast_signed() - edges.len().cast_signed();
        let expected = match *name {
            "torus" | "smallest torus" | "drop" => 0,
            "plane" | "disc" => 1,
            // Two bodies that share a vertex.
            "hourglass" => 3,
            _ => 2,
        };
        assert_eq!(euler, expected, "{name}");
    }
}

#[test]
fn each_edge_is_a_side_and_occurs_once() {
    for (name, mesh) in &SHAPES {
        let sides = sides(mesh);
        let points = points(mesh);
        let mut seen = BTreeSet::new();
        for edge in mesh.edge_indices() {
            let [a, b] = edge.map(|i| points[usize::from(i)]);
            assert!(
                sides.contains_key(&(a, b)) || sides.contains_key(&(b, a)),
                "{name}"
            );
            assert!(seen.insert((a.min(b), a.max(b))), "{name}: twice");
        }
    }
    assert_eq!(SHAPES[0].1.edge_indices().len(), 12);
}

/// Triangles and the normals of their corners point outwards, and these normals have length 1.
#[test]
fn normals_are_unit_vectors_that_point_outwards() {
    for (name, mesh) in &SHAPES {
        for (face, indices) in mesh.faces().iter().enumerate() {
            let [a, b, c] = indices.map(|i| float(mesh.position(i)));
            let side = |to: [f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
            let outwards = cross(side(b), side(c));
            for corner in 0..3 {
                let indices = Indices::of_face(face, *indices);
                let normal = float(mesh.normals.at(indices, corner).unwrap());
                // Each of the three components is rounded by up to 2^-17, so the length has an error of up to √3 ·
                // 2^-17.
                let length = dot(normal, normal).sqrt();
                assert!((length - 1.0).abs() < 1.0 / 32768.0, "{name}: {length}");
                assert!(
                    dot(normal, outwards) > 0.0,
                    "{name}: face {face} is inside out"
                );
            }
        }
    }
}

#[test]
fn sides_of_a_cuboid_are_in_the_documented_order() {
    const ORDER: [[i32; 3]; 6] = [
        [0, 0, 1],
        [1, 0, 0],
        [0, 0, -1],
        [-1, 0, 0],
        [0, 1, 0],
        [0, -1, 0],
    ];
    let (_, cube) = &SHAPES[0];
    let points = points(cube);
    for (side, out) in ORDER.iter().enumerate() {
        for corner in cube.faces()[2 * side..2 * side + 2].as_flattened() {
            let point = points[usize::from(*corner)];
            let height: i32 = point.iter().zip(out).map(|(x, out)| x * out).sum();
            assert_eq!(height, 1 << 16, "side {side}");
        }
    }
}

/// The eight positions are shared; each side has one normal, and the whole texture.
#[test]
fn a_side_of_a_cuboid_has_its_own_normal_and_texture() {
    for mesh in [
        &SHAPES[0].1,
        &shape!(cuboid(vec3!(1, 1, 1)), quantized),
        &shape!(cuboid(vec3!(1, 1, 1)), quantized_8),
    ] {
        let distinct: BTreeSet<_> = points(mesh).into_iter().collect();
        assert_eq!((distinct.len(), mesh.positions().len()), (8, 8));
        for (side, faces) in mesh.faces().chunks(2).enumerate() {
            let mut corners = BTreeSet::new();
            for (half, face) in faces.iter().enumerate() {
                let indices = Indices::of_face(2 * side + half, *face);
                for (corner, at) in face.iter().enumerate() {
                    let normal = float(mesh.normals.at(indices, corner).unwrap());
                    // The position and the normal are 1 along the side's axis. A normal of 8 bits is shorter.
                    let height = dot(float(mesh.position(*at)), normal);
                    assert!(
                        (height - 1.0).abs() < 0.01 && (dot(normal, normal) - 1.0).abs() < 0.02
                    );
                    let uv = mesh.uvs.at(indices, corner).unwrap();
                    corners.insert(uv.to_bits().map(|x| x.div_euclid(1 << 19)));
                }
            }
            let whole = BTreeSet::from([[0, 0], [2, 0], [0, 2], [2, 2]]);
            assert_eq!(corners, whole, "side {side}");
        }
    }
}

/// Each component of a position is rounded by up to 2^-17.
#[test]
fn positions_lie_on_the_mathematical_surface() {
    let tolerance = 4.0 / 65536.0;
    for (name, mesh) in &SHAPES {
        for p in mesh.positions().iter() {
            let [x, y, z] = float(p);
            let distance = match *name {
                "cube" => x.abs().max(y.abs()).max(z.abs()) - 1.0,
                "sphere" | "smallest sphere" | "odd sphere" => {
                    dot([x, y, z], [x, y, z]).sqrt() - 1.0
                }
                "torus" => ((x * x + z * z).sqrt() - 1.0).hypot(y) - 0.3,
                "cylinder" => (x * x + z * z).sqrt().max(y.abs()) - 1.0,
                "cone" if y > -1.0 => x.hypot(z) - (1.0 - y) / 2.0,
                "cone" | "disc" => (x.hypot(z) - 1.0).max(0.0),
                _ => 0.0,
            };
            assert!(distance.abs() < tolerance, "{name}: {p:?}");
        }
    }
}

/// Seen from outside, u points to the right and v down.
#[test]
fn texture_coordinates_are_in_range_and_not_mirrored() {
    for (name, mesh) in &SHAPES {
        for (face, indices) in mesh.faces().iter().enumerate() {
            let indices = Indices::of_face(face, *indices);
            let uv = [0, 1, 2].map(|corner| mesh.uvs.at(indices, corner).unwrap());
            for Vec2 { x, y } in uv {
                assert!((0..=1 << 20).contains(&x.to_bits()), "{name}");
                assert!((0..=1 << 20).contains(&y.to_bits()), "{name}");
            }
            let [a, b, c] = uv.map(|uv| uv.to_bits().map(i64::from));
            let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
            assert!(area < 0, "{name}: face {face} is mirrored");
        }
    }
}

#[test]
fn counts_are_exact() {
    for shape in [
        Shape::sphere(5, 9),
        Shape::torus(fx!(0.5), 4, 7),
        Shape::plane(1, 6),
        Shape::cylinder(9),
        Shape::cone(6),
        Shape::disc(5),
        Shape::lathe(4, PEAR),
        Shape::lathe(4, HOURGLASS),
        Shape::lathe(4, DROP),
        Shape::cuboid(vec3!(1, 2, 3)),
    ] {
        let shape = shape.unwrap();
        let counts = shape.counts();
        let mut positions = std::vec![Vec3::ZERO; counts.positions];
        let mut faces = std::vec![[u16::MAX; 3]; counts.faces];
        let mut edges = std::vec![[u16::MAX; 2]; counts.edges];
        let buffers = Buffers {
            edges: &mut edges,
            ..Buffers::new(&mut positions, &mut faces)
        };
        // If `build` left an index unwritten, its value u16::MAX would be an error.
        let mesh = shape.build(buffers).unwrap();
        assert_eq!(mesh.edge_indices().len(), counts.edges);
        assert!(!mesh.has_uvs() && !mesh.has_normals());
        let own = mesh.counts();
        assert_eq!((own.uv_faces, own.normal_faces), (0, 0));
        let mut uvs = std::vec![Vec2::ZERO; counts.uvs];
        let mut normals = std::vec![Vec3::ZERO; counts.normals];
        let buffers = Buffers {
            edges: &mut edges,
            uvs: &mut uvs,
            normals: &mut normals,
            ..Buffers::new(&mut positions, &mut faces)
        };
        assert_eq!(shape.build(buffers).unwrap().counts(), counts);
        let mut positions = std::vec![Vec3::ZERO; counts.positions - 1];
        let short = shape.build(Buffers::new(&mut positions, &mut faces));
        assert!(matches!(short, Err(Error::Count { .. })));
    }
}

#[test]
fn bad_arguments_are_refused() {
    let message = |shape: Result<Shape, Error>| std::format!("{}", shape.unwrap_err());
    assert_eq!(
        message(Shape::sphere(2, 8)),
        "number of slices is 2: it must be at least 3 and at most 16384"
    );
    assert_eq!(
        message(Shape::sphere(3, 1)),
        "number of stacks is 1: it must be at least 2 and at most 16384"
    );
    assert_eq!(
        message(Shape::sphere(256, 255)),
        "number of positions is 65792: it must be at most 65536"
    );
    assert!(Shape::sphere(255, 255).is_ok() && Shape::cylinder(16_383).is_ok());
    let most = Shape::MAX_PARTS;
    assert!(Shape::sphere(most, 2).is_ok() && Shape::plane(1, most).is_ok());
    for parts in [most - 1, most] {
        let fits = parts < most;
        assert_eq!(Shape::torus(fx!(0.5), parts, 3).is_ok(), fits);
        assert_eq!(Shape::torus(fx!(0.5), 3, parts).is_ok(), fits);
        assert_eq!(Shape::cylinder(parts).is_ok(), fits);
    }
    assert!(Shape::cylinder(u32::MAX).is_err() && Shape::plane(0, 1).is_err());
    assert!(Shape::torus(Scalar::ZERO, 3, 3).is_err());
    assert_eq!(
        message(Shape::torus(fx!(1), 3, 3)),
        "tube radius is 1: it must be above 0 and below 1"
    );
    assert!(Shape::cuboid(vec3!(1, -1, 1)).is_err());
    assert!(Shape::cone(2).is_err() && Shape::disc(2).is_err() && Shape::disc(most).is_ok());
    assert!(Shape::cone(21_844).is_err() && Shape::cone(most - 1).is_ok());
    assert!(Shape::lathe(2, PEAR).is_err());
    assert_eq!(
        message(Shape::lathe(3, &PEAR[..1])),
        "number of points is 1: it must be at least 2 and at most 16384"
    );
    assert_eq!(
        message(Shape::lathe(3, &[(fx!(1), fx!(0)), (fx!(-0.5), fx!(0))])),
        "distance from the axis is -0.5: it must be at least 0"
    );
    assert!(
        Shape::lathe(16_383, &[(fx!(1), fx!(1)); 6]).is_ok(),
        "four of six have a ring"
    );
}

/// The normals at all positions of this height, in the order of the mesh: away from the axis, and along it.
fn normals_at(mesh: &Mesh, height: f64) -> Vec<[f64; 2]> {
    let all = mesh.positions().iter().enumerate();
    let at = all.filter(|(_, p)| (float(*p)[1] - height).abs() < 1e-3);
    at.map(|(i, _)| {
        let indices = Indices::of_face(0, [u16::try_from(i).unwrap(); 3]);
        let [x, y, z] = float(mesh.normals.at(indices, 0).unwrap());
        [x.hypot(z), y]
    })
    .collect()
}

/// A point has the mean of the normals of both sides, and a repeated point has both normals. The tolerance is a unit of
/// each component.
#[test]
fn a_repeated_point_makes_an_edge() {
    let pear = &SHAPES.iter().find(|(name, _)| *name == "pear").unwrap().1;
    let unit = |[out, up]: [f64; 2]| [out, up].map(|x| x / out.hypot(up));
    let mean = |a: [f64; 2], b: [f64; 2]| unit([a[0] + b[0], a[1] + b[1]]);
    let steps = [[0.8, 0.4], [0.9, 0.5], [0.9, -0.4], [0.1, 0.3], [0., -1.]].map(unit);
    for (height, wanted) in [
        (2., std::vec![steps[0]]),
        (1.2, std::vec![mean(steps[0], steps[1])]),
        (0.3, std::vec![mean(steps[1], steps[2])]),
        (-0.6, std::vec![steps[2], steps[3]]),
        (-0.7, std::vec![steps[3], steps[4], [0., -1.]]),
    ] {
        let found = normals_at(pear, height);
        assert_eq!(found.len(), 13 * wanted.len(), "{height}");
        for (found, wanted) in found.chunks(13).zip(wanted) {
            for found in found {
                let off = (found[0] - wanted[0]).hypot(found[1] - wanted[1]);
                assert!(off < 3. / 65536., "{height}: {found:?} is not {wanted:?}");
            }
        }
    }
    // Without a tip, the top of a body is round.
    let bowl = &SHAPES.iter().find(|(name, _)| *name == "bowl").unwrap().1;
    let is_along = |[out, up]: &[f64; 2], wanted: f64| out + (up - wanted).abs() < f64::EPSILON;
    assert!(normals_at(bowl, -0.5).iter().all(|n| is_along(n, 1.)));
    assert!(normals_at(bowl, -0.7).iter().all(|n| is_along(n, -1.)));
    // A loop is smooth where it begins.
    let drop = &SHAPES.iter().find(|(name, _)| *name == "drop").unwrap().1;
    let all = normals_at(drop, 0.5);
    assert_eq!(all.len(), 22);
    let wanted = mean(unit([-0.5, 0.7]), unit([0.5, 0.5]));
    for [out, up] in all {
        // The normals point toward the axis or away from it.
        assert!((out - wanted[0].abs()).hypot(up - wanted[1]) < 3. / 65536.);
    }
}

/// v is the part of the profile's length before a point. The tolerance is a unit of v and the rounding of lengths to
/// 2^-16.
#[test]
fn the_texture_of_a_lathe_follows_the_length_of_its_profile() {
    for profile in [PEAR, HOURGLASS, DROP, BOWL] {
        let points: Vec<_> = profile
            .iter()
            .map(|&(r, y)| [f64::from(r), f64::from(y)])
            .collect();
        let lengths = points
            .windows(2)
            .map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1]));
        let whole: f64 = lengths.clone().sum();
        let mut before = 0.;
        let mut wanted: Vec<f64> = std::iter::once(0.)
            .chain(lengths.map(|length| {
                before += length;
                before / whole
            }))
            .collect();
        if profile[0] == profile[1] {
            wanted.remove(0);
        }
        let counts = Shape::lathe(5, profile).unwrap().counts();
        let mut positions = std::vec![Vec3::ZERO; counts.positions];
        let mut faces = std::vec![[0; 3]; counts.faces];
        let mut uvs = std::vec![Vec2::ZERO; counts.positions];
        let buffers = Buffers {
            uvs: &mut uvs,
            ..Buffers::new(&mut positions, &mut faces)
        };
        Shape::lathe(5, profile).unwrap().build(buffers).unwrap();
        assert_eq!(uvs.len(), 6 * wanted.len());
        for (row, wanted) in uvs.chunks(6).zip(wanted) {
            for uv in row {
                assert!(
                    (f64::from(uv.y) - wanted).abs() < 1e-4,
                    "{uv:?} is not at {wanted}"
                );
            }
        }
    }
}

/// A lathe makes the other bodies, too.
#[test]
fn a_lathe_with_the_profile_of_a_cylinder_or_a_sphere_has_their_positions() {
    fn points(shape: Result<Shape<'_>, Error>) -> Vec<Vec3> {
        let shape = shape.unwrap();
        let counts = shape.counts();
        let mut positions = std::vec![Vec3::ZERO; counts.positions];
        let mut faces = std::vec![[0; 3]; counts.faces];
        let mesh = shape
            .build(Buffers::new(&mut positions, &mut faces))
            .unwrap();
        mesh.positions().iter().collect()
    }
    let side = [(fx!(1), fx!(1)), (fx!(1), fx!(-1))];
    assert_eq!(
        points(Shape::lathe(9, &side)),
        points(Shape::cylinder(9))[..20]
    );
    let ball = points(Shape::sphere(12, 8));
    let arc: Vec<_> = ball.chunks(13).map(|row| (row[0].z, row[0].y)).collect();
    // The radius of a ring is rounded to 2^-17 in the profile, and each coordinate again.
    let off = |a: &Vec3, b: &Vec3| {
        (0..3)
            .map(|at| (a.to_bits()[at] - b.to_bits()[at]).abs())
            .max()
    };
    let turned = points(Shape::lathe(12, &arc));
    assert!(turned.iter().zip(&ball).all(|(a, b)| off(a, b) <= Some(1)));
    assert_eq!(turned.len(), ball.len());
}

/// The normal of each triangle at a tip lies in the middle between the normals at its two other corners, so that light
/// is the same on both sides. A component is rounded by 2^-17.
#[test]
fn the_normals_at_a_tip_are_in_the_middle_of_their_triangles() {
    let cone = &SHAPES.iter().find(|(name, _)| *name == "cone").unwrap().1;
    let mut tips = 0;
    for (face, indices) in cone.faces().iter().enumerate() {
        let of_face = Indices::of_face(face, *indices);
        let normals = [0, 1, 2].map(|corner| float(cone.normals.at(of_face, corner).unwrap()));
        let Some(tip) = indices.iter().position(|&at| cone.position(at).y == fx!(1)) else {
            continue;
        };
        let [x, _, z] = normals[tip];
        let [a, b] = [1, 2].map(|next| {
            let [u, _, w] = normals[(tip + next) % 3];
            x * w - z * u
        });
        assert!(
            (a + b).abs() < 4. / 65536. && a.abs() > 0.1,
            "{face}: {a} {b}"
        );
        tips += 1;
    }
    assert_eq!(tips, 17);
}
