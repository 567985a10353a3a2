//! The colors of pictures as colors of textures, at compile time.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666,
    Rgb888, RgbColor,
};

use super::include::{Convert, File, texels};
use super::{Argb1555, Argb4444};

/// A channel of 8 bits in steps, rounded to nearest; `$max` steps are full. These are macros because the compiler counts
/// calls as steps.
macro_rules! steps {
    ($channel:expr, $max:expr) => {
        rounded!(fraction!($channel), $max)
    };
}

/// c/255 in units of 2⁻¹⁶, with an error of at most half a unit: 0 for 0, 65,536 for 255.
macro_rules! fraction {
    ($channel:expr) => {
        ($channel as u32 * 257 + ($channel >> 7) as u32)
    };
}

/// A fraction in steps.
macro_rules! rounded {
    ($fraction:expr, $max:expr) => {
        (($fraction * $max as u32 + (1 << 15)) >> 16) as u8
    };
}

/// The luma of red, green and blue in steps. The weights add up to 2^14.
macro_rules! luma {
    ($rgb:ident, $max:expr) => {
        rounded!(
            (4899 * fraction!($rgb[0])
                + 9617 * fraction!($rgb[1])
                + 1868 * fraction!($rgb[2])
                + (1 << 13))
                >> 14,
            $max
        )
    };
}

/// Colors that a picture can be converted to: `$nearest` is the one nearest to red, green, blue and alpha.
macro_rules! colors {
    ($([$($Color:ident)+] |$rgba:ident| $nearest:expr;)+) => {$($(
        impl<F: File, const N: usize> Convert<F, N> for $Color {
            const TABLE: &'static [Self; N] = &{
                let $rgba = match F::COLORS.last_chunk::<4>() {
                    Some(last) => *last,
                    None => [0; 4],
                };
                let mut table = [$nearest; N];
                let (mut rest, mut at) = (F::COLORS, 0);
                // Patterns, because in the compiler, an index takes as long as several of them.
                while let (&[r, g, b, alpha, ref others @ ..], true) = (rest, at < N) {
                    let $rgba = [r, g, b, alpha];
                    table[at] = $nearest;
                    rest = others;
                    at += 1;
                }
                table
            };
            const TEXELS: &'static [Self; N] =
                &texels(F::PIXELS, <Self as Convert<F, 256>>::TABLE, <Self as Convert<F, N>>::TABLE);
        }
    )+)+};
}

colors! {
    [Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888] |rgb| Self::new(
        steps!(rgb[0], Self::MAX_R),
        steps!(rgb[1], Self::MAX_G),
        steps!(rgb[2], Self::MAX_B),
    );
    [Gray2] |rgb| Self::new(luma!(rgb, 3));
    [Gray4] |rgb| Self::new(luma!(rgb, 15));
    [Gray8] |rgb| Self::new(luma!(rgb, 255));
    [BinaryColor] |rgb| if luma!(rgb, 1) == 1 { Self::On } else { Self::Off };
    [Argb4444] |rgba| Self::from_bits(
        (steps!(rgba[3], 15) as u16) << 12
            | (steps!(rgba[0], 15) as u16) << 8
            | (steps!(rgba[1], 15) as u16) << 4
            | steps!(rgba[2], 15) as u16
    );
    [Argb1555] |rgba| Self::from_bits(
        ((rgba[3] >> 7) as u16) << 15
            | (steps!(rgba[0], 31) as u16) << 10
            | (steps!(rgba[1], 31) as u16) << 5
            | steps!(rgba[2], 31) as u16
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Levels;
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

    /// A picture of the samples.
    enum Samples {}

    impl File for Samples {
        const PATH: &'static str = "samples";
        const SIZE: [u32; 2] = [COUNT as u32, 1];
        const COLORS: &'static [u8] = SAMPLES.as_flattened();
        const PIXELS: &'static [u8] = &[];
    }

    /// The samples with their colors.
    fn converted<C: Convert<Samples, COUNT>>() -> impl Iterator<Item = ([u8; 4], C)> {
        SAMPLES.into_iter().zip(C::TABLE.iter().copied())
    }

    fn as_levels<C: Levels + core::fmt::Debug + Convert<Samples, COUNT>>() {
        for (rgba, color) in converted::<C>() {
            let [r, g, b, _] = rgba;
            let expected = C::from_rgb(Rgb888::new(r, g, b), Point::zero());
            assert_eq!(color, expected, "{rgba:?}");
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
        // The error of each of the three weights is at most 2^-15, as in Levels.
        let near = |steps: u8, [r, g, b, _]: [u8; 4], max: f64| {
            let [r, g, b] = [r, g, b].map(f64::from);
            let luma = (0.299 * r + 0.587 * g + 0.114 * b) / 255.0;
            (f64::from(steps) - luma * max).abs() <= 0.5 + max * 3.0 / 32768.0
        };
        assert!(converted::<Gray8>().all(|(rgba, gray)| near(gray.luma(), rgba, 255.0)));
        assert!(converted::<Gray4>().all(|(rgba, gray)| near(gray.luma(), rgba, 15.0)));
        assert!(converted::<Gray2>().all(|(rgba, gray)| near(gray.luma(), rgba, 3.0)));
        let mut all = converted::<BinaryColor>();
        assert!(all.all(|(rgba, color)| near(u8::from(color.is_on()), rgba, 1.0)));
    }

    #[test]
    fn opacity_is_rounded_like_channels() {
        let steps = |byte: u8, most: f64| (f64::from(byte) / 255.0 * most).round() as u16;
        for ([r, g, b, a], color) in converted::<Argb4444>() {
            let bits = [a, r, g, b].map(|byte| steps(byte, 15.0));
            let bits = bits[0] << 12 | bits[1] << 8 | bits[2] << 4 | bits[3];
            assert_eq!(color, Argb4444::from_bits(bits));
        }
        for ([r, g, b, a], color) in converted::<Argb1555>() {
            let bits = [r, g, b].map(|byte| steps(byte, 31.0));
            let bits = steps(a, 1.0) << 15 | bits[0] << 10 | bits[1] << 5 | bits[2];
            assert_eq!(color, Argb1555::from_bits(bits));
        }
    }
}
