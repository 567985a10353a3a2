//! Measures how deep the stack of a piece of work is, on a microcontroller.
//!
//! `deepest` fills the free stack with a pattern, does the work, and searches for the deepest word that changed. The
//! stack of an interrupt during the work counts too. A word that happens to be overwritten with the pattern, or that
//! was reserved and never written, does not count.

use core::hint::black_box;
use core::ptr;

/// End of the free stack. Only the statics are below it, as there is no heap.
#[cfg(target_arch = "arm")]
use cortex_m_rt::heap_start as stack_end;
#[cfg(target_arch = "riscv32")]
use riscv_rt::heap_start as stack_end;

/// A pattern that no program writes by chance.
const PAINT: u32 = 0xa51c_e5ab;
/// Bytes below this function's own local that are left alone: the rest of its frame, and the frames of functions that
/// it calls, where they are not inlined. Shallower work cannot be measured.
const MARGIN: usize = 256;
/// Most bytes that are filled; deeper work is reported as this deep.
const MOST: usize = 64 << 10;
/// Bytes of a word of the pattern.
const WORD: usize = size_of::<u32>();

/// Does `work`; returns its result and the bytes of stack below the caller that it reached.
///
/// The result is at least 256, and too large by the rest of this function's own frame: a few words.
#[inline(never)]
pub fn deepest<T>(work: impl FnOnce() -> T) -> (T, usize) {
    let local = 0_u32;
    let top = (&raw const *black_box(&local)).addr();
    let end = stack_end()
        .expose_provenance()
        .max(top.saturating_sub(MOST));
    let start = top - MARGIN;
    for address in (end..start).step_by(WORD) {
        paint(address);
    }
    let result = apart(work);
    let painted = (end..start)
        .step_by(WORD)
        .take_while(|&address| is_painted(address));
    (result, top - (end + painted.count() * WORD))
}

/// Has a stack frame of its own, below the one from which depth is counted.
#[inline(never)]
fn apart<T>(work: impl FnOnce() -> T) -> T {
    work()
}

/// Fills a word of the free stack.
#[inline]
fn paint(address: usize) {
    #[allow(unsafe_code)]
    // SAFETY: the address is a multiple of four, in RAM that only the stack uses, and below every live frame: the
    // frame of an interrupt is gone when this code continues.
    unsafe {
        ptr::with_exposed_provenance_mut::<u32>(address).write_volatile(PAINT);
    }
}

/// Whether a word of the free stack still holds the pattern of [`paint`].
#[inline]
fn is_painted(address: usize) -> bool {
    #[allow(unsafe_code)]
    // SAFETY: as for `paint`, which has written a valid `u32` there.
    unsafe {
        ptr::with_exposed_provenance::<u32>(address).read_volatile() == PAINT
    }
}
