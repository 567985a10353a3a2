//! The code that depends on the core: on whether it has 64-bit products, a divider, and an instruction that counts
//! leading zeros. Each function returns the same bits on all cores.
//!
//! Files outside this folder do not depend on the core's name or on the width of its registers. Where another file can
//! compute a number in two ways, one of the constants [`DIVIDES`], [`IS_WIDE`], [`SHIFTS_LATER`], [`STEPS_INDEX`] and
//! [`STORES_ANYWHERE`] says which way is faster on the core.

mod bits;
mod divide;
mod product;
mod row;

pub(crate) use bits::{at_least, clamp_negative, normalize, up};
pub(crate) use divide::{divide, newton_step};
pub(crate) use product::{
    cross, high, product, product_to_31_bits, scaled_cross, times_17_bits, times_30, times_half,
    times_short, unsigned_product,
};
pub(crate) use row::{Row, dot};

/// Whether the core's products have only 32 bits, as on Armv6-M and the baseline of Armv8-M: Cortex-M0, M0+, M1 and
/// M23. `src/build.rs` derives this from the target's name.
///
/// On these cores the compiler calls a routine that multiplies 64 bits by 64. Four products of 16 bits take half as
/// long as this routine.
const IS_NARROW: bool = cfg!(narrow_core);

/// Whether the core divides fast. Armv6-M has no division, and Cortex-M23 takes up to 34 cycles, longer than the code
/// without a division.
pub(crate) const DIVIDES: bool = !IS_NARROW;

/// Whether a loop over pixels may step one index instead of two addresses. It then takes as many instructions on cores
/// with the DSP extension; on RISC-V, Armv7-M and x86-64 a frame takes up to 8 % more. Builds with debug assertions
/// step an index, too, so that tests on the host run this loop.
pub(crate) const STEPS_INDEX: bool = HAS_DSP || cfg!(debug_assertions);

/// Whether the core has an instruction that counts leading zeros. Narrow cores and RISC-V without Zbb have no such
/// instruction.
const COUNTS_ZEROS: bool =
    !IS_NARROW && !cfg!(all(target_arch = "riscv32", not(target_feature = "zbb")));

/// Whether the core has an instruction, as Cortex-M4 and M7 have, that adds a product to a number times 2^32, and
/// returns the upper half of the sum. `src/build.rs` derives this from the target's name.
const HAS_DSP: bool = cfg!(dsp_core);

/// Whether the core has an instruction, as Cortex-M3 and above have, that limits a number to a given number of bits.
const SATURATES: bool = cfg!(target_arch = "arm") && !IS_NARROW;

/// Whether registers have 32 bits and are stored at any address, as on Cortex-M3 and above. Other cores store a part of
/// a slice of 16-bit numbers number by number.
pub(crate) const STORES_ANYWHERE: bool = cfg!(target_arch = "arm") && !IS_NARROW;

/// Whether registers have 64 bits.
pub(crate) const IS_WIDE: bool = cfg!(target_pointer_width = "64");

/// The integer that fills a register. On a 64-bit core, numbers of 32 bits are widened to this type once, and not for
/// each product.
#[cfg(target_pointer_width = "64")]
pub(crate) type Word = i64;
#[cfg(not(target_pointer_width = "64"))]
pub(crate) type Word = i32;

/// Whether short positions are multiplied before they are shifted. Before the shift, they are small, and narrow cores
/// multiply small numbers faster.
pub(crate) const SHIFTS_LATER: bool = IS_NARROW;

/// Marks a branch that is seldom taken, so that the other branches need no jump around it.
#[cold]
#[inline]
const fn cold() {}

/// Marks a branch that is seldom taken, but only where registers have 64 bits.
#[inline]
pub(crate) fn seldom() {
    if IS_WIDE {
        cold();
    }
}
