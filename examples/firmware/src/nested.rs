//! The measured cube with a smaller cube inside it. The triangles come in two orders.
//!
//! Whatever the order is, only the depth test hides the inner cube: back faces are culled, and front faces that share a
//! pixel are so far apart that their stored depths differ.

use fixel::mesh::{Buffers, Counts, Shape};
use fixel::prelude::*;

/// The triangles of the outer cube, then the triangles of the inner cube.
pub static INWARDS: Mesh = mesh(Mesh::new(&CUBES.positions, &CUBES.faces), &UV_FACES);
/// The same triangles in reverse order, with 16-bit positions. The positions have the same values, but a Cortex-M0+
/// transforms them with other code.
pub static OUTWARDS: Mesh = mesh(
    Mesh::quantized(&QUANTIZED.0, QUANTIZED.1, &reversed(&CUBES.faces)),
    &reversed(&UV_FACES),
);

const SHAPES: [Result<Shape, Error>; 2] = [
    Shape::cuboid(vec3!(1, 1, 1)),
    Shape::cuboid(vec3!(0.5, 0.5, 0.5)),
];
/// The counts of one cube.
const COUNTS: Counts = match SHAPES[0] {
    Ok(cube) => cube.counts(),
    Err(_) => panic!("no cube"),
};

struct Cubes {
    positions: [Vec3; 2 * COUNTS.positions],
    /// Both cubes show the texture in the same way.
    uvs: [Vec2; COUNTS.uvs],
    faces: [[u16; 3]; 2 * COUNTS.faces],
}

static CUBES: Cubes = {
    let mut cubes = Cubes {
        positions: [Vec3::ZERO; 2 * COUNTS.positions],
        uvs: [vec2!(0, 0); COUNTS.uvs],
        faces: [[0; 3]; 2 * COUNTS.faces],
    };
    let (outer_positions, inner_positions) = cubes.positions.split_at_mut(COUNTS.positions);
    let (outer_faces, inner_faces) = cubes.faces.split_at_mut(COUNTS.faces);
    build(SHAPES[0], outer_positions, &mut cubes.uvs, outer_faces);
    build(SHAPES[1], inner_positions, &mut cubes.uvs, inner_faces);
    // The vertices of the inner cube follow the vertices of the outer cube.
    let mut at = 0;
    while at < COUNTS.faces {
        let [a, b, c] = inner_faces[at];
        let first = COUNTS.positions as u16;
        inner_faces[at] = [first + a, first + b, first + c];
        at += 1;
    }
    cubes
};

static QUANTIZED: ([[i16; 3]; 2 * COUNTS.positions], u32) = match INWARDS.quantized_positions() {
    Ok(quantized) => quantized,
    Err(_) => panic!("the counts are exact"),
};

/// The triangles of both cubes, as indices of texture coordinates.
static UV_FACES: [[u16; 3]; 2 * COUNTS.faces] = {
    let [of_cube, _] = match SHAPES[0] {
        Ok(cube) => cube.own_faces(),
        Err(_) => panic!("no cube"),
    };
    let mut faces = [[0; 3]; 2 * COUNTS.faces];
    let mut at = 0;
    while at < faces.len() {
        faces[at] = of_cube[at % of_cube.len()];
        at += 1;
    }
    faces
};

const fn reversed<const N: usize>(faces: &[[u16; 3]; N]) -> [[u16; 3]; N] {
    let mut reversed = [[0; 3]; N];
    let mut at = 0;
    while at < N {
        reversed[at] = faces[N - 1 - at];
        at += 1;
    }
    reversed
}

const fn build(
    shape: Result<Shape, Error>,
    positions: &mut [Vec3],
    uvs: &mut [Vec2],
    faces: &mut [[u16; 3]],
) {
    let mut buffers = Buffers::new(positions, faces);
    buffers.uvs = uvs;
    match shape {
        Ok(shape) => _ = Mesh::checked(shape.build(buffers)),
        Err(_) => panic!("no cube"),
    }
}

const fn mesh(mesh: Result<Mesh<'static>, Error>, uv_faces: &'static [[u16; 3]]) -> Mesh<'static> {
    Mesh::checked(Mesh::checked(mesh).with_uvs(&CUBES.uvs, Some(uv_faces)))
}
