//! The code that [`include_obj!`](crate::include_obj) expands to.

use super::parse;
use crate::error::ok;
use crate::mesh::{Counts, flash::Room};
use crate::{Error, message};

/// An upper bound of the elements of each kind that a text of `bytes` bytes can hold: a corner takes a blank and a
/// digit, and other elements take more.
#[must_use]
pub const fn room(bytes: usize) -> usize {
    bytes / 2 + 1
}

/// The elements of a text, in lists with room for any text of its length, and how many there are. The text is read only
/// once.
///
/// # Panics
///
/// If the text is not valid; the message names the path and the line.
#[must_use]
pub const fn read<const N: usize>(text: &[u8], path: &str) -> (Room<N>, Counts) {
    const fn parsed<const N: usize>(text: &[u8], room: &mut Room<N>) -> Result<Counts, Error> {
        Ok(ok!(parse(text, room.buffers())).counts())
    }
    let mut room = Room::EMPTY;
    let counts = message::checked(parsed(text, &mut room), path);
    (room, counts)
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
