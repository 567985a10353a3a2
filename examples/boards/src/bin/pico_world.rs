//! A Raspberry Pi Pico (RP2040) or Pico 2 (RP2350) and an ST7789. Someone walks through a garden at dusk. Both cores
//! draw.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use boards::pico::{MODULE, PIXELS, hal, report};
use boards::queue::{animate_with_depth, start};
use boards::walk;
use cortex_m::singleton;
use hal::multicore::Stack;

/// The stack of core 1, in words of four bytes: half as much again as was measured.
static STACK: Stack<4096> = Stack::new();

#[hal::entry]
fn main() -> ! {
    let board = start().unwrap();
    let timer = board.timer;
    let draw =
        move |depths: &mut [u16]| -> ! { animate_with_depth(&MODULE, timer, depths, walk::draw) };
    let [here, there] = [
        singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap(),
        singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap(),
    ];
    board.start_core_1(&STACK, move || draw(there));
    draw(here)
}

/// Shows the panic on the display and by the LED.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    report(info, &MODULE)
}
