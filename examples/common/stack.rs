//! How deep the stack of a piece of work is, on a microcontroller.
//!
//! The free stack is painted, the work done, and the deepest word that lost its paint looked for. An
//! interrupt on the way counts too. A word that happens to be left in the paint's color, or that was
//! reserved and never written, does not.

use core::hint::black_box;
use core::ptr;

/// Where the free stack ends: nothing is between it and the statics, for there is no heap.
#[cfg(target_arch = "arm")]
use cortex_m_rt::heap_start as stack_end;
#[cfg(target_arch = "riscv32")]
use riscv_rt::heap_start as stack_end;

/// What no program writes by chance.
const PAINT: u32 = 0xa51c_e5ab;
/// Bytes beneath the painter's own local that are left alone: the rest of its frame, and of what it
/// calls where nothing is inlined. Work of less depth cannot be told.
const MARGIN: usize = 256;
/// Most bytes that are painted: work of more depth is taken for this much.
const MOST: usize = 64 << 10;
/// Bytes of a word of paint.
const WORD: usize = size_of::<u32>();

/// Does `work`; returns its result and the bytes of stack beneath the caller that it reached.
///
/// No less than 256, and more by what is left of this function's own frame: a few words.
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

/// Has a frame of its own, beneath the one from which depth is counted.
#[inline(never)]
fn apart<T>(work: impl FnOnce() -> T) -> T {
    work()
}

/// Paints a word of free stack.
#[inline]
fn paint(address: usize) {
    #[allow(unsafe_code)]
    // SAFETY: the address is a multiple of four, in RAM that belongs to the stack alone, and beneath
    // every frame that is alive: an interrupt's is gone when this goes on.
    unsafe {
        ptr::with_exposed_provenance_mut::<u32>(address).write_volatile(PAINT);
    }
}

/// Whether a word of free stack is as [`paint`] left it.
#[inline]
fn is_painted(address: usize) -> bool {
    #[allow(unsafe_code)]
    // SAFETY: as for `paint`, which has made it a valid `u32` even if nothing else has.
    unsafe {
        ptr::with_exposed_provenance::<u32>(address).read_volatile() == PAINT
    }
}
