//! Helpers that read OBJ text into meshes.

use embedded_graphics::pixelcolor::Rgb888;
use fixel::mesh::{Buffers, Counts, obj};
use fixel::prelude::*;

/// A mesh that owns its lists. Attributes are stored as their values at the triangles' corners.
#[derive(Debug, PartialEq)]
pub struct Owned {
    pub counts: Counts,
    pub positions: Vec<Vec3>,
    pub faces: Vec<[u16; 3]>,
    pub edges: Vec<[u16; 2]>,
    pub uvs: Vec<Vec2>,
    pub uv_faces: Vec<[u16; 3]>,
    pub normals: Vec<Vec3>,
    pub normal_faces: Vec<[u16; 3]>,
    pub colors: Vec<Rgb888>,
}

pub fn read(text: &str) -> Result<Owned, Error> {
    let counts = obj::count(text.as_bytes())?;
    let mut owned = Owned {
        counts,
        positions: vec![Vec3::ZERO; counts.positions],
        faces: vec![[0; 3]; counts.faces],
        edges: vec![[0; 2]; counts.edges],
        uvs: vec![Vec2::default(); counts.uvs],
        uv_faces: vec![[0; 3]; counts.uv_faces],
        normals: vec![Vec3::ZERO; counts.normals],
        normal_faces: vec![[0; 3]; counts.normal_faces],
        colors: vec![Rgb888::default(); counts.colors],
    };
    let mesh = obj::parse(
        text.as_bytes(),
        Buffers {
            positions: &mut owned.positions,
            faces: &mut owned.faces,
            edges: &mut owned.edges,
            uvs: &mut owned.uvs,
            uv_faces: &mut owned.uv_faces,
            normals: &mut owned.normals,
            normal_faces: &mut owned.normal_faces,
            colors: &mut owned.colors,
        },
    )?;
    assert_eq!(mesh.positions().len(), counts.positions);
    assert_eq!(mesh.faces().len(), counts.faces);
    assert_eq!(
        (mesh.has_uvs(), mesh.has_normals(), mesh.has_colors()),
        (counts.uvs > 0, counts.normals > 0, counts.colors > 0)
    );
    let edges = mesh.edges().len();
    owned.edges.truncate(edges);
    Ok(owned)
}

pub fn ok(text: &str) -> Owned {
    read(text).unwrap()
}

/// Checks that reading fails at this line, with a problem that contains this word.
pub fn fails(text: &str, line: usize, word: &str) {
    match read(text) {
        Err(Error::Obj {
            line: at, problem, ..
        }) => {
            assert_eq!(at, line, "{problem}");
            assert!(problem.contains(word), "{problem}");
        }
        other => panic!("{text:?} gave {other:?}"),
    }
}

/// The four corners of a unit square.
pub const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
