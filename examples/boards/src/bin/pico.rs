//! A Raspberry Pi Pico (RP2040) and an ST7789. One core draws; DMA sends the finished bands.
#![no_std]
#![no_main]

use boards::queue::{Share, animate, start};
use boards::scene::Memory;
use cortex_m::singleton;
use panic_halt as _;
use rp2040_hal as hal;

/// The second-stage boot loader, which the chip runs first to set up its flash.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

#[hal::entry]
fn main() -> ! {
    let board = start().unwrap();
    let memory = singleton!(: Memory = Memory::new()).unwrap();
    animate(Share::WHOLE, board.timer, memory)
}
