//! Colors in full precision. Adapters compute with these colors; the canvas rounds or dithers the result.

use core::marker::PhantomData;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::format::{each, fractions, luma, threshold, whole, zip};
use super::{Channels, Illumination, Lanes, PixelFormat, Tolerance, Varyings};

/// A color of format `C`, with channels that keep 16 fraction bits.
///
/// Light, tint, fog and every other adapter return a `Precise` color. So the result of a whole stack of adapters is
/// rounded or dithered once, when the canvas stores it. A *level* is a channel in steps of the format, with 16 fraction
/// bits: a red level of [`Rgb565`] is from 0 to 31 · 65,536. A *fraction* is a share of full brightness; full
/// brightness is 65,536. Gray formats use only the first of the three levels.
///
/// ```
/// use embedded_graphics::{pixelcolor::{Gray4, Rgb565}, prelude::*};
/// use fixel::shade::Precise;
/// let color = Precise::from(Rgb565::new(3, 10, 31)).times([32_768; 3]);
/// assert_eq!(color.levels(), [98_304, 327_680, 1_015_808]); // 1.5, 5, 15.5 steps
/// assert_eq!(color.finish(Point::zero()), Rgb565::new(2, 5, 16));
/// // A quarter of a step remains, also in the mean of 8x8 dithered pixels.
/// let gray = Precise::from(Gray4::new(1)).times([32_768; 3]).times([32_768; 3]);
/// let mean: u32 = (0..64).map(|i| u32::from(gray.finish(Point::new(i % 8, i / 8)).luma())).sum();
/// assert_eq!(mean, 16);
/// ```
///
/// [`Rgb565`]: embedded_graphics::pixelcolor::Rgb565
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Precise<C> {
    /// The levels plus half a step, so that a pixel rounds a level by cutting its fraction. If levels are interpolated,
    /// half a step is added once per vertex instead of once per pixel.
    raised: [i32; 3],
    format: PhantomData<C>,
}

impl<C: PixelFormat> Default for Precise<C> {
    /// Black.
    fn default() -> Self {
        Self::from_levels([0; 3])
    }
}

/// Half a step.
const HALF: i32 = 1 << 15;

impl<C: PixelFormat> From<C> for Precise<C> {
    #[inline]
    fn from(color: C) -> Self {
        Self::from_levels(each(color.steps(), |step| step << 16))
    }
}

impl<C: PixelFormat> Precise<C> {
    /// The number of low bits that a level loses before it is multiplied by a fraction. A dithered format has few
    /// steps, so levels of this format lose only as many bits as a step has, and the error of a product is below 1/1000
    /// step. In other formats, the error is at most 1/250 step.
    const DOWN: u32 = if C::IS_DITHERED {
        32 - C::MAX_STEPS[0].leading_zeros()
    } else {
        8
    };

    /// The error that interpolation may cause: 1/8 step, because rounding hides most of it, or 1/64 step in a dithered
    /// format, because dithering shows it.
    const TOLERANCE: u32 = if C::IS_DITHERED { 1 << 10 } else { 1 << 13 };

    #[inline]
    const fn of_raised(raised: [i32; 3]) -> Self {
        Self {
            raised,
            format: PhantomData,
        }
    }

    /// The color of these levels.
    ///
    /// A level may be below black or above white by up to 511 units of 1/65,536 step; interpolation errors are far
    /// smaller. If a level is farther out of range, the color is unspecified.
    #[must_use]
    #[inline]
    pub fn from_levels(levels: [i32; 3]) -> Self {
        Self::of_raised(each(levels, |level| level.wrapping_add(HALF)))
    }

    /// The levels of red, green and blue, in units of 1/65,536 step of the format. (In `Rgb565`, red is from 0 to 31
    /// steps.)
    #[must_use]
    #[inline]
    pub fn levels(self) -> [i32; 3] {
        each(self.raised, |level| level.wrapping_sub(HALF))
    }

    /// Converts a color of 24 bits. The error is at most 1/65,536 step, or 0.003 step in a gray format; black and white
    /// are exact.
    #[must_use]
    #[inline]
    pub fn of_rgb(color: Rgb888) -> Self {
        if C::Channels::IS_GRAY {
            return Self::of_products(C::MAX_STEPS, fractions::<C>(color));
        }
        let channels = [color.r().into(), color.g().into(), color.b().into()];
        Self::of_raised(zip(channels, C::MAX_STEPS, |channel, most| {
            // `steps` is a constant: the number of steps in 1/255 of white, in units of 2^-24, rounded up so that white
            // is exact. The product plus half a step fits into 32 bits.
            let steps = (most.cast_unsigned() << 24) / 255 + 1;
            let level = channel.cast_unsigned().wrapping_mul(steps);
            (level.wrapping_add(HALF.cast_unsigned() << 8) >> 8).cast_signed()
        }))
    }

    /// The product of steps and fractions, which is exact.
    #[inline]
    pub(super) fn of_products(steps: [i32; 3], fractions: [i32; 3]) -> Self {
        // Products are below 2^24 for numbers in range. Other numbers from a user's shader wrap, so that they cannot
        // cause a panic.
        Self::from_levels(zip(steps, fractions, i32::wrapping_mul))
    }

    /// The exact sum of two colors, limited to white.
    #[inline]
    pub(crate) fn of_sum(a: C, b: C) -> Self {
        let sums = zip(a.steps(), b.steps(), |a, b| a + b);
        let sums = zip(sums, C::MAX_STEPS, Ord::min);
        Self::from_levels(each(sums, |sum| sum << 16))
    }

    /// The product of two colors, where white is 1. The error is at most 16/65,536 step.
    #[inline]
    pub(crate) fn of_product(a: C, b: C) -> Self {
        let products = zip(a.steps(), b.steps(), i32::wrapping_mul);
        Self::from_levels(zip(products, C::MAX_STEPS, over))
    }

    /// The color `below` after the color `above` covers a share of it, from 0 to 65,536; exact.
    #[inline]
    pub(super) fn of_mixture([below, above]: [C; 2], share: i32) -> Self {
        Self::from_levels(zip(below.steps(), above.steps(), |below, above| {
            // A difference of 9 bits times a share of 17 bits fits into 32 bits.
            let more = above.wrapping_sub(below).wrapping_mul(share);
            (below << 16).wrapping_add(more)
        }))
    }

    /// The color that a canvas stores at a pixel of the frame: rounded to nearest, or dithered if the format is coarse.
    #[must_use]
    #[inline]
    pub fn finish(self, at: Point) -> C {
        let Self { raised, .. } = if C::IS_DITHERED {
            self.raised_by_threshold(at)
        } else {
            self
        };
        let [r, g, b] = raised;
        C::from_steps([whole(r), whole(g), whole(b)])
    }

    /// The color, dithered to whole steps at a pixel of the frame, in any format.
    #[must_use]
    #[inline]
    pub(super) fn dithered(self, at: Point) -> Self {
        if C::IS_DITHERED {
            self
        } else {
            self.raised_by_threshold(at)
        }
    }

    #[inline]
    fn raised_by_threshold(self, at: Point) -> Self {
        let threshold = threshold(at) - HALF;
        // The sum is positive for every level in range; the clamp stops lower levels from wrapping.
        Self::of_raised(each(self.raised, |level| {
            level.wrapping_add(threshold).max(0)
        }))
    }

    /// A level, or a difference of two levels, times a fraction.
    #[inline]
    fn part(level: i32, fraction: i32) -> i32 {
        // 16 bits and a sign times 15 bits: the product fits into 32 bits, so that no core needs a 64-bit product.
        (level >> Self::DOWN).wrapping_mul(fraction >> 2) >> (14 - Self::DOWN)
    }

    /// This color multiplied, channel by channel, by fractions from 0 to 65,536.
    #[must_use]
    #[inline]
    pub fn times(self, fractions: [i32; 3]) -> Self {
        Self::from_levels(zip(self.levels(), fractions, Self::part))
    }

    /// The sum of two colors, channel by channel, limited to white.
    #[must_use]
    #[inline]
    pub fn plus(self, other: Self) -> Self {
        Self::of_raised(zip(
            zip(self.raised, other.levels(), i32::wrapping_add),
            C::MAX_STEPS,
            |level, most| level.min((most << 16) + HALF),
        ))
    }

    /// Mixes `share`/65,536 of `other` with the rest of this color.
    #[must_use]
    #[inline]
    pub fn mix(self, other: Self, share: i32) -> Self {
        Self::of_raised(zip(self.raised, other.raised, |below, above| {
            below.wrapping_add(Self::part(above.wrapping_sub(below), share))
        }))
    }

    /// The color under a light.
    #[inline]
    pub(super) fn lit<D: Channels, S: Channels>(self, light: Illumination<D, S>) -> Self {
        self.times(light.diffuse.rgb()).glossed(light.specular)
    }

    /// The color with a highlight.
    #[inline]
    pub(super) fn glossed<S: Channels>(self, specular: S) -> Self {
        if S::IS_NONE {
            return self;
        }
        self.plus(Self::of_products(C::MAX_STEPS, specular.rgb()))
    }

    /// The channels as fractions, 0 to 65,536.
    #[must_use]
    #[inline]
    pub fn fractions(self) -> [i32; 3] {
        // Each level of an 8-bit format gives the nearest fraction. A level of at most 24 bits loses two bits, so that
        // `over` returns at most 2^14 · 2^16, which fits.
        zip(self.levels(), C::MAX_STEPS, |level, most| {
            over(level >> 2, most).wrapping_add(1 << 13) >> 14
        })
    }

    /// This color in another format.
    #[must_use]
    #[inline]
    pub fn converted<D: PixelFormat>(self) -> Precise<D> {
        let fractions = self.fractions();
        let fractions = if D::Channels::IS_GRAY && !C::Channels::IS_GRAY {
            [luma(fractions); 3]
        } else if C::Channels::IS_GRAY {
            [fractions[0]; 3]
        } else {
            fractions
        };
        Precise::of_products(D::MAX_STEPS, fractions)
    }
}

/// `steps` / `most` in units of 2^-16, for a `most` of 2ⁿ − 1 and `steps` up to 2^14 · `most`.
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

impl<C: PixelFormat> Varyings for Precise<C> {
    type Lanes = <C::Channels as Varyings>::Lanes;
    type Face = <C::Channels as Varyings>::Face;

    const PAIRS: bool =
        Self::Lanes::COUNT == 3 && C::MAX_STEPS[0] < 1 << 5 && C::MAX_STEPS[2] < 1 << 5;

    #[inline]
    fn tolerance(_: usize) -> Tolerance {
        Tolerance::Units(Self::TOLERANCE)
    }

    #[inline]
    fn split(self) -> (<Self::Lanes as Lanes>::Of<i32>, Self::Face) {
        C::Channels::of(self.raised).split()
    }

    #[inline]
    fn join(numbers: <Self::Lanes as Lanes>::Of<i32>, face: Self::Face) -> Self {
        Self::of_raised(C::Channels::join(numbers, face).rgb())
    }
}
