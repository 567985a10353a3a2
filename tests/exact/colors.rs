//! The colors of a picture in each format are the nearest colors of that format.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, Rgb555, Rgb565,
    Rgb666, Rgb888,
};
use fixel::prelude::*;
use fixel::texture::{Argb1555, Argb4444};

/// The color of texel `at` in the picture. Over all texels, each channel takes each of its values, together with
/// different values of the other channels.
fn sample(at: usize) -> [u8; 4] {
    let c = (at / 4) as u8;
    let d = c.wrapping_mul(37) ^ 0x5a;
    match at % 4 {
        0 => [c, c, c, d],
        1 => [c, 0, d, c],
        2 => [d, c, 255, 255],
        _ => [255 - d, d, c, 0],
    }
}

/// Pairs of a color of the picture and the color to which the macro converted it.
macro_rules! converted {
    ($Color:ident) => {{
        static TEXELS: &[$Color] = include_texture!("../../src/texture/samples/colors.png");
        assert_eq!(TEXELS.len(), 1024);
        TEXELS
            .iter()
            .enumerate()
            .map(|(at, &color)| (sample(at), color))
    }};
}

#[test]
fn colors_that_are_not_dithered_are_those_of_levels() {
    macro_rules! check {
        ($($Color:ident)+) => {$(
            for (rgba, color) in converted!($Color) {
                let [r, g, b, _] = rgba;
                let expected = $Color::from_rgb(Rgb888::new(r, g, b), Point::zero());
                assert_eq!(color, expected, "{rgba:?}");
            }
        )+};
    }
    check!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888 Gray8);
}

#[test]
fn gray_is_the_nearest_step_of_luma() {
    // The error of each of the three weights is at most 2^-15, as in PixelFormat.
    let near = |steps: u8, [r, g, b, _]: [u8; 4], max: f64| {
        let [r, g, b] = [r, g, b].map(f64::from);
        let luma = (0.299 * r + 0.587 * g + 0.114 * b) / 255.0;
        (f64::from(steps) - luma * max).abs() <= 0.5 + max * 3.0 / 32768.0
    };
    assert!(converted!(Gray8).all(|(rgba, gray)| near(gray.luma(), rgba, 255.0)));
    assert!(converted!(Gray4).all(|(rgba, gray)| near(gray.luma(), rgba, 15.0)));
    assert!(converted!(Gray2).all(|(rgba, gray)| near(gray.luma(), rgba, 3.0)));
    let mut all = converted!(BinaryColor);
    assert!(all.all(|(rgba, color)| near(u8::from(color.is_on()), rgba, 1.0)));
}

#[test]
fn opacity_is_rounded_like_channels() {
    // Rounds to the nearest step. Halves do not occur.
    let steps = |byte: u8, most: u16| (u16::from(byte) * most * 2 + 255) / 510;
    for ([r, g, b, a], color) in converted!(Argb4444) {
        let bits = [a, r, g, b].map(|byte| steps(byte, 15));
        let bits = bits[0] << 12 | bits[1] << 8 | bits[2] << 4 | bits[3];
        assert_eq!(color, Argb4444::from_bits(bits));
    }
    for ([r, g, b, a], color) in converted!(Argb1555) {
        let bits = [r, g, b].map(|byte| steps(byte, 31));
        let bits = steps(a, 1) << 15 | bits[0] << 10 | bits[1] << 5 | bits[2];
        assert_eq!(color, Argb1555::from_bits(bits));
    }
}
