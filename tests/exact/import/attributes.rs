//! Texture coordinates, normals and colors, and which corners have them.

use embedded_graphics::pixelcolor::Rgb888;
use fixel::prelude::*;

use super::reading::{SQUARE, ok};

/// The index of a corner without a value.
const NONE: u16 = Mesh::NO_VALUE;

#[test]
fn corners_may_omit_uv_or_normal() {
    let attributes = "vt 0 0\nvt 1 0.25\nvn 0 0 1\nvn 0 1 0\nvn 2 0 0\n";
    let both = ok(&format!("{SQUARE}{attributes}f 1/2/3 2/1/2 3/2/1"));
    assert_eq!(
        (both.uv_faces, both.normal_faces),
        (vec![[1, 0, 1]], vec![[2, 1, 0]])
    );
    // v points down in the mesh, and up in the file.
    assert_eq!(both.uvs, [vec2!(0, 1), vec2!(1, 0.75)]);
    assert_eq!(both.normals, [Vec3::Z, Vec3::Y, vec3!(2, 0, 0)]);

    let uv = ok(&format!("{SQUARE}{attributes}f 1/2 2/1 3/-1"));
    assert_eq!((uv.uv_faces, uv.counts.normals), (vec![[1, 0, 1]], 0));

    let normal = ok(&format!("{SQUARE}{attributes}f 1//2 2//-3 3//3"));
    assert_eq!(
        (normal.normal_faces, normal.counts.uvs),
        (vec![[1, 0, 2]], 0)
    );

    let neither = ok(&format!("{SQUARE}{attributes}f 1 2/ 3//"));
    assert_eq!((neither.counts.uvs, neither.counts.normals), (0, 0));
}

#[test]
fn attributes_in_order_of_positions_need_no_faces() {
    let mesh = ok(&format!(
        "{SQUARE}vt 0\nvt 1\nvt 0 1 9\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4"
    ));
    assert_eq!((mesh.counts.uvs, mesh.counts.uv_faces), (4, 0));
    assert_eq!(mesh.uvs[..2], [vec2!(0, 1), vec2!(1, 1)]);
    let mesh = ok(&format!("{SQUARE}vt 0\nvt 1\nvt 0 1\nf 1/1 2/2 3/3"));
    assert_eq!((mesh.counts.uvs, mesh.counts.uv_faces), (3, 1));
}

#[test]
fn a_corner_may_lack_a_value() {
    let mesh = ok(&format!("{SQUARE}vt 0 0\nvn 0 0 1\nf 1/1 2 3//1\nf 1 3 4"));
    assert_eq!(mesh.uv_faces, [[0, NONE, NONE], [NONE; 3]]);
    assert_eq!(mesh.normal_faces, [[NONE, NONE, 0], [NONE; 3]]);
}

#[test]
fn colors_are_kept_only_if_all_positions_have_one() {
    let mesh = ok("v 0 0 0 1 0 0.5\nv 1 0 0 0.2 1 1 0.5");
    assert_eq!(
        mesh.colors,
        [Rgb888::new(255, 0, 128), Rgb888::new(51, 255, 255)]
    );
    assert_eq!(ok("v 0 0 0 1 0 0.5\nv 1 0 0").counts.colors, 0);
    assert_eq!(ok("v 1 2 3 4").positions, [vec3!(1, 2, 3)]);
}
