//! A Raspberry Pi Pico (RP2040) or Pico 2 (RP2350) and an ST7789. One core draws; DMA sends the finished bands.
#![no_std]
#![no_main]

use boards::pico::hal;
use boards::queue::{Share, animate, start};
use boards::scene::Memory;
use cortex_m::singleton;
use panic_halt as _;

#[hal::entry]
fn main() -> ! {
    let board = start().unwrap();
    let memory = singleton!(: Memory = Memory::new()).unwrap();
    animate(Share::WHOLE, board.timer, memory)
}
