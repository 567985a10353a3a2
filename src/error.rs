//! The error type: the value that was refused, and the reason.

use core::convert::Infallible;
use core::fmt;

use crate::math::Vec3;
use crate::message::{Message, Piece};
use crate::num::{Angle, Scalar};

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

/// Returns an error unless this length is above 0 and at most `max`.
pub(crate) const fn check_extent(
    of: &'static str,
    given: Scalar,
    max: Scalar,
) -> Result<(), Error> {
    if given.to_bits() > 0 && given.to_bits() <= max.to_bits() {
        Ok(())
    } else {
        Err(Error::Extent { of, given, max })
    }
}

/// Returns an error unless this number lies between two others.
pub(crate) const fn check_range(
    of: &'static str,
    given: Scalar,
    [min, max]: [Scalar; 2],
) -> Result<(), Error> {
    if min.to_bits() <= given.to_bits() && given.to_bits() <= max.to_bits() {
        return Ok(());
    }
    Err(Error::OutOfRange {
        of,
        given,
        min,
        max,
    })
}

/// Returns `high` − `low` in units of 2^-16, or an error unless `high` is above `low`.
pub(crate) const fn check_order(of: &'static str, low: Scalar, high: Scalar) -> Result<i64, Error> {
    let length = high.to_bits() as i64 - low.to_bits() as i64;
    if length > 0 {
        Ok(length)
    } else {
        Err(Error::Empty { of, low, high })
    }
}

/// Returns an error if an angle is above 180 degrees, which two faces cannot form.
pub(crate) const fn check_crease(angle: Angle) -> Result<(), Error> {
    if angle.to_bits() > Angle::HALF.to_bits() {
        return Err(Error::Angle {
            of: "crease angle",
            given: angle,
            needed: "lie between 0 and 180 degrees",
        });
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
    /// let error = Projection::perspective(deg!(180), (4, 3), fx!(0.1), fx!(100)).unwrap_err();
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
    /// An angle outside its range: a field of view of zero, or of half a turn or more; a crease angle above 180 degrees,
    /// which two faces cannot form.
    Angle {
        /// The name of the angle.
        of: &'static str,
        /// The refused angle.
        given: Angle,
        /// The range that the angle is not in.
        needed: &'static str,
    } = "{} is {} degrees: it must {}", Text(of), Degrees(given), Text(needed);
    /// An aspect ratio or a size that is not positive.
    Aspect {
        /// The refused width.
        width: Scalar,
        /// The refused height.
        height: Scalar,
    } = "aspect ratio is {} to {}: both must be above 0", Scalar(width), Scalar(height);
    /// A range with an upper end that is not above its lower end: the depths from the near to the far plane, or the
    /// range of a window, a fog or a gradient.
    Empty {
        /// The name of the quantity that has the range.
        of: &'static str,
        /// The lower end.
        low: Scalar,
        /// The upper end, which is refused.
        high: Scalar,
    } = "{} from {} to {} is empty: the second number must be above the first", Text(of), Scalar(low), Scalar(high);
    /// A number that is too low or too high, such as a brightness above 1.
    OutOfRange {
        /// The name of the quantity.
        of: &'static str,
        /// The refused number.
        given: Scalar,
        /// Lowest number allowed.
        min: Scalar,
        /// Largest number allowed.
        max: Scalar,
    } = "{} is {}: it must lie between {} and {}", Text(of), Scalar(given), Scalar(min), Scalar(max);
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
    /// A cone of light with an inner angle that is not below its outer angle, or with an outer angle above 90 degrees.
    Cone {
        /// The refused inner angle.
        inner: Angle,
        /// The refused outer angle.
        outer: Angle,
    } = "cone reaches from {} degrees to {} degrees: the outer angle must be above the inner one, and at most 90 degrees",
        Degrees(inner), Degrees(outer);
    /// A frame or viewport with a width or a height that is zero or too large.
    Size {
        /// The refused width in pixels.
        width: u32,
        /// The refused height in pixels.
        height: u32,
        /// Largest width and height allowed, in pixels.
        max: u32,
    } = "size is {}x{}: width and height must lie between 1 and {}", Number(width), Number(height), Number(max);
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
    /// A picture with another size than the picture it belongs to: a mask, or the frame of a canvas on which a prepared
    /// list is drawn.
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
    /// Too few or too many elements: of a slice, of a mesh, of the memory for one, of a shape's parts.
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
    /// A band without rows, or with rows outside its frame.
    Rows {
        /// First row of the band.
        first: u32,
        /// Number of rows of the band.
        rows: u32,
        /// Number of rows of the frame.
        height: u32,
    } = "band has {} rows from row {}: it must have at least one and lie within the {} rows of the frame",
        Number(rows), Number(first), Number(height);
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
    /// A length that is not positive or is too large: a dimension of a shape, a sprite or a point, the distance of a
    /// near plane, or the range of a light.
    Extent {
        /// The name of the dimension.
        of: &'static str,
        /// The refused length.
        given: Scalar,
        /// Largest length allowed.
        max: Scalar,
    } = "{} is {}: it must be above 0 and at most {}", Text(of), Scalar(given), Scalar(max);

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
