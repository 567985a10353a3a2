//! The part of a canvas that a picture fills.

use core::ops::Range;

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;

use crate::error::{Error, check_count, ok};

/// The rectangle of pixels that a picture fills. Normalized device coordinates from −1 to 1 map to its width and
/// height.
///
/// The rectangle may reach beyond the canvas; pixels outside the canvas are not drawn.
///
/// A viewport and a model-view-projection are enough to tell where things are on the screen:
///
/// | you want to know | ask |
/// |---|---|
/// | where a point is, for a [label](crate::Canvas::label) | [`project`](Self::project) |
/// | which pixels a mesh may change, to clear, draw and send only these | [`rectangle_on_screen`](Self::rectangle_on_screen) |
/// | how large a mesh is, for a level of detail | [`size_on_screen`](Self::size_on_screen) |
/// | what is seen at a pixel | [`ray`](Self::ray) |
///
/// ```
/// use embedded_graphics::{geometry::{Point, Size}, primitives::Rectangle};
/// use fixel::{Error, Viewport};
/// let right_half = Viewport::new(160, 0, 160, 240)?;
/// let area = Rectangle::new(Point::new(160, 0), Size::new(160, 240));
/// assert_eq!(Viewport::try_from(area), Ok(right_half));
/// assert_eq!(right_half.size(), area.size);
/// assert!(Viewport::new(0, 0, 0, 240).is_err());
/// # Ok::<(), Error>(())
/// ```
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Viewport {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl Viewport {
    /// The limit for a viewport's width and height, and for the offset of its top left corner from the frame's top left
    /// corner, in x and in y. All are in pixels.
    pub const MAX: u32 = 4096;

    /// Makes a viewport with its top left corner at (x, y), in pixels of the frame; y increases downward.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless width and height are from 1 to [`MAX`](Self::MAX); [`Error::Offset`] unless x and y are
    /// within ±[`MAX`](Self::MAX).
    pub const fn new(x: i32, y: i32, width: u32, height: u32) -> Result<Self, Error> {
        let max = Self::MAX;
        let sides = [1, max as usize];
        ok!(check_count(
            "columns of the viewport",
            width as usize,
            sides
        ));
        ok!(check_count("rows of the viewport", height as usize, sides));
        if x.unsigned_abs() > max || y.unsigned_abs() > max {
            return Err(Error::Offset { x, y, max });
        }
        Ok(Self {
            x,
            y,
            width,
            height,
        })
    }

    /// Returns the top left corner.
    #[must_use]
    pub const fn top_left(&self) -> Point {
        Point::new(self.x, self.y)
    }

    /// Returns width and height.
    #[must_use]
    pub const fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }

    /// Returns the viewport that covers a whole frame.
    pub(crate) const fn whole(frame: Size) -> Self {
        Self {
            x: 0,
            y: 0,
            width: frame.width,
            height: frame.height,
        }
    }

    /// Returns the center, where the line of sight meets the picture, in units of 1/256 pixel.
    pub(crate) const fn center(&self) -> [i32; 2] {
        [
            self.x * 256 + self.width.cast_signed() * 128,
            self.y * 256 + self.height.cast_signed() * 128,
        ]
    }

    /// Returns the covered columns and rows.
    pub(crate) const fn pixels(&self) -> [Range<i32>; 2] {
        [
            self.x..self.x + self.width.cast_signed(),
            self.y..self.y + self.height.cast_signed(),
        ]
    }
}

impl TryFrom<Rectangle> for Viewport {
    type Error = Error;

    /// Returns the result of [`Viewport::new`] for the rectangle's corner and size.
    fn try_from(Rectangle { top_left, size }: Rectangle) -> Result<Self, Error> {
        Self::new(top_left.x, top_left.y, size.width, size.height)
    }
}
