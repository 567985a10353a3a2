//! What can be wrong with an input, and how it is said.

use core::convert::Infallible;
use core::fmt;

use crate::{Angle, Scalar, Vec3};

/// Why a value was refused. The message names the value and what is allowed.
///
/// Errors come from constructors and from preparation: drawing cannot fail.
///
/// ```
/// use fixel::prelude::*;
/// let error = Projection::perspective(Angle::from_degrees(180), (4, 3), fx!(0.1), fx!(100)).unwrap_err();
/// assert_eq!(error.to_string(), "field of view is 180 degrees: it must be above 0 and below 180 degrees");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A number that the format cannot hold.
    NotRepresentable {
        /// The number as given.
        value: Given,
        /// Where the format ends, up and down; `None` if it takes every finite number.
        limit: Option<u32>,
    },
    /// A field of view of nothing, or of half a turn and more.
    FieldOfView {
        /// The angle as given.
        angle: Angle,
    },
    /// An aspect ratio or a size that is not positive.
    Aspect {
        /// Width as given.
        width: Scalar,
        /// Height as given.
        height: Scalar,
    },
    /// A focal length that is not positive.
    FocalLength {
        /// The length as given, in pixels.
        pixels: Scalar,
    },
    /// A near plane that is not in front of the eye.
    Near {
        /// The distance as given.
        near: Scalar,
    },
    /// A far plane that is not behind the near plane.
    Far {
        /// The near distance as given.
        near: Scalar,
        /// The far distance as given.
        far: Scalar,
    },
    /// A frustum or box that holds nothing, because an edge is not beyond its opposite.
    EmptyFrustum {
        /// Left or bottom edge as given.
        low: Scalar,
        /// Right or top edge as given.
        high: Scalar,
    },
    /// A camera that stands on what it looks at.
    EyeAtTarget {
        /// The eye as given.
        eye: Vec3,
    },
    /// An up direction that is zero or along the line of sight.
    UpAlongView {
        /// The direction as given.
        up: Vec3,
    },
    /// A vector without a direction where one is needed.
    ZeroDirection,
    /// A brightness of light below nothing or above full.
    Brightness {
        /// The brightness as given, 1 being full.
        value: Scalar,
    },
    /// A canvas, texture or viewport of a size that cannot be drawn into.
    Size {
        /// Width as given, in pixels.
        width: u32,
        /// Height as given, in pixels.
        height: u32,
        /// Largest width and height allowed, in pixels.
        max: u32,
    },
    /// A width or height of a texture that is not a power of two, or too large.
    PowerOfTwo {
        /// Which of them.
        of: &'static str,
        /// Texels as given.
        given: u32,
        /// Most allowed.
        max: u32,
    },
    /// A viewport too far from its canvas.
    Place {
        /// Column of the left edge as given.
        x: i32,
        /// Row of the top edge as given.
        y: i32,
        /// Largest magnitude of either.
        max: u32,
    },
    /// A slice of the wrong length.
    Length {
        /// Elements given.
        given: usize,
        /// Elements needed.
        needed: usize,
    },
    /// A strip whose rows are not inside its frame.
    Rows {
        /// First row of the strip.
        first: u32,
        /// Number of rows of the strip.
        rows: u32,
        /// Number of rows of the frame.
        height: u32,
    },
    /// An index that names no element.
    Index {
        /// The face, edge or entry that holds it.
        at: usize,
        /// The index as given.
        index: u32,
        /// Number of elements there are.
        len: usize,
    },
    /// More elements than an index can name.
    TooMany {
        /// Elements given.
        given: usize,
        /// Elements allowed.
        max: usize,
    },
    /// A list that is too short for what is to be seen.
    Full {
        /// What there is no room for.
        of: &'static str,
        /// How many there are.
        needed: usize,
        /// How many there is room for.
        room: usize,
    },
    /// A shape of too few or too many parts.
    Parts {
        /// What there are so many of.
        of: &'static str,
        /// Number as given.
        given: u32,
        /// Fewest allowed.
        min: u32,
        /// Most allowed.
        max: u32,
    },
    /// A dimension of a shape that is not positive, or too large.
    Extent {
        /// Which dimension.
        of: &'static str,
        /// Length as given.
        given: Scalar,
        /// Greatest allowed.
        max: Scalar,
    },
    /// An image file of a kind that cannot be read.
    Image {
        /// The field of its header.
        of: &'static str,
        /// Value of the field as given.
        given: u32,
        /// The values that can be read.
        needed: &'static str,
    },
    /// An image file that ends before its picture.
    Truncated {
        /// Bytes given.
        given: usize,
        /// Bytes needed, as its header says.
        needed: usize,
    },
    /// OBJ text that cannot be read.
    Obj {
        /// Line, the first being 1.
        line: usize,
        /// What is wrong with it.
        problem: &'static str,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotRepresentable { value, limit } => {
                write!(f, "{value} cannot be represented: it must ")?;
                match limit {
                    // Whatever the format's resolution, it has this number; and rounded, the last.
                    Some(limit) => write!(f, "lie between -{limit} and {}.99999", limit - 1),
                    None => f.write_str("be finite"),
                }
            }
            Self::FieldOfView { angle } => write!(
                f,
                "field of view is {angle}: it must be above 0 and below 180 degrees"
            ),
            Self::Aspect { width, height } => write!(
                f,
                "aspect ratio is {width} to {height}: both must be above 0"
            ),
            Self::FocalLength { pixels } => {
                write!(f, "focal length is {pixels} pixels: it must be above 0")
            }
            Self::Near { near } => {
                write!(
                    f,
                    "near plane is at {near}: it must be above 0, in front of the eye"
                )
            }
            Self::Far { near, far } => {
                write!(
                    f,
                    "far plane is at {far}: it must be beyond the near plane at {near}"
                )
            }
            Self::EmptyFrustum { low, high } => write!(
                f,
                "frustum from {low} to {high} is empty: left must be below right and bottom below top"
            ),
            Self::EyeAtTarget { eye } => write!(
                f,
                "eye and target are both at {eye}: a camera needs something to look at"
            ),
            Self::UpAlongView { up } => write!(
                f,
                "up is {up}, which is zero or parallel to the line of sight: it must point to the side of it"
            ),
            Self::ZeroDirection => f.write_str("direction is (0, 0, 0): it must have a length"),
            Self::Brightness { value } => {
                write!(f, "brightness is {value}: it must lie between 0 and 1")
            }
            Self::Size { width, height, max } => write!(
                f,
                "size is {width}x{height}: width and height must lie between 1 and {max}"
            ),
            Self::PowerOfTwo { of, given, max } => write!(
                f,
                "{of} is {given}: it must be a power of two, at most {max}"
            ),
            Self::Place { x, y, max } => write!(
                f,
                "viewport is at ({x}, {y}): both must lie between -{max} and {max}"
            ),
            Self::Length { given, needed } => {
                write!(f, "slice has {given} elements: exactly {needed} are needed")
            }
            Self::Rows {
                first,
                rows,
                height,
            } => write!(
                f,
                "strip has {rows} rows from row {first}: it must have at least one and lie within the {height} rows of the frame"
            ),
            Self::Index { at, index, len } => write!(
                f,
                "index {index} in element {at} is out of range: there are {len}, the first is 0"
            ),
            Self::TooMany { given, max } => {
                write!(
                    f,
                    "{given} elements are too many: at most {max} are allowed"
                )
            }
            Self::Full { of, needed, room } => {
                write!(
                    f,
                    "{needed} {of} are to be seen: the list has room for {room}"
                )
            }
            Self::Parts {
                of,
                given,
                min,
                max,
            } => {
                write!(
                    f,
                    "number of {of} is {given}: it must lie between {min} and {max}"
                )
            }
            Self::Extent { of, given, max } => {
                write!(f, "{of} is {given}: it must be above 0 and at most {max}")
            }
            Self::Image { of, given, needed } => {
                write!(f, "{of} is {given}: it must be {needed}")
            }
            Self::Truncated { given, needed } => {
                write!(f, "file has {given} bytes: it needs at least {needed}")
            }
            Self::Obj { line, problem } => write!(f, "line {line}: {problem}"),
        }
    }
}

impl core::error::Error for Error {}

/// Drawing onto a canvas by embedded-graphics cannot fail; so `?` may stand there too.
impl From<Infallible> for Error {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}

/// A float as it was given, for a message.
///
/// Kept in thousandths, so that a program that prints errors does not link the formatting of floats.
///
/// ```
/// use fixel::Vec3;
/// let error = Vec3::try_from([0.0, 40_000.5_f64, 0.0]).unwrap_err();
/// assert!(error.to_string().starts_with("40000.5 cannot be represented"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// Not a number.
    Nan,
    /// A number in thousandths, rounded towards zero; at the ends of the format it is that or beyond.
    Thousandths(i64),
}

impl Given {
    pub(crate) const fn new(value: f64) -> Self {
        if value.is_nan() {
            Self::Nan
        } else {
            // The cast saturates.
            Self::Thousandths((value * 1000.0) as i64)
        }
    }
}

impl fmt::Display for Given {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Nan => f.write_str("NaN"),
            Self::Thousandths(i64::MAX) => f.write_str("a number above 9e15"),
            Self::Thousandths(i64::MIN) => f.write_str("a number below -9e15"),
            Self::Thousandths(value) => {
                let sign = if value < 0 { "-" } else { "" };
                let value = value.unsigned_abs();
                write!(f, "{sign}{}", value / 1000)?;
                match value % 1000 {
                    0 => Ok(()),
                    tenths if tenths % 100 == 0 => write!(f, ".{}", tenths / 100),
                    rest => write!(f, ".{rest:03}"),
                }
            }
        }
    }
}
