//! Wavefront OBJ text as a mesh, at compile time or at run time, without floats or allocation.
//!
//! [`include_obj!`](crate::include_obj) makes a `static` mesh of a file; [`parse`] fills the
//! caller's memory. Both read this dialect:
//!
//! | statement | meaning |
//! |---|---|
//! | `v x y z`, `v x y z w` | a position; the weight is ignored |
//! | `v x y z r g b` | a position with a colour, 0 to 1 each; if all positions have one, the mesh has colours |
//! | `vt u`, `vt u v`, `vt u v w` | a texture coordinate; OBJ's v runs up and [`Vec2`](crate::Vec2)'s down, so v becomes 1 − v; w is ignored |
//! | `vn x y z` | a normal, of any length |
//! | `f 1 2 3`, `f 1/1 …`, `f 1//1 …`, `f 1/1/1 …` | a polygon of three or more corners, cut into a fan of triangles from its first |
//! | `l 1 2 3` | edges between positions |
//! | `# …` | a comment, to the end of the line |
//! | any other | ignored, known to OBJ (`o`, `g`, `s`, `p`, `usemtl`, `mtllib`, …) or not |
//!
//! - Indices count from 1, or back from −1, the last element so far. A positive index may name an element
//!   that comes later in the text.
//! - Numbers are decimal, with exponent or without, rounded exactly to the nearest
//!   [`Scalar`](crate::Scalar), halves away from zero.
//! - Lines end in LF, CR or both; a backslash at the end joins the next. Blanks do not matter.
//! - A corner without a texture coordinate gets (0, 0), one without a normal its triangle's own, if
//!   other corners have them; attributes that no corner names are left out.
//! - Edges are the sides of the polygons, not of the triangles, and the lines; each once, from the
//!   smaller index to the greater, in ascending order.
//! - The text is bytes, as comments and names may be in any encoding; a UTF-8 mark at the start is skipped.

mod decimal;
mod edges;
mod reader;

use embedded_graphics::pixelcolor::Rgb888;

use super::buffers::{Buffers, Counts};
use super::mesh::{Index, Mesh};
use super::panic;
use crate::{Error, Vec2, Vec3};
use reader::{Corner, MOST, Reader, Statement};

/// The indices of one attribute over all corners: whether they need a list of their own.
#[derive(Clone, Copy)]
struct Usage {
    /// Whether any corner has one.
    used: bool,
    /// Whether each corner's is the position's.
    same: bool,
}

impl Usage {
    const fn see(&mut self, index: Option<u16>, position: u16) {
        match index {
            Some(index) => {
                self.used = true;
                self.same &= index == position;
            }
            None => self.same = false,
        }
    }

    /// Numbers of values and of triangles, if there are so many in the text.
    const fn counts(self, values: usize, positions: usize, faces: usize) -> (usize, usize) {
        match self {
            Self { used: false, .. } => (0, 0),
            Self { same: true, .. } if values == positions => (values, 0),
            _ => (values, faces),
        }
    }
}

/// Counts what a text holds: how much memory [`parse`] needs.
///
/// # Errors
///
/// [`Error::Obj`] with the line of the first mistake; only whether positive indices name something
/// is left to [`parse`].
///
/// ```
/// use fixel::geometry::obj;
/// let counts = obj::count(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4")?;
/// assert_eq!((counts.positions, counts.faces, counts.edges), (4, 2, 4));
/// # Ok::<(), fixel::Error>(())
/// ```
pub const fn count(text: &[u8]) -> Result<Counts, Error> {
    match survey(text) {
        Ok(survey) => Ok(survey.counts),
        Err(error) => Err(error),
    }
}

/// What a first reading finds.
#[derive(Clone, Copy)]
struct Survey {
    counts: Counts,
    /// Positions, texture coordinates and normals in the text, used or not.
    known: [usize; 3],
}

const fn survey(text: &[u8]) -> Result<Survey, Error> {
    let mut reader = Reader::new(text, MOST);
    let (mut faces, mut edges, mut colors) = (0, 0, 0);
    let mut uvs = Usage {
        used: false,
        same: true,
    };
    let mut normals = uvs;
    loop {
        let statement = match reader.statement() {
            Ok(statement) => statement,
            Err(error) => return Err(error),
        };
        let face = match statement {
            Statement::Position(_, color) => {
                colors += color.is_some() as usize;
                continue;
            }
            Statement::Uv(_) | Statement::Normal(_) => continue,
            Statement::Face => true,
            Statement::Line => false,
            Statement::End => break,
        };
        let mut corners = 0;
        loop {
            match reader.corner() {
                Ok(None) => break,
                Ok(Some(corner)) => {
                    if face {
                        uvs.see(corner.uv, corner.position);
                        normals.see(corner.normal, corner.position);
                    }
                }
                Err(error) => return Err(error),
            }
            corners += 1;
        }
        if face && corners < 3 {
            return reader.error("a face needs at least 3 corners");
        }
        if corners < 2 {
            return reader.error("a line needs at least 2 ends");
        }
        if face {
            faces += corners - 2;
            edges += corners;
        } else {
            edges += corners - 1;
        }
    }
    let seen = reader.seen();
    let (uvs, uv_faces) = uvs.counts(seen[1], seen[0], faces);
    let (normals, normal_faces) = normals.counts(seen[2], seen[0], faces);
    Ok(Survey {
        counts: Counts {
            positions: seen[0],
            faces,
            edges,
            uvs,
            uv_faces,
            normals,
            normal_faces,
            colors: if colors == seen[0] { colors } else { 0 },
        },
        known: seen,
    })
}

/// Reads a text into the caller's memory, of which [`count`] tells the size.
///
/// Texture coordinates, normals, colours and edges for which there is an empty slice are left out.
///
/// # Errors
///
/// [`Error::Obj`] with the line of the first mistake; [`Error::TooMany`] if a slice is too short.
///
/// ```
/// use fixel::geometry::{obj, Buffers};
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
pub const fn parse<'a>(text: &[u8], buffers: Buffers<'a>) -> Result<Mesh<'a>, Error> {
    match survey(text) {
        Ok(survey) => fill(text, survey, buffers),
        Err(error) => Err(error),
    }
}

/// Reads the text for the second time, now writing.
const fn fill<'a>(text: &[u8], survey: Survey, buffers: Buffers<'a>) -> Result<Mesh<'a>, Error> {
    let mut counts = match buffers.wanted(survey.counts) {
        Ok(counts) => counts,
        Err(error) => return Err(error),
    };
    let mut writer = Writer {
        reader: Reader::new(text, survey.known),
        counts,
        buffers,
        faces: 0,
        edges: 0,
    };
    match writer.write() {
        Ok(()) => {}
        Err(error) => return Err(error),
    }
    let Writer { buffers, edges, .. } = writer;
    counts.edges = edges::unique(buffers.edges.split_at_mut(edges).0);
    buffers.mesh(counts)
}

/// Writes the elements in the order of the text.
struct Writer<'t, 'a> {
    reader: Reader<'t>,
    /// What is to be written; the buffers have room for it.
    counts: Counts,
    buffers: Buffers<'a>,
    /// Triangles written.
    faces: usize,
    /// Edges written.
    edges: usize,
}

impl Writer<'_, '_> {
    const fn write(&mut self) -> Result<(), Error> {
        loop {
            // Numbers are counted as they are read, so the last is one less.
            let statement = match self.reader.statement() {
                Ok(statement) => statement,
                Err(error) => return Err(error),
            };
            let [positions, uvs, normals] = self.reader.seen();
            match statement {
                Statement::Position(position, color) => {
                    self.buffers.positions[positions - 1] = Vec3::from_bits(position);
                    if let (Some([r, g, b]), true) = (color, self.counts.colors > 0) {
                        self.buffers.colors[positions - 1] = Rgb888::new(r, g, b);
                    }
                }
                Statement::Uv([u, v]) => {
                    if self.counts.uvs > 0 {
                        // Only v = −32768 has no mirror image, and saturates.
                        self.buffers.uvs[uvs - 1] =
                            Vec2::from_bits([u, (1_i32 << 16).saturating_sub(v)]);
                    }
                }
                Statement::Normal(normal) => {
                    if self.counts.normals > 0 {
                        self.buffers.normals[normals - 1] = Vec3::from_bits(normal);
                    }
                }
                Statement::Face => match self.corners(true) {
                    Ok(()) => {}
                    Err(error) => return Err(error),
                },
                Statement::Line => match self.corners(false) {
                    Ok(()) => {}
                    Err(error) => return Err(error),
                },
                Statement::End => return Ok(()),
            }
        }
    }

    /// The corners of a polygon, as a fan of triangles and as edges, or the ends of a line.
    const fn corners(&mut self, face: bool) -> Result<(), Error> {
        let mut first = None;
        let mut last: Option<Corner> = None;
        let mut count = 0;
        loop {
            let corner = match self.reader.corner() {
                Ok(Some(corner)) => corner,
                Ok(None) => break,
                Err(error) => return Err(error),
            };
            count += 1;
            if let Some(last) = last {
                self.edge(last, corner);
                if let (Some(first), true) = (first, face && count > 2) {
                    self.triangle([first, last, corner]);
                }
            } else {
                first = Some(corner);
            }
            last = Some(corner);
        }
        if let (Some(first), Some(last), true) = (first, last, face) {
            self.edge(last, first);
        }
        Ok(())
    }

    const fn edge(&mut self, from: Corner, to: Corner) {
        let (from, to) = (from.position, to.position);
        // A side from a corner to itself is none.
        if self.counts.edges > 0 && from != to {
            self.buffers.edges[self.edges] = if from < to { [from, to] } else { [to, from] };
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
        self.buffers.faces[at] = [a.position, b.position, c.position];
        if self.counts.uv_faces > 0 {
            self.buffers.uv_faces[at] = [index(a.uv), index(b.uv), index(c.uv)];
        }
        if self.counts.normal_faces > 0 {
            self.buffers.normal_faces[at] = [index(a.normal), index(b.normal), index(c.normal)];
        }
        self.faces += 1;
    }
}

/// What [`include_obj!`](crate::include_obj) expands to, step by step.
#[doc(hidden)]
pub mod import {
    use super::super::buffers::{Arrays, Counts};
    use super::{Error, fill, panic, survey};

    #[doc(hidden)]
    #[derive(Clone, Copy)]
    pub struct Survey(super::Survey);

    impl Survey {
        /// Reads the text of the file at `path`.
        ///
        /// # Panics
        ///
        /// At a mistake, naming path and line.
        #[must_use]
        pub const fn new(text: &[u8], path: &str) -> Self {
            Self(panic::checked(survey(text), path))
        }

        #[must_use]
        pub const fn counts(self) -> Counts {
            self.0.counts
        }
    }

    /// The arrays, and how many of the edges there are.
    ///
    /// # Panics
    ///
    /// At a mistake, naming path and line.
    #[must_use]
    pub const fn arrays<
        const P: usize,
        const F: usize,
        const E: usize,
        const U: usize,
        const UF: usize,
        const N: usize,
        const NF: usize,
        const C: usize,
    >(
        text: &[u8],
        path: &str,
        survey: Survey,
    ) -> (Arrays<P, F, E, U, UF, N, NF, C>, usize) {
        let mut arrays = Arrays::ZERO;
        let edges: Result<usize, Error> = match fill(text, survey.0, arrays.buffers()) {
            Ok(mesh) => Ok(mesh.edges().len()),
            Err(error) => Err(error),
        };
        (arrays, panic::checked(edges, path))
    }
}

/// A mesh of an OBJ file, read while compiling; it lives in flash.
///
/// The path is relative to the source file, as for [`include_str!`]. A mistake in the file stops
/// compilation with its line. [`geometry::obj`](crate::geometry::obj) tells what is read.
///
/// ```
/// use fixel::prelude::*;
/// static MODEL: Mesh = include_obj!("../../../tests/models/house.obj");
/// assert_eq!(MODEL.faces().len(), 14);
/// ```
#[macro_export]
macro_rules! include_obj {
    ($path:expr $(,)?) => {{
        const TEXT: &[u8] = ::core::include_bytes!($path);
        #[allow(long_running_const_eval)]
        const SURVEY: $crate::geometry::obj::import::Survey =
            $crate::geometry::obj::import::Survey::new(TEXT, $path);
        const COUNTS: $crate::geometry::Counts = SURVEY.counts();
        #[allow(long_running_const_eval)]
        const READ: (
            $crate::geometry::Arrays<
                { COUNTS.positions },
                { COUNTS.faces },
                { COUNTS.edges },
                { COUNTS.uvs },
                { COUNTS.uv_faces },
                { COUNTS.normals },
                { COUNTS.normal_faces },
                { COUNTS.colors },
            >,
            usize,
        ) = $crate::geometry::obj::import::arrays(TEXT, $path, SURVEY);
        #[allow(long_running_const_eval)]
        static ARRAYS: $crate::geometry::Arrays<
            { COUNTS.positions },
            { COUNTS.faces },
            { READ.1 },
            { COUNTS.uvs },
            { COUNTS.uv_faces },
            { COUNTS.normals },
            { COUNTS.normal_faces },
            { COUNTS.colors },
        > = READ.0.trim();
        #[allow(long_running_const_eval)]
        static MESH: $crate::Mesh<'static> = ARRAYS.mesh();
        MESH
    }};
}
