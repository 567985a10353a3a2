//! A Cortex-M with SysTick. Every Cortex-M has this timer.

use core::arch::asm;
use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::interrupt;
use cortex_m::peripheral::{Peripherals, SCB, SYST, syst::SystClkSource};
pub use cortex_m_rt::entry;
use cortex_m_rt::exception;

/// SysTick counts down to zero in 24 bits, and then restarts at this value.
const MOST: u32 = 0x00ff_ffff;
/// The number of ticks in a round.
const ROUND: u64 = 1 << 24;

/// The number of rounds that SysTick has completed since the clock was set to zero. Only the exception handler adds to
/// it, so loads and stores are enough.
static ROUNDS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    ROUNDS.store(
        ROUNDS.load(Ordering::Relaxed).wrapping_add(1),
        Ordering::Relaxed,
    );
}

/// SysTick at the frequency of the core. The clock counts SysTick's rounds, too, so it can count 2^56 ticks.
pub struct Clock(SYST);

impl Clock {
    /// Takes the clock. Can be called only once.
    pub fn take() -> Option<Self> {
        let mut timer = Peripherals::take()?.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(MOST);
        timer.clear_current();
        timer.enable_interrupt();
        timer.enable_counter();
        Some(Self(timer))
    }

    /// Calls `work`. Returns its result and the ticks that it took.
    pub fn time<T>(&mut self, work: impl FnOnce() -> T) -> (T, u64) {
        // Start from zero. No exception interrupts the first round, so this round counts only the work.
        interrupt::free(|_| {
            self.0.clear_current();
            SCB::clear_pendst();
            ROUNDS.store(0, Ordering::Relaxed);
        });
        let start = self.ticks();
        let result = work();
        (result, self.ticks() - start)
    }

    /// The number of ticks since the clock was set to zero.
    fn ticks(&self) -> u64 {
        // No round is counted during this block. If a round ends during the block, SysTick's exception is pending, and
        // a second reading of the timer belongs to the next round. If no exception is pending even now, the first
        // reading belongs to the current round.
        let (rounds, left) = interrupt::free(|_| {
            let (rounds, left) = (ROUNDS.load(Ordering::Relaxed), self.left());
            if SCB::is_pendst_pending() {
                (rounds + 1, self.left())
            } else {
                (rounds, left)
            }
        });
        u64::from(rounds) * ROUND + (ROUND - u64::from(left))
    }

    /// The number of ticks left in the round, at least 1. The timer is 0 for one tick, at the end of a round or just
    /// after it was set. Wait until this tick has passed.
    fn left(&self) -> u32 {
        loop {
            let left = self.0.cvr.read();
            if left > 0 {
                return left;
            }
        }
    }
}

/// Executes `count` instructions. `count` must be even and not 0.
pub fn instructions(count: u32) {
    #[allow(unsafe_code)]
    // SAFETY: the code only counts a register down to zero.
    unsafe {
        asm!(
            "2:",
            "subs {left}, #1",
            "bne 2b",
            left = inout(reg) count / 2 => _,
            options(nomem, nostack),
        );
    }
}
