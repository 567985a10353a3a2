//! The error type: the value that was refused, and the reason.

use core::convert::Infallible;
use core::fmt;

use crate::{Angle, Scalar, Vec3};

/// Takes the value of a result, or returns its error: `?` in a const fn.
macro_rules! ok {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(error) => return Err(error),
        }
    };
}
pub(crate) use ok;

/// An error unless a slice has as many elements as needed.
pub(crate) const fn check_length(given: usize, needed: usize) -> Result<(), Error> {
    if given == needed {
        Ok(())
    } else {
        Err(Error::Length { given, needed })
    }
}

/// An error if there are more elements than indices can address, or than there is room for.
pub(crate) const fn check_count(given: usize, max: usize) -> Result<(), Error> {
    if given <= max {
        Ok(())
    } else {
        Err(Error::TooMany { given, max })
    }
}

/// An error unless the number of these parts is in range.
pub(crate) const fn check_parts(
    of: &'static str,
    given: u32,
    [min, max]: [u32; 2],
) -> Result<(), Error> {
    if min <= given && given <= max {
        return Ok(());
    }
    Err(Error::Parts {
        of,
        given,
        min,
        max,
    })
}

/// An error unless this length is above 0 and at most `max`.
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

/// An error unless an angle can lie between two faces.
pub(crate) const fn check_crease(angle: Angle) -> Result<(), Error> {
    if angle.to_bits() > Angle::HALF.to_bits() {
        return Err(Error::CreaseAngle { angle });
    }
    Ok(())
}

/// Declares [`Error`]: its variants with fields, then those without, each with its message.
macro_rules! errors {
    ($(#[$about:meta])+ pub enum Error; $(
        $(#[$doc:meta])+
        $Variant:ident { $($(#[$field_doc:meta])+ $field:ident: $Type:ty,)+ }
            = $message:literal $(, $value:expr)*;
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
            /// The message, with the fields' names in braces.
            pub(crate) const fn template(&self) -> &'static str {
                match self {
                    $(Self::$Variant { .. } => $message,)+
                    $(Self::$Unit => $unit_message,)+
                }
            }
        }

        impl fmt::Display for Error {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match *self {
                    $(Self::$Variant { $($field),+ } => write!(f, $message $(, $value)*),)+
                    $(Self::$Unit => f.write_str($unit_message),)+
                }
            }
        }
    };
}

errors! {
    /// The reason why a value was refused. Its message names the value and the allowed range.
    ///
    /// Functions that build or check a value return errors, and so do those that prepare a
    /// [`DrawList`](crate::DrawList). Draw calls cannot fail, except that
    /// those of a prepared list refuse a canvas of another frame size.
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
        /// The refused number.
        value: RefusedFloat,
        /// The format holds numbers from −`limit` to just below `limit`; `None` if it holds every
        /// finite number.
        limit: Option<u32>,
    } = "{value} cannot be represented: it must {}", Range(limit);
    /// A field of view of zero, or of half a turn or more.
    FieldOfView {
        /// The refused angle.
        angle: Angle,
    } = "field of view is {angle}: it must be above 0 and below 180 degrees";
    /// An aspect ratio or a size that is not positive.
    Aspect {
        /// The refused width.
        width: Scalar,
        /// The refused height.
        height: Scalar,
    } = "aspect ratio is {width} to {height}: both must be above 0";
    /// A focal length that is not positive.
    FocalLength {
        /// The refused length in pixels.
        pixels: Scalar,
    } = "focal length is {pixels} pixels: it must be above 0";
    /// A near plane that is not in front of the eye.
    Near {
        /// The refused distance.
        near: Scalar,
    } = "near plane is at {near}: it must be above 0, in front of the eye";
    /// A far plane that is not behind the near plane.
    Far {
        /// The distance of the near plane.
        near: Scalar,
        /// The refused distance of the far plane.
        far: Scalar,
    } = "far plane is at {far}: it must be beyond the near plane at {near}";
    /// A window without width or height: left is not below right, or bottom is not below top.
    EmptyWindow {
        /// The refused left or bottom edge.
        low: Scalar,
        /// The refused right or top edge.
        high: Scalar,
    } = "window from {low} to {high} is empty: left must be below right and bottom below top";
    /// A camera whose eye is at its target.
    EyeAtTarget {
        /// The position of both.
        eye: Vec3,
    } = "eye and target are both at {eye}: they must differ, to give the camera a direction to look in";
    /// An up direction that is zero or along the line of sight.
    UpAlongView {
        /// The refused direction.
        up: Vec3,
    } = "up is {up}, which is zero or parallel to the line of sight: it must not be zero or along that line";
    /// A matrix whose last row is not 0 0 0 1 where an affine transform is needed.
    NotAffine {
        /// The refused row.
        last_row: [Scalar; 4],
    } = "last row is ({}, {}, {}, {}): it must be (0, 0, 0, 1) in an affine matrix",
        last_row[0], last_row[1], last_row[2], last_row[3];
    /// A brightness below 0 or above 1.
    Brightness {
        /// The refused brightness; 1 is full brightness.
        value: Scalar,
    } = "brightness is {value}: it must lie between 0 and 1";
    /// A lamp's range that is not positive.
    LightRange {
        /// The refused range.
        range: Scalar,
    } = "range of the light is {range}: it must be above 0";
    /// A cone of light whose inner angle is not below its outer angle, or whose outer angle is above 90 degrees.
    Cone {
        /// The refused inner angle.
        inner: Angle,
        /// The refused outer angle.
        outer: Angle,
    } = "cone reaches from {inner} to {outer}: the outer angle must be above the inner one, and at most 90 degrees";
    /// An angle that cannot lie between two faces.
    CreaseAngle {
        /// The refused angle.
        angle: Angle,
    } = "crease angle is {angle}: it must lie between 0 and 180 degrees";
    /// A line's width that is below one pixel, or too large.
    LineWidth {
        /// The refused width.
        width: Scalar,
        /// Largest width allowed.
        max: Scalar,
    } = "line width is {width}: it must lie between 1 and {max} pixels";
    /// A fog whose end is not behind its beginning.
    FogRange {
        /// The distance of the beginning.
        near: Scalar,
        /// The refused distance of the end.
        far: Scalar,
    } = "fog reaches from {near} to {far}: the second distance must be above the first one";
    /// A fog's density below 0.
    FogDensity {
        /// The refused density.
        density: Scalar,
    } = "density of the fog is {density}: it must be at least 0";
    /// Heights of a gradient in the wrong order.
    Heights {
        /// The height of the low color.
        bottom: Scalar,
        /// The refused height of the high color.
        top: Scalar,
    } = "gradient reaches from {bottom} to {top}: the second height must be above the first one";
    /// A frame or viewport whose width or height is zero or too large.
    Size {
        /// The refused width in pixels.
        width: u32,
        /// The refused height in pixels.
        height: u32,
        /// Largest width and height allowed, in pixels.
        max: u32,
    } = "size is {width}x{height}: width and height must lie between 1 and {max}";
    /// A width or height of a texture that is not a power of two, or is too large.
    PowerOfTwo {
        /// The name of the side, width or height.
        of: &'static str,
        /// The refused number of texels.
        given: u32,
        /// Largest number allowed.
        max: u32,
    } = "{of} is {given}: it must be a power of two, at most {max}";
    /// A mask whose size differs from its texture's.
    MaskSize {
        /// Columns and rows of the refused mask.
        given: [u32; 2],
        /// Columns and rows of the texture.
        texture: [u32; 2],
    } = "mask has {}x{} texels: it must have {}x{}, like its texture", given[0], given[1], texture[0], texture[1];
    /// A viewport too far from the top left corner of its frame.
    Offset {
        /// The refused column of the left edge.
        x: i32,
        /// The refused row of the top edge.
        y: i32,
        /// Largest magnitude allowed for both.
        max: u32,
    } = "viewport is at ({x}, {y}): both coordinates must lie between -{max} and {max}";
    /// A slice of the wrong length.
    Length {
        /// Number of elements in the slice.
        given: usize,
        /// Number of elements needed.
        needed: usize,
    } = "slice has {given} elements: exactly {needed} are needed";
    /// A band without rows, or with rows outside its frame.
    Rows {
        /// First row of the band.
        first: u32,
        /// Number of rows of the band.
        rows: u32,
        /// Number of rows of the frame.
        height: u32,
    } = "band has {rows} rows from row {first}: it must have at least one and lie within the {height} rows of the frame";
    /// A canvas whose frame differs in size from the frame that a list was prepared for.
    Frame {
        /// Number of columns of the canvas's frame.
        width: u32,
        /// Number of rows of the canvas's frame.
        height: u32,
        /// Number of columns of the prepared frame.
        needed_width: u32,
        /// Number of rows of the prepared frame.
        needed_height: u32,
    } = "canvas belongs to a frame of {width}x{height}: the list was prepared for {needed_width}x{needed_height}";
    /// An index that is out of range.
    Index {
        /// The face, edge or entry that holds the index.
        at: usize,
        /// The refused index.
        index: u32,
        /// Number of elements; the index must be below it.
        len: usize,
    } = "index {index} in element {at} is out of range: it must be below {len}";
    /// Two meshes whose faces should be the same, and are not.
    FacesDiffer {
        /// The first face that differs.
        at: usize,
    } = "face {at} differs: both meshes must have the same faces";
    /// More elements than indices can address, or than the caller's memory has room for.
    TooMany {
        /// The refused number of elements.
        given: usize,
        /// Largest number allowed.
        max: usize,
    } = "{given} elements are too many: at most {max} are allowed";
    /// A list that is too short for the visible part of a mesh.
    Full {
        /// The kind of element in the list.
        of: &'static str,
        /// Number of visible elements.
        needed: usize,
        /// Number of elements that the list can hold.
        room: usize,
    } = "{needed} {of} are visible: the list must have room for all, and has room for {room}";
    /// Too few or too many parts of a shape, frames of a sprite's texture, or fraction bits of short positions.
    Parts {
        /// The kind of part.
        of: &'static str,
        /// The refused number of parts.
        given: u32,
        /// Fewest allowed.
        min: u32,
        /// Most allowed.
        max: u32,
    } = "number of {of} is {given}: it must lie between {min} and {max}";
    /// A dimension of a shape, a sprite or a point that is not positive, or too large.
    Extent {
        /// The name of the dimension.
        of: &'static str,
        /// The refused length.
        given: Scalar,
        /// Largest length allowed.
        max: Scalar,
    } = "{of} is {given}: it must be above 0 and at most {max}";

    without fields:
    /// A zero vector where a direction is needed.
    ZeroDirection = "direction is (0, 0, 0): at least one component must not be 0";
    /// A zero quaternion where a rotation is needed.
    ZeroQuaternion = "quaternion is (0, 0, 0, 0): at least one component must not be 0";
}

/// The range of a format, as [`Error::NotRepresentable`] names it.
struct Range(Option<u32>);

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            // Every format holds this upper bound without rounding it up to the limit.
            Some(limit) => write!(f, "lie between -{limit} and {}.99999", limit - 1),
            None => f.write_str("be finite"),
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

/// A float that was refused, as precise as a message needs it.
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
    /// A number in thousandths, rounded toward zero; saturates.
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
