//! A Raspberry Pi Pico (RP2040) or Pico 2 (RP2350) that shows the model behind this program in flash, on the module
//! that the model names. A Pico draws with both cores. The playground and `--example model` put both into one UF2.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use boards::led;
use boards::model::Scene;
use boards::pico::{PIXELS, hal, report};
use boards::queue::{animate_with_depth, set_pattern, start_with};
use cortex_m::singleton;
use flash_model::{ADDRESS, Board, Module};
#[cfg(feature = "pico")]
use hal::multicore::{Multicore, Stack};

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
#[cfg(feature = "pico")]
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
    let depths = singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap();
    #[cfg(feature = "pico")]
    {
        let mut board = board;
        let there = singleton!(: [u16; PIXELS] = [0; PIXELS]).unwrap();
        let mut cores = Multicore::new(&mut board.psm, &mut board.ppb, &mut board.fifo);
        let stack = STACK.take().unwrap();
        cores.cores()[1].spawn(stack, move || draw(there)).unwrap();
    }
    draw(depths)
}

/// Shows the panic on the display and by the LED.
#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    report(info, &Module::wanted(flash()))
}
