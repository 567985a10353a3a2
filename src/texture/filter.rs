//! The color at a point between texels.

use super::blend::{self, Blend};
use super::{Addressing, Sampler};
use crate::sealed::{Sealed, sealed};

/// The color of a texture between the centers of its texels: [`Nearest`] or [`Bilinear`].
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::prelude::*;
/// use fixel::texture::{Filter, Repeat};
///
/// /// Takes a texture of one size, with either filter.
/// fn skin<F: Filter<Rgb565>>(textured: Textured<&TextureArray<Rgb565, 64, 64>, Repeat, F>) {
///     let _ = textured;
/// }
/// ```
pub trait Filter<C>: Copy + Sealed {
    /// The color at a column and a row: distances from the first texel's corner, in texels with 16 fraction bits.
    /// `None` where the texture has a hole.
    #[doc(hidden)]
    fn color<S: Sampler<Color = C>, A: Addressing>(&self, sampler: &S, at: [i32; 2]) -> Option<C>;
}

sealed!(Nearest, Bilinear);
impl<F, C> Sealed for CutOut<F, C> {}

/// Takes the texel whose center is nearest.
///
/// A magnified texture shows its texels as sharp squares.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::{prelude::*, shade::Texels, texture::{Nearest, Repeat}};
/// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[10, 20]);
/// let skin: Textured<_, Repeat, Nearest> = Textured::new(&SKIN);
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// // In quarters of a texel.
/// let texels = [0, 1, 2, 3, 4].map(|column| skin.shade(&pixel, Texels([column << 14, 0])));
/// assert_eq!(texels, [10, 10, 10, 10, 20].map(|luma| Some(Gray8::new(luma))));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Nearest;

/// Blends the four texels around a point, with weights that depend on the distances of their centers.
///
/// A magnified texture looks smooth. [`Textured::bilinear`](crate::Textured::bilinear) selects this filter.
///
/// The first texel's center lies half a texel from the texture's corner. Beyond the outermost centers, a
/// repeating texture blends with its other edge, and a [`clamped`](crate::Textured::clamped) one keeps the color
/// of its edge. A reduced texture flickers as with [`Nearest`]; [`Mipmapped`](crate::shade::Mipmapped) does not.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::{prelude::*, shade::Texels, texture::{Bilinear, Clamp}};
/// static SKIN: TextureArray<Gray8, 2, 1> = TextureArray::gray8(&[10, 20]);
/// let skin: Textured<_, Clamp, Bilinear> = Textured::new(&SKIN).clamped().bilinear();
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// // In quarters of a texel.
/// let colors = [0, 1, 2, 3, 4, 5, 6].map(|column| skin.shade(&pixel, Texels([column << 14, 0])));
/// assert_eq!(colors, [10, 10, 10, 13, 15, 18, 20].map(|luma| Some(Gray8::new(luma))));
/// ```
///
/// # Rounding
///
/// The position between the centers is rounded to the nearest 1/32 texel for colors of 16 bits (such as
/// [`Rgb565`](embedded_graphics::pixelcolor::Rgb565)), because one word holds all their channels during a blend. For
/// other colors it is rounded to the nearest 1/256 texel ([`Blend::WEIGHT_BITS`]).
///
/// Two blends along rows come first, each rounded to a whole step; one blend between the rows follows. A channel's
/// error is at most one step, plus 1/32 (or 1/256) of the difference between the four texels. From black to white, this
/// is two steps of red and three of green in Rgb565, and two steps of 255 in Rgb888. At the centers of texels there is
/// no error.
///
/// # Cost
///
/// The table lists the instructions for a pixel in addition to those with [`Nearest`], with `opt-level = 3`, for the
/// benchmark's floor with a 64x64 texture in flash. The ranges cover the modes `Exact` and `Affine`; in the default
/// mode, Rgb565 takes 48 more on the M4 and 75 more on the M0+. The last columns give the bytes of code with
/// `opt-level = "s"`.
///
/// | | Cortex-M4 | Cortex-M0+ | code, M4 | code, M0+ |
/// |---|---:|---:|---:|---:|
/// | Rgb565 | 43 to 48 | 63 to 68 | 112 | 140 |
/// | Rgb565, clamped | 55 to 57 | 81 to 86 | | |
/// | Rgb565 of a [`Palette`](super::PaletteArray) | 49 to 51 | 71 to 98 | | |
/// | Rgb888 | 60 to 65 | 97 to 111 | 164 | 200 |
/// | Gray8 | 32 to 33 | 41 to 47 | 76 | 88 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bilinear;

/// Leaves out texels of one color; see [`Textured::cut_out`](crate::Textured::cut_out).
///
/// Between texels, the nearest one decides whether there is a hole. Where there is none, a [`Bilinear`] filter blends
/// as if the texels that are left out had the nearest texel's color, so their own color never shows.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::{Gray8, GrayColor}};
/// use fixel::{prelude::*, shade::Texels};
/// static SKIN: TextureArray<Gray8, 4, 1> = TextureArray::gray8(&[10, 99, 20, 40]);
/// let skin = Textured::new(&SKIN).clamped().bilinear().cut_out(Gray8::new(99));
/// let pixel = Fragment { point: Point::zero(), depth: 0 };
/// // In halves of a texel: 99 never shows.
/// let colors = [1, 2, 3, 4, 5, 6, 7].map(|column| skin.shade(&pixel, Texels([column << 15, 0])));
/// let hole = 0;
/// let lumas = colors.map(|color| color.map_or(hole, |color| color.luma()));
/// assert_eq!(lumas, [10, 0, 0, 20, 20, 30, 40]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CutOut<F, C> {
    pub(crate) filter: F,
    pub(crate) key: C,
}

impl<C: Copy> Filter<C> for Nearest {
    #[inline]
    fn color<S: Sampler<Color = C>, A: Addressing>(
        &self,
        sampler: &S,
        [u, v]: [i32; 2],
    ) -> Option<C> {
        let [width, height] = sampler.size_log2();
        Some(sampler.texel(A::index(u >> 16, width), A::index(v >> 16, height)))
    }
}

impl<C: Copy + PartialEq> Filter<C> for CutOut<Nearest, C> {
    #[inline]
    fn color<S: Sampler<Color = C>, A: Addressing>(&self, sampler: &S, at: [i32; 2]) -> Option<C> {
        let color = self.filter.color::<S, A>(sampler, at)?;
        (color != self.key).then_some(color)
    }
}

impl<C: Blend> Filter<C> for Bilinear {
    #[inline]
    fn color<S: Sampler<Color = C>, A: Addressing>(&self, sampler: &S, at: [i32; 2]) -> Option<C> {
        let (texels, weights) = around::<C, S, A>(sampler, at);
        Some(C::blend(texels, weights))
    }
}

impl<C: Blend + PartialEq> Filter<C> for CutOut<Bilinear, C> {
    #[inline]
    fn color<S: Sampler<Color = C>, A: Addressing>(&self, sampler: &S, at: [i32; 2]) -> Option<C> {
        let (texels, weights) = around::<C, S, A>(sampler, at);
        let nearest = blend::nearest(texels, weights);
        if nearest == self.key {
            return None;
        }
        let filled = |texel: C| if texel == self.key { nearest } else { texel };
        Some(C::blend(blend::each(texels, filled), weights))
    }
}

/// The four texels around a point, and the weights of the right and of the lower ones.
#[inline]
fn around<C: Blend, S: Sampler<Color = C>, A: Addressing>(
    sampler: &S,
    [u, v]: [i32; 2],
) -> ([[C; 2]; 2], [u32; 2]) {
    const {
        assert!(
            C::WEIGHT_BITS >= 1 && C::WEIGHT_BITS <= 15,
            "weights must have 1 to 15 bits"
        );
    }
    let [width, height] = sampler.size_log2();
    let ([left, right], x) = between::<A>(u, width, C::WEIGHT_BITS);
    let ([upper, lower], y) = between::<A>(v, height, C::WEIGHT_BITS);
    let row = |v| [sampler.texel(left, v), sampler.texel(right, v)];
    ([row(upper), row(lower)], [x, y])
}

/// The two columns or rows whose centers enclose `at`, and the distance of `at` from the first center.
#[inline]
fn between<A: Addressing>(at: i32, log2: u32, weight_bits: u32) -> ([i32; 2], u32) {
    // Centers lie at halves. Half a unit of the weight stays, so that the cut below rounds to nearest.
    let at = A::back(at, (1 << 15) - (1 << (15 - weight_bits)));
    let first = at >> 16;
    let weight = (at.cast_unsigned() & 0xffff) >> (16 - weight_bits);
    // `first` has 16 bits, so adding 1 cannot overflow.
    let both = [A::index(first, log2), A::index(first + 1, log2)];
    (both, weight)
}

#[cfg(test)]
mod tests {
    use super::super::{Repeat, TextureArray};
    use super::*;
    use crate::random::cases;
    use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
    use rand::Rng;

    const KEY: Rgb888 = Rgb888::MAGENTA;

    /// Gray texels, with holes where a bit is set.
    fn skin(grays: [u8; 16], holes: u16) -> TextureArray<Rgb888, 4, 4> {
        let texel = |i: usize| match holes >> i & 1 {
            1 => KEY,
            _ => Rgb888::new(grays[i], grays[i], grays[i]),
        };
        TextureArray::from_texels(core::array::from_fn(|row| {
            core::array::from_fn(|column| texel(4 * row + column))
        }))
    }

    /// A blend that contained the key would not be gray. Where no texel around is left out, nothing changes.
    #[test]
    fn holes_are_the_key_s_and_leave_no_fringe() {
        cases(256, |random| {
            let grays = random.random::<[u8; 16]>();
            let holes = random.random::<u16>();
            let at = random.random::<[i32; 2]>();
            let (skin, whole) = (skin(grays, holes), skin(grays, 0));
            let at = at.map(|at| at >> 10);
            let nearest = Nearest.color::<_, Repeat>(&&skin, at).unwrap();
            let cut = CutOut {
                filter: Nearest,
                key: KEY,
            }
            .color::<_, Repeat>(&&skin, at);
            assert_eq!(cut, (nearest != KEY).then_some(nearest));

            let smooth = CutOut {
                filter: Bilinear,
                key: KEY,
            }
            .color::<_, Repeat>(&&skin, at);
            if let Some(color) = smooth {
                assert!(
                    color.r() == color.g() && color.g() == color.b(),
                    "{color:?}"
                );
            }
            // Weights are rounded to 1/256 texel: elsewhere, the same texel is nearest.
            if at
                .iter()
                .all(|at| (at & 0xffff) >= 256 && (at & 0xffff) < 0xff00)
            {
                assert_eq!(smooth.is_none(), nearest == KEY);
            }
            let (texels, _) = around::<_, _, Repeat>(&&skin, at);
            if !texels.as_flattened().contains(&KEY) {
                assert_eq!(smooth, Bilinear.color::<_, Repeat>(&&whole, at));
            }
        });
    }

    #[test]
    fn a_cut_out_texel_leaves_color_and_depth() {
        use crate::prelude::*;
        static SKIN: TextureArray<Rgb565, 2, 1> =
            TextureArray::from_texels([[Rgb565::RED, Rgb565::BLACK]]);
        static SQUARE: Mesh = shape!(plane(1, 1));
        let window = Window::centered(fx!(2), fx!(2));
        let projection = Projection::orthographic(window, fx!(0), fx!(2)).unwrap();
        let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
        let (mut pixels, mut depths) = ([Rgb565::BLUE; 4], [7; 4]);
        let canvas = Canvas::new(&mut pixels, 4, 1).unwrap();
        let mut canvas = canvas.with_depth(&mut depths).unwrap();
        let skin = Textured::new(&SKIN).clamped();
        canvas.draw(&SQUARE, &mvp, &skin.cut_out(Rgb565::BLACK));
        assert_eq!(
            pixels,
            [Rgb565::RED, Rgb565::RED, Rgb565::BLUE, Rgb565::BLUE]
        );
        assert_eq!(depths[2..], [7, 7]);
        assert!(depths[0] > 7);
    }
}
