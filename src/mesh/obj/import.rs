//! The code that [`include_obj!`](crate::include_obj) expands to.

use super::parse;
use super::reader::MOST;
use crate::Error;
use crate::mesh::buffers::{Arrays, Counts};
use crate::message;

/// Upper bounds of what a text of `bytes` bytes can hold, so that the text has to be read only once.
#[must_use]
pub const fn room(bytes: usize) -> Counts {
    const fn at_most(count: usize, most: usize) -> usize {
        if count < most { count } else { most }
    }
    // The shortest statements are "v 0 0 0", "vt 0" and "vn 0 0 0", each with a line feed; a corner takes a blank and
    // a digit.
    let positions = at_most(bytes / 8 + 1, MOST[0]);
    let corners = bytes / 2 + 1;
    Counts {
        positions,
        faces: corners,
        edges: corners,
        uvs: at_most(bytes / 5 + 1, MOST[1]),
        uv_faces: corners,
        normals: at_most(bytes / 9 + 1, MOST[2]),
        normal_faces: corners,
        colors: positions,
    }
}

/// The mesh's lists, longer than needed, and how many elements each really has.
///
/// # Panics
///
/// If the text is not valid; the message names the path and the line.
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
) -> (Arrays<P, F, E, U, UF, N, NF, C>, Counts) {
    let mut arrays = Arrays::ZERO;
    let counts: Result<Counts, Error> = match parse(text, arrays.buffers()) {
        Ok(mesh) => Ok(mesh.counts()),
        Err(error) => Err(error),
    };
    (arrays, message::checked(counts, path))
}

/// A mesh from an OBJ file, read at compile time and stored in flash.
///
/// The path is relative to the source file, as for [`include_str!`]. A mistake in the file stops
/// compilation and names its line. [`mesh::obj`](crate::mesh::obj) lists the statements it reads.
///
/// ```
/// use fixel::prelude::*;
/// static MODEL: Mesh = include_obj!("../../../tests/models/house.obj");
/// assert_eq!(MODEL.faces().len(), 14);
///
/// // With 16-bit positions, which take half the flash: see Mesh::short.
/// static SMALL: Mesh = include_obj!("../../../tests/models/house.obj", short);
/// assert_eq!(SMALL.positions().len(), MODEL.positions().len());
/// ```
#[macro_export]
macro_rules! include_obj {
    ($path:expr $(,)?) => {{
        $crate::__read_obj!($path);
        #[allow(long_running_const_eval)]
        static ARRAYS: Arrays<{ COUNTS.positions }> = READ.0.trim();
        #[allow(long_running_const_eval)]
        static MESH: $crate::Mesh<'static> = ARRAYS.mesh();
        MESH
    }};
    ($path:expr, short $(,)?) => {{
        $crate::__read_obj!($path);
        #[allow(long_running_const_eval)]
        const ALL: Arrays<{ COUNTS.positions }> = READ.0.trim();
        #[allow(long_running_const_eval)]
        const SHORT: ([[i16; 3]; COUNTS.positions], u32) = ALL.shortened();
        static POSITIONS: [[i16; 3]; COUNTS.positions] = SHORT.0;
        #[allow(long_running_const_eval)]
        static ARRAYS: Arrays<0> = ALL.trim();
        #[allow(long_running_const_eval)]
        static MESH: $crate::Mesh<'static> = ARRAYS.short_mesh(&POSITIONS, SHORT.1);
        MESH
    }};
}

/// The part that both forms of [`include_obj!`](crate::include_obj) share: `READ`, its `COUNTS`, and the type
/// `Arrays`.
#[doc(hidden)]
#[macro_export]
macro_rules! __read_obj {
    ($path:expr) => {
        const TEXT: &[u8] = ::core::include_bytes!($path);
        const ROOM: $crate::mesh::Counts = $crate::mesh::obj::import::room(TEXT.len());
        #[allow(long_running_const_eval)]
        const READ: (
            $crate::mesh::Arrays<
                { ROOM.positions },
                { ROOM.faces },
                { ROOM.edges },
                { ROOM.uvs },
                { ROOM.uv_faces },
                { ROOM.normals },
                { ROOM.normal_faces },
                { ROOM.colors },
            >,
            $crate::mesh::Counts,
        ) = $crate::mesh::obj::import::arrays(TEXT, $path);
        const COUNTS: $crate::mesh::Counts = READ.1;
        type Arrays<const POSITIONS: usize> = $crate::mesh::Arrays<
            POSITIONS,
            { COUNTS.faces },
            { COUNTS.edges },
            { COUNTS.uvs },
            { COUNTS.uv_faces },
            { COUNTS.normals },
            { COUNTS.normal_faces },
            { COUNTS.colors },
        >;
    };
}
