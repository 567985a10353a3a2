//! An ESP32-C3 (RISC-V) and an ST7789 of 240x240 pixels. One band is drawn while DMA sends the other.
//!
//! | display | ESP32-C3 | |
//! |---|---|---|
//! | SCL | GPIO6 | SPI 2, clock |
//! | SDA | GPIO7 | SPI 2, data |
//! | CS | GPIO10 | chip select |
//! | DC | GPIO4 | low for a command, high for data |
//! | RES | GPIO5 | reset |
//! | BL | GPIO3 | backlight |
//! | VCC, GND | 3V3, GND | |
#![no_std]
#![no_main]

use boards::panel::{Module, Panel, Pins};
use boards::scene::{Memory, Scene};
use embedded_graphics::pixelcolor::{Rgb565, raw::BigEndian};
use esp_hal::clock::CpuClock;
use esp_hal::delay::Delay;
use esp_hal::dma_tx_buffer;
use esp_hal::gpio::{Level, Output, OutputConfig};
use esp_hal::spi::Mode;
use esp_hal::spi::master::{Config, Spi};
use esp_hal::time::{Instant, Rate};
use fixel::canvas::Canvas;
use panic_halt as _;

const WIDTH: u32 = 240;
const HEIGHT: u32 = 240;
/// Rows of a band; their number divides the height. A transfer has at most 32,736 bytes, which is 68 rows.
const ROWS: u32 = 60;
const BAND: usize = (WIDTH * ROWS) as usize;

// The boot loader looks for this.
esp_bootloader_esp_idf::esp_app_desc!();

#[esp_hal::main]
fn main() -> ! {
    let chip = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));

    // Displays without CS need mode 3.
    let config = Config::default()
        .with_frequency(Rate::from_mhz(40))
        .with_mode(Mode::_3);
    let mut spi = Spi::new(chip.SPI2, config)
        .unwrap()
        .with_sck(chip.GPIO6)
        .with_mosi(chip.GPIO7)
        .with_dma(chip.DMA_CH0);
    let pins = Pins::new(
        Output::new(chip.GPIO10, Level::High, OutputConfig::default()),
        Output::new(chip.GPIO4, Level::High, OutputConfig::default()),
        Output::new(chip.GPIO5, Level::High, OutputConfig::default()),
    );
    let mut panel = Panel::new(&Module::ST7789, &mut spi, pins, &mut Delay::new()).unwrap();

    // Two bands of 28 KiB in memory that DMA can read.
    let mut colors = dma_tx_buffer!(2 * BAND).unwrap();
    let mut black = dma_tx_buffer!(2 * BAND).unwrap();
    panel.clear(&mut spi, black.as_mut_slice()).unwrap();
    let _light = Output::new(chip.GPIO3, Level::High, OutputConfig::default());

    // From here on, a band is always being sent. The first one is black.
    let scene = Scene::new(WIDTH, HEIGHT).unwrap();
    let mut memory = Memory::new();
    panel.start_frame(&mut spi).unwrap();
    let mut transfer = spi.write_buffer(2 * BAND, black).ok().unwrap();
    loop {
        let now_ms = Instant::now().duration_since_epoch().as_millis();
        let moment = scene.at(now_ms, &mut memory).unwrap();
        for first_row in (0..HEIGHT).step_by(ROWS as usize) {
            // DMA sends bytes, and the display wants the more significant one first.
            let (pixels, _) = colors.as_mut_slice().as_chunks_mut();
            let band = Canvas::<Rgb565, BigEndian>::band(pixels, WIDTH, HEIGHT, first_row);
            moment.draw(&mut band.unwrap());
            // A transfer owns its memory: nothing can be drawn into it until `wait` returns it.
            let (mut spi, sent) = transfer.wait();
            if first_row == 0 {
                panel.start_frame(&mut spi).unwrap();
            }
            transfer = spi.write_buffer(2 * BAND, colors).ok().unwrap();
            colors = sent;
        }
    }
}
