//! Textures whose size is known at run time only.

use std::path::Path;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{PixelColor, Rgb565, Rgb888, RgbColor};
use fixel::mode::Tolerance;
use fixel::prelude::*;
use fixel::shade::Sampler;
use image::imageops::FilterType;
use image::{ImageReader, RgbImage};

use super::Result;

/// Exponent of the largest side, in texels.
const MOST_LOG2: u32 = 10;

/// An image with sides that are powers of two.
#[derive(Debug)]
pub struct Skin(RgbImage);

impl Skin {
    /// Reads a PNG or JPEG and resamples it to the nearest powers of two, up to 1024.
    ///
    /// # Errors
    ///
    /// The file cannot be read or is no such image.
    pub fn read(path: &Path) -> Result<Self> {
        let refuse = |problem: &dyn std::fmt::Display| {
            format!("cannot read texture {}: {problem}", path.display())
        };
        let image = ImageReader::open(path)
            .and_then(ImageReader::with_guessed_format)
            .map_err(|error| refuse(&error))?
            .decode()
            .map_err(|error| refuse(&error))?
            .into_rgb8();
        let (width, height) = image.dimensions();
        if width == 0 || height == 0 {
            return Err(refuse(&format!(
                "it is {width}x{height} pixels: there must be some"
            ))
            .into());
        }
        let sides = (nearest(width), nearest(height));
        Ok(Self(if sides == (width, height) {
            image
        } else {
            image::imageops::resize(&image, sides.0, sides.1, FilterType::Triangle)
        }))
    }

    /// A texture that is compiled in.
    pub fn of<const W: usize, const H: usize>(texture: &Texture<Rgb565, W, H>) -> Self {
        let bytes = texture.texels().as_flattened().iter().flat_map(|&texel| {
            let color = Rgb888::from(texel);
            [color.r(), color.g(), color.b()]
        });
        let side = |side: usize| u32::try_from(side).unwrap_or(0);
        // There are as many bytes as the size needs.
        let image = RgbImage::from_raw(side(W), side(H), bytes.collect());
        Self(image.unwrap_or_default())
    }

    /// 64x64 texels, squares of 8 in two colours.
    pub fn checker() -> Self {
        Self(RgbImage::from_fn(64, 64, |x, y| {
            image::Rgb(if (x / 8 + y / 8) % 2 == 0 {
                [255, 255, 240]
            } else {
                [70, 130, 180]
            })
        }))
    }

    /// The texels in the colour `C`.
    pub fn texels<C: Levels>(&self) -> Texels<C> {
        let (width, height) = self.0.dimensions();
        let color = |&image::Rgb([r, g, b]): &image::Rgb<u8>| {
            C::from_rgb(Rgb888::new(r, g, b), Point::zero())
        };
        Texels {
            list: self.0.pixels().map(color).collect(),
            width_log2: width.ilog2(),
            height_log2: height.ilog2(),
        }
    }
}

/// The power of two that is nearest by ratio, at most 1024.
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
    width_log2: u32,
    height_log2: u32,
}

impl<C> Texels<C> {
    /// A shader of these texels, which thinks that they are 1024x1024.
    pub fn scaled<F>(&self, shader: F) -> Scaled<F> {
        Scaled {
            shader,
            down: [self.width_log2, self.height_log2].map(|log2| MOST_LOG2 - log2),
        }
    }
}

/// Texels of any size, repeated. Columns and rows are given as if there were 1024 of each, and are made
/// those that there are by [`Scaled`].
impl<C: PixelColor> Sampler for &Texels<C> {
    type Color = C;
    const WIDTH_LOG2: u32 = MOST_LOG2;
    const HEIGHT_LOG2: u32 = MOST_LOG2;

    #[inline]
    fn texel(&self, u: i32, v: i32) -> C {
        let inside = |at: i32, log2: u32| at & ((1 << log2) - 1);
        let (u, v) = (inside(u, self.width_log2), inside(v, self.height_log2));
        self.list[((v << self.width_log2) | u).cast_unsigned() as usize]
    }
}

/// A shader whose first two varyings are columns and rows of a texture of 1024x1024, which has
/// fewer: the same colour under each point as if the size were in the type.
#[derive(Clone, Copy, Debug)]
pub struct Scaled<F> {
    shader: F,
    /// Exponents of the ratios of 1024 to the sides.
    down: [u32; 2],
}

impl<F: Shader<N>, const N: usize> Shader<N> for Scaled<F> {
    type Color = F::Color;

    const READS_DEPTH: bool = F::READS_DEPTH;
    const TOLERANCES: [Tolerance; N] = F::TOLERANCES;

    #[inline]
    fn varyings(&self, vertex: &Corner<'_>) -> [i32; N] {
        self.shader.varyings(vertex)
    }

    #[inline]
    fn shade(&self, sample: &Fragment, mut varyings: [i32; N]) -> Option<F::Color> {
        for (varying, down) in varyings.iter_mut().zip(self.down) {
            *varying >>= down;
        }
        self.shader.shade(sample, varyings)
    }

    #[inline]
    fn begin(self, model: &Transform) -> Self {
        let shader = self.shader.begin(model);
        Self { shader, ..self }
    }

    #[inline]
    fn face(self, corners: &mut [[i32; N]; 3], face: &Face<'_>) -> Self {
        let shader = self.shader.face(corners, face);
        Self { shader, ..self }
    }
}
