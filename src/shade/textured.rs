//! Textured surfaces: which texels a pixel shows.

use core::marker::PhantomData;

use super::{Fragment, Masked, Shader, Texel, Texels};
use embedded_graphics::pixelcolor::{GrayColor, PixelColor};

use crate::mesh::Primitive;
use crate::texture::{
    Addressing, Bilinear, Blend, Clamp, CutOut, Filter, Nearest, Repeat, Sampler, texels,
};
use crate::{Error, Vec2};

/// A texture: each pixel shows the texel nearest to its center, or a blend of the four around it
/// ([`bilinear`](Self::bilinear)).
///
#[cfg_attr(doc, doc = page_picture!("textured", "A cube with checkers"))]
/// The texture repeats, or is [`clamped`](Self::clamped) to its edge. It may be [`lit`](Shader::lit), or
/// [`tinted`](Shader::tinted) by vertex colors.
///
/// The varyings are a column and a row, in texels with 16 fraction bits. Along a side of 16 or more texels, they hold
/// the texture coordinates exactly; along a shorter side, they are rounded to nearest. Their range is ±32,768 texels
/// (128 repeats of 256 texels, 8 of 4096); beyond it, they saturate. If the texture repeats, a triangle is first moved
/// by whole repeats so that it begins in the first one. So the range limits only the extent of a triangle, not its
/// place in the texture. Lines and points are not moved.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray8, GrayColor}};
/// use fixel::prelude::*;
/// static SKIN: TextureArray<Gray8, 2, 2> = TextureArray::gray8(&[0x11, 0x22, 0x33, 0x44]);
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray8::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 4, 4)?;
/// canvas.draw(&SQUARE, &mvp, &Textured::new(&SKIN));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["1122", "1122", "3344", "3344"]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Textured<S, A = Repeat, F = Nearest> {
    sampler: S,
    addressing: PhantomData<A>,
    filter: F,
}

impl<S: Sampler> Textured<S> {
    /// A shader of a repeating texture. The argument is usually a reference to a [`Texture`](crate::Texture).
    #[must_use]
    pub const fn new(sampler: S) -> Self {
        Self::of(sampler, Nearest)
    }
}

impl<S, A, F> Textured<S, A, F> {
    const fn of(sampler: S, filter: F) -> Self {
        Self {
            sampler,
            addressing: PhantomData,
            filter,
        }
    }

    /// The texture.
    #[inline]
    pub(super) const fn sampler(&self) -> &S {
        &self.sampler
    }
}

impl<S: Sampler, F: Copy> Textured<S, Repeat, F> {
    /// Clamps the texture to its edge instead of repeating it.
    #[must_use]
    pub const fn clamped(self) -> Textured<S, Clamp, F> {
        Textured::of(self.sampler, self.filter)
    }
}

impl<S: Sampler, A: Addressing> Textured<S, A> {
    /// Blends the four texels around each pixel; [`Bilinear`] describes accuracy and cost.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray8, GrayColor}};
    /// use fixel::prelude::*;
    /// static SKIN: TextureArray<Gray8, 2, 2> = TextureArray::gray8(&[0x00, 0x88, 0x88, 0xff]);
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [Gray8::BLACK; 64];
    /// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
    /// // Eight pixels show two texels: four from center to center, and two from each center to the edge.
    /// canvas.draw(&SQUARE, &mvp, &Textured::new(&SKIN).clamped().bilinear());
    /// let shown: Vec<u8> = pixels.iter().map(|pixel| pixel.luma()).collect();
    /// assert_eq!(shown[..8], [0, 0, 17, 51, 85, 119, 136, 136]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn bilinear(self) -> Textured<S, A, Bilinear>
    where
        S::Color: Blend,
    {
        Textured::of(self.sampler, Bilinear)
    }
}

impl<S: Sampler<Color: PixelColor>, A: Addressing, F> Textured<S, A, F> {
    /// Gives each texel the opacity that a gray texture of the same size, the mask, has there: white is opaque, and
    /// black leaves both color and depth of the canvas as they were.
    ///
    /// A bilinear filter blends colors and opacities separately, so give invisible texels the colors of their
    /// neighbors.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use fixel::{prelude::*, texture::PackedGray4};
    /// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[200, 200]);
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let mask = PackedGray4::new(&[0x3f], 2, 1)?; // a fifth, and the whole
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [Gray8::new(100); 2];
    /// let mut canvas = Canvas::new(&mut pixels, 2, 1)?;
    /// canvas.draw(&SQUARE, &mvp, &Textured::new(&SKIN).masked(&mask)?);
    /// assert_eq!(pixels, [Gray8::new(120), Gray8::new(200)]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::MaskSize`] if the sizes differ.
    pub fn masked<M: Sampler<Color: GrayColor>>(
        self,
        mask: M,
    ) -> Result<Textured<Masked<S, M>, A, F>, Error> {
        let sampler = Masked::new(self.sampler, mask)?;
        Ok(Textured::of(sampler, self.filter))
    }
}

impl<S: Sampler, A: Addressing, F: Filter<S::Color>> Textured<S, A, F> {
    /// Leaves out the texels of exactly this color, for example around fences, leaves and sprites. In these places,
    /// both color and depth of the canvas stay as they were.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
    /// use fixel::prelude::*;
    /// static FENCE: TextureArray<Rgb565, 2, 1> =
    ///     TextureArray::from_texels([[Rgb565::GREEN, Rgb565::MAGENTA]]);
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [Rgb565::BLUE; 8];
    /// let mut canvas = Canvas::new(&mut pixels, 4, 2)?;
    /// canvas.draw(&SQUARE, &mvp, &Textured::new(&FENCE).cut_out(Rgb565::MAGENTA));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&["GGBB", "GGBB"]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn cut_out(self, key: S::Color) -> Textured<S, A, CutOut<F, S::Color>> {
        let filter = self.filter;
        Textured::of(self.sampler, CutOut { filter, key })
    }
}

impl<S: Sampler<Color: Texel>, A: Addressing, F: Filter<S::Color>> Shader for Textured<S, A, F> {
    type Color = <S::Color as Texel>::Source;
    type Varyings = Texels;

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Texels; 3] {
        let [a, b, c] = primitive.uvs().map(Vec2::to_bits);
        let coordinates = |bits: [i32; 3], log2| {
            let is_face = primitive.is_face();
            texels(bits, if is_face { A::origin(bits) } else { 0 }, log2)
        };
        let [width, height] = self.sampler.size_log2();
        let us = coordinates([a[0], b[0], c[0]], width);
        let vs = coordinates([a[1], b[1], c[1]], height);
        [
            Texels([us[0], vs[0]]),
            Texels([us[1], vs[1]]),
            Texels([us[2], vs[2]]),
        ]
    }

    #[inline]
    fn shade(&self, _: &Fragment, Texels(at): Texels) -> Option<Self::Color> {
        self.filter.color::<S, A>(&self.sampler, at)?.source()
    }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::{IDENTITY, edge, face, shade};
    use super::*;
    use crate::texture::TextureArray;
    use crate::{Mesh, Vec3, vec2};
    use embedded_graphics::pixelcolor::{Gray8, GrayColor};

    /// Four columns and two rows; a texel is its column plus ten times its row.
    static SKIN: TextureArray<Gray8, 4, 2> = TextureArray::gray8(&[0, 1, 2, 3, 10, 11, 12, 13]);
    static POSITIONS: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

    fn mesh(uvs: &[Vec2; 3]) -> Mesh<'_> {
        Mesh::new(&POSITIONS, &[[0, 1, 2]])
            .and_then(|mesh| mesh.with_edges(&[[0, 1]]))
            .and_then(|mesh| mesh.with_uvs(uvs, None))
            .unwrap()
    }

    fn corners<S: Sampler<Color: Texel>, A: Addressing>(
        skin: Textured<S, A>,
        uvs: [Vec2; 3],
    ) -> [[i32; 2]; 3] {
        face(skin, &IDENTITY, &mesh(&uvs), 0).1.map(|Texels(at)| at)
    }

    #[test]
    fn coordinates_are_exact_in_texels() {
        // 12 and 24 units of 2^-20 repeat are 3 · 2^-16 texels each, of four columns and of two rows.
        let uvs = [vec2!(0, 0), vec2!(0.25, 1), Vec2::from_bits([12, 24])];
        let expected = [[0, 0], [1 << 16, 2 << 16], [3, 3]];
        assert_eq!(corners(Textured::new(&SKIN), uvs), expected);
        assert_eq!(corners(Textured::new(&SKIN).clamped(), uvs), expected);
        let ends = edge(Textured::new(&SKIN), &mesh(&uvs), 0);
        assert_eq!(ends.map(|Texels(at)| at), expected[..2]);
    }

    #[test]
    fn far_triangles_are_moved_by_whole_repeats() {
        let near = [vec2!(0.25, 0.5), vec2!(1.5, 0.75), vec2!(0.5, 2)];
        for (u, v) in [(1, 1), (-1, 0), (2000, -2048), (-2048, 2045)] {
            let far = near.map(|uv| {
                let [x, y] = uv.to_bits();
                Vec2::from_bits([x + (u << 20), y + (v << 20)])
            });
            assert_eq!(
                corners(Textured::new(&SKIN), far),
                corners(Textured::new(&SKIN), near),
                "{u}, {v}"
            );
        }
        // A triangle that begins left of the first repeat begins in it afterwards.
        let [a, b, _] = corners(
            Textured::new(&SKIN),
            [vec2!(-0.25, -1), vec2!(0.25, 0), vec2!(0, 0)],
        );
        assert_eq!([a, b], [[3 << 16, 0], [5 << 16, 2 << 16]]);
    }

    #[test]
    fn extremes_saturate() {
        static WIDE: [[Gray8; 256]; 64] = [[Gray8::new(0); 256]; 64];
        let (low, high) = (i32::MIN, i32::MAX);
        let uvs = [[low, high], [high, low], [0, 0]].map(Vec2::from_bits);
        let skin = Textured::new(&WIDE);
        let repeated = corners(skin, uvs);
        assert_eq!(repeated, [[0, high], [high, 0], [high, high]]);
        let clamped = corners(skin.clamped(), uvs);
        assert_eq!(clamped, [[low, high], [high, low], [0, 0]]);
        let line = edge(skin, &mesh(&uvs), 0);
        assert_eq!(line.map(|Texels(at)| at), clamped[..2]);
    }

    #[test]
    fn texels_repeat_or_clamp() {
        let at = |u: i32, v: i32| {
            let at = [u << 14, v << 14]; // in quarters
            let repeated = shade(&Textured::new(&SKIN), Texels(at)).luma();
            let clamped = shade(&Textured::new(&SKIN).clamped(), Texels(at)).luma();
            [repeated, clamped]
        };
        assert_eq!(at(0, 0), [0, 0]);
        assert_eq!(at(15, 7), [13, 13]);
        assert_eq!(at(16, 8), [0, 13]);
        assert_eq!(at(-1, -1), [13, 0]);
        assert_eq!(at(-17, 12), [13, 10]);
        let ends = [i32::MIN, i32::MAX];
        assert_eq!(shade(&Textured::new(&SKIN), Texels(ends)).luma(), 10);
        assert_eq!(
            shade(&Textured::new(&SKIN).clamped(), Texels(ends)).luma(),
            10
        );
    }
}
