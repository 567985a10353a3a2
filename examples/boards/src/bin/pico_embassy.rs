//! A Raspberry Pi Pico (RP2040) and an ST7789, with Embassy: a band is drawn while DMA sends the one before it.
//!
//! The display is wired as for the other programs of the Pico: see src/pico.rs.
#![no_std]
#![no_main]

use core::mem::swap;
use core::panic::PanicInfo;

use boards::led;
use boards::panel::{Module, Panel, Pins};
use boards::scene::{Memory, Scene};
use cortex_m::singleton;
use embassy_executor::Spawner;
use embassy_futures::join::join;
use embassy_rp::gpio::{Level, Output};
use embassy_rp::peripherals::{DMA_CH0, PIN_25};
use embassy_rp::spi::{self, Spi};
use embassy_rp::{bind_interrupts, dma};
use embassy_time::{Delay, Instant};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::BigEndian;
use fixel::canvas::Canvas;

const WIDTH: u32 = 240;
const HEIGHT: u32 = 240;
/// Rows of a band; their number divides the height.
const ROWS: u32 = 40;
const BAND: usize = (WIDTH * ROWS) as usize;

bind_interrupts!(struct Interrupts {
    DMA_IRQ_0 => dma::InterruptHandler<DMA_CH0>;
});

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let chip = embassy_rp::init(Default::default()); // 125 MHz
    let mut config = spi::Config::default();
    config.frequency = 62_500_000;
    // Mode 3, which displays without CS need.
    config.polarity = spi::Polarity::IdleHigh;
    config.phase = spi::Phase::CaptureOnSecondTransition;
    let (clock, data) = (chip.PIN_18, chip.PIN_19);
    let mut spi = Spi::new_txonly(chip.SPI0, clock, data, chip.DMA_CH0, Interrupts, config);
    let pins = Pins::new(
        Output::new(chip.PIN_17, Level::High),
        Output::new(chip.PIN_16, Level::High),
        Output::new(chip.PIN_20, Level::High),
    );
    let mut panel = Panel::new(&Module::ST7789, &mut spi, pins, &mut Delay).unwrap();

    // A pixel is two bytes: embassy-rp's bus has no words of 16 bits.
    let mut colors = singleton!(: [[u8; 2]; BAND] = [[0; 2]; BAND]).unwrap();
    let mut ready = singleton!(: [[u8; 2]; BAND] = [[0; 2]; BAND]).unwrap();
    panel.clear(&mut spi, ready.as_flattened()).unwrap();
    let _light = Output::new(chip.PIN_21, Level::High);
    let mut led = Output::new(chip.PIN_25, Level::High);

    // The first band that is sent is black, and so is the display.
    let (scene, mut memory) = (Scene::new(WIDTH, HEIGHT).unwrap(), Memory::new());
    loop {
        let now_ms = Instant::now().as_millis();
        led::show(&mut led, led::RUNS, now_ms);
        let moment = scene.at(now_ms, &mut memory).unwrap();
        for first_row in (0..HEIGHT).step_by(ROWS as usize) {
            // `join` starts the transfer, then draws; it returns when both are done.
            let sending = spi.write(ready.as_flattened());
            let drawing = async {
                let band = Canvas::<Rgb565, BigEndian>::band(colors, WIDTH, HEIGHT, first_row);
                moment.draw(&mut band.unwrap());
            };
            let (sent, ()) = join(sending, drawing).await;
            sent.unwrap();
            if first_row == 0 {
                panel.start_frame::<u8>(&mut spi).unwrap();
            }
            swap(&mut colors, &mut ready);
        }
    }
}

/// Blinks the LED for ever.
#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    // SAFETY: nothing else switches the LED from now on.
    #[allow(unsafe_code)]
    let mut led = Output::new(unsafe { PIN_25::steal() }, Level::High);
    loop {
        led::show(&mut led, led::PANIC, Instant::now().as_millis());
    }
}
