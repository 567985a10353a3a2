//! Converts the colors of pictures to the colors of textures, at compile time.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666,
    Rgb888,
};

use super::include::{FromFile, Picture, Table, texels};
use super::{Argb1555, Argb4444};
use crate::message;

/// Lets a picture be converted to each `$Color`. `$color` computes the color, which it calls `Color`, from `$bytes`, an
/// entry of [`Picture::colors`].
macro_rules! colors {
    ($([$($Color:ident)+] |$bytes:ident| $color:expr;)+) => {$($(
        impl<F, const N: usize, const K: usize> FromFile<F, N, K> for Table<$Color, K>
        where
            Picture: FromFile<F, N, K>,
        {
            const VALUE: Self = Self {
                texels: &{
                    type Color = $Color;
                    let Picture { path, colors, .. } = Picture::VALUE;
                    if colors.len() > K {
                        message::too_many_colors(path, colors.len(), K);
                    }
                    let $bytes = colors[0];
                    let (mut table, mut at) = ([$color; K], 0);
                    while at < colors.len() {
                        let $bytes = colors[at];
                        table[at] = $color;
                        at += 1;
                    }
                    table
                },
            };
        }

        impl<F, const N: usize, const K: usize> FromFile<F, N, K> for &'static [$Color; N]
        where
            Picture: FromFile<F, N, K>,
        {
            const VALUE: Self = &texels(Table::<$Color, K>::VALUE.texels, Picture::VALUE.pixels);
        }
    )+)+};
}

colors! {
    [Rgb555 Bgr555] |of| Color::new(of[0], of[1], of[2]);
    [Rgb565 Bgr565] |of| Color::new(of[0], of[4], of[2]);
    [Rgb666 Bgr666] |of| Color::new(of[3], of[4], of[5]);
    [Rgb888 Bgr888] |of| Color::new(of[6], of[7], of[8]);
    [BinaryColor] |of| if of[9] > 0 { Color::On } else { Color::Off };
    [Gray2] |of| Color::new(of[10]);
    [Gray4] |of| Color::new(of[11]);
    [Gray8] |of| Color::new(of[12]);
    [Argb1555] |of| Color::from_bits(u16::from_be_bytes([of[13], of[14]]));
    [Argb4444] |of| Color::from_bits(u16::from_be_bytes([of[15], of[16]]));
}

impl<F, const N: usize, const K: usize> FromFile<F, N, K> for &'static [u8; N]
where
    Picture: FromFile<F, N, K>,
{
    const VALUE: Self = &{
        let Picture { path, colors, .. } = Picture::VALUE;
        if colors.len() > 256 {
            message::too_many_colors(path, colors.len(), 256);
        }
        texels(&BYTES, Picture::VALUE.pixels)
    };
}

/// Each byte at its own index.
const BYTES: [u8; 256] = {
    let (mut bytes, mut at) = ([0; 256], 0);
    while at < 256 {
        bytes[at] = at as u8;
        at += 1;
    }
    bytes
};
