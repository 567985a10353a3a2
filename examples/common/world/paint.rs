//! Surfaces in the baked light, and in haze.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::mesh::Corner;
use fixel::prelude::*;
use fixel::shade::{PerFace, Within};
use fixel::{Fragment, Primitive};

/// A texture in the light of its vertices' colors. Far away, this light turns into `HAZE`. Both are mixed at the
/// vertices, so that a pixel takes one multiplication for each channel.
#[derive(Clone, Copy, Debug)]
pub struct Painted<S>(pub S);

/// The light of thick air, which begins `NEAR` from the eye, and hides everything after another `DEPTH`.
const HAZE: [i32; 3] = [130, 104, 150];
const NEAR: Scalar = fx!(3);
const DEPTH: Scalar = fx!(33);

/// The light at a corner, in haze. The products are fractions in units of 2^-16.
fn light_at(corner: &Corner<'_>) -> [i32; 3] {
    let (light, far) = (corner.color(), corner.distance() - NEAR);
    let haze = far.clamp(fx!(0), DEPTH).to_bits() / (DEPTH.to_bits() >> 8);
    let light = [light.r(), light.g(), light.b()].map(i32::from);
    [0, 1, 2].map(|at| light[at] * (256 - haze) + HAZE[at] * haze)
}

/// A texel in a light.
#[inline]
fn lit(texel: Rgb565, [r, g, b]: [i32; 3]) -> Rgb565 {
    let times = |channel: u8, light: i32| ((i32::from(channel) * light + 0x8000) >> 16) as u8;
    Rgb565::new(
        times(texel.r(), r),
        times(texel.g(), g),
        times(texel.b(), b),
    )
}

impl<S: Shader<Color = Rgb565>> Shader for Painted<S> {
    type Color = Rgb565;
    type Varyings = (S::Varyings, Within<2048, [i32; 3]>);

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let inner = self.0.varyings(primitive);
        let lights = primitive.corners(light_at);
        [0, 1, 2].map(|at| (inner[at], Within(lights[at])))
    }

    #[inline]
    fn shade(&self, at: &Fragment, (inner, Within(light)): Self::Varyings) -> Option<Rgb565> {
        Some(lit(self.0.shade(at, inner)?, light))
    }
}

/// The same for a small surface, such as a plant: all of it has the light of its first corner.
#[derive(Clone, Copy, Debug)]
pub struct Evenly<S>(pub S);

impl<S: Shader<Color = Rgb565>> Shader for Evenly<S> {
    type Color = Rgb565;
    type Varyings = (S::Varyings, PerFace<[i32; 3]>);

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let lights = primitive.corners(light_at);
        (self.0.varyings(primitive)).map(|inner| (inner, PerFace(lights[0])))
    }

    #[inline]
    fn shade(&self, at: &Fragment, (inner, PerFace(light)): Self::Varyings) -> Option<Rgb565> {
        Some(lit(self.0.shade(at, inner)?, light))
    }
}
