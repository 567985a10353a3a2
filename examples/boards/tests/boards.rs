//! Checks what each board shows: the scene's picture, in a frame and in the board's bands, and the bytes that make a
//! display show it.

mod wires;

// A display that follows its data sheet. The cookbook's tests use it, too.
#[allow(dead_code)]
#[path = "../../cookbook/tests/display/panel.rs"]
mod display;

use embedded_graphics::pixelcolor::{Rgb565, raw::BigEndian};
use embedded_hal::spi::SpiBus;
use fixel::prelude::*;
use scene::Scene;
use scene::panel::{Panel, Pins};

use wires::{Pin, Wires};

/// A board's frame, the height of its bands, and the checksum of the scene at one second.
struct Board {
    size: (u32, u32),
    rows: u32,
    crc: u32,
}

const PICO: Board = Board {
    size: (240, 240),
    rows: 40,
    crc: 0x7714_2a37,
};
const STM32F4: Board = Board {
    size: (320, 240),
    rows: 40,
    crc: 0x6511_7363,
};
const ESP32C3: Board = Board {
    size: (240, 240),
    rows: 60,
    crc: PICO.crc,
};

/// The bytes of the whole frame.
fn frame((width, height): (u32, u32), now_ms: u64) -> Vec<u8> {
    let mut pixels = vec![[0; 2]; (width * height) as usize];
    let mut depths = vec![0; pixels.len()];
    let canvas: Canvas<Rgb565, BigEndian> = Canvas::new(&mut pixels, width, height).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    Scene::new(width, height).unwrap().draw(now_ms, &mut canvas);
    canvas.as_bytes().to_vec()
}

/// Draws the frame in bands, all in the same memory, and passes the bytes of each to `send`.
fn bands(board: &Board, now_ms: u64, mut send: impl FnMut(&[u8])) {
    let (width, height) = board.size;
    let scene = Scene::new(width, height).unwrap();
    let mut colors = vec![[0; 2]; (width * board.rows) as usize];
    let mut depths = vec![0; colors.len()];
    for first_row in (0..height).step_by(board.rows as usize) {
        scene
            .draw_band(now_ms, first_row, &mut colors, &mut depths)
            .unwrap();
        send(colors.as_flattened());
    }
}

#[test]
fn bands_equal_the_frame() {
    for board in [PICO, STM32F4, ESP32C3] {
        for now_ms in [0, 1000, 7777] {
            let mut sent = vec![];
            bands(&board, now_ms, |band| sent.extend_from_slice(band));
            assert!(
                sent == frame(board.size, now_ms),
                "{:?} at {now_ms}",
                board.size
            );
        }
    }
}

/// A chip draws the same bits: you can compare this checksum with one that your firmware logs.
#[test]
fn checksums_of_the_boards_pictures() {
    for board in [PICO, STM32F4, ESP32C3] {
        let crc = crc32fast::hash(&frame(board.size, 1000));
        assert_eq!(crc, board.crc, "{:#x} at {:?}", crc, board.size);
    }
}

fn pins(wires: &Wires) -> Pins<Pin, Pin, Pin> {
    Pins {
        cs: wires.select(),
        dc: wires.data(),
        reset: wires.reset(),
    }
}

/// Sends two frames as a board does, and checks that the display shows the second one.
fn show(board: &Board, mut bus: Wires, mut panel: Panel<Pin, Pin, Pin>) {
    let mut display = display::Panel::default();
    for now_ms in [0, 1000] {
        panel.start_frame(&mut bus).unwrap();
        bands(board, now_ms, |band| bus.write(band).unwrap());
    }
    let mut commands = bus.commands();
    for command in &mut commands {
        // The panel's glass has blue first. With the bit for this order, the display shows the colors that were sent.
        if command.code == 0x36 {
            command.data[0] &= !0b1000;
        }
    }
    display.read(&commands);
    let shown: Vec<u8> = display
        .picture(board.size)
        .iter()
        .flat_map(|pixel| pixel.to_be_bytes())
        .collect();
    assert!(
        shown == frame(board.size, 1000),
        "the display shows another picture"
    );
}

#[test]
fn an_st7789_shows_the_bands() {
    for board in [PICO, ESP32C3] {
        let wires = Wires::default();
        let mut bus = wires.clone();
        let panel = Panel::st7789(&mut bus, pins(&wires), &mut wires.clone()).unwrap();
        show(&board, bus, panel);
    }
}

#[test]
fn an_ili9341_shows_the_bands() {
    let wires = Wires::default();
    let mut bus = wires.clone();
    let panel = Panel::ili9341(&mut bus, pins(&wires), &mut wires.clone()).unwrap();
    show(&STM32F4, bus, panel);
}

/// The log has one line for each command with its data. Other events are in words.
#[test]
fn an_st7789_receives_these_bytes() {
    let wires = Wires::default();
    let mut bus = wires.clone();
    let mut panel = Panel::st7789(&mut bus, pins(&wires), &mut wires.clone()).unwrap();
    panel.start_frame(&mut bus).unwrap();
    bus.write(&[0x12, 0x34, 0x56, 0x78]).unwrap();
    panel.start_frame(&mut bus).unwrap();
    let lines = [
        "reset low",
        "wait 10 us",
        "reset high",
        "wait 150000 us",
        "11", // out of sleep
        "wait 10000 us",
        "36 00", // columns and rows in their own order, red first
        "21",    // inverted, as these panels are
        "3a 55", // 16 bits a pixel
        "wait 10000 us",
        "13", // normal mode
        "wait 10000 us",
        "29", // display on
        "wait 120000 us",
        "2a 00 00 00 ef", // columns 0 to 239
        "2b 00 00 00 ef", // rows 0 to 239
        "2c 12 34 56 78", // pixels
        "2a 00 00 00 ef",
        "2b 00 00 00 ef",
        "2c",
    ];
    assert_eq!(bus.log(), lines.join("\n"));
}

#[test]
fn an_ili9341_receives_these_bytes() {
    let wires = Wires::default();
    let mut bus = wires.clone();
    let mut panel = Panel::ili9341(&mut bus, pins(&wires), &mut wires.clone()).unwrap();
    panel.start_frame(&mut bus).unwrap();
    let lines = [
        "reset low",
        "wait 10 us",
        "reset high",
        "wait 5000 us",
        "36 28", // columns and rows exchanged, blue first
        "b4 00", // inversion by lines
        "20",    // not inverted
        "3a 55",
        "13",
        "wait 120000 us",
        "11",
        "wait 140000 us",
        "29",
        "2a 00 00 01 3f", // columns 0 to 319
        "2b 00 00 00 ef",
        "2c",
    ];
    assert_eq!(bus.log(), lines.join("\n"));
}

/// The guide quotes lines of these programs: the programs must contain them.
#[test]
fn the_guide_quotes_the_programs() {
    const GUIDE: &str = include_str!("../../../src/guide/firmware.md");
    const PROGRAMS: [&str; 2] = [
        include_str!("../src/bin/stm32f4.rs"),
        include_str!("../src/bin/esp32c3.rs"),
    ];
    let plain =
        |text: &str| -> Vec<String> { text.lines().map(|line| line.trim().to_string()).collect() };
    let section = GUIDE.split("\n# Three boards\n").nth(1).unwrap();
    let section = section.split("\n# ").next().unwrap();
    let quotes: Vec<_> = section.split("```").skip(1).step_by(2).collect();
    assert_eq!(quotes.len(), PROGRAMS.len());
    for (quote, program) in quotes.iter().zip(PROGRAMS) {
        let quote = plain(quote.strip_prefix("ignore\n").unwrap());
        let program = plain(program);
        assert!(
            program.windows(quote.len()).any(|lines| lines == quote),
            "not in the program: {quote:#?}"
        );
    }
}
