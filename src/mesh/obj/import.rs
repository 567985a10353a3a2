//! What [`include_obj!`](crate::include_obj) expands to.

use super::parse;
use crate::error::ok;
use crate::mesh::{Counts, flash::Room};
use crate::{Error, message};

/// As many elements of each kind as a text of so many bytes can have: a corner takes a blank and a digit, others more.
#[must_use]
pub const fn room(bytes: usize) -> usize {
    bytes / 2 + 1
}

/// The elements of a text, in room that is enough for any text of its length, and how many there are. The text is read
/// once.
///
/// # Panics
///
/// At a mistake, naming path and line.
#[must_use]
pub const fn read<const N: usize>(text: &[u8], path: &str) -> (Room<N>, Counts) {
    const fn parsed<const N: usize>(text: &[u8], room: &mut Room<N>) -> Result<Counts, Error> {
        Ok(ok!(parse(text, room.buffers())).counts())
    }
    let mut room = Room::EMPTY;
    let counts = message::checked(parsed(text, &mut room), path);
    (room, counts)
}

/// A mesh of an OBJ file, read while compiling; it lives in flash.
///
/// The path is relative to the source file, as for [`include_str!`]. A mistake in the file stops
/// compilation and names its line. [`mesh::obj`](crate::mesh::obj) lists the statements it reads.
///
/// ```
/// use fixel::prelude::*;
/// static MODEL: Mesh = include_obj!("../../../tests/models/house.obj");
/// assert_eq!(MODEL.faces().len(), 14);
///
/// // Positions of 16 bits, in half the flash: see Mesh::short.
/// static SMALL: Mesh = include_obj!("../../../tests/models/house.obj", short);
/// assert_eq!(SMALL.positions().len(), MODEL.positions().len());
/// ```
#[macro_export]
macro_rules! include_obj {
    ($path:expr $(, $short:ident)? $(,)?) => {{
        const TEXT: &[u8] = ::core::include_bytes!($path);
        #[allow(long_running_const_eval)]
        const READ: (
            $crate::mesh::flash::Room<{ $crate::mesh::obj::import::room(TEXT.len()) }>,
            $crate::mesh::Counts,
        ) = $crate::mesh::obj::import::read(TEXT, $path);
        $crate::__mesh!(READ.0, READ.1 $(, $short)?)
    }};
}
