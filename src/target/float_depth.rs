//! Depth as a floating-point number of 16 bits.

use core::ops::Range;

use super::depth::{Depth, DepthBuffer};
use crate::num::wide::IS_NARROW;

/// The caller's depth buffer as fine far off as near by: numbers of 4 bits of exponent and 12 of
/// mantissa. Made by [`Canvas::with_float_depth`](super::Canvas::with_float_depth).
///
/// 65535 is the near plane; each halving of 1/w takes 4096 off, and what is 65,536 times as far as the near
/// plane, or farther, is 0. More is nearer, as in [`Depth`], so that the test is the same.
///
/// Steps of distance, in parts of it, largest up to a far plane so many times as far as the near one:
///
/// | far / near | [`Depth`] | `FloatDepth` |
/// |---:|---:|---:|
/// | 100 | 0.15 % | 0.024 % |
/// | 1,000 | 1.5 % | 0.024 % |
/// | 10,000 | 15 % | 0.024 % |
/// | 65,536 | all | 0.024 % |
///
/// Up to 8 times the near plane [`Depth`] is the finer of the two, up to 16 times they are alike. 1/w is interpolated to
/// 2⁻²⁴ of its greatest in a triangle: of one whose far end is more than 3,000 times as far as its near end, that is more
/// than half a step there.
///
/// A pixel that is tested takes 4 to 9 instructions more on Cortex-M4: of the measured floor and cube 1.77 and 1.43 million
/// a frame in the default mode, in place of 1.43 and 1.24. On Cortex-M0+, which counts no leading zeros, 12 to 26: 3.53 and
/// 6.15, in place of 2.83 and 5.51.
///
/// Shaders see the same [`Fragment::depth`](crate::Fragment::depth) with either, in linear steps. Under a parallel projection depth
/// is linear in the distance as it is, and this one finest at the far plane: take [`Depth`].
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::target::{Canvas, FloatDepth, Native};
/// let (mut pixels, mut depths) = ([Gray8::new(0); 4], [0; 4]);
/// let canvas: Canvas<Gray8, Native, FloatDepth> =
///     Canvas::new(&mut pixels, 2, 2)?.with_float_depth(&mut depths)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Debug)]
pub struct FloatDepth<'d>(pub(super) Depth<'d>);

/// Whether the core counts leading zeros: neither Armv6-M does nor RISC-V without its extension for bits.
const COUNTS_ZEROS: bool =
    !IS_NARROW && !cfg!(all(target_arch = "riscv32", not(target_feature = "zbb")));

/// Bits of a mantissa without its upper one.
const MANTISSA: u32 = 12;

impl<'d> DepthBuffer for FloatDepth<'d> {
    type Cell<'a>
        = &'a mut u16
    where
        Self: 'a;
    type Cells<'a>
        = &'a mut [u16]
    where
        Self: 'a;

    const IS_KEPT: bool = true;

    #[inline]
    fn cells(&mut self, range: Range<usize>) -> Option<&mut [u16]> {
        self.0.cells(range)
    }

    #[inline]
    #[allow(clippy::mut_mut)] // what is taken is no longer in it
    fn first<'a>(cells: &mut &'a mut [u16], count: usize) -> &'a mut [u16]
    where
        Self: 'a,
    {
        Depth::<'d>::first(cells, count)
    }

    #[inline]
    fn each<'a>(cells: &'a mut [u16]) -> impl Iterator<Item = &'a mut u16>
    where
        Self: 'a,
    {
        Depth::<'d>::each(cells)
    }

    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        // Shifted up by its leading zeros, q is a mantissa of 32 bits and 2^(31 - zeros - down) its value. The
        // mantissa's upper bit stays, and adds one to the exponent.
        let exponent = 29u32.wrapping_sub(down) << MANTISSA;
        let (filled, exponent) = if COUNTS_ZEROS {
            filled(q, exponent)
        } else {
            narrow_filled(q, exponent)
        };
        let code = (filled >> (31 - MANTISSA)).wrapping_add(exponent);
        // Below the least exponent it is negative.
        code.cast_signed().max(0).cast_unsigned()
    }

    #[inline]
    fn passes(cell: &&mut u16, depth: u32) -> bool {
        Depth::<'d>::passes(cell, depth)
    }

    #[inline]
    fn store(cell: &mut u16, depth: u16) {
        Depth::<'d>::store(cell, depth);
    }

    #[inline]
    fn clear(&mut self) {
        self.0.clear();
    }
}

/// `q` shifted up until its upper bit is set, and the exponent less by as many as it takes, but for one.
#[inline]
fn filled(q: u32, exponent: u32) -> (u32, u32) {
    // So that no more than 31 bits are shifted.
    let zeros = (q | 1).leading_zeros();
    let exponent = exponent.wrapping_sub(zeros << MANTISSA);
    (q << zeros, exponent.wrapping_add(1 << MANTISSA))
}

/// The same where nothing counts zeros: most of a triangle's are of the greatest 31 bits or one less, as the scale is
/// the triangle's own.
#[inline]
fn narrow_filled(q: u32, mut exponent: u32) -> (u32, u32) {
    let mut filled = q << 1;
    if filled.cast_signed() >= 0 {
        filled |= 1;
        while filled >> 24 == 0 {
            filled <<= 8;
            exponent = exponent.wrapping_sub(8 << MANTISSA);
        }
        while filled.cast_signed() >= 0 {
            filled <<= 1;
            exponent = exponent.wrapping_sub(1 << MANTISSA);
        }
    }
    (filled, exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The least interpolant of a code, at the near plane's shift: it is a whole number for all of them.
    fn least(code: u32) -> u32 {
        ((1 << MANTISSA) + (code & 0xfff)) << ((code >> MANTISSA) + 15 - MANTISSA)
    }

    /// All codes there are, at both ends, and each at every shift that it is seen at; so it rises with 1/w, and one
    /// 1/w has one code however a triangle is scaled.
    #[test]
    fn codes_rise_with_the_interpolant() {
        for code in 0..=0xffff {
            for down in 15..=31 {
                let q = u64::from(least(code)) << (down - 15);
                let Some(q) = u32::try_from(q).ok().filter(|q| q >> 31 == 0) else {
                    break;
                };
                assert_eq!(FloatDepth::encode(q, down), code, "{q} >> {down}");
                let before = code.saturating_sub(1);
                assert_eq!(FloatDepth::encode(q - 1, down), before, "{q} - 1 >> {down}");
            }
        }
        assert_eq!(FloatDepth::encode((1 << 31) - 1, 15), 0xffff);
    }

    /// What is farther than the last code is infinitely far, whatever the shift.
    #[test]
    fn below_the_range_is_zero() {
        for down in 15..=31 {
            for q in [0, 1, 2, (1 << down) - 1] {
                assert_eq!(FloatDepth::encode(q & i32::MAX.cast_unsigned(), down), 0);
            }
        }
    }

    #[test]
    fn cores_that_count_zeros_and_others_agree() {
        for bit in 0..31 {
            for q in [0, 1, 0x5555_5555, u32::MAX].map(|rest| 1 << bit | rest & ((1 << bit) - 1)) {
                let code = |(filled, exponent): (u32, u32)| {
                    ((filled >> 19).wrapping_add(exponent)).cast_signed().max(0)
                };
                for down in 15..=31 {
                    let exponent = 29u32.wrapping_sub(down) << MANTISSA;
                    let [a, b] = [filled(q, exponent), narrow_filled(q, exponent)].map(code);
                    assert_eq!(a, b, "{q} >> {down}");
                }
            }
        }
    }

    /// The shift of a number that no canvas gives is survived.
    #[test]
    fn any_number_is_survived() {
        for q in [0, 1, 1 << 31, u32::MAX] {
            for down in [0, 14, 32, 1 << 20, u32::MAX] {
                let _ = FloatDepth::encode(q, down);
                let _ = narrow_filled(q, down);
            }
        }
    }
}
