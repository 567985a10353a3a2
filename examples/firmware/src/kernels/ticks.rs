//! Measures time in ticks of the board's clock.

use core::fmt;

use semihosting::println;

use super::board::{self, Clock};

/// SysTick counts in 24 bits. No measurement here takes longer than a round of SysTick.
const ROUND: u64 = 1 << 24;

/// Measures how long functions take.
pub struct Stopwatch {
    clock: Clock,
    tick: Tick,
}

/// The unit of a tick.
#[derive(Clone, Copy)]
pub enum Tick {
    /// A number of instructions, under QEMU.
    Instructions(u64),
    /// One cycle of the core. On every core here, an instruction takes at least one cycle.
    Cycle,
}

impl Tick {
    /// The number of instructions or cycles in a tick.
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
    /// Determines the unit of the clock's ticks.
    pub fn new(mut clock: Clock) -> Self {
        // On a chip, two instructions take more than two cycles, because one of them is a branch.
        let ((), ticks) = clock.time(|| board::instructions(1 << 16));
        let tick = if ticks % ROUND > (1 << 16) + (1 << 12) {
            Tick::Cycle
        } else {
            Tick::Instructions(board::instructions_per_tick(&mut clock))
        };
        Self { clock, tick }
    }

    /// Returns the unit of a tick.
    pub fn tick(&self) -> Tick {
        self.tick
    }

    /// Calls `work`, which can fail. Returns the ticks that it took.
    pub fn time<E>(&mut self, work: impl FnOnce() -> Result<(), E>) -> Result<u64, E> {
        let (result, ticks) = self.clock.time(work);
        // An emulator can fail to raise the interrupt that counts the timer's rounds, so whole rounds are dropped.
        result.map(|()| ticks % ROUND)
    }

    /// Prints the ticks of a kernel for this number of units.
    pub fn print(&self, kernel: &str, unit: &str, units: u32, ticks: u64) {
        let hundredths = ticks * self.tick.size() * 100 / u64::from(units);
        let (each, part) = (hundredths / 100, hundredths % 100);
        println!("kernel={kernel} unit={unit} units={units} ticks={ticks} each={each}.{part:02}");
    }

    /// Prints the ticks of this number of frames of a scene.
    pub fn print_frames(&self, mode: &str, scene: &str, frames: u32, ticks: u64) {
        let each = ticks * self.tick.size() / u64::from(frames);
        println!(
            "scene={scene} mode={mode} layout=mean-of-poses frames={frames} ticks={ticks} each={each}"
        );
    }
}
