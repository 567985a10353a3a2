//! A Raspberry Pi Pico (RP2040) and an ST7789. Both cores draw; DMA sends the finished bands.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use boards::pico::{MODULE, hal, report};
use boards::queue::{Share, animate, start};
use boards::scene::Memory;
use cortex_m::singleton;
use hal::multicore::Stack;

/// The stack of core 1, in words of four bytes: half as much again as was measured.
static STACK: Stack<2048> = Stack::new();

/// The ball takes longest to prepare, the crate and the floor to draw.
fn share(core: u32) -> Share {
    if cfg!(feature = "ball") {
        Share::frames(core)
    } else {
        Share::bands(core)
    }
}

#[hal::entry]
fn main() -> ! {
    let board = start().unwrap();
    let timer = board.timer;
    let [here, there] = [
        singleton!(: Memory = Memory::new()).unwrap(),
        singleton!(: Memory = Memory::new()).unwrap(),
    ];
    board.start_core_1(&STACK, move || animate(share(1), timer, there));
    animate(share(0), timer, here)
}

/// Shows the panic on the display and by the LED.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    report(info, &MODULE)
}
