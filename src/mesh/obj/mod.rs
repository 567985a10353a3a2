//! Meshes from Wavefront OBJ text at run time, without floats or allocation: [`parse`] fills the caller's memory.
//!
//! For a file that is known at compile time, use [`include_mesh!`](crate::include_mesh). This is the dialect that
//! [`parse`] reads:
//!
//! | statement | meaning |
//! |---|---|
//! | `v x y z`, `v x y z w` | a position; the weight is ignored |
//! | `v x y z r g b` | a position with a color, each component from 0 to 1; the mesh has colors if every position has one |
//! | `vt u`, `vt u v`, `vt u v w` | a texture coordinate; OBJ's v points up and [`Vec2`](crate::Vec2)'s points down, so v becomes 1 − v; w is ignored |
//! | `vn x y z` | a normal, of any length |
//! | `f 1 2 3`, `f 1/1 …`, `f 1//1 …`, `f 1/1/1 …` | a polygon of three or more corners, cut into a fan of triangles around its first corner |
//! | `l 1 2 3` | edges between positions |
//! | `# …` | a comment, to the end of the line |
//! | any other | ignored, whether OBJ defines it (`o`, `g`, `s`, `p`, `usemtl`, `mtllib`, …) or not |
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
mod elements;
mod reader;
mod writer;

use super::sort::unique;
use super::{Buffers, Counts, Mesh};
use crate::Error;
use crate::error::ok;
use elements::MOST;
use reader::Reader;
use writer::Writer;

/// Counts the elements of a text: the room that [`parse`] needs.
///
/// # Errors
///
/// [`Error::Obj`] with the line of the first mistake. A positive index that names no element is reported only if there
/// is no other mistake, unless it is greater than the index of any element can be.
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
    let seen = writer.reader.seen;
    ok!(Writer::new(Reader::new(text, seen), buffers).write());
    Ok(counts)
}

/// Reads a text into the caller's memory; [`count`] tells how much it needs.
///
/// Texture coordinates, normals, colors and edges are left out if their slice is empty. Every polygon becomes a fan,
/// which covers the wrong area if the polygon is concave: let the program that writes such a file cut its polygons into
/// triangles, or use [`include_mesh!`](crate::include_mesh).
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
    counts.edges = unique(buffers.edges.split_at_mut(counts.edges).0);
    buffers.mesh(counts)
}
