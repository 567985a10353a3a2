//! The shaders of the cases, for the crate and for the model.

use embedded_graphics::pixelcolor::{Rgb565, WebColors};
use fixel::canvas::DepthBuffer;
use fixel::prelude::*;

use super::Result;
use super::scenes;
use super::texture::checkered;

/// The shader of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surface {
    /// The checkered texture of the measured scenes, with a depth buffer.
    Checkered,
    /// Colors at the corners, with a depth buffer.
    Shaded,
    /// A color for each triangle, without a depth buffer.
    Faceted,
    /// A checkered texture with this many texels along a side, without a depth buffer.
    Texture(Side),
}

/// The side of a texture, in texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    T16,
    T64,
    T256,
    T1024,
}

impl Side {
    pub const ALL: [Self; 4] = [Self::T16, Self::T64, Self::T256, Self::T1024];

    pub fn log2(self) -> u32 {
        match self {
            Self::T16 => 4,
            Self::T64 => 6,
            Self::T256 => 8,
            Self::T1024 => 10,
        }
    }
}

/// The canvas of the cases.
pub type Target<'a, D> = Canvas<'a, Rgb565, Native, D>;

/// Code that needs a canvas and a shader.
pub trait Job {
    /// Runs with the canvas and the shader.
    fn run<D: DepthBuffer, F: ShaderFor<Rgb565>>(
        self,
        canvas: &mut Target<'_, D>,
        shader: &F,
    ) -> Result<()>;
}

impl Surface {
    /// Runs a job with a canvas of this size and with this shader.
    pub fn give(self, (width, height): (u32, u32), job: impl Job) -> Result<()> {
        let mut colors = vec![Rgb565::default(); width as usize * height as usize];
        let mut depths = vec![0; colors.len()];
        let mut flat = Canvas::new(&mut colors, width, height)?;
        match self {
            Self::Checkered => job.run(&mut flat.with_depth(&mut depths)?, &scenes::checkered()),
            Self::Shaded => job.run(&mut flat.with_depth(&mut depths)?, &scenes::shaded()),
            Self::Faceted => job.run(&mut flat, &scenes::faceted()),
            Self::Texture(Side::T16) => checkered::<16, _>(|skin| job.run(&mut flat, &skin)),
            Self::Texture(Side::T64) => checkered::<64, _>(|skin| job.run(&mut flat, &skin)),
            Self::Texture(Side::T256) => checkered::<256, _>(|skin| job.run(&mut flat, &skin)),
            Self::Texture(Side::T1024) => checkered::<1024, _>(|skin| job.run(&mut flat, &skin)),
        }
    }

    /// Whether the case can be drawn again over itself. With a depth buffer, the second drawing would be hidden.
    pub fn may_repeat(self) -> bool {
        matches!(self, Self::Faceted | Self::Texture(_))
    }

    /// Returns the model's color on a face for u and v, and for red, green and blue from 0 to 255.
    pub fn model(self, face: usize, [u, v, r, g, b]: [f64; 5]) -> Rgb565 {
        // All textures have eight by eight squares. The edges of the squares are edges of texels, too.
        let odd = |at: f64| (at * 8.).floor().rem_euclid(2.) > 0.5;
        match self {
            Self::Shaded => {
                let steps = |value: f64, most: f64| (value / 255. * most).round() as u8;
                Rgb565::new(steps(r, 31.), steps(g, 63.), steps(b, 31.))
            }
            Self::Faceted => scenes::FACE_COLORS[face],
            _ if odd(u) == odd(v) => Rgb565::CSS_IVORY,
            _ => Rgb565::CSS_STEEL_BLUE,
        }
    }
}
