//! Textured surfaces: which texels a pixel shows.

use core::marker::PhantomData;

use embedded_graphics::pixelcolor::{GrayColor, PixelColor};

use super::{Fragment, Shader, Texel, Texels, Translucent};
use crate::error::Error;
use crate::mesh::Primitive;
use crate::texture::{Bilinear, Blend, CutOut, Filter, Nearest, Sampler, texels};

/// A texture: each pixel shows the texel nearest to its center, or a blend of the four texels around its center
/// ([`bilinear`](Self::bilinear)).
///
#[cfg_attr(doc, doc = page_picture!("textured", "A cube with checkers"))]
/// The texture repeats, or is [`clamped`](Self::clamped) to its edge. The textured surface may be [`lit`](Shader::lit),
/// or [`tinted`](Shader::tinted) by vertex colors. A [`Mipmap`](crate::texture::Mipmap) may be
/// [`mipmapped`](Self::mipmapped), so that it does not flicker in the distance.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
/// use fixel::prelude::*;
/// use fixel::Window;
/// static SKIN: [[Rgb565; 2]; 2] = [[Rgb565::WHITE, Rgb565::BLUE], [Rgb565::BLUE, Rgb565::RED]];
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 4, 4)?;
/// canvas.draw(&SQUARE, &mvp, &Textured::new(&SKIN));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["WWBB", "WWBB", "BBRR", "BBRR"]);
/// # Ok::<(), Error>(())
/// ```
///
/// The shader's varyings are a column and a row of the texture, in texels with 16 fraction bits. If the texture has 16
/// or more columns, the column is exact; otherwise it is rounded to nearest. The same holds for the row. The range of
/// the varyings is ±32,768 texels (128 repeats of 256 texels, or 8 repeats of 4096 texels); beyond this range, they
/// saturate. If the texture repeats, the shader first moves a triangle's texture coordinates by whole repeats, so that
/// their middle is in the first repeat. So the range limits how much of a repeating texture one triangle can show, but
/// not how far the triangle's texture coordinates are from 0. The texture coordinates of lines and points are not
/// moved.
///
/// # The type
///
/// The type parameters have defaults, which methods such as `clamped` change. If you [write the
/// type](crate::shade#a-shader-in-a-struct), you must name the parameters: the texture's type; `true` for a clamped
/// texture; the filter, which is `Nearest`, `Bilinear` or `Trilinear` (of the module [`texture`](crate::texture)); and
/// `shade::Mipmapped` for a mipmapped texture. [`cut_out`](Self::cut_out) turns a texture `S` into a
/// `texture::CutOut<S, C>`, where `C` is the color, and [`masked`](Self::masked) into a `shade::Masked<S, M>`, where
/// `M` is the mask.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray4, Rgb565};
/// use fixel::shade::{Masked, Mipmapped};
/// use fixel::texture::{Bilinear, CutOut, Mipmap, Raw, Trilinear};
/// use fixel::{Texture, Textured};
/// struct Garden {
///     wall: Textured<Texture<'static, Rgb565>, true, Bilinear>,
///     fence: Textured<CutOut<Texture<'static, Rgb565>, Rgb565>>,
///     pane: Textured<Masked<Texture<'static, Rgb565>, Raw<'static, Gray4>>>,
///     lawn: Textured<Mipmap<'static, Rgb565>, false, Trilinear, Mipmapped>,
/// }
/// # use fixel::{Error, Projection};
/// # fn garden(t: Texture<'static, Rgb565>, mask: Raw<'static, Gray4>, mipmap: Mipmap<'static, Rgb565>, key: Rgb565,
/// #     projection: &Projection) -> Result<Garden, Error> {
/// # let (texture, mipmap) = (Textured::new(t), Textured::new(mipmap));
/// # Ok(Garden {
/// #     wall: texture.clamped().bilinear(),
/// #     fence: texture.cut_out(key),
/// #     pane: texture.masked(mask)?,
/// #     lawn: mipmap.mipmapped(projection, (4, 3))?.trilinear(),
/// # })
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Textured<S, const CLAMPED: bool = false, F = Nearest, D = ()> {
    pub(super) texture: S,
    pub(super) filter: PhantomData<F>,
    /// How the level of a pixel is found.
    pub(super) detail: D,
}

impl<S: Sampler> Textured<S> {
    /// A shader that repeats a texture. Give it a reference to rows of texels, a [`Texture`](crate::Texture), or
    /// another [`Sampler`].
    #[must_use]
    pub const fn new(texture: S) -> Self {
        Self::of(texture, ())
    }
}

impl<S, const CLAMPED: bool, F, D> Textured<S, CLAMPED, F, D> {
    pub(super) const fn of(texture: S, detail: D) -> Self {
        Self {
            texture,
            filter: PhantomData,
            detail,
        }
    }
}

impl<S: Sampler, const CLAMPED: bool, F: Copy, D: Copy> Textured<S, CLAMPED, F, D> {
    /// Clamps the texture to its edge instead of repeating it.
    ///
    /// ```
    /// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
    /// use fixel::{prelude::*, shade::Texels};
    /// let texture = &[[Gray8::new(10), Gray8::new(20)]];
    /// let pixel = Fragment { point: Point::zero(), depth: 0 };
    /// let columns = [-1, 0, 1, 2, 3].map(|column| Texels([column << 16, 0]));
    /// let skin = Textured::new(texture);
    /// let colors = columns.map(|at| skin.shade(&pixel, at));
    /// assert_eq!(colors, [20, 10, 20, 10, 20].map(|luma| Some(Gray8::new(luma))));
    /// let colors = columns.map(|at| skin.clamped().shade(&pixel, at));
    /// assert_eq!(colors, [10, 10, 20, 20, 20].map(|luma| Some(Gray8::new(luma))));
    /// ```
    #[must_use]
    pub const fn clamped(self) -> Textured<S, true, F, D> {
        Textured::of(self.texture, self.detail)
    }

    /// Blends the four texels around each pixel, with weights that depend on how near the texels' centers are to the
    /// pixel's center. A magnified texture then looks smooth.
    ///
    /// The centers of the outermost texels lie half a texel inside the texture's edges. Beyond these centers, a
    /// repeating texture blends with the texels at its opposite edge, and a [`clamped`](Self::clamped) texture keeps
    /// the color of its edge. A texture that is drawn at a reduced size flickers even with this filter; a
    /// [`mipmapped`](Self::mipmapped) texture does not.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray8, GrayColor}};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static SKIN: [[Gray8; 2]; 1] = [[Gray8::new(0), Gray8::new(0x88)]];
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
    ///
    /// # Rounding
    ///
    /// A pixel's position between the centers of texels is rounded to the nearest 1/32 texel for colors of 16 bits
    /// (such as [`Rgb565`](embedded_graphics::pixelcolor::Rgb565)), because a blend multiplies all channels of such a
    /// color at once, in one word. For other colors, the position is rounded to the nearest 1/256 texel
    /// ([`Blend::WEIGHT_BITS`]).
    ///
    /// The filter first makes two blends along rows, each rounded to a whole step, and then one blend between the rows.
    /// A channel's error is at most one step, plus 1/32 (or 1/256) of the greatest difference between the four texels.
    /// Between black and white, this error is two steps of red and three steps of green in Rgb565, and two steps of
    /// every channel in Rgb888. At the centers of texels, there is no error.
    ///
    /// # Cost
    ///
    /// The table lists the instructions per pixel that the filter takes in addition to the instructions for the nearest
    /// texel, with `opt-level = 3`, for the benchmark's floor with a 64x64 texture in flash. A range spans the modes
    /// `Exact` and `Affine`. In the default mode, which the ranges do not include, the filter takes 48 instructions for
    /// Rgb565 on the M4 and 75 on the M0+. The last columns give the bytes of code with `opt-level = "s"`.
    ///
    /// | | Cortex-M4 | Cortex-M0+ | code, M4 | code, M0+ |
    /// |---|---:|---:|---:|---:|
    /// | Rgb565 | 43 to 48 | 63 to 68 | 112 | 140 |
    /// | Rgb565, clamped | 55 to 57 | 81 to 86 | | |
    /// | Rgb565, [`Indexed`](crate::texture::Indexed) | 49 to 51 | 71 to 98 | | |
    /// | Rgb888 | 60 to 65 | 97 to 111 | 164 | 200 |
    /// | Gray8 | 32 to 33 | 41 to 47 | 76 | 88 |
    #[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
    #[must_use]
    pub const fn bilinear(self) -> Textured<S, CLAMPED, Bilinear, D>
    where
        S::Color: Blend,
    {
        Textured::of(self.texture, self.detail)
    }

    /// Leaves out the texels of exactly this color, for example around fences, leaves and sprites. Where a texel is
    /// left out, the color and the depth on the canvas do not change.
    ///
    /// At each pixel, the nearest texel decides whether there is a hole. Where there is no hole, a
    /// [`bilinear`](Self::bilinear) filter blends as if the left-out texels had the nearest texel's color. So the
    /// left-out color is never visible.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static FENCE: [[Rgb565; 2]; 1] = [[Rgb565::GREEN, Rgb565::MAGENTA]];
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
    pub const fn cut_out(self, key: S::Color) -> Textured<CutOut<S, S::Color>, CLAMPED, F, D>
    where
        S::Color: PartialEq,
    {
        let texture = self.texture;
        Textured::of(CutOut { texture, key }, self.detail)
    }

    /// Gives each texel an opacity from a mask, which is a gray texture of the same size: white is opaque, and black is
    /// invisible. Where the mask is black, the color and the depth on the canvas do not change.
    ///
    /// A bilinear filter blends colors and opacities separately, so give invisible texels the colors of their
    /// neighbors.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray4, Gray8};
    /// use fixel::{Window, prelude::*, texture::Raw};
    /// static SKIN: [[Gray8; 2]; 1] = [[Gray8::new(200); 2]];
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let mask = Raw::<Gray4>::new(&[0x3f], 2, 1)?; // opacities of 1/5 and 1
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [Gray8::new(100); 2];
    /// let mut canvas = Canvas::new(&mut pixels, 2, 1)?;
    /// canvas.draw(&SQUARE, &mvp, &Textured::new(&SKIN).masked(mask)?);
    /// assert_eq!(pixels, [Gray8::new(120), Gray8::new(200)]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::SizeDiffers`] if the sizes differ.
    pub fn masked<M: Sampler<Color: GrayColor>>(
        self,
        mask: M,
    ) -> Result<Textured<Masked<S, M>, CLAMPED, F, D>, Error>
    where
        S::Color: PixelColor,
    {
        let (size, given) = (self.texture.size_log2(), mask.size_log2());
        if size != given {
            // Widths and heights are at most 2^15, so the masks change nothing.
            let pixels = |[width, height]: [u32; 2]| [1 << (width & 15), 1 << (height & 15)];
            return Err(Error::SizeDiffers {
                of: "the mask",
                given: pixels(given),
                needed: pixels(size),
                like: "its texture",
            });
        }
        let texture = self.texture;
        Ok(Textured::of(Masked { texture, mask }, self.detail))
    }
}

impl<S: Sampler<Color: Texel>, const CLAMPED: bool, F: Filter<S::Color>, D>
    Textured<S, CLAMPED, F, D>
{
    /// The columns and rows of the texture at a primitive's corners.
    #[inline]
    pub(super) fn corners(&self, primitive: &Primitive<'_>) -> [Texels; 3] {
        let [a, b, c] = primitive.corners(|corner| corner.uv().to_bits());
        let coordinates = |bits: [i32; 3], log2| {
            let moves = !CLAMPED && primitive.face().is_some();
            texels(bits, moves, log2)
        };
        let [width, height] = self.texture.size_log2();
        let us = coordinates([a[0], b[0], c[0]], width);
        let vs = coordinates([a[1], b[1], c[1]], height);
        [
            Texels([us[0], vs[0]]),
            Texels([us[1], vs[1]]),
            Texels([us[2], vs[2]]),
        ]
    }

    /// The color at a column and a row, and at a level with 8 fraction bits.
    #[inline]
    pub(super) fn color(
        &self,
        Texels(at): Texels,
        level: i32,
    ) -> Option<<S::Color as Texel>::Source> {
        F::color::<CLAMPED>(&self.texture, at, level).source()
    }
}

impl<S: Sampler<Color: Texel>, const CLAMPED: bool, F: Filter<S::Color>> Shader
    for Textured<S, CLAMPED, F>
{
    type Color = <S::Color as Texel>::Source;
    type Varyings = Texels;

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Texels; 3] {
        self.corners(primitive)
    }

    #[inline]
    fn shade(&self, _: &Fragment, at: Texels) -> Option<Self::Color> {
        self.color(at, 0)
    }
}

/// A texture with opacities that come from another texture, the mask; see [`Textured::masked`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Masked<S, M> {
    texture: S,
    mask: M,
}

impl<S: Sampler<Color: PixelColor>, M: Sampler<Color: GrayColor>> Sampler for Masked<S, M> {
    type Color = Translucent<S::Color>;

    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.texture.size_log2()
    }

    #[inline]
    fn texel(&self, u: i32, v: i32) -> Self::Color {
        self.texel_at(0, u, v)
    }

    #[inline]
    fn texel_at(&self, level: u32, u: i32, v: i32) -> Self::Color {
        // The luma of white is 1, 3, 15 or 255.
        let scale = 255 / M::Color::WHITE.luma().max(1);
        let mask = self.mask.texel_at(level, u, v);
        Translucent {
            color: self.texture.texel_at(level, u, v),
            opacity: mask.luma().wrapping_mul(scale),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::shader::{IDENTITY, edge, face, shade};
    use crate::{Mesh, Vec2, Vec3, vec2};
    use embedded_graphics::pixelcolor::{Gray4, Gray8, GrayColor, Rgb565};

    /// Four columns and two rows; a texel is its column plus ten times its row.
    static SKIN: [[Gray8; 4]; 2] = [
        [Gray8::new(0), Gray8::new(1), Gray8::new(2), Gray8::new(3)],
        [
            Gray8::new(10),
            Gray8::new(11),
            Gray8::new(12),
            Gray8::new(13),
        ],
    ];
    static POSITIONS: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

    fn mesh(uvs: &[Vec2; 3]) -> Mesh<'_> {
        Mesh::new(&POSITIONS, &[[0, 1, 2]])
            .and_then(|mesh| mesh.with_edges(&[[0, 1]]))
            .and_then(|mesh| mesh.with_uvs(uvs, None))
            .unwrap()
    }

    fn corners<S: Sampler<Color: Texel>, const CLAMPED: bool>(
        skin: Textured<S, CLAMPED>,
        uvs: [Vec2; 3],
    ) -> [[i32; 2]; 3] {
        face(skin, &IDENTITY, &mesh(&uvs), 0).1.map(|Texels(at)| at)
    }

    #[test]
    fn coordinates_are_exact_in_texels() {
        // With four columns, 12 units of 2^-20 repeat are 3 · 2^-16 texels. With two rows, 24 units are as many texels.
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
        // A triangle with its middle left of the first repeat's start keeps its place, or is moved by a repeat.
        let [a, b, _] = corners(
            Textured::new(&SKIN),
            [vec2!(-0.25, -1), vec2!(0.25, 0), vec2!(0, 0)],
        );
        assert_eq!([a, b], [[-1 << 16, 0], [1 << 16, 2 << 16]]);
    }

    #[test]
    fn extremes_saturate() {
        static WIDE: [[Gray8; 256]; 64] = [[Gray8::new(0); 256]; 64];
        let (low, high) = (i32::MIN, i32::MAX);
        let uvs = [[low, high], [high, low], [0, 0]].map(Vec2::from_bits);
        let skin = Textured::new(&WIDE);
        let repeated = corners(skin, uvs);
        // The middle is half a unit below 0, so the origin is the start of the repeat before.
        assert_eq!(repeated, [[low, high], [high, low], [1 << 24, 1 << 22]]);
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

    #[test]
    fn a_mask_of_another_size_is_refused() {
        let (skin, mask) = ([[Rgb565::new(1, 2, 3); 4]; 2], [[Gray4::new(15); 2]; 4]);
        let error = Textured::new(&skin).masked(&mask).unwrap_err();
        assert_eq!(
            std::format!("{error}"),
            "size of the mask is 2x4: it must be 4x2, like its texture"
        );
    }
}
