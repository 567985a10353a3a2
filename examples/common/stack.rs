//! Measures how much stack a function uses on a microcontroller.
//!
//! `deepest` fills the free stack with a pattern, calls the function, and searches for the deepest word that has
//! changed. Interrupts during the call use the same stack, and count, too. A word does not count if it was reserved but
//! never written, or was overwritten with the pattern by chance.

use core::hint::black_box;
use core::ptr;

/// The end of the free stack. Only statics are below it, because there is no heap.
#[cfg(target_arch = "arm")]
use cortex_m_rt::heap_start as stack_end;
#[cfg(target_arch = "riscv32")]
use riscv_rt::heap_start as stack_end;

/// A pattern that programs are unlikely to write by chance.
const PAINT: u32 = 0xa51c_e5ab;
/// The number of bytes below the local variable of [`deepest`] that are not filled. These bytes hold the rest of its
/// stack frame, and the frames of functions that it calls, if they are not inlined. Less stack than this cannot be
/// measured.
const MARGIN: usize = 256;
/// The largest number of bytes that are filled. If a function uses more, this number is reported.
const MOST: usize = 256 << 10;
/// The number of bytes in a word of the pattern.
const WORD: usize = size_of::<u32>();

/// Calls `work`. Returns its result, and the number of bytes of stack below the caller that it used.
///
/// The number is at least 256. The number includes the rest of this function's own frame, a few words.
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

/// Calls `work` in a stack frame of its own, below the frame from which the depth of the stack is counted.
#[inline(never)]
fn apart<T>(work: impl FnOnce() -> T) -> T {
    work()
}

/// Fills a word of the free stack.
#[inline]
fn paint(address: usize) {
    #[allow(unsafe_code)]
    // SAFETY: the address is a multiple of four, in RAM that only the stack uses, and below every live frame. The frame
    // of an interrupt is gone when this code continues.
    unsafe {
        ptr::with_exposed_provenance_mut::<u32>(address).write_volatile(PAINT);
    }
}

/// Whether a word of the free stack still holds the pattern of [`paint`].
#[inline]
fn is_painted(address: usize) -> bool {
    #[allow(unsafe_code)]
    // SAFETY: the same holds as for `paint`, which has written a valid `u32` to this address.
    unsafe {
        ptr::with_exposed_provenance::<u32>(address).read_volatile() == PAINT
    }
}
