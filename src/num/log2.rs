//! Logarithms to the base 2.

/// Returns log₂ of a number, with 8 fraction bits and an error of at most 0.011; returns 0 for 0.
#[inline(never)]
pub(crate) fn log2(number: u64) -> i32 {
    /// c of the parabola below, 0.3431, in units of 2^-16.
    const C: u32 = 22_485;
    let number = number.max(1);
    let zeros = number.leading_zeros();
    // Let m be the fraction. Then log₂(1 + m) is about m + c · m · (1 − m), with an error of at most 0.0089.
    let m = ((number << zeros) >> 47) as u32 & 0xffff;
    let curved = m + ((((m * (0x1_0000 - m)) >> 16) * C) >> 16);
    (63 - zeros.cast_signed()) * 256 + ((curved + 128) >> 8).cast_signed()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[allow(clippy::cast_precision_loss)] // 11 significant bits
    fn logarithms_are_close() {
        let mut most = 0_f64;
        for bits in 0..64 {
            for mantissa in 1024_u64..2048 {
                let number = if bits < 10 {
                    mantissa >> (10 - bits)
                } else {
                    mantissa << (bits - 10)
                };
                let exact = (number as f64).log2();
                most = most.max((f64::from(log2(number)) / 256. - exact).abs());
            }
        }
        // The error comes from the parabola, half a unit of the result, and 2^-15 from bits that are cut off.
        assert!(most <= 0.0089 + 1. / 512. + 0.0001, "{most}");
        assert_eq!(
            [log2(0), log2(1), log2(2), log2(1 << 63)],
            [0, 0, 256, 63 << 8]
        );
    }
}
