//! Colors as numbers to interpolate, and back by rounding or dithering.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor,
    Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};

use super::dither::dither;
use super::{Channels, Illumination};
use crate::texture::Blend;

/// A color that can be interpolated, lit, tinted and dithered.
///
/// A *level* is a channel in steps of the color's own format, with 16 fraction bits: red of [`Rgb565`] runs from 0 to
/// 31 · 65,536. With levels, the work per pixel is one addition and one shift per channel. A *fraction* is a channel
/// relative to full brightness, which is 65,536.
///
/// There are up to three channels: red, green and blue. A gray color has three equal channels; only the first is used.
/// Gray is the BT.601 luma of the stored values (without gamma): 0.299 red + 0.587 green + 0.114 blue, with weights
/// rounded to 2⁻¹⁴.
///
/// This trait is implemented for the colors of embedded-graphics. Colors with 5 or more bits per channel are rounded
/// to nearest. [`Gray4`], [`Gray2`] and [`BinaryColor`] (on is white) are dithered by an 8x8 ordered matrix that is
/// fixed to the frame. The mean of 8x8 pixels that show one level differs from it by at most 1/128 step; black stays
/// black, and white stays white.
///
/// ```
/// use embedded_graphics::{pixelcolor::{BinaryColor, Rgb565, Rgb888}, prelude::*};
/// use fixel::prelude::*;
/// let orange = Rgb888::new(255, 128, 0);
/// assert_eq!(Rgb565::from_rgb(orange, Point::zero()), Rgb565::new(31, 32, 0));
/// // Orange has about 0.6 of white's luma, so this share of the pixels is on.
/// let on = (0..64).filter(|i| BinaryColor::from_rgb(orange, Point::new(i % 8, i / 8)).is_on());
/// assert_eq!(on.count(), 38);
/// ```
pub trait Levels: PixelColor {
    /// White, in whole steps: 31, 63, 31 for [`Rgb565`]; each is 2ⁿ − 1, at most 255.
    const MAX_STEPS: [i32; 3];

    /// The channels that are interpolated: `[i32; 3]`, or `[i32; 1]` for gray.
    type Channels: Channels;

    /// The channels of `color` as fractions, 0 to 65,536; for gray, its luma.
    fn fractions(color: Rgb888) -> [i32; 3];

    /// The channels in whole steps, 0 to [`MAX_STEPS`](Self::MAX_STEPS).
    fn steps(self) -> [i32; 3];

    /// The color of `levels` at a pixel of the frame: rounded to nearest, or dithered.
    ///
    /// Levels may lie outside black to white by up to 511 units of 2⁻¹⁶, far more than the error of interpolation.
    /// Beyond that, the color is unspecified.
    #[must_use]
    fn from_levels(levels: [i32; 3], at: Point) -> Self;

    /// The color of levels that have been raised by half a step, 2^15. To round such levels, it is enough to cut them,
    /// so the addition is needed once per vertex and not at every pixel.
    #[must_use]
    #[inline]
    fn from_raised(levels: [i32; 3], at: Point) -> Self {
        Self::from_levels(each(levels, |level| level.wrapping_sub(HALF)), at)
    }

    /// The levels of `color`, with an error of at most 0.003 step; exact for black and white.
    #[must_use]
    #[inline]
    fn levels(color: Rgb888) -> [i32; 3] {
        scale(Self::MAX_STEPS, Self::fractions(color))
    }

    /// The color nearest to `color`, or its dithered value at a pixel of the frame.
    #[must_use]
    #[inline]
    fn from_rgb(color: Rgb888, at: Point) -> Self {
        Self::from_levels(Self::levels(color), at)
    }

    /// The color of whole steps, 0 to [`MAX_STEPS`](Self::MAX_STEPS): exact, without dithering.
    #[must_use]
    #[inline]
    fn of_steps(steps: [i32; 3]) -> Self {
        // No dithering changes a whole step.
        Self::from_levels(each(steps, |step| step << 16), Point::zero())
    }

    /// This color, covered by another one in a share of `coverage`/256, where `coverage` is 0 to 256.
    ///
    /// The mixture is rounded or dithered as by [`from_levels`](Self::from_levels). For colors of 15 and 16 bits, the
    /// share is first rounded to 1/32.
    #[must_use]
    #[inline]
    fn covered(self, by: Self, coverage: u32, at: Point) -> Self {
        Self::from_levels(covered(self.steps(), by.steps(), coverage), at)
    }

    /// The sum of two colors, channel by channel, at most white.
    #[must_use]
    #[inline]
    fn plus(self, other: Self) -> Self {
        let sums = zip(self.steps(), other.steps(), |a, b| a + b);
        Self::of_steps(zip(sums, Self::MAX_STEPS, Ord::min))
    }

    /// The product of two colors, channel by channel, where white is 1; rounded or dithered as by
    /// [`from_levels`](Self::from_levels).
    #[must_use]
    #[inline]
    fn times(self, other: Self, at: Point) -> Self {
        let products = scale(self.steps(), other.steps());
        Self::from_levels(zip(products, Self::MAX_STEPS, over), at)
    }

    /// This color under a light of `fractions`, channel by channel.
    #[must_use]
    #[inline]
    fn filtered(self, fractions: [i32; 3], at: Point) -> Self {
        Self::from_levels(scale(self.steps(), fractions), at)
    }

    /// This color under a light.
    #[must_use]
    #[inline]
    fn lit(self, light: Illumination, at: Point) -> Self {
        let levels = scale(self.steps(), light.diffuse);
        Self::from_levels(glossed::<Self>(levels, light), at)
    }
}

/// Converts three channels. Not `array::map`: optimized for size, that is a loop over memory.
#[inline]
pub(super) fn each([r, g, b]: [i32; 3], f: impl Fn(i32) -> i32) -> [i32; 3] {
    [f(r), f(g), f(b)]
}

/// `f` of each two channels.
#[inline]
fn zip([r, g, b]: [i32; 3], [x, y, z]: [i32; 3], f: impl Fn(i32, i32) -> i32) -> [i32; 3] {
    [f(r, x), f(g, y), f(b, z)]
}

/// Whole steps (at most 255) times fractions (up to about 65,536): levels.
#[inline]
fn scale(levels: [i32; 3], factors: [i32; 3]) -> [i32; 3] {
    // Products of interpolated values are below 2^24. Wrapping, so that numbers from a user's shader cannot panic.
    zip(levels, factors, i32::wrapping_mul)
}

/// The levels between two colors' steps, of which the second have a share of `coverage`/256.
#[inline]
fn covered(below: [i32; 3], above: [i32; 3], coverage: u32) -> [i32; 3] {
    zip(below, above, |below, above| {
        // 9 bits times 17 bits.
        let more = above.wrapping_sub(below);
        (below << 16).wrapping_add(more.wrapping_mul((coverage << 8).cast_signed()))
    })
}

/// A product of two steps from 0 to `most`, which is 2ⁿ − 1, over `most`, in levels. The error is at most 16 units of
/// 2⁻¹⁶ step; a value that is rounded differs from a half by more.
#[inline]
const fn over(steps: i32, most: i32) -> i32 {
    // 2^16 = whole · most + rest, and rest/most is about rest/2ⁿ.
    let n = 32 - most.cast_unsigned().leading_zeros();
    let (whole, rest) = if most > 0 {
        (65_536 / most, 65_536 % most)
    } else {
        (0, 0)
    };
    steps
        .wrapping_mul(whole)
        .wrapping_add(steps.wrapping_mul(rest) >> n)
}

/// Levels of a color `C` under a light from −2 to 65,538. The error is at most 1/32 step; full brightness is exact for
/// whole steps.
#[inline]
pub(super) fn dimmed<C: Levels>(levels: [i32; 3], light: Illumination) -> [i32; 3] {
    // 16 bits times 15 bits, so that cores without a long multiply do not need one.
    let dim = |level: i32, light: i32| (level >> 8).wrapping_mul(light >> 2) >> 6;
    glossed::<C>(zip(levels, light.diffuse, dim), light)
}

/// Levels of a color `C` with a highlight added, at most white.
#[inline]
fn glossed<C: Levels>(levels: [i32; 3], light: Illumination) -> [i32; 3] {
    let Some(specular) = light.specular else {
        return levels;
    };
    zip(levels, C::MAX_STEPS, |level, most| {
        let glossed = level.wrapping_add(specular.wrapping_mul(most));
        glossed.min(most << 16)
    })
}

/// Half a step.
pub(super) const HALF: i32 = 1 << 15;

/// Error of a level that cannot be seen: 1/8 step.
pub(super) const LEVEL: u32 = 1 << 13;

/// Error of a fraction or a brightness that cannot be seen, in units of 1/65,536: 1/16 step of 6 bits, 1/4 step of 8
/// bits.
pub(super) const FRACTION: u32 = 1 << 6;

/// c/255 in units of 2⁻¹⁶, with an error of at most half a unit: 0 for 0, 65,536 for 255.
#[inline]
const fn fraction(c: u8) -> i32 {
    // 65,536/255 = 257 + 1/255, and c/255 rounds to the top bit of c.
    c as i32 * 257 + (c >> 7) as i32
}

#[inline]
fn rgb_fractions(color: Rgb888) -> [i32; 3] {
    [
        fraction(color.r()),
        fraction(color.g()),
        fraction(color.b()),
    ]
}

/// The luma of fractions.
#[inline]
pub(super) fn luma([r, g, b]: [i32; 3]) -> i32 {
    // The sum of the weights is 2^14, and the luma of white is 2^30.
    (4899 * r + 9617 * g + 1868 * b + (1 << 13)) >> 14
}

/// The nearest step. The half step absorbs interpolation errors below 0 and above white.
#[inline]
fn round(level: i32) -> u8 {
    whole(level.wrapping_add(HALF))
}

/// The whole steps of a level that is in range.
#[inline]
pub(super) fn whole(level: i32) -> u8 {
    (level >> 16).cast_unsigned() as u8
}

macro_rules! rgb {
    ($($color:ident)+) => {$(
        impl Levels for $color {
            type Channels = [i32; 3];

            const MAX_STEPS: [i32; 3] = [
                $color::MAX_R as i32,
                $color::MAX_G as i32,
                $color::MAX_B as i32,
            ];

            #[inline]
            fn fractions(color: Rgb888) -> [i32; 3] {
                rgb_fractions(color)
            }

            #[inline]
            fn steps(self) -> [i32; 3] {
                [self.r().into(), self.g().into(), self.b().into()]
            }

            #[inline]
            fn from_levels([r, g, b]: [i32; 3], _: Point) -> Self {
                Self::new(round(r), round(g), round(b))
            }

            #[inline]
            fn from_raised([r, g, b]: [i32; 3], _: Point) -> Self {
                Self::new(whole(r), whole(g), whole(b))
            }

            #[inline]
            fn covered(self, by: Self, coverage: u32, at: Point) -> Self {
                if Self::WEIGHT_BITS == 5 {
                    // One product for all channels. In this order, one color and one share are prepared before a loop.
                    return by.mix(self, 32 - ((coverage + 4) >> 3));
                }
                Self::from_levels(covered(self.steps(), by.steps(), coverage), at)
            }
        }

    )+};
}

macro_rules! gray {
    ($($color:ident $white:literal $step:ident |$level:ident, $at:pat_param| $from:expr;)+) => {$(
        impl Levels for $color {
            type Channels = [i32; 1];

            const MAX_STEPS: [i32; 3] = [$white; 3];

            #[inline]
            fn fractions(color: Rgb888) -> [i32; 3] {
                [luma(rgb_fractions(color)); 3]
            }

            #[inline]
            fn steps(self) -> [i32; 3] {
                [i32::from(self.$step()); 3]
            }

            #[inline]
            fn from_levels([$level, ..]: [i32; 3], $at: Point) -> Self {
                $from
            }
        }
    )+};
}

rgb!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);
gray! {
    Gray2 3 luma |level, at| Self::new(dither(level, at));
    Gray4 15 luma |level, at| Self::new(dither(level, at));
    Gray8 255 luma |level, _| Self::new(round(level));
    BinaryColor 1 is_on |level, at| Self::from(dither(level, at) & 1 != 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    const ORIGIN: Point = Point::zero();

    fn pixels() -> impl Iterator<Item = Point> {
        // Away from the origin, because the pattern belongs to the frame.
        (0..64).map(|i| Point::new(3 + i % 8, i / 8 - 5))
    }

    #[test]
    fn rgb_rounds_to_nearest_for_every_value() {
        for c in 0..=255 {
            let color = Rgb565::from_rgb(Rgb888::new(c, c, c), ORIGIN);
            let steps = [color.r(), color.g()].map(f64::from);
            let exact = [31.0, 63.0].map(|max| f64::from(c) * max / 255.0);
            assert!((steps[0] - exact[0]).abs() < 0.5 && (steps[1] - exact[1]).abs() < 0.5);
            assert_eq!(color, Rgb565::from(Rgb888::new(c, c, c)));
            let other = Rgb888::new(c, 255 - c, c ^ 0x55);
            assert_eq!(Rgb888::from_rgb(other, ORIGIN), other);
            assert_eq!(Bgr888::from_rgb(other, ORIGIN), other.into());
            assert_eq!(Bgr565::from_rgb(other, ORIGIN), other.into());
            assert_eq!(Rgb666::from_rgb(other, ORIGIN), other.into());
            assert_eq!(Gray8::from_rgb(Rgb888::new(c, c, c), ORIGIN), Gray8::new(c));
        }
    }

    #[test]
    fn gray_is_luma() {
        for (color, weight) in [
            (Rgb888::RED, 0.299),
            (Rgb888::GREEN, 0.587),
            (Rgb888::BLUE, 0.114),
        ] {
            let [level, ..] = Gray8::levels(color);
            // The error of a weight is at most 2^-15, which is 0.008 step.
            assert!((f64::from(level) / 65536.0 - weight * 255.0).abs() < 0.012);
        }
    }

    fn dithers<C: Levels>(step: impl Fn(C) -> i32) {
        let [white, ..] = C::MAX_STEPS;
        for level in (0..=white << 16).step_by(97) {
            let sum: i32 = pixels()
                .map(|at| step(C::from_levels([level; 3], at)))
                .sum();
            // One step of the sum is 1/64 step of the mean; the error is at most half a step of the sum.
            let error = (sum << 16) - level * 64;
            assert!(error.abs() <= 1 << 15, "level {level}: sum {sum}");
        }
        for at in pixels() {
            for error in [-511, -2, 0, 2, 511] {
                assert_eq!(step(C::from_levels([error; 3], at)), 0);
                let level = (white << 16) + error;
                assert_eq!(step(C::from_levels([level; 3], at)), white);
            }
            assert_eq!(step(C::from_rgb(Rgb888::BLACK, at)), 0);
            assert_eq!(step(C::from_rgb(Rgb888::WHITE, at)), white);
        }
    }

    #[test]
    fn dithering_keeps_the_mean_and_the_ends() {
        dithers(|color: Gray4| color.luma().into());
        dithers(|color: Gray2| color.luma().into());
        dithers(|color: BinaryColor| color.is_on().into());
    }

    #[test]
    fn half_white_is_a_checker() {
        let rows: std::vec::Vec<std::string::String> = (0..4)
            .map(|y| {
                (0..8)
                    .map(
                        |x| match BinaryColor::from_levels([1 << 15; 3], Point::new(x, y)) {
                            BinaryColor::On => '#',
                            BinaryColor::Off => '.',
                        },
                    )
                    .collect()
            })
            .collect();
        assert_eq!(rows, [".#.#.#.#", "#.#.#.#.", ".#.#.#.#", "#.#.#.#."]);
    }

    #[test]
    fn interpolation_errors_do_not_wrap() {
        for error in [-2, 2] {
            let ends = [Rgb565::BLACK, Rgb565::WHITE].map(|end| {
                let levels = Rgb565::levels(end.into()).map(|level| level + error);
                Rgb565::from_levels(levels, ORIGIN)
            });
            assert_eq!(ends, [Rgb565::BLACK, Rgb565::WHITE]);
            assert_eq!(Gray8::from_levels([error; 3], ORIGIN), Gray8::BLACK);
            assert_eq!(
                Rgb888::WHITE.lit(Illumination::white(65536 + error), ORIGIN),
                Rgb888::WHITE
            );
            assert_eq!(
                Rgb888::WHITE.lit(Illumination::white(error), ORIGIN),
                Rgb888::BLACK
            );
        }
    }

    #[test]
    fn light_scales_and_no_number_panics() {
        assert_eq!(
            Rgb565::new(30, 40, 11).lit(Illumination::white(1 << 15), ORIGIN),
            Rgb565::new(15, 20, 6)
        );
        assert_eq!(
            Gray8::new(201).lit(Illumination::white(65536), ORIGIN),
            Gray8::new(201)
        );
        let full = dimmed::<Rgb888>(Rgb888::levels(Rgb888::WHITE), Illumination::white(65536));
        assert_eq!(full, [255 << 16; 3]);
        for n in [i32::MIN, -1, i32::MAX] {
            let light = Illumination {
                specular: Some(n),
                ..Illumination::white(n)
            };
            let _ = (
                Rgb565::WHITE.lit(light, ORIGIN),
                dimmed::<Rgb565>([n; 3], light),
            );
            let _ = BinaryColor::from_levels([n; 3], Point::new(n, n));
        }
    }
}
