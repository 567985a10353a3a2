//! The colors of vertices in flash.

use embedded_graphics::pixelcolor::Rgb565;
use fixel::shade::{Illumination, Output, PreciseOf, Within};
use fixel::{Fragment, Primitive, Shader};

/// The colors of a model's vertices: red, green and blue. (A mesh's own colors, of `Rgb888`, cannot be borrowed from
/// words without `unsafe`.)
#[derive(Clone, Copy, Debug)]
pub struct Colors<'a> {
    pub(crate) values: &'a [[u8; 3]],
    /// Indices of values for each face; if empty, values are indexed like positions.
    pub(crate) faces: &'a [[u16; 3]],
}

impl<'a> Colors<'a> {
    /// A surface, multiplied by these colors as [`Shader::tinted`] would.
    #[must_use]
    pub const fn over<S>(self, surface: S) -> Tinted<'a, S> {
        let colors = self;
        Tinted { surface, colors }
    }

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

/// A surface times the colors of vertices.
#[derive(Clone, Copy, Debug)]
pub struct Tinted<'a, S> {
    surface: S,
    colors: Colors<'a>,
}

impl<S: Shader<Color: Output<Color = Rgb565>>> Shader for Tinted<'_, S> {
    type Color = PreciseOf<S>;
    type Varyings = (S::Varyings, Within<64, [i32; 3]>);

    const READS_DEPTH: bool = S::READS_DEPTH;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let inner = self.surface.varyings(primitive);
        let indices = primitive.corners(|corner| usize::from(corner.index()));
        [0, 1, 2].map(|at| {
            let tint = self.colors.fractions(primitive.face(), at, indices[at]);
            (inner[at], Within(tint))
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
        Some(self.surface.shade(at, inner)?.lit(light))
    }
}
