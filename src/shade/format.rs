//! Color formats: how a color is split into channels, and how channels are rounded or dithered to a color.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor,
    Rgb555, Rgb565, Rgb666, Rgb888, RgbColor,
};

use super::{Precise, Varyings};
use crate::sealed::Sealed;
use crate::texture::Blend;

/// A color whose channels can be interpolated, lit, tinted, blended, and rounded or dithered.
///
/// This trait is implemented for the colors of embedded-graphics. There are three channels: red, green and blue. A gray
/// color has three equal channels; only the first is used. Gray is the BT.601 luma of the stored values (without
/// gamma): 0.299 red + 0.587 green + 0.114 blue, with weights rounded to 2⁻¹⁴. A *step* is a unit of a channel in the
/// color's own format: the red of [`Rgb565`](Rgb565) is from 0 to 31 steps. A [`Precise`] color has channels with
/// fraction bits.
///
/// Colors with 5 or more bits per channel are rounded to nearest. [`Gray4`](Gray4), [`Gray2`](Gray2) and
/// [`BinaryColor`](BinaryColor) (on is white) are dithered by an 8x8 ordered matrix that is fixed to the frame. In an
/// area of one value, the mean of the dithered pixels is within 1/128 step of that value in any tile of 8x8 pixels. In
/// tiles whose corners are at multiples of the tile's size in the frame, the mean is within 7/128 step for 4x4 pixels,
/// and within 31/128 step for 2x2 pixels. Black stays black, and white stays white.
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
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no channels to compute with",
    label = "not a color that can be lit, tinted, blended or converted",
    note = "the colors of embedded-graphics have channels; for another color, implement `fixel::PixelFormat`"
)]
pub trait PixelFormat: PixelColor {
    /// The channels of white, in steps: 31, 63, 31 for [`Rgb565`](Rgb565). The white of a channel with n bits is 2ⁿ −
    /// 1, at most 255.
    const MAX_STEPS: [i32; 3];

    /// Whether the format is so coarse that it is dithered.
    const IS_DITHERED: bool = Self::MAX_STEPS[0] < 1 << 4;

    /// The channels that are interpolated: `[i32; 3]`, or `i32` for gray.
    type Channels: Channels;

    /// The channels in whole steps, 0 to [`MAX_STEPS`](Self::MAX_STEPS).
    fn steps(self) -> [i32; 3];

    /// Makes a color of these channels, in whole steps. Bits that the format does not have are dropped.
    #[must_use]
    fn from_steps(steps: [i32; 3]) -> Self;

    /// Converts `color` to this format: rounded to nearest or, in a dithered format, dithered for the pixel `at` of the
    /// frame.
    #[must_use]
    #[inline]
    fn from_rgb(color: Rgb888, at: Point) -> Self {
        Precise::of_rgb(color).finish(at)
    }

    /// Mixes `share`/65,536 of the color `by` with the rest of this color, and rounds or dithers the result. For colors
    /// of 15 and 16 bits, the share is first rounded to 1/32.
    #[must_use]
    #[inline]
    fn covered(self, by: Self, share: i32, at: Point) -> Self {
        // `by` comes first here, so that in a loop over pixels with the same `by` and the same share, the compiler
        // prepares both before the loop.
        let left_32 = 32_i32.wrapping_sub(share.wrapping_add(1 << 10) >> 11);
        match by.mix_32(self, left_32.cast_unsigned()) {
            Some(mixed) => mixed,
            None => Precise::of_mixture([self, by], share).finish(at),
        }
    }

    /// A mixture of this color and `weight`/32 of another color; `None` if the format cannot multiply all channels at
    /// once.
    #[doc(hidden)]
    #[must_use]
    #[inline]
    fn mix_32(self, other: Self, weight: u32) -> Option<Self> {
        let _ = (other, weight);
        None
    }
}

/// Applies `f` to three channels. This is not `array::map`, because in a build for size, `map` becomes a loop over
/// memory.
#[inline]
pub(super) fn each([r, g, b]: [i32; 3], f: impl Fn(i32) -> i32) -> [i32; 3] {
    [f(r), f(g), f(b)]
}

/// Applies `f` to each pair of channels.
#[inline]
pub(super) fn zip(
    [r, g, b]: [i32; 3],
    [x, y, z]: [i32; 3],
    f: impl Fn(i32, i32) -> i32,
) -> [i32; 3] {
    [f(r, x), f(g, y), f(b, z)]
}

/// The error that interpolation may add to a fraction: 1/1024.
pub(super) const FRACTION: u32 = 1 << 6;

/// c/255 in units of 2⁻¹⁶, with an error of at most half a unit: 0 for 0, 65,536 for 255.
#[inline]
pub(crate) const fn fraction(c: u8) -> i32 {
    // 65,536/255 = 257 + 1/255, and c/255 rounds to the top bit of c.
    c as i32 * 257 + (c >> 7) as i32
}

/// The channels of a color as fractions, 0 to 65,536; for a gray format, the color's luma.
#[inline]
pub(super) fn fractions<C: PixelFormat>(color: Rgb888) -> [i32; 3] {
    let rgb = [
        fraction(color.r()),
        fraction(color.g()),
        fraction(color.b()),
    ];
    if C::Channels::IS_GRAY {
        [luma(rgb); 3]
    } else {
        rgb
    }
}

/// The luma of red, green and blue, all as fractions.
#[inline]
pub(super) fn luma([r, g, b]: [i32; 3]) -> i32 {
    // The sum of the weights is 2^14, and the luma of white is 2^30.
    (4899 * r + 9617 * g + 1868 * b + (1 << 13)) >> 14
}

/// The whole steps of a level that is in range.
#[inline]
pub(super) fn whole(level: i32) -> i32 {
    level >> 16
}

/// Implements [`PixelFormat`] for colors of three channels, or for grays with their white, the method that returns their
/// step, and the function that makes a gray of `$steps`.
macro_rules! formats {
    ($($Color:ident)+) => {$(
        impl PixelFormat for $Color {
            type Channels = [i32; 3];

            const MAX_STEPS: [i32; 3] = [
                $Color::MAX_R as i32,
                $Color::MAX_G as i32,
                $Color::MAX_B as i32,
            ];

            #[inline]
            fn steps(self) -> [i32; 3] {
                [self.r().into(), self.g().into(), self.b().into()]
            }

            #[inline]
            fn from_steps([r, g, b]: [i32; 3]) -> Self {
                // Written without `map`, which is a loop in a build for size.
                let (r, g, b) = (r.cast_unsigned(), g.cast_unsigned(), b.cast_unsigned());
                Self::new(r as u8, g as u8, b as u8)
            }

            #[inline]
            fn mix_32(self, other: Self, weight: u32) -> Option<Self> {
                (Self::WEIGHT_BITS == 5).then(|| self.mix(other, weight))
            }
        }
    )+};
    ($($Gray:ident $white:literal $step:ident |$steps:ident| $from:expr;)+) => {$(
        impl PixelFormat for $Gray {
            type Channels = i32;

            const MAX_STEPS: [i32; 3] = [$white; 3];

            #[inline]
            fn steps(self) -> [i32; 3] {
                [i32::from(self.$step()); 3]
            }

            #[inline]
            fn from_steps([$steps, ..]: [i32; 3]) -> Self {
                let $steps = $steps.cast_unsigned() as u8;
                $from
            }
        }
    )+};
}
formats!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);
formats! {
    Gray2 3 luma |steps| Self::new(steps);
    Gray4 15 luma |steps| Self::new(steps);
    Gray8 255 luma |steps| Self::new(steps);
    BinaryColor 1 is_on |steps| Self::from(steps & 1 != 0);
}

/// The channels of a color or of light that are computed and interpolated: `[i32; 3]` for red, green and blue; `i32` if
/// all three are equal, as in gray and in white light; `()` for no light.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, Rgb565};
/// use fixel::shade::{Channels, PixelFormat};
/// let gray = <Gray8 as PixelFormat>::Channels::of([7, 7, 7]);
/// let color = <Rgb565 as PixelFormat>::Channels::of([1, 2, 3]);
/// assert_eq!((gray, color), (7, [1, 2, 3]));
/// ```
#[doc(hidden)]
pub trait Channels: Varyings + Default + Sealed {
    /// The channels of the sum of this light and another light.
    type Or<E: Channels>: Channels;

    /// The channels of the sum of this light and a white light.
    type OrWhite: Channels;

    /// The channels of this light on a canvas of color `C`.
    type On<C: PixelFormat>: Channels;

    /// Whether all channels are equal.
    const IS_GRAY: bool = false;

    const IS_NONE: bool = false;

    /// Selects these channels from red, green and blue.
    fn of(rgb: [i32; 3]) -> Self;

    /// Red, green and blue.
    fn rgb(self) -> [i32; 3];
}

impl Sealed for [i32; 3] {}
impl Sealed for i32 {}
impl Sealed for () {}

impl Channels for [i32; 3] {
    type Or<E: Channels> = Self;
    type OrWhite = Self;
    type On<C: PixelFormat> = C::Channels;

    #[inline]
    fn of(rgb: Self) -> Self {
        rgb
    }

    #[inline]
    fn rgb(self) -> Self {
        self
    }
}

impl Channels for i32 {
    type Or<E: Channels> = E::OrWhite;
    type OrWhite = Self;
    type On<C: PixelFormat> = Self;

    const IS_GRAY: bool = true;

    #[inline]
    fn of([channel, ..]: [i32; 3]) -> Self {
        channel
    }

    #[inline]
    fn rgb(self) -> [i32; 3] {
        // In a build for size, `[self; 3]` becomes a loop over memory.
        [self, self, self]
    }
}

impl Channels for () {
    type Or<E: Channels> = E;
    type OrWhite = i32;
    type On<C: PixelFormat> = ();

    const IS_NONE: bool = true;

    #[inline]
    fn of(_: [i32; 3]) -> Self {}

    #[inline]
    fn rgb(self) -> [i32; 3] {
        [0; 3]
    }
}

/// The 8x8 matrix of Bayer (1973): each number from 0 to 63 once, with consecutive numbers far apart.
///
/// In column x and row y, the number consists of the bits of x ^ y and of y, interleaved and in reverse order.
static BAYER: [[u8; 8]; 8] = [
    [0, 32, 8, 40, 2, 34, 10, 42],
    [48, 16, 56, 24, 50, 18, 58, 26],
    [12, 44, 4, 36, 14, 46, 6, 38],
    [60, 28, 52, 20, 62, 30, 54, 22],
    [3, 35, 11, 43, 1, 33, 9, 41],
    [51, 19, 59, 27, 49, 17, 57, 25],
    [15, 47, 7, 39, 13, 45, 5, 37],
    [63, 31, 55, 23, 61, 29, 53, 21],
];

/// The number to add to a level before the level is cut to whole steps, in units of 2⁻¹⁶ step. The number is (m + ½)/64
/// of a step, where m is the matrix's entry for this pixel. It lies between 512 and 65,024, with a mean of half a step.
///
/// A level of whole steps keeps its value even with an error of up to 511 units in either direction.
#[inline]
pub(super) fn threshold(at: Point) -> i32 {
    let (x, y) = (at.x.cast_unsigned() & 7, at.y.cast_unsigned() & 7);
    i32::from(BAYER[y as usize][x as usize]) * 1024 + 512
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::{Illumination, Output};

    const ORIGIN: Point = Point::zero();

    fn pixels() -> impl Iterator<Item = Point> {
        // These 8x8 pixels do not begin at the origin, because the pattern is fixed to the frame.
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

    /// Levels are c · white / 255, within a unit of 2^-16; the brightest is white.
    #[test]
    fn levels_of_24_bits_are_exact_to_a_unit() {
        fn check<C: PixelFormat>() {
            for channel in 0..=255_u8 {
                let color = Rgb888::new(channel, 255 - channel, channel / 2);
                let levels = Precise::<C>::of_rgb(color).levels();
                let channels = [color.r(), color.g(), color.b()];
                for ((level, channel), white) in levels.into_iter().zip(channels).zip(C::MAX_STEPS)
                {
                    let exact = (i64::from(channel) * i64::from(white)) << 16;
                    let error = 255 * i64::from(level) - exact;
                    assert!(error.abs() < 255, "{error} / 255 for {channel} of {white}");
                    assert!(channel < 255 || error == 0, "{level} for {white}");
                }
            }
        }
        check::<Rgb555>();
        check::<Rgb565>();
        check::<Rgb666>();
        check::<Bgr888>();
    }

    #[test]
    fn gray_is_luma() {
        for (color, weight) in [
            (Rgb888::RED, 0.299),
            (Rgb888::GREEN, 0.587),
            (Rgb888::BLUE, 0.114),
        ] {
            let [level, ..] = Precise::<Gray8>::of_rgb(color).levels();
            // The error of a weight is at most 2^-15, which is 0.008 step.
            assert!((f64::from(level) / 65536.0 - weight * 255.0).abs() < 0.012);
        }
    }

    fn dithers<C: PixelFormat>(step: impl Fn(C) -> i32) {
        let [white, ..] = C::MAX_STEPS;
        for level in (0..=white << 16).step_by(97) {
            let sum: i32 = pixels()
                .map(|at| step(Precise::<C>::from_levels([level; 3]).finish(at)))
                .sum();
            // A step of the sum is 1/64 step of the mean. The sum has an error of at most half a step.
            let error = (sum << 16) - level * 64;
            assert!(error.abs() <= 1 << 15, "level {level}: sum {sum}");
            // The thresholds of a smaller tile are 1/16 step apart (4x4) or 1/4 step (2x2). Its lowest threshold is at
            // least 1/128 step, and its highest at most 1 − 1/128 step.
            for (size, worst) in [(4, 7), (2, 31)] {
                for tile in 0..64 / (size * size) {
                    let (x, y) = (tile * size % 8, tile * size / 8 * size);
                    let at = |i| Point::new(x + i % size, y + i / size);
                    let dithered = |i| step(Precise::<C>::from_levels([level; 3]).finish(at(i)));
                    let sum: i32 = (0..size * size).map(dithered).sum();
                    let error = (sum << 16) - level * size * size;
                    let allowed = worst * size * size * (1 << 16) / 128;
                    assert!(error.abs() <= allowed, "level {level}, {size}: sum {sum}");
                }
            }
        }
        for at in pixels() {
            for error in [-511, -2, 0, 2, 511] {
                assert_eq!(step(Precise::<C>::from_levels([error; 3]).finish(at)), 0);
                let level = (white << 16) + error;
                assert_eq!(
                    step(Precise::<C>::from_levels([level; 3]).finish(at)),
                    white
                );
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
                        |x| match Precise::from_levels([1 << 15; 3]).finish(Point::new(x, y)) {
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
                let levels = Precise::<Rgb565>::of_rgb(end.into()).levels();
                Precise::<Rgb565>::from_levels(levels.map(|level| level + error)).finish(ORIGIN)
            });
            assert_eq!(ends, [Rgb565::BLACK, Rgb565::WHITE]);
            let gray = Precise::<Gray8>::from_levels([error; 3]).finish(ORIGIN);
            assert_eq!(gray, Gray8::BLACK);
            assert_eq!(
                Rgb888::WHITE
                    .lit(Illumination::white(65536 + error))
                    .finish(ORIGIN),
                Rgb888::WHITE
            );
            assert_eq!(
                Rgb888::WHITE.lit(Illumination::white(error)).finish(ORIGIN),
                Rgb888::BLACK
            );
        }
    }

    #[test]
    fn light_scales_and_no_number_panics() {
        assert_eq!(
            Rgb565::new(30, 40, 11)
                .lit(Illumination::white(1 << 15))
                .finish(ORIGIN),
            Rgb565::new(15, 20, 6)
        );
        assert_eq!(
            Gray8::new(201)
                .lit(Illumination::white(65536))
                .finish(ORIGIN),
            Gray8::new(201)
        );
        let full = Precise::<Rgb888>::of_rgb(Rgb888::WHITE).times([65536; 3]);
        assert_eq!(full.levels(), [255 << 16; 3]);
        for n in [i32::MIN, -1, i32::MAX] {
            let light = Illumination {
                diffuse: n,
                specular: n,
            };
            let _ = (
                Rgb565::WHITE.lit(light).finish(ORIGIN),
                Precise::<Rgb565>::from_levels([n; 3]).lit(light),
            );
            let _ = Precise::<BinaryColor>::from_levels([n; 3]).finish(Point::new(n, n));
        }
    }

    #[test]
    fn the_matrix_is_the_one_bayer_published() {
        // The first two rows of the 8x8 matrix, which follows from Bayer's printed 4x4 matrix by doubling.
        assert_eq!(BAYER[0], [0, 32, 8, 40, 2, 34, 10, 42]);
        assert_eq!(BAYER[1], [48, 16, 56, 24, 50, 18, 58, 26]);
        let mut all: std::vec::Vec<u8> = BAYER.as_flattened().into();
        all.sort_unstable();
        assert!(all.into_iter().eq(0..64));
    }

    #[test]
    fn thresholds_repeat_left_of_and_above_the_frame() {
        assert_eq!(threshold(Point::new(-8, -1)), threshold(Point::new(0, 7)));
    }
}
