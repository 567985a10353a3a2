//! A RISC-V core that counts its cycles.

use core::arch::asm;

use riscv::register::mcycle;
pub use riscv_rt::entry;

/// The 64-bit cycle counter of the core. Under QEMU with `-icount shift=0`, it counts instructions.
pub struct Clock(());

impl Clock {
    /// Takes the clock, which counts from reset. Can be called any number of times.
    #[allow(clippy::unnecessary_wraps)] // the same signature as on Arm, where it can fail
    pub fn take() -> Option<Self> {
        Some(Self(()))
    }

    /// Calls `work`. Returns its result and the ticks that it took.
    #[allow(clippy::unused_self)] // the same signature as on Arm
    pub fn time<T>(&mut self, work: impl FnOnce() -> T) -> (T, u64) {
        let start = mcycle::read64();
        let result = work();
        (result, mcycle::read64() - start)
    }
}

/// Executes `count` instructions. `count` must be even and not 0.
pub fn instructions(count: u32) {
    #[allow(unsafe_code)]
    // SAFETY: the code only counts a register down to zero.
    unsafe {
        asm!(
            "2:",
            "addi {left}, {left}, -1",
            "bnez {left}, 2b",
            left = inout(reg) count / 2 => _,
            options(nomem, nostack),
        );
    }
}
