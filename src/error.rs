//! The error type: the value that was refused, and the reason.

use core::convert::Infallible;
use core::fmt;

use crate::{Angle, Scalar, Vec3};

/// The reason why a value was refused. The message names the value and the allowed range.
///
/// Constructors and [`TriangleList::prepare`](crate::TriangleList::prepare) return errors. Drawing cannot fail.
///
/// ```
/// use fixel::prelude::*;
/// let error = Projection::perspective(deg!(180), (4, 3), fx!(0.1), fx!(100)).unwrap_err();
/// assert_eq!(error.to_string(), "field of view is 180 degrees: it must be above 0 and below 180 degrees");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Error {
    /// A number outside the range of its format.
    #[non_exhaustive]
    NotRepresentable {
        /// The refused number.
        value: RefusedFloat,
        /// The format holds numbers from −`limit` to just below `limit`; `None` if it holds every
        /// finite number.
        limit: Option<u32>,
    },
    /// A field of view of zero, or of half a turn or more.
    #[non_exhaustive]
    FieldOfView {
        /// The refused angle.
        angle: Angle,
    },
    /// An aspect ratio or a size that is not positive.
    #[non_exhaustive]
    Aspect {
        /// The refused width.
        width: Scalar,
        /// The refused height.
        height: Scalar,
    },
    /// A focal length that is not positive.
    #[non_exhaustive]
    FocalLength {
        /// The refused length in pixels.
        pixels: Scalar,
    },
    /// A near plane that is not in front of the eye.
    #[non_exhaustive]
    Near {
        /// The refused distance.
        near: Scalar,
    },
    /// A far plane that is not behind the near plane.
    #[non_exhaustive]
    Far {
        /// The distance of the near plane.
        near: Scalar,
        /// The refused distance of the far plane.
        far: Scalar,
    },
    /// A window without width or height, because an edge is not beyond its opposite.
    #[non_exhaustive]
    EmptyWindow {
        /// The refused left or bottom edge.
        low: Scalar,
        /// The refused right or top edge.
        high: Scalar,
    },
    /// A camera whose eye is at its target.
    #[non_exhaustive]
    EyeAtTarget {
        /// The position of both.
        eye: Vec3,
    },
    /// An up direction that is zero or along the line of sight.
    #[non_exhaustive]
    UpAlongView {
        /// The refused direction.
        up: Vec3,
    },
    /// A zero vector where a direction is needed.
    ZeroDirection,
    /// A zero quaternion where a rotation is needed.
    ZeroQuaternion,
    /// A matrix whose last row is not 0 0 0 1 where an affine transform is needed.
    #[non_exhaustive]
    NotAffine {
        /// The refused row.
        last_row: [Scalar; 4],
    },
    /// A brightness below 0 or above 1.
    #[non_exhaustive]
    Brightness {
        /// The refused brightness; 1 is full brightness.
        value: Scalar,
    },
    /// A canvas, texture or viewport whose size is zero or too large.
    #[non_exhaustive]
    Size {
        /// The refused width in pixels.
        width: u32,
        /// The refused height in pixels.
        height: u32,
        /// Largest width and height allowed, in pixels.
        max: u32,
    },
    /// A width or height of a texture that is not a power of two, or is too large.
    #[non_exhaustive]
    PowerOfTwo {
        /// The name of the side, width or height.
        of: &'static str,
        /// The refused number of texels.
        given: u32,
        /// Largest number allowed.
        max: u32,
    },
    /// A viewport too far from the top left corner of its frame.
    #[non_exhaustive]
    Offset {
        /// The refused column of the left edge.
        x: i32,
        /// The refused row of the top edge.
        y: i32,
        /// Largest magnitude allowed for both.
        max: u32,
    },
    /// A slice of the wrong length.
    #[non_exhaustive]
    Length {
        /// Number of elements in the slice.
        given: usize,
        /// Number of elements needed.
        needed: usize,
    },
    /// A band without rows, or with rows outside its frame.
    #[non_exhaustive]
    Rows {
        /// First row of the band.
        first: u32,
        /// Number of rows of the band.
        rows: u32,
        /// Number of rows of the frame.
        height: u32,
    },
    /// An index that is out of range.
    #[non_exhaustive]
    Index {
        /// The face, edge or entry that holds the index.
        at: usize,
        /// The refused index.
        index: u32,
        /// Number of elements; the index must be below it.
        len: usize,
    },
    /// More elements than indices can address.
    #[non_exhaustive]
    TooMany {
        /// The refused number of elements.
        given: usize,
        /// Largest number allowed.
        max: usize,
    },
    /// A list that is too short for the visible part of a mesh.
    #[non_exhaustive]
    Full {
        /// The kind of element in the list.
        of: &'static str,
        /// Number of visible elements.
        needed: usize,
        /// Number of elements that the list can hold.
        room: usize,
    },
    /// A shape with too few or too many parts.
    #[non_exhaustive]
    Parts {
        /// The kind of part.
        of: &'static str,
        /// The refused number of parts.
        given: u32,
        /// Fewest allowed.
        min: u32,
        /// Most allowed.
        max: u32,
    },
    /// A dimension of a shape that is not positive, or too large.
    #[non_exhaustive]
    Extent {
        /// The name of the dimension.
        of: &'static str,
        /// The refused length.
        given: Scalar,
        /// Largest length allowed.
        max: Scalar,
    },
    /// An image file in a format that cannot be read.
    #[non_exhaustive]
    Image {
        /// The field of the file's header.
        of: &'static str,
        /// The refused value of the field.
        given: u32,
        /// The values that can be read.
        needed: &'static str,
    },
    /// An image file that ends before its picture does.
    #[non_exhaustive]
    Truncated {
        /// Number of bytes in the file.
        given: usize,
        /// Number of bytes needed, according to the file's header.
        needed: usize,
    },
    /// OBJ text that cannot be read.
    #[non_exhaustive]
    Obj {
        /// The line number, counted from 1.
        line: usize,
        /// The mistake in the line.
        problem: &'static str,
    },
}

impl fmt::Display for Error {
    #[allow(clippy::too_many_lines)] // a message for each variant
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotRepresentable { value, limit } => {
                write!(f, "{value} cannot be represented: it must ")?;
                match limit {
                    // Every format holds this upper bound without rounding it up to the limit.
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
            Self::Near { near } => write!(
                f,
                "near plane is at {near}: it must be above 0, in front of the eye"
            ),
            Self::Far { near, far } => write!(
                f,
                "far plane is at {far}: it must be beyond the near plane at {near}"
            ),
            Self::EmptyWindow { low, high } => write!(
                f,
                "window from {low} to {high} is empty: left must be below right and bottom below top"
            ),
            Self::EyeAtTarget { eye } => write!(
                f,
                "eye and target are both at {eye}: they must differ, to give the camera a direction to look in"
            ),
            Self::UpAlongView { up } => write!(
                f,
                "up is {up}, which is zero or parallel to the line of sight: it must point away from that line"
            ),
            Self::ZeroDirection => {
                f.write_str("direction is (0, 0, 0): at least one component must not be 0")
            }
            Self::ZeroQuaternion => {
                f.write_str("quaternion is (0, 0, 0, 0): at least one component must not be 0")
            }
            Self::NotAffine {
                last_row: [x, y, z, w],
            } => write!(
                f,
                "last row is ({x}, {y}, {z}, {w}): it must be (0, 0, 0, 1) in an affine matrix"
            ),
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
            Self::Offset { x, y, max } => write!(
                f,
                "viewport is at ({x}, {y}): both coordinates must lie between -{max} and {max}"
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
                "band has {rows} rows from row {first}: it must have at least one and lie within the {height} rows of the frame"
            ),
            Self::Index { at, index, len } => write!(
                f,
                "index {index} in element {at} is out of range: it must be below {len}"
            ),
            Self::TooMany { given, max } => write!(
                f,
                "{given} elements are too many: at most {max} are allowed"
            ),
            Self::Full { of, needed, room } => write!(
                f,
                "{needed} {of} are visible: the list must have room for all, and has room for {room}"
            ),
            Self::Parts {
                of,
                given,
                min,
                max,
            } => write!(
                f,
                "number of {of} is {given}: it must lie between {min} and {max}"
            ),
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

/// Lets `?` follow operations of embedded-graphics on a canvas, which cannot fail.
impl From<Infallible> for Error {
    fn from(never: Infallible) -> Self {
        match never {}
    }
}

/// A float that was refused, with the precision that a message needs.
///
/// It is stored in thousandths, so that a program that prints errors does not link the formatting of floats.
///
/// ```
/// use fixel::Vec3;
/// let error = Vec3::try_from([0.0, 40_000.5_f64, 0.0]).unwrap_err();
/// assert!(error.to_string().starts_with("40000.5 cannot be represented"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RefusedFloat {
    /// Not a number.
    Nan,
    /// A number in thousandths, rounded towards zero; saturates.
    Thousandths(i64),
}

impl RefusedFloat {
    pub(crate) const fn new(value: f64) -> Self {
        if value.is_nan() {
            Self::Nan
        } else {
            // The cast saturates.
            Self::Thousandths((value * 1000.0) as i64)
        }
    }
}

impl fmt::Display for RefusedFloat {
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
