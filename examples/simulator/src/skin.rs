//! Textures whose size is known only at run time.

use std::fs;
use std::path::Path;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{PixelColor, Rgb565, Rgb888};
use fixel::prelude::*;

use super::Result;
use super::picture::Picture;

/// Exponent of the largest side, in texels.
const MOST_LOG2: u32 = 10;

/// An image with sides that are powers of two.
#[derive(Debug)]
pub struct Skin(Picture);

impl Skin {
    /// Reads a PNG or JPEG and resamples it to the nearest powers of two, up to 1024.
    ///
    /// # Errors
    ///
    /// The file cannot be read or is not a PNG or JPEG.
    pub fn read(path: &Path) -> Result<Self> {
        let refuse = |problem: &dyn std::fmt::Display| {
            format!("cannot read texture {}: {problem}", path.display())
        };
        let bytes = fs::read(path).map_err(|error| refuse(&error))?;
        let picture = Picture::decode(&bytes).map_err(|error| refuse(&error))?;
        Ok(Self(picture.resampled(
            nearest(picture.width),
            nearest(picture.height),
        )))
    }

    /// Returns a texture that is compiled in.
    pub fn of<const W: usize, const H: usize>(texture: &TextureArray<Rgb565, W, H>) -> Self {
        let color = |&texel| Rgb888::from(texel);
        Self(Picture {
            width: u32::try_from(W).unwrap_or(0),
            height: u32::try_from(H).unwrap_or(0),
            colors: texture.texels().as_flattened().iter().map(color).collect(),
        })
    }

    /// 64x64 texels, squares of 8 in two colors.
    pub fn checker() -> Self {
        let color = |at: u32| {
            let (x, y) = (at % 64, at / 64);
            if (x / 8 + y / 8) % 2 == 0 {
                Rgb888::new(255, 255, 240)
            } else {
                Rgb888::new(70, 130, 180)
            }
        };
        Self(Picture {
            width: 64,
            height: 64,
            colors: (0..64 * 64).map(color).collect(),
        })
    }

    /// Returns the texels in the color `C`.
    pub fn texels<C: Levels>(&self) -> Texels<C> {
        let color = |&color| C::from_rgb(color, Point::zero());
        Texels {
            list: self.0.colors.iter().map(color).collect(),
            width: self.0.width,
            height: self.0.height,
        }
    }
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
