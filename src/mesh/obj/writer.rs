//! Writes the elements of an OBJ text into lists, and counts them.

use super::elements::Corner;
use super::reader::Reader;
use crate::Error;
use crate::error::ok;
use crate::mesh::{Buffers, Counts, Index, Mesh};

/// Writes the elements in the order of the text, as long as there is room.
pub(super) struct Writer<'t, 'b, 'a> {
    pub(super) reader: Reader<'t>,
    buffers: &'b mut Buffers<'a>,
    /// Triangles so far.
    faces: usize,
    /// Corners of all polygons so far.
    corners: usize,
    /// Edges so far, duplicates included.
    edges: usize,
    /// Positions with colors so far.
    colors: usize,
    uvs: Usage,
    normals: Usage,
}

/// How the corners use an attribute, which decides whether it needs indices of its own.
#[derive(Clone, Copy)]
struct Usage {
    /// How many corners name a value.
    corners: usize,
    /// Whether any of these indices differs from the corner's position index.
    differs: bool,
}

impl Usage {
    const fn see(&mut self, index: u16, position: u16) {
        self.corners += 1;
        self.differs |= index != position;
    }

    /// The lengths needed for the attribute's lists of values and of triangles. The arguments count the values,
    /// positions, corners and triangles in the text.
    const fn counts(
        self,
        values: usize,
        positions: usize,
        corners: usize,
        faces: usize,
    ) -> (usize, usize) {
        if self.corners == 0 {
            (0, 0)
        } else if self.differs || self.corners < corners || values != positions {
            (values, faces)
        } else {
            (values, 0)
        }
    }
}

/// Writes to a list if there is room.
macro_rules! put {
    ($self:ident.buffers.$list:ident[$at:expr] = $value:expr) => {
        if $at < $self.buffers.$list.len() {
            $self.buffers.$list[$at] = $value;
        }
    };
}

impl<'t, 'b, 'a> Writer<'t, 'b, 'a> {
    pub(super) const fn new(reader: Reader<'t>, buffers: &'b mut Buffers<'a>) -> Self {
        let unused = Usage {
            corners: 0,
            differs: false,
        };
        Self {
            reader,
            buffers,
            faces: 0,
            corners: 0,
            edges: 0,
            colors: 0,
            uvs: unused,
            normals: unused,
        }
    }

    pub(super) const fn counts(&self) -> Counts {
        let [positions, uvs, normals] = self.reader.seen;
        let (uvs, uv_faces) = self.uvs.counts(uvs, positions, self.corners, self.faces);
        let (normals, normal_faces) =
            self.normals
                .counts(normals, positions, self.corners, self.faces);
        let colored = self.colors == positions;
        Counts {
            positions,
            faces: self.faces,
            edges: self.edges,
            uvs,
            uv_faces,
            normals,
            normal_faces,
            colors: if colored { positions } else { 0 },
        }
    }

    pub(super) const fn write(&mut self) -> Result<(), Error> {
        while self.reader.begins() {
            if self.reader.keyword(b"v") {
                let (at, position, color) = ok!(self.reader.position());
                put!(self.buffers.positions[at] = position);
                if let Some(color) = color {
                    put!(self.buffers.colors[at] = color);
                    self.colors += 1;
                }
            } else if self.reader.keyword(b"f") {
                ok!(self.polygon(true));
            } else if self.reader.keyword(b"vt") {
                let (at, uv) = ok!(self.reader.uv());
                put!(self.buffers.uvs[at] = uv);
            } else if self.reader.keyword(b"vn") {
                let (at, normal) = ok!(self.reader.normal());
                put!(self.buffers.normals[at] = normal);
            } else if self.reader.keyword(b"l") {
                ok!(self.polygon(false));
            } else {
                self.reader.skip(false);
            }
        }
        Ok(())
    }

    /// Reads the corners of a polygon and writes its triangles and edges, or reads a line and writes its edges.
    const fn polygon(&mut self, face: bool) -> Result<(), Error> {
        let mut first = None;
        let mut last = None;
        let mut count = 0;
        while let Some(corner) = ok!(self.reader.corner()) {
            count += 1;
            if let (Some(uv), true) = (corner.uv, face) {
                self.uvs.see(uv, corner.position);
            }
            if let (Some(normal), true) = (corner.normal, face) {
                self.normals.see(normal, corner.position);
            }
            if let (Some(first), Some(last)) = (first, last) {
                self.edge(last, corner);
                if face && count > 2 {
                    self.triangle([first, last, corner]);
                }
            } else {
                first = Some(corner);
            }
            last = Some(corner);
        }
        if face && count < 3 {
            return self.reader.error("a face needs at least 3 corners");
        }
        if count < 2 {
            return self.reader.error("a line needs at least 2 ends");
        }
        if let (Some(first), Some(last), true) = (first, last, face) {
            self.edge(last, first);
            self.corners += count;
        }
        Ok(())
    }

    const fn edge(&mut self, from: Corner, to: Corner) {
        let (from, to) = (from.position, to.position);
        // A side from a position to itself is no edge.
        if from != to {
            let edge = if from < to { [from, to] } else { [to, from] };
            put!(self.buffers.edges[self.edges] = edge);
            self.edges += 1;
        }
    }

    const fn triangle(&mut self, [a, b, c]: [Corner; 3]) {
        const fn index(index: Option<Index>) -> Index {
            match index {
                Some(index) => index,
                None => Mesh::NO_VALUE,
            }
        }
        let at = self.faces;
        put!(self.buffers.faces[at] = [a.position, b.position, c.position]);
        put!(self.buffers.uv_faces[at] = [index(a.uv), index(b.uv), index(c.uv)]);
        put!(self.buffers.normal_faces[at] = [index(a.normal), index(b.normal), index(c.normal)]);
        self.faces += 1;
    }
}
