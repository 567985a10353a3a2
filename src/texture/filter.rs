//! Filters: the color at a point between texels, and between levels of a mipmap.

use super::addressing::{back, index};
use super::{Blend, Sampler};
use crate::sealed::Sealed;

/// The color of a texture between the centers of its texels: [`Nearest`], [`Bilinear`] or [`Trilinear`].
#[doc(hidden)]
pub trait Filter<C>: Copy + Sealed {
    /// The color of a texture, which may be clamped, at a column, a row and a level. Columns and rows are distances from
    /// the first texel's corner, in texels of level 0 with 16 fraction bits. The level has 8 fraction bits.
    fn color<const CLAMPED: bool>(sampler: &impl Sampler<Color = C>, at: [i32; 2], level: i32)
    -> C;
}

impl Sealed for Nearest {}
impl Sealed for Bilinear {}
impl Sealed for Trilinear {}

/// Takes the texel with the nearest center.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Nearest;

/// Blends the four texels around a point, with weights that depend on the distances of their centers.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bilinear;

/// Blends the four texels around a point in each of the two mipmap levels nearest to a pixel's level, and then blends
/// the two results.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Trilinear;

/// Limits a level, with 8 fraction bits, to the range from the first to the last level.
#[inline]
fn clamped(level: i32, sampler: &impl Sampler) -> u32 {
    let [width, height] = sampler.size_log2();
    level.max(0).cast_unsigned().min(width.min(height) << 8)
}

/// The whole level nearest to a level with 8 fraction bits.
#[inline]
fn nearest(level: i32, sampler: &impl Sampler) -> u32 {
    let [width, height] = sampler.size_log2();
    ((level + 128).max(0).cast_unsigned() >> 8).min(width.min(height))
}

/// The base-2 logarithms of a level's width and height. The function is written out, because in a build for size, `map`
/// remains a loop.
#[inline]
pub(super) const fn size_at(level: u32, [width, height]: [u32; 2]) -> [u32; 2] {
    [width.wrapping_sub(level), height.wrapping_sub(level)]
}

impl<C: Copy> Filter<C> for Nearest {
    #[inline]
    fn color<const CLAMPED: bool>(
        sampler: &impl Sampler<Color = C>,
        [u, v]: [i32; 2],
        level: i32,
    ) -> C {
        let level = nearest(level, sampler);
        let [width, height] = size_at(level, sampler.size_log2());
        let place = |at: i32, log2| index::<CLAMPED>(at >> level >> 16, log2);
        sampler.texel_at(level, place(u, width), place(v, height))
    }
}

impl<C: Blend> Filter<C> for Bilinear {
    #[inline]
    fn color<const CLAMPED: bool>(
        sampler: &impl Sampler<Color = C>,
        at: [i32; 2],
        level: i32,
    ) -> C {
        let (texels, weights) = around::<_, CLAMPED>(sampler, at, nearest(level, sampler));
        C::blend(texels, weights)
    }
}

impl<C: Blend> Filter<C> for Trilinear {
    #[inline]
    fn color<const CLAMPED: bool>(
        sampler: &impl Sampler<Color = C>,
        at: [i32; 2],
        level: i32,
    ) -> C {
        let level = clamped(level, sampler);
        let (whole, weight) = (level >> 8, (level & 0xff) << C::WEIGHT_BITS >> 8);
        let (texels, weights) = around::<_, CLAMPED>(sampler, at, whole);
        let fine = C::blend(texels, weights);
        if weight == 0 {
            return fine;
        }
        let (texels, weights) = around::<_, CLAMPED>(sampler, at, whole + 1);
        fine.mix(C::blend(texels, weights), weight)
    }
}

/// The four texels around a point in a level, and the weights of the right and of the lower texels.
#[inline]
pub(super) fn around<S: Sampler<Color: Blend>, const CLAMPED: bool>(
    sampler: &S,
    [u, v]: [i32; 2],
    level: u32,
) -> ([[S::Color; 2]; 2], [u32; 2]) {
    let bits = const {
        let bits = S::Color::WEIGHT_BITS;
        assert!(bits >= 1 && bits <= 15, "weights must have 1 to 15 bits");
        bits
    };
    let [width, height] = size_at(level, sampler.size_log2());
    let ([left, right], x) = between::<CLAMPED>(u >> level, width, bits);
    let ([upper, lower], y) = between::<CLAMPED>(v >> level, height, bits);
    let row = |v| {
        let texel = |u| sampler.texel_at(level, u, v);
        [texel(left), texel(right)]
    };
    ([row(upper), row(lower)], [x, y])
}

/// The two columns or rows with `at` between their centers, and the weight of the second: the distance of `at` from the
/// first center.
#[inline]
fn between<const CLAMPED: bool>(at: i32, log2: u32, weight_bits: u32) -> ([i32; 2], u32) {
    // A texel's center is half a texel from its corner, so half a texel is subtracted. Half a unit of the weight is
    // added, so that the shift below rounds to nearest.
    let at = back::<CLAMPED>(at, (1 << 15) - (1 << (15 - weight_bits)));
    let first = at >> 16;
    let weight = (at.cast_unsigned() & 0xffff) >> (16 - weight_bits);
    // `first` has 16 bits, so adding 1 cannot overflow.
    let both = [
        index::<CLAMPED>(first, log2),
        index::<CLAMPED>(first + 1, log2),
    ];
    (both, weight)
}
