//! The error type: the value that was refused, and the reason.

use core::convert::Infallible;
use core::fmt;
use core::ops::Bound::{self, Excluded, Included, Unbounded};

use crate::math::Vec3;
use crate::message::{Message, Piece};
use crate::num::{Angle, Scalar};

#[cfg(test)]
mod tests;

/// Takes the value of a result, or returns the error, like `?`, but also in a const fn.
macro_rules! ok {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(error) => return Err(error),
        }
    };
}
pub(crate) use ok;

/// Returns an error unless a count is in range; `of` names the count.
pub(crate) const fn check_count(
    of: &'static str,
    given: usize,
    [min, max]: [usize; 2],
) -> Result<(), Error> {
    if min <= given && given <= max {
        return Ok(());
    }
    Err(Error::Count {
        of,
        given,
        min,
        max,
    })
}

/// Returns an error unless a list has exactly as many elements as needed.
pub(crate) const fn check_length(
    of: &'static str,
    given: usize,
    needed: usize,
) -> Result<(), Error> {
    check_count(of, given, [needed; 2])
}

/// Returns an error unless a number lies in a range; `of` names the number.
pub(crate) const fn check_range(
    of: &'static str,
    given: Scalar,
    range: (Bound<Scalar>, Bound<Scalar>),
) -> Result<(), Error> {
    let is_low = match range.0 {
        Included(low) => given.to_bits() < low.to_bits(),
        Excluded(low) => given.to_bits() <= low.to_bits(),
        Unbounded => false,
    };
    let is_high = match range.1 {
        Included(high) => given.to_bits() > high.to_bits(),
        Excluded(high) => given.to_bits() >= high.to_bits(),
        Unbounded => false,
    };
    if is_low || is_high {
        return Err(Error::OutOfRange { of, given, range });
    }
    Ok(())
}

/// Returns `given` − `low` in units of 2^-16, or an error unless `given` is above `low`.
pub(crate) const fn check_above(
    of: &'static str,
    given: Scalar,
    low: Scalar,
) -> Result<i64, Error> {
    ok!(check_range(of, given, (Excluded(low), Unbounded)));
    Ok(given.to_bits() as i64 - low.to_bits() as i64)
}

/// Returns an error unless an angle lies in a range; `of` names the angle.
pub(crate) const fn check_angle(
    of: &'static str,
    given: Angle,
    range: (Bound<Angle>, Bound<Angle>),
) -> Result<(), Error> {
    let is_low = match range.0 {
        Included(low) => given.to_bits() < low.to_bits(),
        Excluded(low) => given.to_bits() <= low.to_bits(),
        Unbounded => false,
    };
    let is_high = match range.1 {
        Included(high) => given.to_bits() > high.to_bits(),
        Excluded(high) => given.to_bits() >= high.to_bits(),
        Unbounded => false,
    };
    if is_low || is_high {
        return Err(Error::Angle { of, given, range });
    }
    Ok(())
}

impl Error {
    /// A zero vector where a direction is needed.
    pub(crate) const ZERO_DIRECTION: Self = Self::NoDirection {
        of: "direction",
        given: Vec3::ZERO,
        needed: "at least one component must not be 0",
    };
}

/// Declares [`Error`]: each variant, its message, and the values that replace the braces in the message.
macro_rules! errors {
    ($(#[$about:meta])+ pub enum Error; $(
        $(#[$doc:meta])+
        $Variant:ident { $($(#[$field_doc:meta])+ $field:ident: $Type:ty,)+ }
            = $message:literal $(, $Piece:ident($value:expr))*;
    )+ without fields: $(
        $(#[$unit_doc:meta])+
        $Unit:ident = $unit_message:literal;
    )+) => {
        $(#[$about])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Error {
            $($(#[$doc])+ #[non_exhaustive] $Variant { $($(#[$field_doc])+ $field: $Type,)+ },)+
            $($(#[$unit_doc])+ $Unit,)+
        }

        /// The names of all variants.
        #[cfg(test)]
        const VARIANTS: &[&str] = &[$(stringify!($Variant),)+ $(stringify!($Unit),)+];

        impl Error {
            #[allow(clippy::cast_lossless, clippy::cast_possible_wrap)] // counts
            pub(crate) const fn message(&self) -> Message {
                match *self {
                    $(Self::$Variant { $($field),+ } => {
                        Message::new($message, &[$(errors!(@ $Piece $value)),*])
                    })+
                    $(Self::$Unit => Message::new($unit_message, &[]),)+
                }
            }
        }
    };
    (@ Number $value:expr) => { Piece::Number($value as i64) };
    (@ $Piece:ident $value:expr) => { Piece::$Piece($value) };
}

errors! {
    /// The reason why a value was refused. The error's message names the value and the allowed range.
    ///
    /// Functions that build or check a value, and functions that prepare a [`DrawList`](crate::DrawList), return
    /// errors. Draw calls cannot fail, with one exception: drawing a prepared list fails if the canvas and the list
    /// have different frame sizes.
    ///
    /// ```
    /// use fixel::prelude::*;
    /// let error = Projection::perspective(deg!(180), (4, 3), fx!(0.5), fx!(50)).unwrap_err();
    /// assert_eq!(
    ///     error.to_string(),
    ///     "field of view is 180 degrees: it must be above 0 and below 180 degrees",
    /// );
    /// ```
    pub enum Error;

    /// A number outside the range of its format.
    NotRepresentable {
        /// The refused number in thousandths, rounded toward zero and saturated. (It is an integer, so that a program
        /// that prints errors does not need the code that formats floats.)
        thousandths: i64,
        /// The format holds numbers from −`limit` to just below `limit`.
        limit: u32,
    } = "{} cannot be represented: it must lie between -{} and {}.99999",
        Thousandths(thousandths), Number(limit), Number(limit - 1);
    /// An angle that is too small or too large: a field of view of 0 or 180 degrees, a crease angle above 180 degrees
    /// (which two faces cannot form), or an angle of a cone of light.
    Angle {
        /// The name of the angle.
        of: &'static str,
        /// The refused angle.
        given: Angle,
        /// The angles allowed.
        range: (Bound<Angle>, Bound<Angle>),
    } = "{} is {} degrees: it must {} degrees", Text(of), Degrees(given), Angles(range);
    /// A number that is too low or too high: a brightness above 1, a size of 0, or a far plane that is not beyond the
    /// near plane.
    OutOfRange {
        /// The name of the quantity.
        of: &'static str,
        /// The refused number.
        given: Scalar,
        /// The numbers allowed. An end can be another argument: a far plane must be beyond the near plane.
        range: (Bound<Scalar>, Bound<Scalar>),
    } = "{} is {}: it must {}", Text(of), Scalar(given), Scalars(range);
    /// A vector that gives no direction where one is needed: a zero vector, an up direction along the line of sight, or
    /// the position of an eye that equals its target.
    NoDirection {
        /// The name of the vector.
        of: &'static str,
        /// The refused vector.
        given: Vec3,
        /// The condition that the vector does not meet.
        needed: &'static str,
    } = "{} is ({}, {}, {}): {}",
        Text(of), Scalar(given.x), Scalar(given.y), Scalar(given.z), Text(needed);
    /// A matrix with a last row that is not 0 0 0 1, where an affine transform is needed.
    NotAffine {
        /// The refused row.
        last_row: [Scalar; 4],
    } = "last row is ({}, {}, {}, {}): it must be (0, 0, 0, 1) in an affine matrix",
        Scalar(last_row[0]), Scalar(last_row[1]), Scalar(last_row[2]), Scalar(last_row[3]);
    /// A width or height of a texture that is not a power of two, or is too large.
    PowerOfTwo {
        /// The name of the side: width or height.
        of: &'static str,
        /// The refused number of texels.
        given: u32,
        /// Largest number allowed.
        max: u32,
    } = "{} is {}: it must be a power of two, at most {}, such as {}",
        Text(of), Number(given), Number(max), Number(nearest(given, max));
    /// Two sizes that differ and must not: of a mask and its texture, or of a canvas's frame and the frame that a list
    /// was prepared for.
    SizeDiffers {
        /// The name of the picture.
        of: &'static str,
        /// The refused width and height.
        given: [u32; 2],
        /// The width and height of the other picture.
        needed: [u32; 2],
        /// The name of the other picture.
        like: &'static str,
    } = "size of {} is {}x{}: it must be {}x{}, like {}",
        Text(of), Number(given[0]), Number(given[1]), Number(needed[0]), Number(needed[1]), Text(like);
    /// A viewport too far from the top left corner of its frame.
    Offset {
        /// The refused column of the left edge.
        x: i32,
        /// The refused row of the top edge.
        y: i32,
        /// Largest magnitude allowed for `x` and for `y`.
        max: u32,
    } = "viewport is at ({}, {}): both coordinates must lie between -{} and {}",
        Number(x), Number(y), Number(max), Number(max);
    /// Too few or too many: elements of a slice or of a mesh, parts of a shape, rows or columns of a frame.
    Count {
        /// The name of the count.
        of: &'static str,
        /// The refused count.
        given: usize,
        /// Lowest count allowed.
        min: usize,
        /// Highest count allowed; `min` if only one count is allowed.
        max: usize,
    } = "number of {} is {}: it must be {}", Text(of), Number(given), Counts([min, max]);
    /// An index that is out of range.
    Index {
        /// The position, in its own list, of the face, edge or other element that holds the refused index.
        at: usize,
        /// The refused index.
        index: u32,
        /// Number of elements to which the index can refer; the index must be less than this number.
        len: usize,
    } = "index {} in element {} is out of range: it must be below {}", Number(index), Number(at), Number(len);
    /// Two meshes with different faces, where both must have the same faces.
    FacesDiffer {
        /// The index of the first face that differs.
        at: usize,
    } = "face {} differs: both meshes must have the same faces", Number(at);
    /// A list that is too short for the visible part of a mesh.
    Full {
        /// The kind of element in the list.
        of: &'static str,
        /// Number of visible elements.
        needed: usize,
        /// Number of elements that the list can hold.
        room: usize,
    } = "{} {} are visible: the list must have room for all, and has room for {}",
        Number(needed), Text(of), Number(room);

    without fields:
    /// A float that is infinite or not a number, where only finite numbers can be represented.
    NotFinite = "number is infinite or not a number: it must be finite";
    /// A zero quaternion where a rotation is needed.
    ZeroQuaternion = "quaternion is (0, 0, 0, 0): at least one component must not be 0";
}

/// Returns the least power of two that is not below `given`, but at most `max`.
const fn nearest(given: u32, max: u32) -> u32 {
    if given > max {
        max
    } else {
        given.next_power_of_two()
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.message().text())
    }
}

impl core::error::Error for Error {}

/// Allows `?` after operations of embedded-graphics on a canvas, which cannot fail.
impl From<Infallible> for Error {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}
