//! The messages of errors that stop compilation.

use crate::{Error, Scalar};

/// Longest message, in bytes; the rest is cut off.
const ROOM: usize = 512;

/// Text assembled at compile time, when `format_args!` cannot run.
struct Message {
    bytes: [u8; ROOM],
    len: usize,
}

impl Message {
    const fn new() -> Self {
        Self {
            bytes: [0; ROOM],
            len: 0,
        }
    }

    const fn push(mut self, text: &str) -> Self {
        let mut i = 0;
        while i < text.len() && self.len < ROOM {
            self.bytes[self.len] = text.as_bytes()[i];
            self.len += 1;
            i += 1;
        }
        self
    }

    const fn number(self, number: usize) -> Self {
        const DIGITS: &str = "0123456789";
        let before = if number > 9 {
            self.number(number / 10)
        } else {
            self
        };
        let (_, digit) = DIGITS.split_at(number % 10);
        before.push(digit.split_at(1).0)
    }

    /// Pushes a number with up to five decimals.
    const fn scalar(self, value: Scalar) -> Self {
        let sign = if value.to_bits() < 0 { "-" } else { "" };
        // In units of 1/100000, rounded to nearest.
        let parts = (value.to_bits().unsigned_abs() as u64 * 100_000 + (1 << 15)) >> 16;
        let mut message = self.push(sign).number((parts / 100_000) as usize);
        let (mut decimals, mut unit) = (parts as usize % 100_000, 10_000);
        if decimals > 0 {
            message = message.push(".");
        }
        while decimals > 0 {
            message = message.number(decimals / unit);
            decimals %= unit;
            unit /= 10;
        }
        message
    }

    const fn text(&self) -> &str {
        match core::str::from_utf8(self.bytes.split_at(self.len).0) {
            Ok(text) => text,
            // The path is so long that the message was cut within a character.
            Err(_) => "a file or shape is wrong, and its path is too long to name",
        }
    }
}

/// Unwraps a value made at compile time from the file, shape or texture called `name`.
///
/// # Panics
///
/// If `result` is an error. The message resembles the error's own.
pub(crate) const fn checked<T: Copy>(result: Result<T, Error>, name: &str) -> T {
    let message = Message::new().push(name).push(": ");
    let message = match result {
        Ok(value) => return value,
        Err(Error::Obj { line, problem }) => {
            message.push("line ").number(line).push(": ").push(problem)
        }
        Err(Error::TooMany { given, max }) => message
            .number(given)
            .push(" elements are too many: at most ")
            .number(max)
            .push(" are allowed"),
        Err(Error::Parts {
            of,
            given,
            min,
            max,
        }) => message
            .push("number of ")
            .push(of)
            .push(" is ")
            .number(given as usize)
            .push(": it must lie between ")
            .number(min as usize)
            .push(" and ")
            .number(max as usize),
        Err(Error::Extent { of, given, max }) => message
            .push(of)
            .push(" is ")
            .scalar(given)
            .push(": it must be above 0 and at most ")
            .scalar(max),
        Err(Error::PowerOfTwo { of, given, max }) => message
            .push(of)
            .push(" is ")
            .number(given as usize)
            .push(": it must be a power of two, at most ")
            .number(max as usize)
            .push(", such as ")
            .number(nearest(given, max) as usize),
        Err(Error::Image { of, given, needed }) => message
            .push(of)
            .push(" is ")
            .number(given as usize)
            .push(": it must be ")
            .push(needed),
        Err(Error::Truncated { given, needed }) => message
            .push("file has ")
            .number(given)
            .push(" bytes: it needs at least ")
            .number(needed),
        Err(_) => message.push("its indices must be below the lengths of its lists"),
    };
    panic!("{}", message.text())
}

/// Returns the least power of two that is not below `given`, or `max`.
const fn nearest(given: u32, max: u32) -> u32 {
    if given > max {
        max
    } else {
        given.next_power_of_two()
    }
}

/// Stops compilation when an array of `width` x `height` texels receives too few or too many elements.
///
/// # Panics
///
/// Always.
pub(crate) const fn wrong_length(
    [width, height]: [usize; 2],
    elements: &str,
    given: usize,
    needed: usize,
) -> ! {
    let message = Message::new()
        .push("a texture of ")
        .number(width)
        .push("x")
        .number(height)
        .push(" texels needs ")
        .number(needed)
        .push(" ")
        .push(elements)
        .push(": ")
        .number(given)
        .push(" are given; write the image's own width and height in the type");
    panic!("{}", message.text())
}

/// Stops compilation when the size of a file's picture differs from the size in the type.
///
/// # Panics
///
/// Always.
pub(crate) const fn wrong_size(
    name: &str,
    [width, height]: [u32; 2],
    [type_width, type_height]: [usize; 2],
) -> ! {
    let message = Message::new()
        .push(name)
        .push(": size is ")
        .number(width as usize)
        .push("x")
        .number(height as usize)
        .push(", but the type says ")
        .number(type_width)
        .push("x")
        .number(type_height)
        .push(": write the file's size in the type");
    panic!("{}", message.text())
}

/// Stops compilation when the MTL file `mtl` lacks a material that the OBJ file `obj` uses.
///
/// # Panics
///
/// Always.
pub(crate) const fn no_material(obj: &str, mtl: &str, name: &[u8]) -> ! {
    let name = match core::str::from_utf8(name) {
        Ok(name) => name,
        Err(_) => "of a name that is not UTF-8",
    };
    let message = Message::new()
        .push(obj)
        .push(": usemtl names the material ")
        .push(name)
        .push(", which ")
        .push(mtl)
        .push(" does not have");
    panic!("{}", message.text())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fx;

    #[test]
    fn scalars_have_five_decimals() {
        for (value, text) in [
            (fx!(0), "0"),
            (fx!(-2), "-2"),
            (fx!(-0.25), "-0.25"),
            (fx!(0.001), "0.00101"), // 66/65536
            (Scalar::MAX, "32767.99998"),
            (Scalar::MIN, "-32768"),
        ] {
            assert_eq!(Message::new().scalar(value).text(), text);
        }
    }
}
