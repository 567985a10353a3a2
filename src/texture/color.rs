//! The colors of pictures as colors of textures, at compile time.

pub use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666,
    Rgb888, RgbColor,
};

use super::include::Pixels;
pub use super::{Argb1555, Argb4444};

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

/// Colors that a picture can be converted to: `$nearest` is the one nearest to red, green, blue and alpha. Each has a
/// module of two functions, which the macro's expansion calls for the constants of [`Convert`](super::include::Convert):
/// the compiler lets only code of the program itself run for long.
macro_rules! colors {
    ($($color:ident $name:ident |$rgba:ident| $nearest:expr;)+) => {$(
        #[doc = concat!("Pictures in `", stringify!($color), "`.")]
        pub mod $name {
            use super::*;

            /// The first colors, as many as there is room for, and the last one for all further indices.
            const fn table<const N: usize>(colors: &[u8]) -> [$color; N] {
                let $rgba = match colors.last_chunk::<4>() {
                    Some(last) => *last,
                    None => [0; 4],
                };
                let mut table = [$nearest; N];
                let (mut rest, mut at) = (colors, 0);
                while let (&[r, g, b, alpha, ref others @ ..], true) = (rest, at < N) {
                    let $rgba = [r, g, b, alpha];
                    table[at] = $nearest;
                    rest = others;
                    at += 1;
                }
                table
            }

            /// A palette's colors, from the bytes of red, green, blue and alpha.
            #[must_use]
            pub const fn colors(colors: &[u8]) -> [$color; 256] {
                table(colors)
            }

            /// The pixels of a picture. With indices of three bytes, it has no more colors than pixels.
            #[must_use]
            pub const fn texels<const N: usize>(colors: &[u8], pixels: Pixels) -> [$color; N] {
                let mut texels = table::<N>(colors);
                let mut at = 0;
                // Patterns, because in the compiler, an index takes as long as several of them.
                match pixels {
                    Pixels::Bytes(mut pixels) => {
                        let table = table::<256>(colors);
                        while let &[pixel, ref others @ ..] = pixels {
                            texels[at] = table[pixel as usize];
                            pixels = others;
                            at += 1;
                        }
                    }
                    Pixels::Words(mut pixels) => {
                        let table = texels;
                        while let &[a, b, c, ref others @ ..] = pixels {
                            texels[at] = table[a as usize | (b as usize) << 8 | (c as usize) << 16];
                            pixels = others;
                            at += 1;
                        }
                    }
                }
                texels
            }
        }
    )+};
}

macro_rules! rgb_colors {
    ($($color:ident $name:ident)+) => {
        colors! {$(
            $color $name |rgb| $color::new(
                steps!(fraction!(rgb[0]), $color::MAX_R),
                steps!(fraction!(rgb[1]), $color::MAX_G),
                steps!(fraction!(rgb[2]), $color::MAX_B),
            );
        )+}
    };
}

rgb_colors! {
    Rgb555 rgb555 Bgr555 bgr555 Rgb565 rgb565 Bgr565 bgr565
    Rgb666 rgb666 Bgr666 bgr666 Rgb888 rgb888 Bgr888 bgr888
}
colors! {
    Gray2 gray2 |rgb| Gray2::new(steps!((luma!(rgb)), 3));
    Gray4 gray4 |rgb| Gray4::new(steps!((luma!(rgb)), 15));
    Gray8 gray8 |rgb| Gray8::new(steps!((luma!(rgb)), 255));
    BinaryColor binary |rgb| if luma!(rgb) >= 1 << 15 { BinaryColor::On } else { BinaryColor::Off };
    Argb1555 argb1555 |rgba| Argb1555::from_bits(
        ((rgba[3] >> 7) as u16) << 15
            | (steps!(fraction!(rgba[0]), 31) as u16) << 10
            | (steps!(fraction!(rgba[1]), 31) as u16) << 5
            | steps!(fraction!(rgba[2]), 31) as u16
    );
    Argb4444 argb4444 |rgba| Argb4444::from_bits(
        (steps!(fraction!(rgba[3]), 15) as u16) << 12
            | (steps!(fraction!(rgba[0]), 15) as u16) << 8
            | (steps!(fraction!(rgba[1]), 15) as u16) << 4
            | steps!(fraction!(rgba[2]), 15) as u16
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PixelFormat;
    use embedded_graphics::geometry::Point;
    use embedded_graphics::pixelcolor::GrayColor;

    const COUNT: usize = 1024;

    /// Every value of each channel, with different values of the other channels.
    const SAMPLES: [[u8; 4]; COUNT] = {
        let mut samples = [[0; 4]; COUNT];
        let mut at = 0;
        while at < COUNT {
            let c = (at / 4) as u8;
            let d = c.wrapping_mul(37) ^ 0x5a;
            samples[at] = match at % 4 {
                0 => [c, c, c, d],
                1 => [c, 0, d, c],
                2 => [d, c, 255, 255],
                _ => [255 - d, d, c, 0],
            };
            at += 1;
        }
        samples
    };

    const INDICES: [[u8; 3]; COUNT] = {
        let mut indices = [[0; 3]; COUNT];
        let mut at = 0;
        while at < COUNT {
            let index = COUNT - 1 - at;
            indices[at] = [index as u8, (index >> 8) as u8, 0];
            at += 1;
        }
        indices
    };

    /// The samples with their colors: those of a picture of the samples in the opposite order.
    fn converted<C>(
        texels: impl Fn(&[u8], Pixels) -> [C; COUNT],
    ) -> impl Iterator<Item = ([u8; 4], C)> {
        let texels = texels(
            SAMPLES.as_flattened(),
            Pixels::Words(INDICES.as_flattened()),
        );
        SAMPLES.into_iter().rev().zip(texels)
    }

    fn as_levels<C: PixelFormat + core::fmt::Debug>(texels: impl Fn(&[u8], Pixels) -> [C; COUNT]) {
        for (rgba, color) in converted(texels) {
            let [r, g, b, _] = rgba;
            let expected = C::from_rgb(Rgb888::new(r, g, b), Point::zero());
            assert_eq!(color, expected, "{rgba:?}");
        }
    }

    #[test]
    fn colors_that_are_not_dithered_are_those_of_levels() {
        as_levels(rgb555::texels);
        as_levels(bgr555::texels);
        as_levels(rgb565::texels);
        as_levels(bgr565::texels);
        as_levels(rgb666::texels);
        as_levels(bgr666::texels);
        as_levels(rgb888::texels);
        as_levels(bgr888::texels);
        as_levels(gray8::texels);
    }

    #[test]
    fn gray_is_the_nearest_step_of_luma() {
        // The error of each of the three weights is at most 2^-15, as in PixelFormat.
        let near = |steps: u8, [r, g, b, _]: [u8; 4], max: f64| {
            let [r, g, b] = [r, g, b].map(f64::from);
            let luma = (0.299 * r + 0.587 * g + 0.114 * b) / 255.0;
            (f64::from(steps) - luma * max).abs() <= 0.5 + max * 3.0 / 32768.0
        };
        assert!(converted(gray8::texels).all(|(rgba, gray)| near(gray.luma(), rgba, 255.0)));
        assert!(converted(gray4::texels).all(|(rgba, gray)| near(gray.luma(), rgba, 15.0)));
        assert!(converted(gray2::texels).all(|(rgba, gray)| near(gray.luma(), rgba, 3.0)));
        let mut all = converted(binary::texels);
        assert!(all.all(|(rgba, color)| near(u8::from(color.is_on()), rgba, 1.0)));
    }

    #[test]
    fn opacity_is_rounded_like_channels() {
        let steps = |byte: u8, most: f64| (f64::from(byte) / 255.0 * most).round() as u16;
        for ([r, g, b, a], color) in converted(argb4444::texels) {
            let bits = [a, r, g, b].map(|byte| steps(byte, 15.0));
            let bits = bits[0] << 12 | bits[1] << 8 | bits[2] << 4 | bits[3];
            assert_eq!(color, Argb4444::from_bits(bits));
        }
        for ([r, g, b, a], color) in converted(argb1555::texels) {
            let bits = [r, g, b].map(|byte| steps(byte, 31.0));
            let bits = steps(a, 1.0) << 15 | bits[0] << 10 | bits[1] << 5 | bits[2];
            assert_eq!(color, Argb1555::from_bits(bits));
        }
    }
}
