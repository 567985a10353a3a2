//! Builds the messages of errors without `core::fmt`, because errors at compile time need messages, too, and
//! `core::fmt` does not run there.

#![allow(clippy::cast_possible_wrap)] // counts

use core::ops::Bound::{self, Excluded, Included, Unbounded};

use crate::error::Error;
use crate::num::Angle;

/// Longest message, in bytes; the rest is cut off.
const ROOM: usize = 512;

/// A value that takes the place of a pair of braces in a template.
#[derive(Clone, Copy)]
pub(crate) enum Piece<'a> {
    Text(&'a str),
    Number(i64),
    Thousandths(i64),
    Scalar(crate::num::Scalar),
    Degrees(Angle),
    /// The words of a range after "it must".
    Scalars((Bound<crate::num::Scalar>, Bound<crate::num::Scalar>)),
    Angles((Bound<Angle>, Bound<Angle>)),
    /// The lowest and the highest count allowed.
    Counts([usize; 2]),
}
use Piece::{Angles, Counts, Degrees, Number, Scalar, Scalars, Text, Thousandths};

/// A template with values in place of its braces.
pub(crate) struct Message {
    bytes: [u8; ROOM],
    len: usize,
}

impl Message {
    pub(crate) const fn new(template: &str, pieces: &[Piece<'_>]) -> Self {
        let mut message = Self {
            bytes: [0; ROOM],
            len: 0,
        };
        let template = template.as_bytes();
        let (mut at, mut piece) = (0, 0);
        while at < template.len() {
            if template[at] == b'{' {
                message.piece(pieces[piece]);
                piece += 1;
                at += 1; // the closing brace is skipped below
            } else {
                message.byte(template[at]);
            }
            at += 1;
        }
        message
    }

    pub(crate) const fn text(&self) -> &str {
        match core::str::from_utf8(self.bytes.split_at(self.len).0) {
            Ok(text) => text,
            // The path is so long that the message was cut within a character.
            Err(_) => "a file or shape is wrong, and its path is too long to name",
        }
    }

    const fn byte(&mut self, byte: u8) {
        if self.len < ROOM {
            self.bytes[self.len] = byte;
            self.len += 1;
        }
    }

    const fn append(&mut self, text: &str) {
        let mut i = 0;
        while i < text.len() {
            self.byte(text.as_bytes()[i]);
            i += 1;
        }
    }

    const fn piece(&mut self, piece: Piece<'_>) {
        match piece {
            Text(text) => self.append(text),
            Counts([min, max]) => {
                if min == max {
                    self.append("exactly ");
                } else if min == 0 {
                    self.append("at most ");
                } else {
                    self.append("at least ");
                    self.decimal(min as i64, 1);
                    self.append(" and at most ");
                }
                self.decimal(max as i64, 1);
            }
            Number(number) => self.decimal(number, 1),
            Thousandths(number) => self.decimal(number, 1000),
            Scalar(value) => {
                // Writes the fewest decimals that still round to this very `Scalar`; five are always enough.
                let (bits, mut unit) = (value.to_bits() as i64, 1);
                while rounded(rounded(bits * unit, 1 << 16) << 16, unit) != bits {
                    unit *= 10;
                }
                self.decimal(rounded(bits * unit, 1 << 16), unit);
            }
            Degrees(angle) => self.decimal(angle.ten_thousandths(), 10_000),
            Scalars((low, high)) => {
                let [before_low, before_high] = words((low, high));
                self.append(before_low);
                if let Included(low) | Excluded(low) = low {
                    self.piece(Scalar(low));
                }
                self.append(before_high);
                if let Included(high) | Excluded(high) = high {
                    self.piece(Scalar(high));
                }
            }
            Angles((low, high)) => {
                let [before_low, before_high] = words((low, high));
                self.append(before_low);
                if let Included(low) | Excluded(low) = low {
                    self.piece(Degrees(low));
                }
                self.append(before_high);
                if let Included(high) | Excluded(high) = high {
                    self.piece(Degrees(high));
                }
            }
        }
    }

    /// Writes `parts` / `unit` without zeros at the end; `unit` is a power of ten.
    const fn decimal(&mut self, parts: i64, unit: i64) {
        if parts < 0 {
            self.byte(b'-');
        }
        let unit = unit.cast_unsigned();
        let (mut rest, mut place) = (parts.unsigned_abs(), unit);
        while rest / place > 9 {
            place *= 10;
        }
        while place >= unit || rest > 0 {
            if place == unit / 10 {
                self.byte(b'.');
            }
            self.byte(b'0' + (rest / place) as u8);
            rest %= place;
            place /= 10;
        }
    }
}

/// Returns the words before each end of a range.
const fn words<T: Copy>(range: (Bound<T>, Bound<T>)) -> [&'static str; 2] {
    match range {
        (Included(_), Included(_)) => ["lie between ", " and "],
        (Included(_), Excluded(_)) => ["be at least ", " and below "],
        (Included(_), Unbounded) => ["be at least ", ""],
        (Excluded(_), Included(_)) => ["be above ", " and at most "],
        (Excluded(_), Excluded(_)) => ["be above ", " and below "],
        (Excluded(_), Unbounded) => ["be above ", ""],
        (Unbounded, Included(_)) => ["be at most ", ""],
        (Unbounded, _) => ["be below ", ""],
    }
}

/// Returns `top` / `bottom`, rounded to nearest (half up).
const fn rounded(top: i64, bottom: i64) -> i64 {
    (top + bottom / 2).div_euclid(bottom)
}

/// Stops compilation with a message.
///
/// # Panics
///
/// Always.
pub(crate) const fn stop(template: &str, pieces: &[Piece<'_>]) -> ! {
    panic!("{}", Message::new(template, pieces).text())
}

/// Unwraps a value made at compile time. `name` is the name of the value or of its file.
///
/// # Panics
///
/// If `result` is an error. The message is the name, followed by the error's message.
pub const fn checked<T: Copy>(result: Result<T, Error>, name: &str) -> T {
    match result {
        Ok(value) => value,
        Err(error) => stop("{}: {}", &[Text(name), Text(error.message().text())]),
    }
}

/// Stops compilation if a file's picture has more colors than fit into a texture's type.
///
/// # Panics
///
/// Always.
pub(crate) const fn too_many_colors(name: &str, given: usize, max: usize) -> ! {
    stop(
        "{}: the picture has {} colors, but the type's table has room for {}: a table can have at most 256",
        &[Text(name), Number(given as i64), Number(max as i64)],
    )
}

/// Stops compilation if the size of a file's picture differs from the size in the type.
pub(crate) const fn wrong_size(name: &str, given: [u32; 2], in_type: [usize; 2]) -> ! {
    let [width, height] = [Number(given[0] as i64), Number(given[1] as i64)];
    let [type_width, type_height] = [Number(in_type[0] as i64), Number(in_type[1] as i64)];
    stop(
        "{}: size is {}x{}, but the type says {}x{}: write the file's size in the type",
        &[Text(name), width, height, type_width, type_height],
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{cases, number};
    use crate::{Scalar, deg, fx};
    use std::string::ToString;

    #[test]
    #[should_panic(expected = "outline: crease angle is 200.025 degrees: it must lie between 0")]
    fn angles_have_four_decimals() {
        let angle = deg!(200.025);
        let range = (Included(Angle::ZERO), Included(Angle::HALF));
        checked(
            crate::error::check_angle("crease angle", angle, range),
            "outline",
        );
    }

    #[test]
    fn scalars_have_the_decimals_that_they_need() {
        let text = |value| {
            Message::new("{}", &[Piece::Scalar(value)])
                .text()
                .to_string()
        };
        for (value, expected) in [
            (fx!(0), "0"),
            (fx!(-2), "-2"),
            (fx!(-0.25), "-0.25"),
            (fx!(0.1), "0.1"),
            (Scalar::DELTA, "0.00002"),
            (Scalar::MAX, "32767.99998"),
            (Scalar::MIN, "-32768"),
        ] {
            assert_eq!(text(value), expected);
        }
        cases(256, |random| {
            let value = Scalar::from_bits(number(random));
            let read: f64 = text(value).parse().unwrap();
            assert_eq!(Scalar::try_from(read), Ok(value));
        });
    }
}
