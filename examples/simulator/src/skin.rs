//! Textures with a size that is known only at run time.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::shade::Translucent;
use fixel_assets::Picture;

use super::Result;

/// The base-2 logarithm of the largest side, in texels.
const MOST_LOG2: u32 = 10;

/// A picture with sides that are powers of two.
#[derive(Debug)]
pub struct Skin {
    picture: Picture,
    /// The larger side of the original picture, in texels.
    pub side: u32,
}

impl Skin {
    /// Makes a skin of a picture. The sides are resampled to the nearest powers of two, up to 1024.
    pub fn new(picture: &Picture) -> Self {
        let (width, height) = (picture.width, picture.height);
        let mut picture = picture.resampled(nearest(width), nearest(height));
        if picture.has_alpha() {
            spread(&mut picture);
        }
        Self {
            picture,
            side: width.max(height),
        }
    }

    /// A checker of 64x64 texels, with squares of 8x8 texels in two colors.
    pub fn checker() -> Self {
        let colors = [[255, 255, 240, 255], [70, 130, 180, 255]];
        let color = |at: usize| colors[(at % 64 / 8 + at / 64 / 8) % 2];
        Self {
            picture: Picture {
                width: 64,
                height: 64,
                pixels: (0..64 * 64).map(color).collect(),
                table: None,
            },
            side: 64,
        }
    }

    /// A texture that is compiled in.
    pub fn of_rows<const SIDE: usize>(rows: &[[Rgb565; SIDE]; SIDE]) -> Self {
        let pixel = |&color: &Rgb565| {
            let color = Rgb888::from(color);
            [color.r(), color.g(), color.b(), 255]
        };
        Self::new(&Picture {
            width: SIDE as u32,
            height: SIDE as u32,
            pixels: rows.as_flattened().iter().map(pixel).collect(),
            table: None,
        })
    }

    /// Whether some texel is not opaque.
    pub fn has_alpha(&self) -> bool {
        self.picture.has_alpha()
    }

    /// Returns the texels in the color `C`.
    pub fn texels<C: PixelFormat>(&self) -> Texels<C> {
        let texel = |&[r, g, b, opacity]: &[u8; 4]| Translucent {
            color: C::from_rgb(Rgb888::new(r, g, b), Point::zero()),
            opacity,
        };
        Texels {
            list: self.picture.pixels.iter().map(texel).collect(),
            width: self.picture.width,
            height: self.picture.height,
        }
    }
}

/// Gives each invisible texel the mean color of its visible neighbors, because a bilinear filter blends the invisible
/// texel with these neighbors.
fn spread(picture: &mut Picture) {
    let (width, height) = (picture.width as usize, picture.height as usize);
    let old = picture.pixels.clone();
    for (at, pixel) in picture.pixels.iter_mut().enumerate() {
        if pixel[3] > 0 {
            continue;
        }
        let (x, y) = (at % width + width, at / width + height);
        let (mut sum, mut count) = ([0_usize; 3], 0);
        for (x, y) in (y - 1..=y + 1).flat_map(|y| (x - 1..=x + 1).map(move |x| (x, y))) {
            let [r, g, b, alpha] = old[y % height * width + x % width];
            if alpha > 0 {
                count += 1;
                for (sum, channel) in sum.iter_mut().zip([r, g, b]) {
                    *sum += usize::from(channel);
                }
            }
        }
        for (to, sum) in pixel.iter_mut().zip(sum) {
            // The mean of bytes fits into a byte.
            *to = (sum / count.max(1)) as u8;
        }
    }
}

/// Returns the power of two, at most 1024, that is nearest to `side` by ratio.
fn nearest(side: u32) -> u32 {
    let exponent = f64::from(side).log2().round();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a side's logarithm
    let exponent = (exponent as u32).min(MOST_LOG2);
    1 << exponent
}

/// Texels in one list.
#[derive(Debug)]
pub struct Texels<C> {
    list: Vec<Translucent<C>>,
    width: u32,
    height: u32,
}

impl<C: PixelFormat> Texels<C> {
    /// Returns these texels as a texture.
    pub fn texture(&self) -> Result<Texture<'_, Translucent<C>>> {
        Ok(Texture::new(&self.list, self.width, self.height)?)
    }
}
