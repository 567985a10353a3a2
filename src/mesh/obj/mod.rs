//! Meshes from Wavefront OBJ text, at compile time or at run time, without floats or allocation.
//!
//! [`include_obj!`](crate::include_obj) turns a file into a `static` mesh; [`parse`] fills the caller's memory. Both
//! read this dialect:
//!
//! | statement | meaning |
//! |---|---|
//! | `v x y z`, `v x y z w` | a position; the weight is ignored |
//! | `v x y z r g b` | a position with a color, each component from 0 to 1; the mesh has colors if every position has one |
//! | `vt u`, `vt u v`, `vt u v w` | a texture coordinate; OBJ's v points up and [`Vec2`](crate::Vec2)'s points down, so v becomes 1 − v; w is ignored |
//! | `vn x y z` | a normal, of any length |
//! | `f 1 2 3`, `f 1/1 …`, `f 1//1 …`, `f 1/1/1 …` | a polygon of three or more corners, cut into a fan of triangles around its first corner; where this fan leaves a concave polygon, [`include_obj!`](crate::include_obj) cuts off ears instead |
//! | `l 1 2 3` | edges between positions |
//! | `# …` | a comment, to the end of the line |
//! | `usemtl name` | the material of the faces that follow; only [`include_mtl!`](crate::include_mtl) reads it |
//! | any other | ignored, whether OBJ defines it (`o`, `g`, `s`, `p`, `mtllib`, …) or not |
//!
//! - Indices start from 1; −1 is the last element so far, −2 the one before it. A positive index may name an element
//!   that comes later in the text.
//! - Numbers are decimal, with or without an exponent. Each is rounded exactly to the nearest
//!   [`Scalar`](crate::Scalar), after `vt` to the nearest [`TexCoord`](crate::TexCoord); halves round away from zero.
//! - Lines end in LF, CR or both. A backslash at the end of a line joins the next line to it. Extra blanks are
//!   ignored.
//! - If some corners have texture coordinates, the others get (0, 0). If some have normals, the others get the normal
//!   of their triangle. Attributes that no corner names are left out.
//! - Edges are the sides of the polygons (not the diagonals of the fan) and the lines. Each occurs once, from the
//!   smaller index to the greater, in ascending order.
//! - The text is bytes, because comments and names may be in any encoding. A UTF-8 byte-order mark at the start is
//!   skipped.

mod decimal;
mod ears;
mod edges;
#[doc(hidden)]
pub mod import;
mod mtl;
mod parts;
mod reader;

use super::{Buffers, Counts, Index, Mesh};
use crate::Error;
use crate::error::ok;
use reader::{Corner, MOST, Reader};

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

/// Counts the elements of a text: the room that [`parse`] needs.
///
/// # Errors
///
/// [`Error::Obj`] with the line of the first mistake. Indices that name no element are reported only if there is no
/// other mistake.
///
/// ```
/// use fixel::mesh::obj;
/// let counts = obj::count(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4")?;
/// assert_eq!((counts.positions, counts.faces, counts.edges), (4, 2, 4));
/// # Ok::<(), fixel::Error>(())
/// ```
pub const fn count(text: &[u8]) -> Result<Counts, Error> {
    let mut nothing = Buffers::new(&mut [], &mut []);
    read(text, &mut nothing)
}

/// Reads a text and counts its elements; writes as many of them as the buffers hold.
const fn read(text: &[u8], buffers: &mut Buffers<'_>) -> Result<Counts, Error> {
    let mut writer = Writer::new(Reader::new(text, MOST), buffers);
    ok!(writer.write());
    let counts = writer.counts();
    if !writer.reader.missed() {
        return Ok(counts);
    }
    // An index was too great. The totals are known now, so a second reading finds its line.
    let seen = writer.reader.seen();
    ok!(Writer::new(Reader::new(text, seen), buffers).write());
    Ok(counts)
}

/// Reads a text into the caller's memory; [`count`] tells how much it needs.
///
/// Texture coordinates, normals, colors and edges are left out if their slice is empty. Every polygon becomes a fan,
/// which covers the wrong area if the polygon is concave: let the program that writes such a file cut its polygons into
/// triangles, or use [`include_obj!`](crate::include_obj).
///
/// # Errors
///
/// [`Error::Obj`] as for [`count`]; [`Error::TooMany`] if a slice is too short (an empty slice for attributes or edges
/// is accepted).
///
/// ```
/// use fixel::mesh::{obj, Buffers};
/// use fixel::prelude::*;
/// let (mut positions, mut faces) = ([Vec3::ZERO; 100], [[0; 3]; 100]);
/// let mesh = obj::parse(
///     b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
///     Buffers::new(&mut positions, &mut faces),
/// )?;
/// assert_eq!(mesh.faces(), [[0, 1, 2]]);
///
/// let error = obj::count(b"v 0 0 0\nv 1 zero 0").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: a number is malformed: it must be like 1, -0.25 or 2.5e-3");
/// # Ok::<(), Error>(())
/// ```
pub const fn parse<'a>(text: &[u8], mut buffers: Buffers<'a>) -> Result<Mesh<'a>, Error> {
    let counts = ok!(read(text, &mut buffers));
    let mut counts = ok!(buffers.wanted(counts));
    counts.edges = edges::unique(buffers.edges.split_at_mut(counts.edges).0);
    buffers.mesh(counts)
}

/// Writes the elements in the order of the text, as long as there is room.
struct Writer<'t, 'b, 'a> {
    reader: Reader<'t>,
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

/// Writes to a list if there is room.
macro_rules! put {
    ($self:ident.buffers.$list:ident[$at:expr] = $value:expr) => {
        if $at < $self.buffers.$list.len() {
            $self.buffers.$list[$at] = $value;
        }
    };
}

impl<'t, 'b, 'a> Writer<'t, 'b, 'a> {
    const fn new(reader: Reader<'t>, buffers: &'b mut Buffers<'a>) -> Self {
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

    const fn counts(&self) -> Counts {
        let [positions, uvs, normals] = self.reader.seen();
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

    const fn write(&mut self) -> Result<(), Error> {
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
