//! A surface times vertex colors.

use super::format::FRACTION;
use super::{
    Channels, ColorOf, Fragment, Illumination, Output, PixelFormat, PreciseOf, Shader, Within,
};
use crate::mesh::Primitive;

/// A surface times the interpolated vertex color, channel by channel; see [`Shader::tinted`].
///
#[cfg_attr(doc, doc = page_picture!("tinted", "A cube with checkers, multiplied by the colors of its corners"))]
/// A white vertex leaves the surface as it is, a black vertex makes it black.
///
/// The fractions of the vertex color (65,536 is 1) are varyings that follow the surface's own: three, or one for a gray
/// surface.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, Rgb888, RgbColor}};
/// use fixel::prelude::*;
/// static SKIN: [[Rgb565; 2]; 1] = [[Rgb565::YELLOW, Rgb565::BLUE]];
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::BLACK; 8];
/// let mut canvas = Canvas::new(&mut pixels, 4, 2)?;
/// // Under red, yellow is red and blue is black.
/// let mesh = SQUARE.with_colors(&[Rgb888::RED; 4], None)?;
/// canvas.draw(&mesh, &mvp, &Textured::new(&SKIN).tinted());
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["RRKK", "RRKK"]);
/// # Ok::<(), Error>(())
/// ```
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
            specular: None,
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
