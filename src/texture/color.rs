//! Converts the colors of pictures to the colors of textures, at compile time.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666,
    Rgb888,
};

use super::include::{Convert, File, texels};
use super::{Argb1555, Argb4444};
use crate::message;

/// Lets a picture be converted to each `$Color`. `$color` computes the color from `$bytes`, an entry of
/// [`File::COLORS`].
macro_rules! colors {
    ($([$($Color:ident)+] |$bytes:ident| $color:expr;)+) => {$($(
        impl<F: File, const N: usize, const K: usize> Convert<F, N, K> for $Color {
            const TEXELS: &'static [Self; N] =
                &texels(<Self as Convert<F, N, K>>::TABLE, F::PIXELS);
            const TABLE: &'static [Self; K] = &{
                if F::COLORS.len() > K {
                    message::too_many_colors(F::PATH, F::COLORS.len(), K);
                }
                let $bytes = F::COLORS[0];
                let (mut table, mut at) = ([$color; K], 0);
                while at < F::COLORS.len() {
                    let $bytes = F::COLORS[at];
                    table[at] = $color;
                    at += 1;
                }
                table
            };
        }
    )+)+};
}

colors! {
    [Rgb555 Bgr555] |of| Self::new(of[0], of[1], of[2]);
    [Rgb565 Bgr565] |of| Self::new(of[0], of[4], of[2]);
    [Rgb666 Bgr666] |of| Self::new(of[3], of[4], of[5]);
    [Rgb888 Bgr888] |of| Self::new(of[6], of[7], of[8]);
    [BinaryColor] |of| if of[9] > 0 { Self::On } else { Self::Off };
    [Gray2] |of| Self::new(of[10]);
    [Gray4] |of| Self::new(of[11]);
    [Gray8] |of| Self::new(of[12]);
    [Argb1555] |of| Self::from_bits(u16::from_be_bytes([of[13], of[14]]));
    [Argb4444] |of| Self::from_bits(u16::from_be_bytes([of[15], of[16]]));
}

impl<F: File, const N: usize, const K: usize> Convert<F, N, K> for u8 {
    const TEXELS: &'static [u8; N] = &texels(<u8 as Convert<F, N, K>>::TABLE, F::PIXELS);
    const TABLE: &'static [u8; K] = &{
        if F::COLORS.len() > 256 {
            message::too_many_colors(F::PATH, F::COLORS.len(), 256);
        }
        let (mut table, mut at) = ([0; K], 0);
        while at < K {
            table[at] = at as u8;
            at += 1;
        }
        table
    };
}
