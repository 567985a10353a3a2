//! Texels with an opacity.

use embedded_graphics::pixelcolor::Rgb565;

use super::blend::{self, Blend, bilinear, blend, each, linear, mean};

/// A texel of 16 bits with an opacity of 4 bits, and 4 bits each of red, green and blue.
///
/// The texel's color is an [`Rgb565`](Rgb565). A texel of opacity 0 changes neither the color nor the depth on the
/// canvas. A bilinear filter blends the colors of all texels, even of those with opacity 0, so give texels of opacity 0
/// the colors of their neighbors.
///
/// ```
/// use fixel::texture::Argb4444;
/// let texel = Argb4444::new(8, 15, 0, 1);
/// assert_eq!(texel, Argb4444::from_bits(0x8f01));
/// assert_eq!(texel.opacity(), 136); // 8/15 of 255
/// assert_eq!(texel.color(), embedded_graphics::pixelcolor::Rgb565::new(31, 0, 2));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Argb4444(u16);

/// A texel of 16 bits that is either opaque or a hole: 1 bit of opacity, and 5 bits each of red, green and blue.
///
/// The texel's color is an [`Rgb565`](Rgb565). A hole changes neither the color nor the depth on the canvas. With a
/// [`Bilinear`](super::Bilinear) filter, a pixel is a hole if the nearest texel is a hole. Otherwise, the filter blends
/// the pixel as if the holes around it had the nearest texel's color.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb565;
/// use fixel::texture::Argb1555;
/// assert_eq!(Argb1555::new(31, 16, 1), Argb1555::from_bits(0xfe01));
/// assert_eq!(Argb1555::new(31, 16, 1).color(), Some(Rgb565::new(31, 33, 1)));
/// assert_eq!(Argb1555::HOLE.color(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Argb1555(u16);

impl Argb4444 {
    /// A texel from its opacity, red, green and blue; only the low four bits of each are used.
    #[must_use]
    pub const fn new(opacity: u8, red: u8, green: u8, blue: u8) -> Self {
        let bytes = [opacity << 4 | red & 15, green << 4 | blue & 15];
        Self(u16::from_be_bytes(bytes))
    }

    /// A texel from its bits, which are, from the highest to the lowest, opacity, red, green and blue.
    #[must_use]
    #[inline]
    pub const fn from_bits(bits: u16) -> Self {
        Self(bits)
    }

    /// The opacity, from 0 (invisible) to 255 (opaque).
    #[must_use]
    #[inline]
    pub const fn opacity(self) -> u8 {
        (self.0 >> 12) as u8 * 17
    }

    /// The color. [`Rgb565`](Rgb565) has more bits per channel: one more for red and blue, two more for green. A
    /// channel's highest bits are repeated in these low bits, so full brightness stays full brightness.
    #[must_use]
    #[inline]
    pub const fn color(self) -> Rgb565 {
        let [r, g, b] = [self.0 >> 8 & 15, self.0 >> 4 & 15, self.0 & 15];
        Rgb565::new(
            (r << 1 | r >> 3) as u8,
            (g << 2 | g >> 2) as u8,
            (b << 1 | b >> 3) as u8,
        )
    }
}

impl Argb1555 {
    /// A hole.
    pub const HOLE: Self = Self(0);

    /// An opaque texel from its red, green and blue; only the low five bits of each are used.
    #[must_use]
    pub const fn new(red: u8, green: u8, blue: u8) -> Self {
        let [r, g, b] = [red as u16 & 31, green as u16 & 31, blue as u16 & 31];
        Self(0x8000 | r << 10 | g << 5 | b)
    }

    /// A texel from its bits, which are, from the highest to the lowest, opacity, red, green and blue.
    #[must_use]
    #[inline]
    pub const fn from_bits(bits: u16) -> Self {
        Self(bits)
    }

    #[inline]
    const fn is_hole(self) -> bool {
        self.0 & 0x8000 == 0
    }

    /// The color, or `None` for a hole. [`Rgb565`](Rgb565) has one more bit of green: green's highest bit, repeated.
    #[must_use]
    #[inline]
    pub const fn color(self) -> Option<Rgb565> {
        if self.is_hole() {
            return None;
        }
        let [r, g, b] = [self.0 >> 10, self.0 >> 4 & 0x3e | self.0 >> 9 & 1, self.0];
        Some(Rgb565::new(r as u8 & 31, g as u8, b as u8 & 31))
    }
}

blend! {
    // Each channel gets four unused bits above it.
    [Argb4444] (4, |texel| texel.0.into(), [0x0f0f_0f0f |bits| (bits | bits << 12)],
        |[lanes]| Self((lanes | lanes >> 12) as u16))
}

impl Blend for Argb1555 {
    const WEIGHT_BITS: u32 = 5;

    #[inline]
    fn blend(texels: [[Self; 2]; 2], [x, y]: [u32; 2]) -> Self {
        let nearest = blend::nearest::<Self>(texels, [x, y]);
        if nearest.is_hole() {
            return nearest;
        }
        let lanes = |texel: Self| {
            let bits = u32::from(if texel.is_hole() { nearest } else { texel }.0);
            (bits | bits << 16) & 0x03e0_7c1f
        };
        let blended = blend::bilinear::<0x03e0_7c1f, 5>(blend::each(texels, lanes), [x, y]);
        Self(0x8000 | (blended | blended >> 16) as u16)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::cases;
    use embedded_graphics::pixelcolor::RgbColor;
    use rand::Rng;

    #[test]
    fn channels_are_those_of_the_canvas() {
        for bits in 0..=u16::MAX {
            let texel = Argb4444::from_bits(bits);
            let near = |found: u8, most: f64, digit: u16, white: f64| {
                let exact = f64::from(digit) / most * white;
                // The greatest error is in channels of six bits. From the four bits n of a texel, the code makes 4n +
                // n/4, rounded down, instead of 4n + n/5. For n = 3, this is too little by 3/5.
                let error = (f64::from(found) - exact).abs();
                assert!(error < 0.601, "{bits:x}: {exact}");
            };
            let color = texel.color();
            near(texel.opacity(), 15., bits >> 12, 255.);
            near(color.r(), 15., bits >> 8 & 15, 31.);
            near(color.g(), 15., bits >> 4 & 15, 63.);
            near(color.b(), 15., bits & 15, 31.);
            if let Some(color) = Argb1555::from_bits(bits).color() {
                near(color.r(), 31., bits >> 10 & 31, 31.);
                near(color.g(), 31., bits >> 5 & 31, 63.);
                near(color.b(), 31., bits & 31, 31.);
            }
            assert_eq!(Argb1555::from_bits(bits).color().is_none(), bits >> 15 == 0);
        }
    }

    /// The exact blend of four channels, in steps.
    fn exact([a, b, c, d]: [f64; 4], [x, y]: [f64; 2]) -> f64 {
        (a * (1. - x) + b * x) * (1. - y) + (c * (1. - x) + d * x) * y
    }

    #[test]
    fn blends_are_within_a_step() {
        cases(256, |random| {
            let bits: [u16; 4] = random.random();
            let x = random.random_range(0..16_u32);
            let y = random.random_range(0..16_u32);
            let [a, b, c, d] = bits.map(Argb4444::from_bits);
            let Argb4444(found) = Argb4444::blend([[a, b], [c, d]], [x, y]);
            for channel in [0, 4, 8, 12] {
                let values = bits.map(|bits| f64::from(bits >> channel & 15));
                let exact = exact(values, [x, y].map(|weight| f64::from(weight) / 16.));
                // There are two roundings, each by at most half a step.
                assert!((f64::from(found >> channel & 15) - exact).abs() <= 1.);
            }
        });
    }

    #[test]
    fn holes_leave_no_fringe() {
        cases(256, |random| {
            let bits: [u16; 4] = random.random();
            let x = random.random_range(0..32_u32);
            let y = random.random_range(0..32_u32);
            let texels = bits.map(Argb1555::from_bits);
            let nearest = texels[usize::from(x >= 16) + 2 * usize::from(y >= 16)];
            let [a, b, c, d] = texels;
            let Argb1555(found) = Argb1555::blend([[a, b], [c, d]], [x, y]);
            assert_eq!(found >> 15 == 0, nearest.is_hole());
            if nearest.is_hole() {
                return;
            }
            let filled =
                texels.map(|Argb1555(bits)| if bits >> 15 == 0 { nearest.0 } else { bits });
            for channel in [0, 5, 10] {
                let values = filled.map(|bits| f64::from(bits >> channel & 31));
                let exact = exact(values, [x, y].map(|weight| f64::from(weight) / 32.));
                assert!((f64::from(found >> channel & 31) - exact).abs() <= 1.);
            }
        });
    }
}
