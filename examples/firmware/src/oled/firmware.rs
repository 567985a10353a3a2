//! The part of the program that runs on the board. This part draws frame after frame in bands, one frame every 30 ms.

use cortex_m::asm;
use cortex_m::peripheral::{SYST, syst::SystClkSource};
use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use fixel::prelude::*;
use semihosting::{println, process};

use super::board::Oled;
use super::gyroscope::{FRAME_MS, FRAMES, HEIGHT, Lists, WIDTH};
use super::ssd0323::Ssd0323;

/// The number of rows of a band.
const ROWS: u32 = 16;

/// The chip starts with its internal oscillator, which has about 12 MHz.
const TICKS_PER_MS: u32 = 12_000;

fn spin(panel: &mut Ssd0323, timer: &mut SYST) -> Result<(), Error> {
    let mut grays = [Gray4::BLACK; (WIDTH * ROWS) as usize];
    let mut depths = [0; (WIDTH * ROWS) as usize];
    let mut lists = Lists::new();
    for frame in 0..FRAMES {
        let gyroscope = lists.prepare(frame)?;
        for first_row in (0..HEIGHT).step_by(ROWS as usize) {
            let band = Canvas::band(&mut grays, WIDTH, HEIGHT, first_row)?;
            let mut band = band.with_depth(&mut depths)?;
            gyroscope.draw(&mut band)?;
            band.show(panel)?;
        }
        // If a frame takes longer than this, the next frame follows at once.
        while !timer.has_wrapped() {}
    }
    Ok(())
}

#[entry]
fn main() -> ! {
    let mut timer = cortex_m::Peripherals::take().expect("taken once").SYST;
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(TICKS_PER_MS * FRAME_MS - 1);
    timer.clear_current();
    timer.enable_counter();

    let mut panel = Ssd0323::new(Oled::new());
    println!("{} frames, one every {} ms", FRAMES, FRAME_MS);
    if let Err(error) = spin(&mut panel, &mut timer) {
        println!("{}", error);
        process::exit(1);
    }
    println!(
        "frame {} shown, and there it stays: Ctrl-C ends it",
        FRAMES - 1
    );
    loop {
        asm::wfi();
    }
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
    println!("{}", info);
    process::exit(1)
}
