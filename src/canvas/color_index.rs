//! Indices of colors in a palette.

use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::pixelcolor::raw::{RawData, RawU8};

/// A color that is an index into a palette, so that a pixel of a colored picture takes one byte.
///
/// Draw calls write indices to the canvas. A [`map`](crate::Shader::map) makes indices from a shader's colors, and
/// [`Canvas::show_with`](super::Canvas::show_with) looks up the colors of the palette:
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::{Gray8, Rgb888, raw::RawU24};
/// use embedded_graphics::prelude::*;
/// use fixel::{Window, prelude::*, canvas::ColorIndex};
/// static GLOW: [Rgb888; 3] = [Rgb888::BLACK, Rgb888::RED, Rgb888::YELLOW];
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [ColorIndex(0); 4];
/// let mut canvas = Canvas::new(&mut pixels, 2, 2)?;
/// let gray = Flat::new(Gray8::new(200));
/// let index = gray.map(|_, gray: Gray8| Some(ColorIndex(gray.luma() / 100)));
/// canvas.draw(&SQUARE, &mvp, &index);
/// canvas.draw_iter([Pixel(Point::zero(), ColorIndex(1))])?;
///
/// let mut display = MockDisplay::new();
/// canvas.show_with(&mut display, |_, ColorIndex(index)| GLOW[usize::from(index)])?;
/// display.assert_pattern(&["RY", "YY"]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ColorIndex(pub u8);

impl PixelColor for ColorIndex {
    type Raw = RawU8;
}

impl From<RawU8> for ColorIndex {
    fn from(raw: RawU8) -> Self {
        Self(raw.into_inner())
    }
}

impl From<ColorIndex> for RawU8 {
    fn from(ColorIndex(index): ColorIndex) -> Self {
        Self::new(index)
    }
}
