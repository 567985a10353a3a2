//! A Raspberry Pi Pico (RP2040) or Pico 2 (RP2350) and an ST7789. One core draws; DMA sends the finished bands.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use boards::pico::{MODULE, hal, report};
use boards::queue::{Share, animate, start};
use boards::scene::Memory;
use cortex_m::singleton;

#[hal::entry]
fn main() -> ! {
    let board = start().unwrap();
    let memory = singleton!(: Memory = Memory::new()).unwrap();
    animate(Share::WHOLE, board.timer, memory)
}

/// Shows the panic on the display and by the LED.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    report(info, &MODULE)
}
