//! The picture in the colors of a display.
//!
//! In a program, `converted` maps a shader's colors to the display's format, pixel by pixel. Here a shader's colors are
//! Rgb565, and the page converts them after drawing, so that the module has each shader only once; the pixels are the
//! same. The lighthouse's sky is not a shader: it is drawn again in the display's colors, with its caption over it.

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb888, RgbColor,
};
use fixel::prelude::*;

use super::common::lighthouse;

/// Writes bytes of red, green, blue and opacity. The page knows formats by their place. `sky` has the depths of a
/// picture with the lighthouse's sky.
pub fn show(picture: &[Rgb565], sky: Option<&[u16]>, size: Size, format: u32, shown: &mut [u32]) {
    match format {
        0 => bytes(picture.iter().copied(), shown),
        1 => each::<Rgb555>(picture, sky, size, shown),
        2 => each::<Gray8>(picture, sky, size, shown),
        3 => each::<Gray4>(picture, sky, size, shown),
        4 => each::<Gray2>(picture, sky, size, shown),
        _ => each::<BinaryColor>(picture, sky, size, shown),
    }
}

/// The rows of a picture, converted and dithered.
fn each<C: PixelFormat + Into<Rgb888>>(
    picture: &[Rgb565],
    sky: Option<&[u16]>,
    size: Size,
    shown: &mut [u32],
) {
    let width = size.width.max(1) as usize;
    let mut row = [C::from_rgb(Rgb888::BLACK, Point::zero()); 640];
    let row = &mut row[..width.min(640)];
    for (y, (colors, shown)) in (0..).zip(picture.chunks(width).zip(shown.chunks_mut(width))) {
        let depths = sky.map(|depths| &depths[y as usize * width..]);
        if depths.is_some()
            && let Ok(mut canvas) = Canvas::band(&mut *row, size.width, size.height, y)
        {
            lighthouse::sky(&mut canvas);
        }
        for (x, (to, &color)) in (0_u32..).zip(row.iter_mut().zip(colors)) {
            if depths.is_none_or(|depths| depths[x as usize] > 0) {
                *to = C::from_rgb(color.into(), Point::new(x.cast_signed(), y.cast_signed()));
            }
        }
        if depths.is_some()
            && let Ok(mut canvas) = Canvas::band(&mut *row, size.width, size.height, y)
        {
            lighthouse::caption(&mut canvas);
        }
        bytes(row.iter().copied(), shown);
    }
}

fn bytes<C: Into<Rgb888>>(colors: impl Iterator<Item = C>, shown: &mut [u32]) {
    for (color, shown) in colors.zip(shown) {
        let color: Rgb888 = color.into();
        *shown = u32::from_le_bytes([color.r(), color.g(), color.b(), 255]);
    }
}
