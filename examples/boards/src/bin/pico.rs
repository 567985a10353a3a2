//! A Raspberry Pi Pico (RP2040) and an ST7789 of 240x240 pixels. One band is drawn while DMA sends the other.
//!
//! | display | Pico | |
//! |---|---|---|
//! | SCL | GP18 | SPI 0, clock |
//! | SDA | GP19 | SPI 0, data |
//! | CS | GP17 | chip select |
//! | DC | GP16 | low for a command, high for data |
//! | RES | GP20 | reset |
//! | BL | GP21 | backlight |
//! | VCC, GND | 3V3, GND | |
#![no_std]
#![no_main]

use cortex_m::singleton;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::MODE_0;
use hal::clocks::{Clock, init_clocks_and_plls};
use hal::dma::{DMAExt, single_buffer};
use hal::fugit::RateExtU32;
use hal::gpio::{self, FunctionSpi};
use hal::{Sio, Spi, Timer, Watchdog, pac};
use panic_halt as _;
use rp2040_hal as hal;
use scene::Scene;
use scene::panel::{Panel, Pins};

const WIDTH: u32 = 240;
const HEIGHT: u32 = 240;
/// Rows of a band; their number divides the height.
const ROWS: u32 = 40;
const BAND: usize = (WIDTH * ROWS) as usize;

/// The second-stage boot loader, which the chip runs first to set up its flash.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

/// The frequency of the Pico's crystal.
const CRYSTAL_HZ: u32 = 12_000_000;

#[hal::entry]
fn main() -> ! {
    // The processor and its peripherals run at 125 MHz.
    let mut pac = pac::Peripherals::take().unwrap();
    let mut watchdog = Watchdog::new(pac.WATCHDOG);
    let clocks = init_clocks_and_plls(
        CRYSTAL_HZ,
        pac.XOSC,
        pac.CLOCKS,
        pac.PLL_SYS,
        pac.PLL_USB,
        &mut pac.RESETS,
        &mut watchdog,
    )
    .ok()
    .unwrap();
    let mut timer = Timer::new(pac.TIMER, &mut pac.RESETS, &clocks);

    let sio = Sio::new(pac.SIO);
    let gpio = gpio::Pins::new(
        pac.IO_BANK0,
        pac.PADS_BANK0,
        sio.gpio_bank0,
        &mut pac.RESETS,
    );
    let clock = gpio.gpio18.into_function::<FunctionSpi>();
    let data = gpio.gpio19.into_function::<FunctionSpi>();
    let mut spi = Spi::<_, _, _, 8>::new(pac.SPI0, (data, clock)).init(
        &mut pac.RESETS,
        clocks.peripheral_clock.freq(),
        62_500_000.Hz(),
        MODE_0,
    );
    let pins = Pins {
        cs: gpio.gpio17.into_push_pull_output(),
        dc: gpio.gpio16.into_push_pull_output(),
        reset: gpio.gpio20.into_push_pull_output(),
    };
    let mut panel = Panel::st7789(&mut spi, pins, &mut timer).unwrap();
    gpio.gpio21.into_push_pull_output().set_high().unwrap();

    // Two bands of color and one of depth: 56 KiB, none of it on the stack.
    let mut colors = singleton!(: [[u8; 2]; BAND] = [[0; 2]; BAND]).unwrap();
    let black = singleton!(: [[u8; 2]; BAND] = [[0; 2]; BAND]).unwrap();
    let depths = singleton!(: [u16; BAND] = [0; BAND]).unwrap();
    let scene = Scene::new(WIDTH, HEIGHT).unwrap();

    // From here on, a band is always being sent. The first one is black.
    let channel = pac.DMA.split(&mut pac.RESETS).ch0;
    panel.start_frame(&mut spi).unwrap();
    let mut transfer = single_buffer::Config::new(channel, black, spi).start();
    loop {
        let now_ms = timer.get_counter().ticks() / 1000;
        for first_row in (0..HEIGHT).step_by(ROWS as usize) {
            scene.draw_band(now_ms, first_row, colors, depths).unwrap();
            // A transfer owns its memory: nothing can be drawn into it until `wait` returns it.
            let (channel, sent, mut spi) = transfer.wait();
            if first_row == 0 {
                panel.start_frame(&mut spi).unwrap();
            }
            transfer = single_buffer::Config::new(channel, colors, spi).start();
            colors = sent;
        }
    }
}
