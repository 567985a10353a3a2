//! What reading a BMP header and reading a TGA header have in common: numbers, checks and the order of rows.

use super::pixel::{byte, word};
use crate::Error;

/// Where the first of `count` rows or columns is, and the way to the next one, if a file holds them in this order or
/// from the last to the first.
pub(super) const fn along(
    start: usize,
    step: usize,
    count: u32,
    is_reversed: bool,
) -> (usize, isize) {
    if is_reversed {
        (start + step * (count as usize - 1), -(step as isize))
    } else {
        (start, step as isize)
    }
}

/// An error about a field of a file's header.
pub(super) const fn refused<T>(
    of: &'static str,
    given: u32,
    needed: &'static str,
) -> Result<T, Error> {
    Err(Error::Image { of, given, needed })
}

/// The number in two bytes, the low one first.
pub(super) const fn u16_at(bytes: &[u8], at: usize) -> u32 {
    word!(bytes, bytes.len(), at)
}

/// The number in four bytes, the low one first.
pub(super) const fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u16_at(bytes, at) | u16_at(bytes, at + 2) << 16
}

/// An error if there are fewer than `needed` bytes.
pub(super) const fn at_least(bytes: &[u8], needed: u64) -> Result<(), Error> {
    let given = bytes.len();
    if given as u64 >= needed {
        return Ok(());
    }
    // Saturated, because a word may not hold the number.
    let needed = if needed > usize::MAX as u64 {
        usize::MAX
    } else {
        needed as usize
    };
    Err(Error::Truncated { given, needed })
}
