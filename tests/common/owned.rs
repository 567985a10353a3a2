//! Meshes that are read from OBJ text into lists of their own.

use embedded_graphics::pixelcolor::Rgb888;
use fixel::mesh::{Buffers, Counts, obj};
use fixel::prelude::*;

/// A mesh that owns its lists.
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

impl Owned {
    fn new(counts: Counts) -> Self {
        Self {
            counts,
            positions: vec![Vec3::ZERO; counts.positions],
            faces: vec![[0; 3]; counts.faces],
            edges: vec![[0; 2]; counts.edges],
            uvs: vec![Vec2::default(); counts.uvs],
            uv_faces: vec![[0; 3]; counts.uv_faces],
            normals: vec![Vec3::ZERO; counts.normals],
            normal_faces: vec![[0; 3]; counts.normal_faces],
            colors: vec![Rgb888::default(); counts.colors],
        }
    }

    /// Reads text into lists with room for `counts` elements.
    pub fn read(text: &[u8], counts: Counts) -> Result<Self, Error> {
        let mut owned = Self::new(counts);
        let mesh = obj::parse(
            text,
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
        let counts = mesh.counts();
        assert_eq!(
            (mesh.has_uvs(), mesh.has_normals(), mesh.has_colors()),
            (counts.uvs > 0, counts.normals > 0, counts.colors > 0)
        );
        owned.counts = counts;
        owned.positions.truncate(counts.positions);
        owned.faces.truncate(counts.faces);
        owned.edges.truncate(counts.edges);
        owned.uvs.truncate(counts.uvs);
        owned.uv_faces.truncate(counts.uv_faces);
        owned.normals.truncate(counts.normals);
        owned.normal_faces.truncate(counts.normal_faces);
        owned.colors.truncate(counts.colors);
        Ok(owned)
    }
}
