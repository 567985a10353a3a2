//! A surface times vertex colors.

use super::format::FRACTION;
use super::{
    Channels, ColorOf, Fragment, Illumination, Output, PixelFormat, PreciseOf, Shader, Within,
};
use crate::mesh::Primitive;

/// A surface times the interpolated vertex color, channel by channel; see [`Shader::tinted`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Tinted<S> {
    pub(super) surface: S,
}

impl<S: Shader<Color: Output<Color: PixelFormat>>> Shader for Tinted<S> {
    type Color = PreciseOf<S>;
    type Varyings = (
        S::Varyings,
        Within<FRACTION, <ColorOf<S> as PixelFormat>::Channels>,
    );

    const READS_DEPTH: bool = S::READS_DEPTH;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let [a, b, c] = self.surface.varyings(primitive);
        let [x, y, z] = primitive.corners(|corner| {
            let fractions = ColorOf::<S>::fractions(corner.color());
            Within(Channels::first(fractions))
        });
        [(a, x), (b, y), (c, z)]
    }

    #[inline]
    fn shade(&self, at: &Fragment, (inside, Within(tint)): Self::Varyings) -> Option<PreciseOf<S>> {
        let tint = Illumination {
            diffuse: tint.all(),
            specular: (),
        };
        Some(self.surface.shade(at, inside)?.lit(tint))
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::{IDENTITY, count, face, shade};
    use super::super::{Converted, Textured};
    use super::*;
    use crate::{Mesh, Vec3, vec2};
    use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888, RgbColor};

    static POSITIONS: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

    #[test]
    fn texels_are_filtered_by_the_vertex_color() {
        let skin = [[Rgb565::WHITE, Rgb565::new(20, 21, 22)]];
        let uvs = [vec2!(7.5, 0), vec2!(7.5, 0), vec2!(7, 0)];
        let colors = [
            Rgb888::WHITE,
            Rgb888::new(255, 0, 128),
            Rgb888::new(0, 128, 255),
        ];
        let mesh = Mesh::new(&POSITIONS, &[[0, 1, 2]])
            .and_then(|mesh| mesh.with_uvs(&uvs, None)?.with_colors(&colors, None))
            .unwrap();
        let (shader, corners) = face(Textured::new(&skin).tinted(), &IDENTITY, &mesh, 0);
        let (numbers, _) = super::super::Varyings::split(corners[0]);
        assert_eq!(numbers, [1 << 16, 0, 1 << 16, 1 << 16, 1 << 16]);
        assert_eq!(
            corners.map(|corner| shade(&shader, corner)),
            [
                Rgb565::new(20, 21, 22),
                Rgb565::new(20, 0, 11),
                Rgb565::new(0, 32, 31)
            ]
        );
    }

    #[test]
    fn the_color_decides_the_number_of_varyings() {
        let skin = [[Rgb565::WHITE]];
        let shader = Textured::new(&skin).tinted();
        assert_eq!(count(&shader), 5);
        assert_eq!(count(&Converted::<_, BinaryColor>::new(shader)), 5);
        let skin = [[Gray8::new(200)]];
        let shader = Textured::new(&skin).clamped().tinted();
        assert_eq!(count(&shader), 3);
        let (texels, one) = (super::super::Texels([0, 0]), Within([1 << 15]));
        assert_eq!(shade(&shader, (texels, one)), Gray8::new(100));
    }
}
