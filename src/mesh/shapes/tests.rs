//! Properties of every shape: closed, facing outwards, with unit normals and texture coordinates within 0..1.

use std::collections::{BTreeMap, BTreeSet};
use std::vec::Vec;

use super::Shape;
use crate::mesh::Indices;
use crate::mesh::{Buffers, Mesh};
use crate::{Error, Scalar, Vec2, Vec3};
use crate::{fx, shape, vec3};

type Point = [i32; 3];

static SHAPES: [(&str, Mesh); 10] = [
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
        let open = *name == "plane";
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
            "torus" | "smallest torus" => 0,
            "plane" => 1,
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
}
