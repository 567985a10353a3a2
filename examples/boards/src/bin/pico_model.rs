//! A Raspberry Pi Pico (RP2040) or Pico 2 (RP2350) that shows the model behind this program in flash, on the module
//! that the model names. Both cores draw. The playground and `--example model` put both into one UF2.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use boards::led;
use boards::model::Scene;
use boards::pico::{PIXELS, hal, report};
use boards::queue::{animate_with_depth, set_pattern, start_with};
use cortex_m::singleton;
use flash_model::{ADDRESS, Board, Module};
use hal::multicore::Stack;

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

/// The stack of core 1, in words of four bytes: half as much again as was measured.
static STACK: Stack<3584> = Stack::new();

#[hal::entry]
fn main() -> ! {
    let words = flash();
    let scene: &Scene<'_> = singleton!(: Scene<'static> = Scene::new(words).unwrap()).unwrap();
    let module = Module::wanted(words);
    let board = start_with(&module).unwrap();
    if !scene.has_model() {
        set_pattern(led::NO_MODEL);
    }
    let timer = board.timer;
    let draw = move |depths: &mut [u16]| -> ! {
        animate_with_depth(&module, timer, depths, |now_ms, band| {
            scene.draw(now_ms, band);
            Ok(())
        })
    };
    let [here, there] = [
        singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap(),
        singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap(),
    ];
    board.start_core_1(&STACK, move || draw(there));
    draw(here)
}

/// Shows the panic on the display and by the LED.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    report(info, &Module::wanted(flash()))
}
