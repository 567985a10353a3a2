//! A Raspberry Pi Pico (RP2040) or Pico 2 (RP2350) and an ST7789. Someone walks through a garden at dusk. A Pico draws
//! with both cores.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use boards::pico::{MODULE, PIXELS, hal, report};
use boards::queue::{animate_with_depth, start};
use boards::walk;
use cortex_m::singleton;
#[cfg(feature = "pico")]
use hal::multicore::{Multicore, Stack};

/// The stack of core 1, in words of four bytes: half as much again as was measured.
#[cfg(feature = "pico")]
static STACK: Stack<4096> = Stack::new();

#[hal::entry]
fn main() -> ! {
    let board = start().unwrap();
    let timer = board.timer;
    let draw =
        move |depths: &mut [u16]| -> ! { animate_with_depth(&MODULE, timer, depths, walk::draw) };
    let depths = singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap();
    #[cfg(feature = "pico")]
    {
        let mut board = board;
        let there = singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap();
        let mut cores = Multicore::new(&mut board.psm, &mut board.ppb, &mut board.fifo);
        let stack = STACK.take().unwrap();
        cores.cores()[1].spawn(stack, move || draw(there)).unwrap();
    }
    draw(depths)
}

/// Shows the panic on the display and by the LED.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    report(info, &MODULE)
}
