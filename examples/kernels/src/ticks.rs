//! Time in ticks of the board's clock.

use core::fmt;

use semihosting::println;

use super::board::{self, Clock};

/// SysTick counts through 24 bits; nothing here takes that long.
const ROUND: u64 = 1 << 24;

/// Takes the time of pieces of work.
pub struct Stopwatch {
    clock: Clock,
    tick: Tick,
}

/// What a tick is.
#[derive(Clone, Copy)]
pub enum Tick {
    /// So many instructions, under QEMU.
    Instructions(u64),
    /// A cycle of the core. It has no fewer cycles than instructions.
    Cycle,
}

impl Tick {
    /// In instructions or cycles.
    fn size(self) -> u64 {
        match self {
            Self::Instructions(count) => count,
            Self::Cycle => 1,
        }
    }
}

impl fmt::Display for Tick {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Instructions(count) => write!(f, "tick={count} instructions"),
            Self::Cycle => f.write_str("tick=1 cycles"),
        }
    }
}

impl Stopwatch {
    /// Learns what a tick of the clock is.
    pub fn new(mut clock: Clock) -> Self {
        // Two instructions take more than two cycles, as one of them is a branch.
        let ((), ticks) = clock.time(|| board::instructions(1 << 16));
        let tick = if ticks % ROUND > (1 << 16) + (1 << 12) {
            Tick::Cycle
        } else {
            Tick::Instructions(board::instructions_per_tick(&mut clock))
        };
        Self { clock, tick }
    }

    /// What a tick is.
    pub fn tick(&self) -> Tick {
        self.tick
    }

    /// Does `work`, which may fail; returns the ticks that it took.
    pub fn time<E>(&mut self, work: impl FnOnce() -> Result<(), E>) -> Result<u64, E> {
        let (result, ticks) = self.clock.time(work);
        // A simulator may have no interrupt that counts the rounds of its timer.
        result.map(|()| ticks % ROUND)
    }

    /// Prints what so many units of a kernel took.
    pub fn print(&self, kernel: &str, unit: &str, units: u32, ticks: u64) {
        let hundredths = ticks * self.tick.size() * 100 / u64::from(units);
        let (each, part) = (hundredths / 100, hundredths % 100);
        println!("kernel={kernel} unit={unit} units={units} ticks={ticks} each={each}.{part:02}");
    }
}
