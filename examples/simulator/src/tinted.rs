//! A shader for a texture with both colored lights and vertex colors.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::shade::{Channels, Flat, Illumination, Levels, Lighting, Matte, Rgb, Within};
use fixel::{Fragment, Primitive, Shader};

/// A surface times the colors of the vertices times the light.
///
/// The library's `surface.tinted().lit(light)` interpolates both colors, which takes six numbers. This shader
/// multiplies them at each corner, and interpolates the three products. This leaves room for a texture and fog among
/// the eight numbers that are allowed.
#[derive(Clone, Copy)]
pub struct TintedLit<S, L> {
    pub surface: S,
    pub light: L,
}

impl<C, S, L> Shader for TintedLit<S, L>
where
    C: Levels,
    S: Shader<Color = C>,
    L: Lighting<Diffuse = Rgb, Specular = Matte>,
{
    type Color = C;
    type Varyings = (S::Varyings, Within<64, C::Channels>);

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let white = Flat::<C>::rgb(Rgb888::WHITE);
        let tints = white.tinted().varyings(primitive);
        let lights = white.lit(self.light).varyings(primitive);
        let mut varyings = self
            .surface
            .varyings(primitive)
            .map(|inside| (inside, Within(C::Channels::default())));
        for ((to, ((), Within(tint))), ((), Within((light, ())))) in
            varyings.iter_mut().zip(tints).zip(lights)
        {
            let (tint, light) = (tint.all(), light.all());
            // At most 2^16 each.
            let product = [0, 1, 2].map(|at| {
                let product = i64::from(tint[at]) * i64::from(light[at]);
                (product >> 16) as i32
            });
            to.1 = Within(C::Channels::first(product));
        }
        varyings
    }

    fn shade(&self, at: &Fragment, (inside, Within(light)): Self::Varyings) -> Option<C> {
        let light = Illumination {
            diffuse: light.all(),
            specular: None,
        };
        self.surface.shade_lit(at, inside, light)
    }
}
