//! Errors that stop compilation, in words.

use crate::Error;

/// Longest message, in bytes; the rest is cut off.
const ROOM: usize = 512;

/// Text put together while compiling, where there is no formatting.
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

    const fn text(&self) -> &str {
        match core::str::from_utf8(self.bytes.split_at(self.len).0) {
            Ok(text) => text,
            // The cut went through a character, of a very long path.
            Err(_) => "a file or shape is in error",
        }
    }
}

/// Unwraps what was made of the source called `name` while compiling.
///
/// # Panics
///
/// If it is an error, in words as close to the error's own as a const fn can put them.
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
        Err(Error::Extent { of, .. }) => message
            .push(of)
            .push(" is out of range: it must be above 0 and not too large"),
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
        Err(_) => message.push("its indices do not fit its lists"),
    };
    panic!("{}", message.text())
}

/// The power of two that follows, or the largest.
const fn nearest(given: u32, max: u32) -> u32 {
    if given > max {
        max
    } else {
        given.next_power_of_two()
    }
}

/// Stops compilation where an array of `width` x `height` texels is given too few or too many elements.
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

/// Stops compilation where a file's picture has another size than the type.
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
