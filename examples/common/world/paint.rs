//! Surfaces in the baked light, and in haze.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::prelude::*;
use fixel::shade::Within;
use fixel::{Fragment, Primitive};

/// A texture in the light of its vertices' colors. Far away, this light turns into `HAZE`. Both are mixed at the
/// vertices, so that a pixel takes one multiplication for each channel.
#[derive(Clone, Copy, Debug)]
pub struct Painted<S>(pub S);

/// The light of thick air, which begins `NEAR` from the eye, and hides everything after another `DEPTH`.
const HAZE: [i32; 3] = [130, 104, 150];
const NEAR: Scalar = fx!(3);
const DEPTH: Scalar = fx!(33);

impl<S: Shader<Color = Rgb565>> Shader for Painted<S> {
    type Color = Rgb565;
    /// Fractions in units of 2^-16.
    type Varyings = (S::Varyings, Within<2048, [i32; 3]>);

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let inner = self.0.varyings(primitive);
        let lights = primitive.corners(|corner| {
            let (light, far) = (corner.color(), corner.distance() - NEAR);
            let haze = far.clamp(fx!(0), DEPTH).to_bits() / (DEPTH.to_bits() >> 8);
            let light = [light.r(), light.g(), light.b()].map(i32::from);
            [0, 1, 2].map(|at| light[at] * (256 - haze) + HAZE[at] * haze)
        });
        [0, 1, 2].map(|at| (inner[at], Within(lights[at])))
    }

    #[inline]
    fn shade(&self, at: &Fragment, (inner, Within(light)): Self::Varyings) -> Option<Rgb565> {
        let texel = self.0.shade(at, inner)?;
        let [r, g, b] = light;
        let times = |channel: u8, light: i32| ((i32::from(channel) * light + 0x8000) >> 16) as u8;
        Some(Rgb565::new(
            times(texel.r(), r),
            times(texel.g(), g),
            times(texel.b(), b),
        ))
    }
}
