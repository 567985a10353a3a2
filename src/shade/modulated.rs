//! Texture times vertex colour.

use super::levels::{Channels, FRACTION, Levels, all, first};
use super::{Addressing, Filter, Fragment, Nearest, Repeat, Sampler, Shader, Textured};
use crate::mesh::{Corner, Face};
use crate::span::Tolerance;

/// A texel times the interpolated vertex colour, channel by channel; a white vertex leaves the
/// texture as it is, a black one makes it black. Made by [`Textured::modulated`].
///
/// Varyings are column and row, then the vertex colour's fractions (65,536 is 1): three, or one for a grey texture.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, Rgb888, RgbColor}};
/// use fixel::prelude::*;
/// static SKIN: TextureArray<Rgb565, 2, 1> = TextureArray::from_texels([[Rgb565::YELLOW, Rgb565::BLUE]]);
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(fx!(-1), fx!(1), fx!(-1), fx!(1), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::BLACK; 8];
/// let mut canvas = Canvas::new(&mut pixels, 4, 2)?;
/// // Under red, yellow is red and blue is black.
/// let mesh = SQUARE.with_colors(&[Rgb888::RED; 4], None)?;
/// canvas.draw(&mesh, &mvp, &Textured::new(&SKIN).modulated());
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["RRKK", "RRKK"]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Modulated<S, A = Repeat, F = Nearest> {
    texture: Textured<S, A, F>,
}

impl<S: Sampler, A: Addressing, F> Modulated<S, A, F> {
    pub(super) const fn new(texture: Textured<S, A, F>) -> Self {
        Self { texture }
    }
}

/// One implementation per number of channels: their sum with the coordinates cannot be computed in a type.
macro_rules! modulated {
    ($n:literal $channels:literal $($channel:ident)+) => {
        impl<S: Sampler, A: Addressing, F: Filter<S::Color>> Shader<$n> for Modulated<S, A, F>
        where
            S::Color: Channels<$channels>,
        {
            type Color = S::Color;

            const TOLERANCES: [Tolerance; $n] = [
                Tolerance::Texels,
                Tolerance::Texels,
                $({
                    let $channel = FRACTION;
                    $channel
                }),+
            ];

            #[inline]
            fn varyings(&self, vertex: &Corner<'_>) -> [i32; $n] {
                let [u, v] = self.texture.coordinates(vertex);
                let [$($channel),+] = first(S::Color::fractions(vertex.color()));
                [u, v, $($channel),+]
            }

            #[inline]
            fn face(self, corners: &mut [[i32; $n]; 3], face: &Face<'_>) -> Self {
                self.texture.place(corners, face);
                self
            }

            #[inline]
            fn shade(&self, sample: &Fragment, [u, v, $($channel),+]: [i32; $n]) -> Option<S::Color> {
                let texel = self.texture.color(u, v);
                Some(texel.filtered(all([$($channel),+]), sample.point))
            }
        }
    };
}

modulated!(5 3 r g b);
modulated!(3 1 l);

#[cfg(test)]
mod tests {
    use super::super::Converted;
    use super::super::trial::{IDENTITY, count, face, shade};
    use super::*;
    use crate::texture::TextureArray;
    use crate::{Mesh, Vec3, vec2};
    use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888, RgbColor};

    static POSITIONS: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

    #[test]
    fn texels_are_filtered_by_the_vertex_colour() {
        let skin = TextureArray::from_texels([[Rgb565::WHITE, Rgb565::new(20, 21, 22)]]);
        let uvs = [vec2!(7.5, 0), vec2!(7.5, 0), vec2!(7, 0)];
        let colors = [
            Rgb888::WHITE,
            Rgb888::new(255, 0, 128),
            Rgb888::new(0, 128, 255),
        ];
        let mesh = Mesh::new(&POSITIONS, &[[0, 1, 2]])
            .and_then(|mesh| mesh.with_uvs(&uvs, None)?.with_colors(&colors, None))
            .unwrap();
        let (shader, corners) = face(Textured::new(&skin).modulated(), &IDENTITY, &mesh, 0);
        assert_eq!(corners[0], [1 << 16, 0, 1 << 16, 1 << 16, 1 << 16]);
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
    fn the_number_of_varyings_follows_from_the_colour() {
        let skin = TextureArray::from_texels([[Rgb565::WHITE]]);
        let shader = Textured::new(&skin).modulated();
        assert_eq!(count(&shader), 5);
        assert_eq!(count(&Converted::<_, BinaryColor>::new(shader)), 5);
        let skin = TextureArray::from_texels([[Gray8::new(200)]]);
        let shader = Textured::new(&skin).clamped().modulated();
        assert_eq!(count(&shader), 3);
        assert_eq!(shade(&shader, [0, 0, 1 << 15]), Gray8::new(100));
    }
}
