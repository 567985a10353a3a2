//! The code that [`include_obj!`](crate::include_obj) and [`include_mtl!`](crate::include_mtl) expand to.

use super::ears;
use super::reader::are_same;
use super::{mtl, parse, parts};
use crate::error::ok;
use crate::mesh::{Counts, Part, flash::Room};
use crate::{Error, message};

/// An upper bound for the elements of each kind in a text: a blank, or the backslash that joins two lines, comes before
/// each number and each corner.
#[must_use]
pub const fn room(mut text: &[u8]) -> usize {
    let mut room = 1;
    while let [c, rest @ ..] = text {
        if matches!(c, b' ' | b'\t' | b'\\') {
            room += 1;
        }
        text = rest;
    }
    room
}

/// The elements of a text, in lists with `room` for them, and their number. The text is read only once.
///
/// # Panics
///
/// If the text is not valid; the message names the path and the line.
#[must_use]
pub const fn read<const N: usize>(text: &[u8], path: &str) -> (Room<N>, Counts) {
    const fn parsed<const N: usize>(text: &[u8], room: &mut Room<N>) -> Result<Counts, Error> {
        const PROBLEM: &str =
            "the file has no positions: it must be an OBJ file, and not in UTF-16";
        let counts = ok!(parse(text, room.buffers())).counts();
        if counts.positions == 0 {
            return Err(Error::Obj {
                line: 1,
                problem: PROBLEM,
            });
        }
        Ok(counts)
    }
    let mut room = Room::EMPTY;
    let counts = message::checked(parsed(text, &mut room), path);
    ears::cut(text, &mut room);
    (room, counts)
}

/// A mesh from an OBJ file, read at compile time and stored in flash.
///
/// The path is relative to the source file, as for [`include_str!`]. A mistake in the file stops compilation with a
/// message that names its line. [`mesh::obj`](crate::mesh::obj) lists the statements it reads.
///
/// A triangle takes the compiler about two milliseconds. For tens of thousands of triangles, let the simulator write
/// the mesh as Rust source, which the compiler need not compute: `cargo run --release -p simulator -- model.obj
/// --export model.rs`.
///
/// ```standalone_crate
/// use fixel::mesh::Quantized;
/// use fixel::prelude::*;
/// static MODEL: Mesh = include_obj!("../../../tests/models/house.obj");
/// assert_eq!(MODEL.faces().len(), 14);
///
/// // With 16-bit positions, which take half the flash: see Mesh::short.
/// static SMALL: Mesh = include_obj!("../../../tests/models/house.obj", short);
/// assert_eq!(SMALL.positions().len(), MODEL.positions().len());
///
/// // With small attributes too: see Quantized.
/// static SMALLEST: Quantized = include_obj!("../../../tests/models/house.obj", quantized_8);
/// assert_eq!(SMALLEST.mesh().positions(), SMALL.positions());
/// ```
///
/// A file without positions does not compile, because the reader ignores statements that it does not know, and so would
/// make an empty mesh of a file in another format:
///
/// ```compile_fail
/// use fixel::prelude::*;
/// static MODEL: Mesh = include_obj!("../../../tests/models/house.mtl");
/// ```
#[macro_export]
macro_rules! include_obj {
    ($path:expr $(, $short:ident)? $(,)?) => {{
        const TEXT: &[u8] = ::core::include_bytes!($path);
        #[allow(long_running_const_eval)]
        // A reference: each use of a constant by itself would copy it.
        const READ: &(
            $crate::mesh::flash::Room<{ $crate::mesh::obj::import::room(TEXT) }>,
            $crate::mesh::Counts,
        ) = &$crate::mesh::obj::import::read(TEXT, $path);
        $crate::__mesh!(READ.0, READ.1 $(, $short)?)
    }};
}

pub use super::parts::room as room_for_parts;

/// A text and the path of its file.
type File = (&'static [u8], &'static str);

/// The parts of an OBJ file, in a list with room for those of any file of its length.
#[derive(Clone, Copy, Debug)]
pub struct Parts<const N: usize> {
    /// Their names are in the files.
    found: [Part<'static>; N],
    /// Where the names of each go: the material's, then its texture's.
    names_at: [usize; N],
    /// How many there are.
    pub count: usize,
    /// How many bytes the names take; parts of the same material share them.
    pub bytes: usize,
}

impl<const N: usize> Parts<N> {
    /// Reads both files.
    ///
    /// # Panics
    ///
    /// If one of them is not valid, or if the MTL file lacks a material; the message names the path.
    #[must_use]
    pub const fn find((obj, obj_path): File, (mtl, mtl_path): File) -> Self {
        let (mut found, count) = message::checked(parts::runs::<N>(obj), obj_path);
        let (mut names_at, mut bytes, mut at) = ([0; N], 0, 0);
        while at < count {
            let name = found[at].material;
            let mut same = 0;
            while same < at && !are_same(found[same].material, name) {
                same += 1;
            }
            (found[at].color, found[at].texture) = if same < at {
                names_at[at] = names_at[same];
                (found[same].color, found[same].texture)
            } else {
                let (color, texture) = match message::checked(mtl::find(mtl, name), mtl_path) {
                    Some(material) => material,
                    None if name.is_empty() => (Part::NO_MATERIAL, ""),
                    None => message::no_material(obj_path, mtl_path, name),
                };
                names_at[at] = bytes;
                bytes += name.len() + texture.len();
                (color, texture)
            };
            at += 1;
        }
        Self {
            found,
            names_at,
            count,
            bytes,
        }
    }

    /// The names, one after the other.
    #[must_use]
    pub const fn text<const BYTES: usize>(&self) -> [u8; BYTES] {
        const fn copy(text: &mut [u8], start: usize, name: &str) {
            let mut at = 0;
            while at < name.len() {
                text[start + at] = name.as_bytes()[at];
                at += 1;
            }
        }
        let mut text = [0; BYTES];
        let mut at = 0;
        while at < self.count {
            let (part, start) = (self.found[at], self.names_at[at]);
            copy(&mut text, start, part.material);
            copy(&mut text, start + part.material.len(), part.texture);
            at += 1;
        }
        text
    }

    /// The parts, with their names in `text`.
    #[must_use]
    pub const fn parts<const COUNT: usize>(&self, text: &'static [u8]) -> [Part<'static>; COUNT] {
        /// Both readers have checked that names are UTF-8.
        const fn name(text: &'static [u8], start: usize, len: usize) -> &'static str {
            match core::str::from_utf8(text.split_at(start).1.split_at(len).0) {
                Ok(name) => name,
                Err(_) => "",
            }
        }
        let mut parts = [Part::new(0..0, Part::NO_MATERIAL); COUNT];
        let mut at = 0;
        while at < COUNT {
            let (part, start) = (self.found[at], self.names_at[at]);
            let middle = start + part.material.len();
            parts[at] = part
                .with_material(name(text, start, part.material.len()))
                .with_texture(name(text, middle, part.texture.len()));
            at += 1;
        }
        parts
    }
}

/// The parts of an OBJ file's mesh with the materials of an MTL file, read at compile time and stored in flash.
///
/// A part is a run of faces after one `usemtl`; it has the color and perhaps the name of the texture that the MTL file
/// gives to this material. The result is a `&'static [Part]` for the mesh that [`include_obj!`](crate::include_obj)
/// makes of the same OBJ file.
///
/// These statements of an MTL file are read; all others are ignored:
///
/// | statement | meaning |
/// |---|---|
/// | `newmtl name` | the following statements describe the material of this name |
/// | `Kd r g b`, `Kd gray` | its color, each component from 0 to 1, rounded to the nearest 255th; white without this statement |
/// | `map_Kd file`, `map_Kd -options … file` | the name of its texture; after options, the last word |
///
/// Names extend to the end of their line or a comment, and may contain blanks. Faces before the first `usemtl` are a
/// white part without a name. `mtllib` is ignored, because a macro cannot open files whose names it reads in another
/// file. A mistake in a file stops compilation with a message that names its line; so does a material that the MTL file
/// lacks.
///
/// ```standalone_crate
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::mesh::Part;
/// use fixel::prelude::*;
/// use fixel::shade::PartColors;
/// static HOUSE: Mesh = include_obj!("../../../tests/models/house.obj");
/// static PARTS: &[Part] = include_mtl!(
///     "../../../tests/models/house.obj",
///     "../../../tests/models/house.mtl",
/// );
/// assert_eq!(PARTS.len(), 2);
/// assert_eq!((PARTS[0].material(), PARTS[0].texture()), ("brick", Some("brick.tga")));
/// assert_eq!((PARTS[1].material(), PARTS[1].faces()), ("tiles", 10..14));
///
/// let projection = Projection::perspective(deg!(60), (4, 3), fx!(0.5), fx!(100))?;
/// let mvp = projection * Camera::look_at(vec3!(3, 2, 5), vec3!(0, 1, 0), Vec3::Y)?;
/// let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
/// let mut pixels = [Rgb565::BLACK; 32 * 24];
/// let mut canvas = Canvas::new(&mut pixels, 32, 24)?;
/// // All parts in one call ...
/// canvas.draw(&HOUSE, &mvp, &PartColors::rgb(PARTS).lit_faces(sun));
/// // ... or one by one.
/// for part in PARTS {
///     canvas.draw(&HOUSE.part(part.faces()), &mvp, &Flat::rgb(part.color()).lit_faces(sun));
/// }
/// # Ok::<(), Error>(())
/// ```
///
/// An OBJ file without faces does not compile, because it is probably another file:
///
/// ```compile_fail
/// use fixel::mesh::Part;
/// use fixel::prelude::*;
/// static PARTS: &[Part] = include_mtl!(
///     "../../../tests/models/house.mtl",
///     "../../../tests/models/house.obj",
/// );
/// ```
#[macro_export]
macro_rules! include_mtl {
    ($obj:expr, $mtl:expr $(,)?) => {{
        use $crate::mesh::obj::import::{Parts, room_for_parts};
        const OBJ: &[u8] = ::core::include_bytes!($obj);
        const MTL: &[u8] = ::core::include_bytes!($mtl);
        #[allow(long_running_const_eval)]
        const FOUND: Parts<{ room_for_parts(OBJ.len()) }> = Parts::find((OBJ, $obj), (MTL, $mtl));
        static NAMES: [u8; FOUND.bytes] = FOUND.text();
        static PARTS: [$crate::mesh::Part<'static>; FOUND.count] = FOUND.parts(&NAMES);
        PARTS.as_slice()
    }};
}
