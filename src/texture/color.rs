//! Colors of files as colors of textures, at run time and at compile time.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565,
    Rgb666, Rgb888, RgbColor,
};

use super::include::{Convert, File};
use super::pixel::{Entry, Pixel, byte, channels, entry, index, rgb, widened, word, write_colors};
use crate::message;
use crate::sealed::Sealed;

/// A color that the pixels of a file can be converted to: any color of embedded-graphics.
///
/// Each channel is rounded to the nearest step, as in embedded-graphics. Gray is the BT.601 luma that
/// [`Levels`](crate::shade::Levels) uses (0.299 red + 0.587 green + 0.114 blue), rounded once to the nearest step and
/// not dithered. [`BinaryColor`] is on if the luma is at least half of white.
///
/// ```
/// use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565};
/// use fixel::texture::ImageColor;
/// let orange = [255, 128, 0];
/// assert_eq!(Rgb565::nearest(orange), Rgb565::new(31, 32, 0));
/// assert_eq!(Gray4::nearest(orange), Gray4::new(9)); // 8.9
/// assert_eq!(BinaryColor::nearest(orange), BinaryColor::On);
/// ```
pub trait ImageColor: PixelColor + Sealed {
    /// The color nearest to red, green and blue, where 255 is full.
    #[must_use]
    fn nearest(rgb: [u8; 3]) -> Self;
}

/// c/255 in units of 2⁻¹⁶, with an error of at most half a unit: 0 for 0, 65,536 for 255. A macro, like the following
/// ones, because the compiler counts calls as steps.
macro_rules! fraction {
    ($channel:expr) => {
        ($channel as u32 * 257 + ($channel >> 7) as u32)
    };
}

/// A fraction in steps, rounded to nearest; `max` steps are full.
macro_rules! steps {
    ($fraction:expr, $max:expr) => {
        (($fraction * $max as u32 + (1 << 15)) >> 16) as u8
    };
}

/// The luma of red, green and blue as a fraction. The weights add up to 2^14.
macro_rules! luma {
    ($rgb:ident) => {
        (4899 * fraction!($rgb[0])
            + 9617 * fraction!($rgb[1])
            + 1868 * fraction!($rgb[2])
            + (1 << 13))
            >> 14
    };
}

macro_rules! colors {
    ($($color:ident |$rgb:ident| $nearest:expr;)+) => {$(
        impl Sealed for $color {}

        impl ImageColor for $color {
            #[inline]
            fn nearest($rgb: [u8; 3]) -> Self {
                $nearest
            }
        }

        impl<F: File, const N: usize> Convert<F, N> for $color {
            const TEXELS: &'static [Self; N] = &{
                const BLACK: $color = {
                    let $rgb = [0_u8; 3];
                    $nearest
                };
                let mut texels = [BLACK; N];
                write_colors!(texels[..N] = F::IMAGE, |$rgb| $nearest);
                texels
            };
            const COLORS: &'static [Self; 256] = &{
                let (image, path) = (F::IMAGE, F::PATH);
                let (table, length) = (message::checked(image.table(), path), image.bytes.len());
                let $rgb = entry!(table, image.bytes, length, 0);
                let mut colors = [$nearest; 256];
                let mut index = 1;
                while index < 256 {
                    let $rgb = entry!(table, image.bytes, length, index);
                    colors[index] = $nearest;
                    index += 1;
                }
                colors
            };
        }
    )+};
}

macro_rules! rgb_colors {
    ($($color:ident)+) => {
        colors! {$(
            $color |rgb| $color::new(
                steps!(fraction!(rgb[0]), $color::MAX_R),
                steps!(fraction!(rgb[1]), $color::MAX_G),
                steps!(fraction!(rgb[2]), $color::MAX_B),
            );
        )+}
    };
}

rgb_colors!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);
colors! {
    Gray2 |rgb| Gray2::new(steps!((luma!(rgb)), 3));
    Gray4 |rgb| Gray4::new(steps!((luma!(rgb)), 15));
    Gray8 |rgb| Gray8::new(steps!((luma!(rgb)), 255));
    BinaryColor |rgb| if luma!(rgb) >= 1 << 15 { BinaryColor::On } else { BinaryColor::Off };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Levels;
    use embedded_graphics::geometry::Point;
    use embedded_graphics::pixelcolor::GrayColor;

    /// Every value of each channel, with different values of the other channels.
    fn samples() -> impl Iterator<Item = [u8; 3]> {
        (0..=255).flat_map(|c: u8| {
            let d = c.wrapping_mul(37) ^ 0x5a;
            [[c, c, c], [c, 0, d], [d, c, 255], [255 - d, d, c]]
        })
    }

    fn as_levels<C: ImageColor + Levels + core::fmt::Debug>() {
        for rgb in samples() {
            let [r, g, b] = rgb;
            let expected = C::from_rgb(Rgb888::new(r, g, b), Point::zero());
            assert_eq!(C::nearest(rgb), expected, "{rgb:?}");
        }
    }

    #[test]
    fn colors_that_are_not_dithered_are_those_of_levels() {
        as_levels::<Rgb555>();
        as_levels::<Bgr555>();
        as_levels::<Rgb565>();
        as_levels::<Bgr565>();
        as_levels::<Rgb666>();
        as_levels::<Bgr666>();
        as_levels::<Rgb888>();
        as_levels::<Bgr888>();
        as_levels::<Gray8>();
    }

    #[test]
    fn gray_is_the_nearest_step_of_luma() {
        for rgb in samples() {
            let [r, g, b] = rgb.map(f64::from);
            let luma = (0.299 * r + 0.587 * g + 0.114 * b) / 255.0;
            // The error of each of the three weights is at most 2^-15, as in Levels.
            let near = |steps: u8, max: f64| {
                (f64::from(steps) - luma * max).abs() <= 0.5 + max * 3.0 / 32768.0
            };
            assert!(near(Gray8::nearest(rgb).luma(), 255.0), "{rgb:?}");
            assert!(near(Gray4::nearest(rgb).luma(), 15.0), "{rgb:?}");
            assert!(near(Gray2::nearest(rgb).luma(), 3.0), "{rgb:?}");
            let on = u8::from(BinaryColor::nearest(rgb).is_on());
            assert!(near(on, 1.0), "{rgb:?}");
        }
    }
}
