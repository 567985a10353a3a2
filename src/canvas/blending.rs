//! How a draw call's colors are blended with the colors on the canvas.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;

use crate::sealed::Sealed;
use crate::shade::{Output, PixelFormat, Precise, fraction};

/// How the colors of a draw call are blended with the colors on a canvas of color `C`: [`Replace`], [`Opacity`],
/// [`Add`] or [`Multiply`]. Sealed.
///
#[cfg_attr(doc, doc = page_picture!("blending", "A pane over stripes: Replace, Opacity, Add and Multiply"))]
/// [`DrawOptions::with_blending`](crate::DrawOptions::with_blending) chooses the blending. Draw opaque surfaces first,
/// then blended surfaces, from back to front. Draw the blended surfaces with [`TestOnly`](super::TestOnly), so that
/// they hide nothing that is drawn later.
///
/// Each channel is blended as it is stored, without gamma. The result is rounded to nearest, or dithered if channels
/// have at most 4 bits (see [`PixelFormat`]).
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// use fixel::canvas::{Blending, TestOnly};
/// fn ghostly<B: Blending<Rgb565>>(blending: B) -> DrawOptions<fixel::mode::Newton, TestOnly, B> {
///     DrawOptions::new().with_depth_test(TestOnly).with_blending(blending)
/// }
/// ghostly(fixel::canvas::Add);
/// ```
pub trait Blending<C>: Copy + Sealed {
    /// Whether [`blend`](Self::blend) reads the color on the canvas.
    #[doc(hidden)]
    const READS: bool = true;

    /// The new color at a pixel of the frame. `below` returns the old color; it is called only if the result depends on
    /// the old color.
    #[doc(hidden)]
    fn blend<O: Output<Color = C>>(self, output: O, below: impl FnOnce() -> C, at: Point) -> C;
}

impl Sealed for Replace {}
impl Sealed for Opacity {}
impl Sealed for Add {}
impl Sealed for Multiply {}

/// A [`Blending`]: the new color replaces the color on the canvas. The default.
///
/// ```
/// use fixel::{prelude::*, canvas::Replace};
/// assert_eq!(DrawOptions::new(), DrawOptions::new().with_blending(Replace));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Replace;

/// A [`Blending`]: each new color covers the color on the canvas by a fixed share, from 0 (not at all) to 255 (wholly).
/// Use it for glass, water and ghosts.
///
/// For colors of 15 and 16 bits, the share is rounded to a multiple of 1/32. Compared with the exact mix, the error is
/// at most 1.1 steps in a channel of 5 bits, 1.7 steps in a channel of 6 bits, and 1 step in a channel of any other
/// color. A share of 0 keeps the color on the canvas, and a share of 255 replaces it.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::{Window, prelude::*, canvas::Opacity};
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::RED];
/// let mut canvas = Canvas::new(&mut pixels, 1, 1)?;
/// let glass = DrawOptions::new().with_blending(Opacity(64));
/// canvas.draw_with(&glass, &SQUARE, &mvp, &Flat::new(Rgb565::BLUE));
/// assert_eq!(pixels, [Rgb565::new(23, 0, 8)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Opacity(pub u8);

/// A [`Blending`]: the new color is added to the color on the canvas, channel by channel, and the sum is limited to
/// white. Use it for fire, sparks and beams of light. The sum is exact.
///
/// To fade an added surface with distance, put it in black fog.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::{Window, prelude::*, canvas::Add};
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::new(30, 10, 3)];
/// let mut canvas = Canvas::new(&mut pixels, 1, 1)?;
/// let fire = DrawOptions::new().with_blending(Add);
/// canvas.draw_with(&fire, &SQUARE, &mvp, &Flat::new(Rgb565::new(4, 5, 6)));
/// assert_eq!(pixels, [Rgb565::new(31, 15, 9)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Add;

/// A [`Blending`]: each channel of the color on the canvas is multiplied by the same channel of the new color. A
/// channel's greatest value counts as 1, so white changes nothing. Use it for shadows and stained glass. The product is
/// rounded to nearest, or dithered.
///
/// To fade a multiplied surface with distance, put it in white fog.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::{Window, prelude::*, canvas::Multiply};
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray8::new(100)];
/// let mut canvas = Canvas::new(&mut pixels, 1, 1)?;
/// let shadow = DrawOptions::new().with_blending(Multiply);
/// canvas.draw_with(&shadow, &SQUARE, &mvp, &Flat::new(Gray8::new(51))); // a fifth
/// assert_eq!(pixels, [Gray8::new(20)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Multiply;

impl<C: PixelColor> Blending<C> for Replace {
    const READS: bool = false;

    #[inline]
    fn blend<O: Output<Color = C>>(self, output: O, below: impl FnOnce() -> C, at: Point) -> C {
        output.onto(below, at)
    }
}

impl<C: PixelFormat> Blending<C> for Opacity {
    #[inline]
    fn blend<O: Output<Color = C>>(self, output: O, below: impl FnOnce() -> C, at: Point) -> C {
        output.cover(below(), fraction(self.0), at)
    }
}

/// Replaces a share of the color below by `precise(below, color)`. The color and the share are the parts of `output`.
/// `plain` is the same function for outputs without fraction bits, which cover the whole pixel.
#[inline]
fn changed<C: PixelFormat, O: Output<Color = C>>(
    output: O,
    below: C,
    at: Point,
    plain: impl FnOnce(C, C) -> Precise<C>,
    precise: impl FnOnce(Precise<C>, Precise<C>) -> Precise<C>,
) -> C {
    if O::IS_PLAIN {
        return plain(below, output.finish(at)).finish(at);
    }
    let ((color, share), below) = (output.parts(), Precise::from(below));
    below.mix(precise(below, color), share).finish(at)
}

impl<C: PixelFormat> Blending<C> for Add {
    #[inline]
    fn blend<O: Output<Color = C>>(self, output: O, below: impl FnOnce() -> C, at: Point) -> C {
        changed(output, below(), at, Precise::of_sum, Precise::plus)
    }
}

impl<C: PixelFormat> Blending<C> for Multiply {
    #[inline]
    fn blend<O: Output<Color = C>>(self, output: O, below: impl FnOnce() -> C, at: Point) -> C {
        changed(output, below(), at, Precise::of_product, |below, color| {
            below.times(color.fractions())
        })
    }
}
