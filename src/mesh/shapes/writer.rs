//! Writes the vertices, triangles and edges of a shape one after the other.

use crate::error::{Error, ok};
use crate::math::{Vec2, Vec3};
use crate::mesh::{Buffers, Counts, Index};
use crate::num::TexCoord;

/// Writes a mesh into buffers, and keeps the place of the next element of each list.
pub(super) struct MeshWriter<'a> {
    pub(super) buffers: Buffers<'a>,
    pub(super) counts: Counts,
    /// The number of the next position.
    pub(super) positions: u32,
    normals: usize,
    uvs: usize,
    faces: usize,
    edges: usize,
}

impl<'a> MeshWriter<'a> {
    pub(super) const fn new(buffers: Buffers<'a>, counts: Counts) -> Result<Self, Error> {
        let counts = ok!(buffers.wanted(counts));
        Ok(Self {
            buffers,
            counts,
            positions: 0,
            normals: 0,
            uvs: 0,
            faces: 0,
            edges: 0,
        })
    }

    /// Stores numbers in the place of a position that is written later.
    pub(super) const fn keep(&mut self, at: u32, numbers: [i32; 3]) {
        self.buffers.positions[at as usize] = Vec3::from_bits(numbers);
    }

    pub(super) const fn kept(&self, at: u32) -> [i32; 3] {
        self.buffers.positions[at as usize].to_bits()
    }

    /// Writes a position with its own normal and texture coordinate.
    pub(super) const fn vertex(&mut self, position: Vec3, normal: Vec3, uv: [TexCoord; 2]) {
        self.position(position);
        self.normal(normal);
        self.uv(uv);
    }

    pub(super) const fn position(&mut self, position: Vec3) {
        self.buffers.positions[self.positions as usize] = position;
        self.positions += 1;
    }

    pub(super) const fn normal(&mut self, normal: Vec3) {
        if self.counts.normals > 0 {
            self.buffers.normals[self.normals] = normal;
            self.normals += 1;
        }
    }

    pub(super) const fn uv(&mut self, [u, v]: [TexCoord; 2]) {
        if self.counts.uvs > 0 {
            self.buffers.uvs[self.uvs] = Vec2::new(u, v);
            self.uvs += 1;
        }
    }

    pub(super) const fn triangle(&mut self, [a, b, c]: [u32; 3]) {
        // `Shape` limits the number of positions, so each index of a triangle or of an edge fits into 16 bits.
        self.buffers.faces[self.faces] = [a as Index, b as Index, c as Index];
        self.faces += 1;
    }

    pub(super) const fn edge(&mut self, [from, to]: [u32; 2]) {
        if self.counts.edges > 0 {
            self.buffers.edges[self.edges] = [from as Index, to as Index];
            self.edges += 1;
        }
    }
}
