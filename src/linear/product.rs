//! Products of 32 bits by 32, in 64.

/// Whether the core multiplies to 32 bits only, as those of Armv6-M do.
///
/// What their compiler calls for more multiplies 64 bits by 64; four products of 16 bits take half
/// as long. (No other Arm is without atomics and of so few instructions.)
pub(crate) const IS_NARROW: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// The product.
#[inline]
pub(crate) const fn product(a: i32, b: i32) -> i64 {
    if IS_NARROW {
        narrow_product(a, b)
    } else {
        a as i64 * b as i64
    }
}

/// The upper half of a product of numbers without a sign, the second below 2^31.
#[inline]
pub(crate) const fn upper(a: u32, b: u32) -> u32 {
    if IS_NARROW {
        upper_of_signed(a, b)
    } else {
        ((a as u64 * b as u64) >> 32) as u32
    }
}

/// The same from the product of signed numbers.
#[inline]
const fn upper_of_signed(a: u32, b: u32) -> u32 {
    let product = product(a.cast_signed(), b.cast_signed()).cast_unsigned();
    let upper = (product >> 32) as u32;
    // As a signed number `a` is less by 2^32 if its upper bit is set.
    upper.wrapping_add(b & (a.cast_signed() >> 31).cast_unsigned())
}

/// The dot product; the caller sees to it that it fits, as that of mantissas of 30 bits by 31 does.
#[inline]
pub(crate) fn dot(a: &[i32; 3], b: &[i32; 3]) -> i64 {
    if IS_NARROW {
        narrow_dot(a, b)
    } else {
        product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2])
    }
}

// Calls: they are as long as what they stand for.

#[inline(never)]
const fn narrow_product(a: i32, b: i32) -> i64 {
    of_halves(a, b)
}

#[inline(never)]
fn narrow_dot(a: &[i32; 3], b: &[i32; 3]) -> i64 {
    a.iter().zip(b).map(|(&a, &b)| of_halves(a, b)).sum()
}

/// The product of two numbers, from those of their halves.
#[inline]
const fn of_halves(a: i32, b: i32) -> i64 {
    let ([a_high, a_low], [b_high, b_low]) = ([a >> 16, a & 0xffff], [b >> 16, b & 0xffff]);
    let low = a_low.cast_unsigned() * b_low.cast_unsigned();
    // A half with a sign times one without is at most 2^31 - 2^15 in magnitude, so that 16 bits more
    // are no overflow.
    let cross = a_high * b_low + (low >> 16).cast_signed();
    let other = a_low * b_high + (cross & 0xffff);
    let high = a_high * b_high + (cross >> 16) + (other >> 16);
    let low = (other << 16).cast_unsigned() | (low & 0xffff);
    ((high as i64) << 32) | low as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn halves_make_the_product_at_the_ends() {
        let ends = [
            0,
            1,
            -1,
            0x7fff,
            0x8000,
            0xffff,
            0x1_0000,
            -0x8000,
            -0xffff,
            -0x1_0000,
            0x7fff_0000,
            i32::MAX,
            i32::MIN,
            i32::MIN + 0xffff,
        ];
        for a in ends {
            for b in ends {
                assert_eq!(of_halves(a, b), i64::from(a) * i64::from(b), "{a} · {b}");
                let (a, b) = (a.cast_unsigned(), b.cast_unsigned() & (u32::MAX >> 1));
                let upper = (u64::from(a) * u64::from(b)) >> 32;
                assert_eq!(u64::from(upper_of_signed(a, b)), upper, "{a} · {b}");
            }
        }
    }

    proptest! {
        #[test]
        fn halves_make_the_product(a in any::<i32>(), b in any::<i32>()) {
            prop_assert_eq!(of_halves(a, b), i64::from(a) * i64::from(b));
            let (a, b) = (a.cast_unsigned(), b.cast_unsigned() & (u32::MAX >> 1));
            let upper = (u64::from(a) * u64::from(b)) >> 32;
            prop_assert_eq!(u64::from(upper_of_signed(a, b)), upper);
        }
    }
}
