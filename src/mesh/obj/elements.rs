//! The elements of an OBJ text: positions, texture coordinates, normals, and the corners that name them.

use embedded_graphics::pixelcolor::Rgb888;

use super::decimal::{SCALAR, TEX_COORD, digits};
use super::reader::{Reader, word_end};
use crate::error::ok;
use crate::{Error, Mesh, TexCoord, Vec2, Vec3};

/// The indices of a corner, counted from 0.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) position: u16,
    pub(super) uv: Option<u16>,
    pub(super) normal: Option<u16>,
}

/// The most elements of each kind that 16-bit indices can name; `Mesh::NO_VALUE` takes one index from the attributes.
pub(super) const MOST: [usize; 3] = [
    Mesh::MAX_POSITIONS,
    Mesh::NO_VALUE as usize,
    Mesh::NO_VALUE as usize,
];

const TOO_MANY: [&str; 3] = [
    "more than 65536 positions",
    "more than 65535 texture coordinates",
    "more than 65535 normals",
];

const MALFORMED: &str = "a corner is malformed: it must be like 1, 1/2, 1//3 or 1/2/3";

const NOT_THERE: [&str; 3] = [
    "an index names a position that does not exist",
    "an index names a texture coordinate that does not exist",
    "an index names a normal that does not exist",
];

impl Reader<'_> {
    /// Whether an index named an element that the text does not have.
    pub(super) const fn missed(&self) -> bool {
        self.named[0] > self.seen[0] || self.named[1] > self.seen[1] || self.named[2] > self.seen[2]
    }

    /// Counts one more element of a kind, and returns its index.
    const fn see(&mut self, kind: usize) -> Result<usize, Error> {
        let index = self.seen[kind];
        if index == MOST[kind] {
            return self.error(TOO_MANY[kind]);
        }
        self.seen[kind] = index + 1;
        Ok(index)
    }

    /// Reads the numbers of `v`: the position, and its color if it has one.
    pub(super) const fn position(&mut self) -> Result<(usize, Vec3, Option<Rgb888>), Error> {
        let (n, count) = ok!(self.numbers::<7>(SCALAR));
        let color = match count {
            // A fourth number is a weight for curves, a seventh is an opacity.
            3 | 4 => None,
            6 | 7 => Some(ok!(self.rgb([n[3], n[4], n[5]]))),
            _ => return self.error("a position needs 3 numbers, or 6 with its color"),
        };
        Ok((ok!(self.see(0)), Vec3::from_bits([n[0], n[1], n[2]]), color))
    }

    /// Reads the numbers of `vt`, with v pointing down.
    pub(super) const fn uv(&mut self) -> Result<(usize, Vec2), Error> {
        let ([u, up, _], 1..) = ok!(self.numbers(TEX_COORD)) else {
            return self.error("a texture coordinate needs 2 numbers");
        };
        let Some(down) = TexCoord::ONE.to_bits().checked_sub(up) else {
            return self.error(TEX_COORD.range);
        };
        Ok((ok!(self.see(1)), Vec2::from_bits([u, down])))
    }

    /// Reads the numbers of `vn`.
    pub(super) const fn normal(&mut self) -> Result<(usize, Vec3), Error> {
        let (n, 3) = ok!(self.numbers::<3>(SCALAR)) else {
            return self.error("a normal needs 3 numbers");
        };
        Ok((ok!(self.see(2)), Vec3::from_bits(n)))
    }

    /// Reads the next corner of a face or line; `None` at its end.
    pub(super) const fn corner(&mut self) -> Result<Option<Corner>, Error> {
        if !self.word() {
            return Ok(None);
        }
        let mut corner = Corner {
            position: 0,
            uv: None,
            normal: None,
        };
        let mut kind = 0;
        loop {
            // 1//3 has no texture coordinate, and some programs write 1/ and 1/2/.
            if kind == 0 || !matches!(self.rest, word_end!(b'/')) {
                let index = ok!(self.index(kind));
                match kind {
                    0 => corner.position = index,
                    1 => corner.uv = Some(index),
                    _ => corner.normal = Some(index),
                }
            }
            match self.rest {
                word_end!() => return Ok(Some(corner)),
                [b'/', rest @ ..] if kind < 2 => self.rest = rest,
                _ => return self.error(MALFORMED),
            }
            kind += 1;
        }
    }

    /// Reads an index of a kind of element: 1 is the first, −1 the last so far.
    const fn index(&mut self, kind: usize) -> Result<u16, Error> {
        let (negative, start) = match self.rest {
            [b'-', rest @ ..] => (true, rest),
            rest => (false, rest),
        };
        if !matches!(start, [b'0'..=b'9', ..]) {
            return self.error(MALFORMED);
        }
        // Greater numbers are as wrong as this one.
        let (number, rest) = digits!(start, MOST[0] as u64 + 1);
        self.rest = rest;
        let number = number as usize;
        if number == 0 {
            return self.error("an index is 0: the first is 1, and the last -1");
        }
        let (limit, index) = if negative {
            (self.seen[kind], self.seen[kind].wrapping_sub(number))
        } else {
            (self.known[kind], number - 1)
        };
        if number > limit {
            return self.error(NOT_THERE[kind]);
        }
        if index >= self.named[kind] {
            self.named[kind] = index + 1;
        }
        // Below `MOST`.
        Ok(index as u16)
    }
}
