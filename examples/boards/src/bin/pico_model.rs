//! A Raspberry Pi Pico (RP2040) or Pico 2 (RP2350) that shows the model behind this program in flash, on an ST7789 or
//! an ILI9341. The playground and `--example model` put both into one UF2.
#![no_std]
#![no_main]

use boards::model::Scene;
use boards::panel::Controller;
use boards::pico::{BANDS_OF_FRAME, HEIGHT, PIXELS, ROWS, hal};
use boards::queue::{begin, free, send, start_with};
use cortex_m::singleton;
use embedded_graphics::pixelcolor::Rgb565;
use fixel::canvas::{Canvas, Words};
use flash_model::{ADDRESS, Board, Panel};
use panic_halt as _;

/// The flash behind the program.
fn flash() -> &'static [u32] {
    let board = if cfg!(feature = "pico2") {
        Board::Pico2
    } else {
        Board::Pico
    };
    // SAFETY: these words are in the board's flash, memory.x keeps the program out of them, and nothing writes to them.
    #[allow(unsafe_code)]
    unsafe {
        core::slice::from_raw_parts(ADDRESS as *const u32, board.words())
    }
}

#[hal::entry]
fn main() -> ! {
    let words = flash();
    let scene = Scene::new(words).unwrap();
    let (width, _) = scene.size();
    let controller = match Panel::wanted(words) {
        Panel::St7789 => Controller::St7789,
        Panel::Ili9341 => Controller::Ili9341,
    };
    let board = start_with(controller, width).unwrap();
    let depths = singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap();
    let mut frame = 0_u32;
    loop {
        let now_ms = begin(frame, board.timer);
        for number in 0..BANDS_OF_FRAME {
            let band = free();
            let canvas = Canvas::<Rgb565, Words>::band(&mut band[..], width, HEIGHT, number * ROWS);
            scene.draw(now_ms, canvas.unwrap(), depths).unwrap();
            send((frame, number), band);
        }
        frame = frame.wrapping_add(1);
    }
}
