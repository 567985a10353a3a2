//! A Raspberry Pi Pico (RP2040) or Pico 2 (RP2350) that shows the model behind this program in flash, on the module
//! that the model names. The playground and `--example model` put both into one UF2.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use boards::led;
use boards::model::Scene;
use boards::panel::widen;
use boards::pico::{PIXELS, hal, report, rows_for};
use boards::queue::{begin, free, send, set_pattern, start_with};
use cortex_m::singleton;
use embedded_graphics::pixelcolor::Rgb565;
use fixel::canvas::{Canvas, Words};
use flash_model::{ADDRESS, Board, Module};

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
    let module = Module::wanted(words);
    let ((width, height), rows) = (module.size(), rows_for(&module));
    let pixels = (width * rows) as usize;
    let board = start_with(&module).unwrap();
    if !scene.has_model() {
        set_pattern(led::NO_MODEL);
    }
    let depths = singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap();
    let mut frame = 0_u32;
    loop {
        let now_ms = begin(frame, board.timer);
        for number in 0..height / rows {
            let band = free();
            let canvas =
                Canvas::<Rgb565, Words>::band(&mut band[..pixels], width, height, number * rows);
            scene.draw(now_ms, canvas.unwrap(), depths).unwrap();
            if module.bytes_of_pixel() == 3 {
                widen(band);
            }
            send((frame, number), band);
        }
        frame = frame.wrapping_add(1);
    }
}

/// Shows the panic on the display and by the LED.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    report(info, &Module::wanted(flash()))
}
