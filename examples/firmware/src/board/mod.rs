//! Everything that depends on the core: the entry of a program, its end, and the clock.
//!
//! On all cores, the console and the exit use semihosting.

use core::panic::PanicInfo;

use fixel::Error;
use semihosting::{println, process};

#[cfg(target_arch = "arm")]
mod arm;
#[cfg(target_arch = "riscv32")]
mod riscv;

#[cfg(target_arch = "arm")]
pub use self::arm::{Clock, entry, instructions};
#[cfg(target_arch = "riscv32")]
pub use self::riscv::{Clock, entry, instructions};

/// The number of instructions in a tick of the clock, measured with a loop of known length.
///
/// Under QEMU with `-icount shift=0`, an instruction takes a nanosecond, so the result is the clock's period in
/// nanoseconds. On a chip, the result is near 1, because the clock counts the core's cycles.
pub fn instructions_per_tick(clock: &mut Clock) -> u64 {
    const COUNT: u32 = 1 << 20;
    let ((), ticks) = clock.time(|| instructions(COUNT));
    (u64::from(COUNT) + ticks / 2) / ticks
}

/// Ends the program: with status 0 after success, with status 1 after an error, which is printed.
pub fn exit(result: Result<(), Error>) -> ! {
    match result {
        Ok(()) => process::exit(0),
        Err(error) => {
            println!("{error}");
            process::exit(1)
        }
    }
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    println!("{info}");
    process::exit(1)
}
