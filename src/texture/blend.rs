//! Colors between four texels.

use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, Gray8, GrayColor, IntoStorage, Rgb555, Rgb565, Rgb666, Rgb888,
    raw::RawU16, raw::RawU24,
};

/// A color, or a texel with an opacity, that [`Bilinear`](super::Bilinear) filtering can blend.
///
/// Each channel is blended as it is stored, without gamma.
///
/// The trait is implemented for [`Gray8`](Gray8), the RGB and BGR colors of embedded-graphics,
/// [`Argb4444`](super::Argb4444), [`Argb1555`](super::Argb1555) and [`Translucent`](crate::shade::Translucent) colors.
/// `Gray4`, `Gray2` and `BinaryColor` have too few steps to blend: store such a texture in [`Gray8`](Gray8), and let
/// [`converted`](crate::Shader::converted) dither the result.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::texture::Blend;
/// let quad = [[Rgb565::BLACK, Rgb565::RED], [Rgb565::BLACK, Rgb565::RED]];
/// // A quarter of the way to the right, in 32nds.
/// assert_eq!(Rgb565::blend(quad, [8, 0]), Rgb565::new(8, 0, 0));
/// ```
pub trait Blend: Copy {
    /// [`blend`](Self::blend) divides the distance between two texels into 2^`WEIGHT_BITS` steps. `WEIGHT_BITS` must be
    /// from 1 to 15.
    const WEIGHT_BITS: u32;

    /// The color between this color and `other`: this color if `weight` is 0, and `other` if `weight` is
    /// 2^[`WEIGHT_BITS`](Self::WEIGHT_BITS), its greatest value. Each channel is rounded to nearest, halves up.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// use fixel::texture::Blend;
    /// assert_eq!(Rgb565::BLACK.mix(Rgb565::YELLOW, 8), Rgb565::new(8, 16, 0)); // 8/32
    /// assert_eq!(Rgb565::BLACK.mix(Rgb565::YELLOW, 32), Rgb565::YELLOW);
    /// ```
    ///
    /// By default, this function calls [`blend`](Self::blend) with `weight`. In that case, `blend` must also accept the
    /// greatest weight, which means 1.
    #[must_use]
    #[inline]
    fn mix(self, other: Self, weight: u32) -> Self {
        Self::blend([[self, other]; 2], [weight, 0])
    }

    /// The color at a point between four texels. In `texels`, the upper row comes first, and in each row, the left
    /// texel comes first.
    ///
    /// `weights` are the point's distances from the first texel, to the right and downward, each from 0 to less than 1,
    /// in units of 2^-[`WEIGHT_BITS`](Self::WEIGHT_BITS). With weights of 0, the result must be exactly the first
    /// texel.
    #[must_use]
    fn blend(texels: [[Self; 2]; 2], weights: [u32; 2]) -> Self;

    /// The mean of four texels, which replaces them in the next level of a [`Mipmap`](super::Mipmap). Each channel is
    /// rounded to nearest, halves up.
    ///
    /// By default, the mean is the [`blend`](Self::blend) halfway between the texels; rounding may then make a channel
    /// a step too high.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// use fixel::texture::Blend;
    /// let quad = [[Rgb565::BLACK, Rgb565::RED], [Rgb565::BLACK, Rgb565::BLACK]];
    /// assert_eq!(Rgb565::mean(quad), Rgb565::new(8, 0, 0)); // 7.75
    /// ```
    #[must_use]
    fn mean(texels: [[Self; 2]; 2]) -> Self {
        Self::blend(texels, [1 << (Self::WEIGHT_BITS - 1); 2])
    }
}

/// Whether every lane of `mask` has `bits` unused bits above it. If the mask is shifted left by up to `bits`, no lane
/// may reach the lowest bit of another lane, and no lane may leave the word.
const fn roomy(mask: u32, bits: u32) -> bool {
    let mut room = 0;
    while room < bits && mask.leading_zeros() > room && (mask << (room + 1)) & lowest(mask) == 0 {
        room += 1;
    }
    room == bits
}

/// The lowest bit of each lane of `mask`.
const fn lowest(mask: u32) -> u32 {
    mask & !(mask << 1)
}

/// Applies `of` to each of four texels. The function is written out, because in a build for size, `map` remains a loop.
#[inline]
pub(super) fn each<T, U>([[a, b], [c, d]]: [[T; 2]; 2], of: impl Fn(T) -> U) -> [[U; 2]; 2] {
    [[of(a), of(b)], [of(c), of(d)]]
}

/// Blends the channels of four texels. A word holds a texel's channels in lanes, which are the runs of ones in `MASK`.
/// The function blends along the upper row and along the lower row, and then between the two results. Each of these
/// blends is rounded to nearest, halves up.
///
/// Each of the two roundings has an error of at most half a step, so a channel is within one step of the exact sum
/// weighted by `x` and `y`.
#[inline]
pub(super) fn bilinear<const MASK: u32, const BITS: u32>(
    [upper, lower]: [[u32; 2]; 2],
    [x, y]: [u32; 2],
) -> u32 {
    let row = |texels| linear::<MASK, BITS>(texels, x);
    linear::<MASK, BITS>([row(upper), row(lower)], y)
}

/// Of the four texels around a point, the texel with the nearest center.
#[inline]
pub(super) fn nearest<C: Blend>([upper, lower]: [[C; 2]; 2], [x, y]: [u32; 2]) -> C {
    let half = 1 << (C::WEIGHT_BITS - 1);
    let [left, right] = if y < half { upper } else { lower };
    if x < half { left } else { right }
}

/// Blends the channels of two colors, in the same lanes as [`bilinear`], rounded to nearest, halves up.
#[inline]
pub(super) fn linear<const MASK: u32, const BITS: u32>([a, b]: [u32; 2], weight: u32) -> u32 {
    const { assert!(roomy(MASK, BITS), "lanes overlap when weighted") };
    // a · (2^BITS − weight) + b · weight, for all lanes at once. In b − a, a negative lane borrows from the lane above.
    // In the sum, no lane is negative, so nothing remains borrowed.
    let half = lowest(MASK) << (BITS - 1);
    let sum = (a << BITS)
        .wrapping_add(half)
        .wrapping_add(b.wrapping_sub(a).wrapping_mul(weight));
    (sum >> BITS) & MASK
}

/// The mean of the channels of four colors, in the same lanes as [`bilinear`], rounded to nearest, halves up.
#[inline]
pub(super) fn mean<const MASK: u32>([[a, b], [c, d]]: [[u32; 2]; 2]) -> u32 {
    const { assert!(roomy(MASK, 2), "lanes overlap when added") };
    ((a + b + c + d + (lowest(MASK) << 1)) >> 2) & MASK
}

/// Implements [`Blend`] for colors with weights of `$bits` bits. `$raw` returns the bits of a color, `$lanes` spreads
/// these bits to the lanes of a mask, and `$of` makes a color from the blended words.
macro_rules! blend {
    ($([$($Color:ident)+] $rule:tt)+) => {
        $($(blend! { $Color $rule })+)+
    };
    ($Color:ident ($bits:literal, |$color:ident| $raw:expr,
        [$($mask:literal |$bit:ident| $lanes:expr),+], |$words:pat_param| $of:expr)) => {
        impl Blend for $Color {
            const WEIGHT_BITS: u32 = $bits;

            #[inline]
            fn mix(self, other: Self, weight: u32) -> Self {
                let raw = |$color: Self| -> u32 { $raw };
                let [a, b] = [raw(self), raw(other)];
                let $words = [$({
                    let lanes = |$bit: u32| $lanes & $mask;
                    linear::<$mask, $bits>([lanes(a), lanes(b)], weight)
                }),+];
                $of
            }

            #[inline]
            fn blend(texels: [[Self; 2]; 2], weights: [u32; 2]) -> Self {
                let raw = each(texels, |$color: Self| -> u32 { $raw });
                let $words = [$({
                    bilinear::<$mask, $bits>(each(raw, |$bit| $lanes & $mask), weights)
                }),+];
                $of
            }

            #[inline]
            fn mean(texels: [[Self; 2]; 2]) -> Self {
                let raw = each(texels, |$color: Self| -> u32 { $raw });
                let $words = [$(mean::<$mask>(each(raw, |$bit| $lanes & $mask))),+];
                $of
            }
        }
    };
}
pub(super) use blend;

// 15 or 16 bits fit into one word with five unused bits above each channel, if the middle channel is in the upper half.
// More bits need two words: the first and the third channel are in one word, 16 bits apart, and the middle channel is
// in the other word.
blend! {
    [Rgb565 Bgr565] (5, |color| color.into_storage().into(), [0x07e0_f81f |raw| (raw | raw << 16)],
        |[lanes]| RawU16::new((lanes | lanes >> 16) as u16).into())
    [Rgb555 Bgr555] (5, |color| color.into_storage().into(), [0x03e0_7c1f |raw| (raw | raw << 16)],
        |[lanes]| RawU16::new((lanes | lanes >> 16) as u16).into())
    [Rgb666 Bgr666] (8, |color| color.into_storage(),
        [0x003f_003f |raw| (raw << 4 & !0xffff | raw & 0xffff), 0x3f |raw| raw >> 6],
        |[outer, middle]| RawU24::new(outer >> 16 << 12 | middle << 6 | outer & 0x3f).into())
    [Rgb888 Bgr888] (8, |color| color.into_storage(), [0x00ff_00ff |raw| raw, 0xff |raw| raw >> 8],
        |[outer, middle]| RawU24::new(outer | middle << 8).into())
    [Gray8] (8, |gray| gray.luma().into(), [0xff |luma| luma], |[luma]| Self::new(luma as u8))
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::RgbColor;

    #[test]
    fn lanes_have_room_up_to_the_next_lane_and_the_end_of_the_word() {
        for (mask, most) in [
            (0xff, 24),
            (0x1f, 27),
            (0x00ff_00ff, 8),
            (0x003f_003f, 10),
            // Green is in the upper half. Above blue are 6 unused bits, above red are 5, and above green are 5.
            (0x07e0_f81f, 5),
            (0x03e0_7c1f, 5),
            (0x8000_0000, 0),
            (3, 30),
        ] {
            for bits in 0..40 {
                assert_eq!(roomy(mask, bits), bits <= most, "{mask:#x}: {bits} bits");
            }
        }
    }

    fn mixes_are_rounded<C: Blend + RgbColor + core::fmt::Debug>(new: impl Fn(u8, u8, u8) -> C) {
        let most = 1 << C::WEIGHT_BITS;
        let ends = [new(0, C::MAX_G, 3), new(C::MAX_R, 5, 1)];
        for weight in 0..=most {
            let mixed = ends[0].mix(ends[1], weight);
            for channel in [C::r, C::g, C::b] {
                let [a, b] = ends.map(|end| u32::from(channel(&end)));
                let exact = (a * (most - weight) + b * weight + most / 2) / most;
                assert_eq!(u32::from(channel(&mixed)), exact, "{weight}");
            }
        }
    }

    #[test]
    fn a_mix_is_rounded_to_nearest_at_every_weight() {
        mixes_are_rounded(Rgb565::new);
        mixes_are_rounded(Bgr555::new);
        mixes_are_rounded(Rgb888::new);
        mixes_are_rounded(Bgr666::new);
        let grays = (0..=256).map(|weight| Gray8::new(10).mix(Gray8::new(210), weight).luma());
        assert!(
            grays.eq((0..=256).map(|weight: u32| ((10 * 256 + 200 * weight + 128) >> 8) as u8))
        );
    }

    #[test]
    fn lowest_has_the_lowest_bit_of_each_lane() {
        assert_eq!(lowest(0x07e0_f81f), 0x0020_0801);
        assert_eq!(lowest(0x00ff_00ff), 0x0001_0001);
    }
}
