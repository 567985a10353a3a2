//! Textures whose size is known only at run time.

use std::fs;
use std::path::Path;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{PixelColor, Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

use super::Result;
use fixel_assets::{Image, Picture};

/// Exponent of the largest side, in texels.
const MOST_LOG2: u32 = 10;

/// An image with sides that are powers of two.
#[derive(Debug)]
pub struct Skin {
    picture: Picture,
    /// Width and height before it was resampled.
    original: (u32, u32),
}

impl Skin {
    /// Reads the picture at `path`; see [`decode`](Self::decode).
    ///
    /// # Errors
    ///
    /// The file cannot be read, or has an unknown format.
    pub fn read(path: &Path) -> Result<Self> {
        let refuse = |problem: &dyn std::fmt::Display| {
            format!("cannot read texture {}: {problem}", path.display())
        };
        let bytes = fs::read(path).map_err(|error| refuse(&error))?;
        Ok(Self::decode(&bytes).map_err(|problem| refuse(&problem))?)
    }

    /// Reads an image of a model, with its texels multiplied by a material's color.
    ///
    /// # Errors
    ///
    /// As for [`read`](Self::read).
    pub fn of_model(image: &Image, color: [u8; 3]) -> Result<Self> {
        let mut skin = match image {
            Image::File(path) => Self::read(path)?,
            Image::Bytes(name, bytes) => Self::decode(bytes)
                .map_err(|problem| format!("cannot read texture {name}: {problem}"))?,
        };
        if color != [255; 3] {
            for [r, g, b, _] in &mut skin.picture.pixels {
                [*r, *g, *b] = times([*r, *g, *b], color);
            }
        }
        Ok(skin)
    }

    /// Decodes a picture and resamples it to the nearest powers of two, up to 1024.
    fn decode(bytes: &[u8]) -> Result<Self, String> {
        let picture = Picture::decode(bytes)?;
        let (width, height) = (picture.width, picture.height);
        Ok(Self {
            picture: picture.resampled(nearest(width), nearest(height)),
            original: (width, height),
        })
    }

    /// Makes a skin from a picture without resampling it.
    fn whole(picture: Picture) -> Self {
        Self {
            original: (picture.width, picture.height),
            picture,
        }
    }

    /// Returns the number of texels per texel of the given image, along the side where this number is smaller.
    pub fn resampled(&self) -> f64 {
        let ratio = |now: u32, original: u32| f64::from(now) / f64::from(original);
        ratio(self.picture.width, self.original.0).min(ratio(self.picture.height, self.original.1))
    }

    /// Returns the larger side of the given image, in texels.
    pub fn side(&self) -> f64 {
        self.original.0.max(self.original.1).into()
    }

    /// Makes a skin from a texture that is compiled in.
    pub fn of<const W: usize, const H: usize>(texture: &TextureArray<Rgb565, W, H>) -> Self {
        let color = |&texel| {
            let color = Rgb888::from(texel);
            [color.r(), color.g(), color.b(), 255]
        };
        Self::whole(Picture {
            width: u32::try_from(W).unwrap_or(0),
            height: u32::try_from(H).unwrap_or(0),
            pixels: texture.texels().as_flattened().iter().map(color).collect(),
            table: None,
        })
    }

    /// A checker of 64x64 texels, with squares of 8x8 texels in two colors.
    pub fn checker() -> Self {
        let color = |at: u32| {
            let (x, y) = (at % 64, at / 64);
            if (x / 8 + y / 8) % 2 == 0 {
                [255, 255, 240, 255]
            } else {
                [70, 130, 180, 255]
            }
        };
        Self::whole(Picture {
            width: 64,
            height: 64,
            pixels: (0..64 * 64).map(color).collect(),
            table: None,
        })
    }

    /// Returns the size, and the texels row by row from the top.
    pub fn rows(&self) -> ((u32, u32), impl DoubleEndedIterator<Item = &[[u8; 4]]>) {
        let Picture {
            width,
            height,
            ref pixels,
            ..
        } = self.picture;
        ((width, height), pixels.chunks_exact(width.max(1) as usize))
    }

    /// Returns the texels in the color `C`.
    pub fn texels<C: Levels>(&self) -> Texels<C> {
        let color = |&[r, g, b, _]: &[u8; 4]| C::from_rgb(Rgb888::new(r, g, b), Point::zero());
        Texels {
            list: self.picture.pixels.iter().map(color).collect(),
            width: self.picture.width,
            height: self.picture.height,
        }
    }
}

/// The product of two colors, as fractions.
pub fn times(a: [u8; 3], b: [u8; 3]) -> [u8; 3] {
    [0, 1, 2].map(|at| {
        let product = u16::from(a[at]) * u16::from(b[at]);
        #[allow(clippy::cast_possible_truncation)] // at most 255
        let rounded = ((product + 127) / 255) as u8;
        rounded
    })
}

/// Returns the power of two that is nearest by ratio, at most 1024.
fn nearest(side: u32) -> u32 {
    let exponent = f64::from(side).log2().round();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a side's logarithm
    let exponent = (exponent as u32).min(MOST_LOG2);
    1 << exponent
}

/// Texels in one list.
#[derive(Debug)]
pub struct Texels<C> {
    list: Vec<C>,
    width: u32,
    height: u32,
}

impl<C: PixelColor> Texels<C> {
    /// Returns these texels as a texture.
    pub fn texture(&self) -> Result<Texture<'_, C>> {
        Ok(Texture::new(&self.list, self.width, self.height)?)
    }
}
