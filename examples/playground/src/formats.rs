//! The picture in the colors of a display.
//!
//! In a program, `converted` maps a shader's colors to the display's format, pixel by pixel. Here a picture for a
//! display of another format than Rgb565 keeps what a shader returns, in full precision, and the page converts it after
//! drawing. So the module has each shader only twice; the pixels are the same. The lighthouse's sky is not a shader: it
//! is drawn again in the display's colors, with its caption over it.

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565, Rgb888, RgbColor,
};
use fixel::prelude::*;
use fixel::shade::{Output, Precise};

use super::common::lighthouse;

/// A color of a picture.
pub trait Color: PixelColor {
    /// A shader whose results are stored in this color.
    fn shader<S: ShaderFor<Rgb565>>(shader: S) -> impl ShaderFor<Self>;

    /// The color at a pixel of a display.
    fn at<C: PixelFormat>(self, point: Point) -> C;
}

impl Color for Rgb565 {
    fn shader<S: ShaderFor<Rgb565>>(shader: S) -> impl ShaderFor<Self> {
        shader
    }

    fn at<C: PixelFormat>(self, point: Point) -> C {
        C::from_rgb(self.into(), point)
    }
}

/// The levels that a shader returns for Rgb565, before they are rounded.
#[derive(Clone, Copy, PartialEq)]
pub struct Deep([i32; 3]);

impl PixelColor for Deep {
    type Raw = ();
}

impl Color for Deep {
    fn shader<S: ShaderFor<Rgb565>>(shader: S) -> impl ShaderFor<Self> {
        shader.map(|_, output| {
            let mut levels = [0; 3];
            _ = output.map::<Rgb565>(|color| {
                levels = color.levels();
                color
            });
            Some(Self(levels))
        })
    }

    fn at<C: PixelFormat>(self, point: Point) -> C {
        self.precise().converted().finish(point)
    }
}

impl Deep {
    pub const BLACK: Self = Self([0; 3]);

    fn precise(self) -> Precise<Rgb565> {
        Precise::from_levels(self.0)
    }
}

/// Writes bytes of red, green, blue and opacity. The page knows formats by their place. `sky` has the depths of a
/// picture with the lighthouse's sky.
pub fn show<P: Color>(
    picture: &[P],
    sky: Option<&[u16]>,
    size: Size,
    format: u32,
    shown: &mut [u32],
) {
    match format {
        0 => bytes(
            picture
                .iter()
                .map(|color| color.at::<Rgb565>(Point::zero())),
            shown,
        ),
        1 => each::<Rgb555, _>(picture, sky, size, shown),
        2 => each::<Gray8, _>(picture, sky, size, shown),
        3 => each::<Gray4, _>(picture, sky, size, shown),
        4 => each::<Gray2, _>(picture, sky, size, shown),
        _ => each::<BinaryColor, _>(picture, sky, size, shown),
    }
}

/// The rows of a picture, converted and dithered.
fn each<C: PixelFormat + Into<Rgb888>, P: Color>(
    picture: &[P],
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
                *to = color.at(Point::new(x.cast_signed(), y.cast_signed()));
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
