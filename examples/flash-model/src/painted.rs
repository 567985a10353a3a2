//! Surfaces in the colors of vertices, lit from both sides, and with light of their own.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::shade::{Illumination, Lighting, Output, Precise, Within};
use fixel::{Fragment, Primitive};

/// The colors of a model's vertices: red, green and blue. (A mesh's own colors, of `Rgb888`, cannot be borrowed from
/// words without `unsafe`.)
#[derive(Clone, Copy, Debug)]
pub struct Colors<'a> {
    pub(crate) values: &'a [[u8; 3]],
    /// Indices of values for each face; if empty, values are indexed like positions.
    pub(crate) faces: &'a [[u16; 3]],
}

impl Colors<'_> {
    /// The color of a corner as fractions, 0 to 65,536. A corner without a color is white.
    fn fractions(&self, face: Option<usize>, corner: usize, index: usize) -> [i32; 3] {
        let index = match face.and_then(|face| self.faces.get(face)) {
            Some(face) => face[corner].into(),
            None => index,
        };
        let color = self.values.get(index);
        // 65,536/255 = 257 + 1/255
        let fraction = |channel: &u8| i32::from(*channel) * 257 + i32::from(channel >> 7);
        color.map_or([1 << 16; 3], |color| color.each_ref().map(fraction))
    }
}

/// A surface times the colors of vertices and the light, plus the light that the surface sends out.
///
/// The two colors are multiplied at each corner, and only the product is interpolated.
#[derive(Clone, Copy, Debug)]
pub struct Painted<'a, S, L> {
    pub(crate) surface: S,
    pub(crate) colors: Colors<'a>,
    /// The light; `None` for a surface that has its own colors in every light.
    pub(crate) light: Option<L>,
    pub(crate) emission: Rgb888,
}

impl<S, L> Shader for Painted<'_, S, L>
where
    S: Shader<Color: Output<Color = Rgb565, With<Rgb565> = Precise<Rgb565>>>,
    L: Lighting<Diffuse = i32, Specular = ()>,
{
    type Color = Precise<Rgb565>;
    type Varyings = (S::Varyings, Within<64, [i32; 3]>);

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let inner = self.surface.varyings(primitive);
        let indices = primitive.corners(|corner| usize::from(corner.index()));
        let white = Flat::<Rgb565>::rgb(Rgb888::WHITE);
        let lights = self.light.map(|light| white.lit(light).varyings(primitive));
        [0, 1, 2].map(|at| {
            let tint = (self.colors).fractions(primitive.face(), at, indices[at]);
            let lit = lights.map_or(tint, |lights| {
                let ((), Within((light, ()))) = lights[at];
                // Tint and light are at most 2^16.
                tint.map(|tint| ((i64::from(tint) * i64::from(light)) >> 16) as i32)
            });
            (inner[at], Within(lit))
        })
    }

    #[inline]
    fn shade(
        &self,
        at: &Fragment,
        (inner, Within(diffuse)): Self::Varyings,
    ) -> Option<Self::Color> {
        let specular = ();
        let light = Illumination { diffuse, specular };
        let lit = self.surface.shade(at, inner)?.lit(light);
        if self.emission == Rgb888::BLACK {
            return Some(lit);
        }
        Some(lit.plus(Precise::of_rgb(self.emission)))
    }
}
