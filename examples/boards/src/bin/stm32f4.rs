//! An STM32F405 with Embassy, and an ILI9341 of 320x240 pixels. One band is drawn while DMA sends the other.
//!
//! | display | STM32F405 | |
//! |---|---|---|
//! | SCK | PA5 | SPI 1, clock |
//! | SDI (MOSI) | PA7 | SPI 1, data |
//! | CS | PA4 | chip select |
//! | DC | PB0 | low for a command, high for data |
//! | RESET | PB1 | reset |
//! | LED | PB10 | backlight |
//! | VCC, GND | 3.3 V, GND | |
//!
//! For another STM32, change the name of the chip in Cargo.toml and .cargo/config.toml, and the clocks and pins here.
#![no_std]
#![no_main]

use core::mem::swap;

use boards::panel::{Module, Panel, Pins};
use boards::scene::{Memory, Scene};
use cortex_m::singleton;
use embassy_executor::Spawner;
use embassy_futures::join::join;
use embassy_stm32::gpio::{Level, Output, Speed};
use embassy_stm32::spi::{self, Spi};
use embassy_stm32::time::mhz;
use embassy_stm32::{Config, bind_interrupts, dma, peripherals, rcc};
use embassy_time::{Delay, Instant};
use embedded_graphics::pixelcolor::Rgb565;
use fixel::canvas::{Canvas, Words};
use panic_halt as _;

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;
/// Rows of a band; their number divides the height.
const ROWS: u32 = 40;
const BAND: usize = (WIDTH * ROWS) as usize;

bind_interrupts!(struct Interrupts {
    DMA2_STREAM3 => dma::InterruptHandler<peripherals::DMA2_CH3>;
});

/// 168 MHz from the chip's internal oscillator, so that the board's crystal does not matter.
fn clocks() -> Config {
    let mut config = Config::default();
    config.rcc.pll_src = rcc::PllSource::HSI;
    config.rcc.pll = Some(rcc::Pll {
        prediv: rcc::PllPreDiv::DIV8,
        mul: rcc::PllMul::MUL168,
        divp: Some(rcc::PllPDiv::DIV2),
        divq: None,
        divr: None,
    });
    config.rcc.sys = rcc::Sysclk::PLL1_P;
    config.rcc.apb1_pre = rcc::APBPrescaler::DIV4;
    config.rcc.apb2_pre = rcc::APBPrescaler::DIV2;
    config
}

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let chip = embassy_stm32::init(clocks());

    let mut config = spi::Config::default();
    config.frequency = mhz(42);
    let mut spi = Spi::new_txonly(
        chip.SPI1,
        chip.PA5,
        chip.PA7,
        chip.DMA2_CH3,
        Interrupts,
        config,
    );
    let pins = Pins::new(
        Output::new(chip.PA4, Level::High, Speed::VeryHigh),
        Output::new(chip.PB0, Level::High, Speed::VeryHigh),
        Output::new(chip.PB1, Level::High, Speed::Low),
    );
    let mut panel = Panel::new(&Module::ILI9341, &mut spi, pins, &mut Delay).unwrap();

    // Two bands: 50 KiB, none of it on the stack. A pixel is a word of the bus.
    let mut colors = singleton!(: [u16; BAND] = [0; BAND]).unwrap();
    let mut ready = singleton!(: [u16; BAND] = [0; BAND]).unwrap();
    panel.clear(&mut spi, &ready[..]).unwrap();
    let _light = Output::new(chip.PB10, Level::High, Speed::Low);

    // The first band that is sent is black.
    let scene = Scene::new(WIDTH, HEIGHT).unwrap();
    let memory = singleton!(: Memory = Memory::new()).unwrap();
    panel.start_frame::<u16>(&mut spi).unwrap();
    loop {
        let moment = scene.at(Instant::now().as_millis(), memory).unwrap();
        for first_row in (0..HEIGHT).step_by(ROWS as usize) {
            // `join` starts the transfer, then draws; it returns when both are done.
            let sending = spi.write(&ready[..]);
            let drawing = async {
                let band = Canvas::<Rgb565, Words>::band(&mut colors[..], WIDTH, HEIGHT, first_row);
                moment.draw(&mut band.unwrap());
            };
            let (sent, ()) = join(sending, drawing).await;
            sent.unwrap();
            if first_row == 0 {
                panel.start_frame::<u16>(&mut spi).unwrap();
            }
            swap(&mut colors, &mut ready);
        }
    }
}
