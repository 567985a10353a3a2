//! The messages of errors that stop compilation.

use crate::Error;

/// Longest message, in bytes; the rest is cut off.
const ROOM: usize = 512;

/// What a name in a template stands for.
#[derive(Clone, Copy)]
enum Piece<'a> {
    Text(&'a str),
    Number(usize),
    Scalar(crate::Scalar),
    Angle(crate::Angle),
}
use Piece::{Angle, Number, Scalar, Text};

/// Splits a text at the first such byte: the text before it, and the text after it, if there is such a byte.
const fn cut(text: &str, byte: u8) -> (&str, Option<&str>) {
    let mut at = 0;
    while at < text.len() {
        if text.as_bytes()[at] == byte {
            let (before, rest) = text.split_at(at);
            return (before, Some(rest.split_at(1).1));
        }
        at += 1;
    }
    (text, None)
}

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

    /// Adds a template, whose names in braces stand for the pieces in their order.
    const fn fill(mut self, template: &str, pieces: &[Piece<'_>]) -> Self {
        let mut rest = template;
        let mut piece = 0;
        while let (text, Some(name)) = cut(rest, b'{') {
            self = self.push(text);
            self = match pieces[piece] {
                Piece::Text(text) => self.push(text),
                Piece::Number(number) => self.number(number),
                Piece::Scalar(value) => self.scalar(value),
                Piece::Angle(angle) => self
                    .decimal(angle.ten_thousandths(), 10_000)
                    .push(" degrees"),
            };
            let ((_, Some(after)) | (after, None)) = cut(name, b'}');
            rest = after;
            piece += 1;
        }
        self.push(rest)
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
    const fn scalar(self, value: crate::Scalar) -> Self {
        let sign = if value.to_bits() < 0 { "-" } else { "" };
        // In units of 1/100000, rounded to nearest.
        let parts = (value.to_bits().unsigned_abs() as u64 * 100_000 + (1 << 15)) >> 16;
        self.push(sign).decimal(parts as usize, 100_000)
    }

    /// Pushes `parts` / `unit`, where `unit` is a power of ten.
    const fn decimal(self, parts: usize, mut unit: usize) -> Self {
        let mut message = self.number(parts / unit);
        let mut decimals = parts % unit;
        if decimals > 0 {
            message = message.push(".");
        }
        while decimals > 0 {
            unit /= 10;
            message = message.number(decimals / unit);
            decimals %= unit;
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

/// Unwraps a value made at compile time, which is called `name`, or from the file of this name.
///
/// # Panics
///
/// If `result` is an error. The message is the error's own after the name.
pub const fn checked<T: Copy>(result: Result<T, Error>, name: &str) -> T {
    const NONE: Piece<'_> = Text("");
    let error = match result {
        Ok(value) => return value,
        Err(error) => error,
    };
    let mut hint = Message::new();
    let pieces = match error {
        Error::TooMany { given, max } => [Number(given), Number(max), NONE, NONE],
        Error::Index { at, index, len } => [Number(index as usize), Number(at), Number(len), NONE],
        Error::Length { given, needed } => [Number(given), Number(needed), NONE, NONE],
        Error::FacesDiffer { at } => [Number(at), NONE, NONE, NONE],
        Error::Parts {
            of,
            given,
            min,
            max,
        } => [
            Text(of),
            Number(given as usize),
            Number(min as usize),
            Number(max as usize),
        ],
        Error::Extent { of, given, max } => [Text(of), Scalar(given), Scalar(max), NONE],
        Error::PowerOfTwo { of, given, max } => {
            hint = hint.push(", such as ").number(nearest(given, max) as usize);
            [Text(of), Number(given as usize), Number(max as usize), NONE]
        }
        Error::CreaseAngle { angle } => [Angle(angle), NONE, NONE, NONE],
        // Nothing that is made at compile time has another error with fields.
        _ => [Text("the value"); 4],
    };
    let message = Message::new().push(name).push(": ");
    panic!(
        "{}",
        message
            .fill(error.template(), &pieces)
            .push(hint.text())
            .text()
    )
}

/// Returns the least power of two that is not below `given`, or `max`.
const fn nearest(given: u32, max: u32) -> u32 {
    if given > max {
        max
    } else {
        given.next_power_of_two()
    }
}

/// Stops compilation when a file's picture has more colors than a texture's type has room for.
///
/// # Panics
///
/// Always.
pub(crate) const fn too_many_colors(name: &str, given: usize, max: usize) -> ! {
    const TEMPLATE: &str =
        "{}: the picture has {} colors, and the type's table {}: a table has at most 256";
    let pieces = [Text(name), Number(given), Number(max)];
    panic!("{}", Message::new().fill(TEMPLATE, &pieces).text())
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
    const TEMPLATE: &str =
        "{}: size is {}x{}, but the type says {}x{}: write the file's size in the type";
    let [width, height] = [Number(width as usize), Number(height as usize)];
    let pieces = [
        Text(name),
        width,
        height,
        Number(type_width),
        Number(type_height),
    ];
    panic!("{}", Message::new().fill(TEMPLATE, &pieces).text())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Scalar, deg, fx};

    #[test]
    #[should_panic(expected = "outline: crease angle is 200.025 degrees: it must lie between 0")]
    fn angles_have_four_decimals() {
        let angle = deg!(200.025);
        checked::<()>(Err(Error::CreaseAngle { angle }), "outline");
    }

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
