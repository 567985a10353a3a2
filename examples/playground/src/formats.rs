//! The picture in the colors of a display.
//!
//! A shader ends in Rgb565 here, and `converted` maps its colors to the format's, pixel by pixel. The page does so
//! after drawing, so that the module has each shader once; the pixels are the same.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb888, RgbColor,
};
use fixel::prelude::*;

/// Writes bytes of red, green, blue and opacity. The page knows formats by their index.
pub fn show(picture: &[Rgb565], width: u32, format: usize, shown: &mut [u32]) {
    match format {
        0 => bytes(picture.iter().copied(), shown),
        1 => each::<Rgb555>(picture, width, shown),
        2 => each::<Gray8>(picture, width, shown),
        3 => each::<Gray4>(picture, width, shown),
        4 => each::<Gray2>(picture, width, shown),
        _ => each::<BinaryColor>(picture, width, shown),
    }
}

/// The rows of a picture, converted and dithered.
fn each<C: Levels + Into<Rgb888>>(picture: &[Rgb565], width: u32, shown: &mut [u32]) {
    let width = width.max(1) as usize;
    for ((y, colors), shown) in (0..)
        .zip(picture.chunks(width))
        .zip(shown.chunks_mut(width))
    {
        let converted = (0..)
            .zip(colors)
            .map(|(x, &color)| C::from_rgb(color.into(), Point::new(x, y)));
        bytes(converted, shown);
    }
}

fn bytes<C: Into<Rgb888>>(colors: impl Iterator<Item = C>, shown: &mut [u32]) {
    for (color, shown) in colors.zip(shown) {
        let color: Rgb888 = color.into();
        *shown = u32::from_le_bytes([color.r(), color.g(), color.b(), 255]);
    }
}
