//! Checks what each board shows: the scene's picture, in a frame and in the board's bands, and the bytes that make a
//! display show it.

mod wires;

// A display that follows its data sheet. The cookbook's tests use it, too.
#[allow(dead_code)]
#[path = "../../cookbook/src/bus/mipi.rs"]
mod display;

use std::cell::RefCell;
use std::convert::Infallible;
use std::fmt::Write;

use boards::panel::{Panel, Pins, Word};
use boards::report::Report;
use boards::slow_bus::SlowBus;
use boards::{ball, floor};
use embedded_graphics::pixelcolor::raw::{BigEndian, ToBytes};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_hal::digital::{OutputPin, PinState};
use embedded_hal::spi::SpiBus;
use fixel::canvas::Words;
use fixel::prelude::*;
use flash_model::Module;

use wires::{Pin, Wires};

/// A board's frame, the height of its bands, and the checksum of its scene at one second.
struct Board {
    size: (u32, u32),
    rows: u32,
    crc: u32,
    module: Module,
}

const PICO: Board = Board {
    size: (240, 240),
    rows: 40,
    crc: 0x219f_59d9,
    module: Module::ST7789,
};
const STM32F4: Board = Board {
    size: (320, 240),
    rows: 40,
    crc: 0x31c2_e00e,
    module: Module::ILI9341,
};
const ESP32C3: Board = Board {
    size: (240, 240),
    rows: 60,
    crc: PICO.crc,
    module: Module::ST7789,
};
/// The ball on a Pico.
const BALL: Board = Board {
    size: (320, 240),
    rows: 30,
    crc: 0xdf84_69b2,
    module: Module {
        rotation: 1,
        ..Module::ST7789_TALL
    },
};

/// The bytes of a frame, drawn in bands of `$rows` rows.
macro_rules! draw {
    ($scene:ident, $O:ty, $cell:expr, $size:expr, $rows:expr, $now_ms:expr) => {{
        let (width, height) = $size;
        let scene = $scene::Scene::new(width, height).unwrap();
        let mut memory = $scene::Memory::new();
        let moment = scene.at($now_ms, &mut memory).unwrap();
        let mut pixels = vec![$cell; (width * $rows) as usize];
        let mut bytes: Vec<u8> = vec![];
        for first_row in (0..height).step_by($rows as usize) {
            let mut band =
                Canvas::<Rgb565, $O>::band(&mut pixels, width, height, first_row).unwrap();
            moment.draw(&mut band);
            bytes.extend(band.pixels().flat_map(|pixel| pixel.to_be_bytes()));
        }
        bytes
    }};
}

/// The whole frame in words.
fn frame(size: (u32, u32), now_ms: u64) -> Vec<u8> {
    draw!(floor, Words, 0, size, size.1, now_ms)
}

#[test]
fn bands_equal_the_frame() {
    for now_ms in [0, 1000, 7777] {
        for Board { size, rows, .. } in [PICO, STM32F4, ESP32C3] {
            let whole = frame(size, now_ms);
            assert!(
                whole == draw!(floor, Words, 0, size, rows, now_ms),
                "{size:?} at {now_ms}"
            );
            let bytes = draw!(floor, BigEndian, [0; 2], size, rows, now_ms);
            assert!(whole == bytes, "{size:?} at {now_ms}");
        }
        let Board { size, rows, .. } = BALL;
        let [whole, bands] = [size.1, rows].map(|rows| draw!(ball, Words, 0, size, rows, now_ms));
        assert!(whole == bands, "the ball at {now_ms}");
    }
}

/// A board draws these bits: you can compare the checksum with one that your firmware logs.
#[test]
fn checksums_of_the_boards_pictures() {
    for board in [PICO, STM32F4, ESP32C3] {
        let crc = crc32fast::hash(&frame(board.size, 1000));
        assert_eq!(crc, board.crc, "{crc:#x} at {:?}", board.size);
    }
    let crc = crc32fast::hash(&draw!(ball, Words, 0, BALL.size, BALL.size.1, 1000));
    assert_eq!(crc, BALL.crc, "{crc:#x}");
}

/// The list has room for the visible triangles at all times.
#[test]
fn the_ball_fits_into_its_memory() {
    let scene = ball::Scene::new(320, 240).unwrap();
    let mut memory = ball::Memory::new();
    for now_ms in (0..60_000).step_by(50) {
        let moment = scene.at(now_ms, &mut memory);
        assert!(moment.is_ok(), "at {now_ms} ms: {:?}", moment.err());
    }
}

fn pins(wires: &Wires) -> Pins<Pin, Pin, Pin> {
    Pins {
        cs: Some(wires.select()),
        dc: wires.data(),
        reset: Some(wires.reset()),
    }
}

/// The words of 16 bits that have these bytes, the more significant one first.
fn pairs(bytes: &[u8]) -> Vec<u16> {
    let (pairs, _) = bytes.as_chunks();
    pairs.iter().map(|&pair| u16::from_be_bytes(pair)).collect()
}

/// Clears the display and sends two frames as a board does, in bytes or in words, and checks that the display shows the
/// second one.
fn show<W: Word>(
    board: &Board,
    mut bus: Wires,
    mut panel: Panel<Pin, Pin, Pin>,
    words: fn(&[u8]) -> Vec<W>,
) where
    Wires: SpiBus<W, Error = Infallible>,
{
    let (columns, rows) = (board.module.memory[0] as u16, board.module.memory[1] as u16);
    let mut display = display::Panel::new(columns, rows);
    if board.module.blue_first == 1 {
        display = display.with_blue_first();
    }
    panel.clear(&mut bus, &words(&[0; 1000])).unwrap();
    for now_ms in [0, 1000] {
        panel.start_frame(&mut bus).unwrap();
        bus.write(&words(&frame(board.size, now_ms))).unwrap();
    }
    display.read(&bus.commands());
    // All of the memory was cleared.
    let stride = board.module.memory_size().0;
    let (left, top) = board.module.origin();
    let pixels = (0..).zip(display.pixels());
    let shown: Vec<u8> = pixels
        .map(|(at, pixel)| (at % stride, at / stride, pixel.expect("never written")))
        .filter(|(x, y, pixel)| {
            let (x, y) = (x.wrapping_sub(left), y.wrapping_sub(top));
            let is_seen = x < board.size.0 && y < board.size.1;
            assert!(is_seen || *pixel == 0, "not black beside the picture");
            is_seen
        })
        .flat_map(|(.., pixel)| (pixel as u16).to_be_bytes())
        .collect();
    assert!(
        shown == frame(board.size, 1000),
        "the display shows another picture"
    );
}

#[test]
fn an_st7789_shows_the_bands() {
    let panel = |board: &Board, wires: &Wires| {
        let mut bus = wires.clone();
        Panel::new(&board.module, &mut bus, pins(wires), &mut wires.clone()).unwrap()
    };
    let wires = Wires::default();
    show(
        &ESP32C3,
        wires.clone(),
        panel(&ESP32C3, &wires),
        <[u8]>::to_vec,
    );
    for board in [PICO, BALL] {
        let wires = Wires::default();
        show(&board, wires.clone(), panel(&board, &wires), pairs);
    }
}

#[test]
fn an_ili9341_shows_the_bands() {
    let wires = Wires::default();
    let mut bus = wires.clone();
    let panel = Panel::new(&Module::ILI9341, &mut bus, pins(&wires), &mut wires.clone()).unwrap();
    show(&STM32F4, bus, panel, pairs);
}

/// The log has one line for each command with its data. Other events are in words.
#[test]
fn an_st7789_receives_these_bytes() {
    let wires = Wires::default();
    let mut bus = wires.clone();
    let mut panel =
        Panel::new(&Module::ST7789, &mut bus, pins(&wires), &mut wires.clone()).unwrap();
    panel.start_frame::<u8>(&mut bus).unwrap();
    SpiBus::<u8>::write(&mut bus, &[0x12, 0x34, 0x56, 0x78]).unwrap();
    panel.start_frame::<u16>(&mut bus).unwrap();
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
    let mut panel =
        Panel::new(&Module::ILI9341, &mut bus, pins(&wires), &mut wires.clone()).unwrap();
    panel.start_frame::<u8>(&mut bus).unwrap();
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

/// The levels of a clock and of a data line, and the bits at each rising edge of the clock.
#[derive(Default)]
struct Lines {
    clock: bool,
    data: bool,
    bits: Vec<bool>,
}

struct Line<'a>(&'a RefCell<Lines>, bool);

impl embedded_hal::digital::ErrorType for Line<'_> {
    type Error = Infallible;
}

impl OutputPin for Line<'_> {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.set_state(PinState::Low)
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.set_state(PinState::High)
    }

    fn set_state(&mut self, state: PinState) -> Result<(), Infallible> {
        let lines = &mut *self.0.borrow_mut();
        let is_high = state == PinState::High;
        if !self.1 {
            lines.data = is_high;
        } else if lines.clock != is_high {
            lines.clock = is_high;
            if is_high {
                lines.bits.push(lines.data);
            }
        }
        Ok(())
    }
}

/// In both modes, each bit comes with one rising edge, and the clock rests at the mode's level.
#[test]
fn a_slow_bus_sends_each_bit_once() {
    for rests_high in [false, true] {
        let lines = RefCell::default();
        let mut bus = SlowBus {
            clock: Line(&lines, true),
            data: Line(&lines, false),
            rests_high,
        };
        bus.rest();
        lines.borrow_mut().bits.clear();
        for bytes in [&[0x2c, 0xff][..], &[0x00], &[0xa5]] {
            bus.write(bytes).unwrap();
            let bits = bytes
                .iter()
                .flat_map(|byte| (0..8).rev().map(move |bit| byte >> bit & 1 == 1));
            assert_eq!(lines.borrow().bits, bits.collect::<Vec<_>>());
            assert_eq!(lines.borrow().clock, rests_high);
            lines.borrow_mut().bits.clear();
        }
    }
}

/// The guide quotes lines of these programs: the programs must contain them.
#[test]
fn the_guide_quotes_the_programs() {
    const GUIDE: &str = include_str!("../../../src/guide/firmware.md");
    const EMBASSY: &str = include_str!("../src/bin/pico_embassy.rs");
    const RTIC: &str = include_str!("../src/bin/pico_rtic.rs");
    const ESP32C3: &str = include_str!("../esp32c3/src/main.rs");
    const SECTIONS: [(&str, &[&str]); 2] = [
        ("Embassy and RTIC", &[EMBASSY, RTIC, RTIC]),
        ("Four boards", &[ESP32C3]),
    ];
    let plain =
        |text: &str| -> Vec<String> { text.lines().map(|line| line.trim().to_string()).collect() };
    for (title, programs) in SECTIONS {
        let section = GUIDE.split(&format!("\n# {title}\n")).nth(1).unwrap();
        let section = section.split("\n# ").next().unwrap();
        let quotes: Vec<_> = section.split("```").skip(1).step_by(2).collect();
        assert_eq!(quotes.len(), programs.len(), "{title}");
        for (quote, program) in quotes.iter().zip(programs) {
            let quote = plain(quote.strip_prefix("ignore\n").unwrap());
            let program = plain(program);
            assert!(
                program.windows(quote.len()).any(|lines| lines == quote),
                "not in the program: {quote:#?}"
            );
        }
    }
}

/// The text of a report on a frame: the pixels that are not black.
fn ink(size: (u32, u32), text: &str) -> Vec<(u32, u32)> {
    let mut report = Report::new(size);
    report.write_str(text).unwrap();
    let mut pixels = vec![Rgb565::BLACK; (size.0 * size.1) as usize];
    report.draw(&mut Canvas::new(&mut pixels, size.0, size.1).unwrap());
    let places = (0..size.1).flat_map(|y| (0..size.0).map(move |x| (x, y)));
    let inked = places
        .zip(pixels)
        .filter(|(_, pixel)| *pixel != Rgb565::BLACK);
    inked.map(|(place, _)| place).collect()
}

#[test]
fn a_report_fits_on_every_display() {
    for (name, _, module) in Module::ALL {
        let (width, height) = module.size();
        let long = ink((width, height), &"H".repeat(1000));
        assert!(long.iter().any(|&(_, y)| y > height / 2), "{name}");
        // Both margins stay empty.
        let (left, right) = (width / 20, width - width / 20);
        assert!(
            long.iter().all(|(x, _)| (left..right).contains(x)),
            "{name}"
        );
        // A full line breaks at the right margin.
        let columns = ((right - left) / 6) as usize;
        let [one, two] = ["", "\n"].map(|end| {
            let first = "H".repeat(columns);
            ink((width, height), &format!("{first}{end}HHH"))
        });
        assert_eq!(one, two, "{name}");
        let rows = |ink: &[(u32, u32)]| ink.iter().map(|&(_, y)| y).max();
        let full = ink((width, height), &"H".repeat(columns));
        assert!(rows(&full) < rows(&one), "{name}");
    }
}

/// The linker keeps `pico_model` out of the flash that belongs to the model.
#[test]
fn a_model_begins_where_its_program_must_end() {
    const BUILD: &str = include_str!("../build.rs");
    let model = format!("--defsym=_model={:#x}\"", flash_model::ADDRESS);
    assert!(BUILD.contains(&model), "{model}");
}

#[cfg(feature = "model")]
mod model {
    use super::*;
    use boards::model::Scene;
    use embedded_graphics::pixelcolor::raw::RawU16;
    use fixel_assets::Disk;
    use flash_model::{Board, Model, rate, write};
    use std::collections::HashMap;
    use std::fs;

    /// The cabin for a panel of 320x240 pixels.
    fn cabin() -> Vec<u32> {
        cabin_for(Module::ILI9341)
    }

    fn cabin_for(module: Module) -> Vec<u32> {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/cabin.obj");
        write(path, &Disk, None, Board::Pico, module, &mut Vec::new()).unwrap()
    }

    /// The frame at a time, in bands.
    fn bands(words: &[u32], rows: u32, now_ms: u64) -> Vec<Rgb565> {
        let scene = Scene::new(words).unwrap();
        let (width, height) = scene.size();
        let mut pixels = vec![0; (width * rows) as usize];
        let mut depths = vec![0; pixels.len()];
        let mut frame = Vec::new();
        for first_row in (0..height).step_by(rows as usize) {
            let canvas =
                Canvas::<Rgb565, Words>::band(&mut pixels, width, height, first_row).unwrap();
            scene.draw(now_ms, &mut canvas.with_depth(&mut depths).unwrap());
            let colors = pixels.iter().map(|&word| Rgb565::from(RawU16::new(word)));
            frame.extend(colors);
        }
        frame
    }

    /// The words of an OBJ with its materials, for a panel of 240x240 pixels.
    fn written(obj: &str, mtl: &str, name: &str) -> Vec<u32> {
        let folder = std::env::temp_dir().join(format!("boards-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("a.mtl"), mtl).unwrap();
        // Two texels: red, and a hole.
        let tga = [
            0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 32, 8, 0, 0, 255, 255, 0, 0, 0, 0,
        ];
        fs::write(folder.join("a.tga"), tga).unwrap();
        let path = folder.join("a.obj");
        fs::write(&path, format!("mtllib a.mtl\n{obj}")).unwrap();
        let (module, mut notes) = (Module::ST7789, Vec::new());
        let words = write(
            path.to_str().unwrap(),
            &Disk,
            None,
            Board::Pico,
            module,
            &mut notes,
        );
        fs::remove_dir_all(&folder).unwrap();
        assert_eq!(notes, [""; 0]);
        words.unwrap()
    }

    /// How often each color but the sky's is in the frame at a time.
    fn colors(words: &[u32], now_ms: u64) -> HashMap<Rgb565, usize> {
        let frame = bands(words, 40, now_ms);
        let mut counts = HashMap::new();
        for color in frame.iter().filter(|&&color| color != frame[0]) {
            *counts.entry(*color).or_default() += 1;
        }
        counts
    }

    /// A sail that turns, upright, with its front and its back to the sun by turns.
    const SAIL: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3 4/4\n";

    #[test]
    fn a_sail_is_seen_and_lit_from_both_sides() {
        let words = written(SAIL, "newmtl a\nKd 1 0 0\n", "sail");
        // Half a turn later, the back is where the front was, and the sun shines on it alike.
        for now_ms in [0, 400, 9000] {
            let [front, back] = [now_ms, now_ms + 5000].map(|now_ms| colors(&words, now_ms));
            assert!(front.values().sum::<usize>() > 10_000, "{front:?}");
            let brightest = |counts: &HashMap<Rgb565, usize>| counts.keys().map(|it| it.r()).max();
            let [front_red, back_red] = [&front, &back].map(brightest);
            // One step for the directions of light, which are rounded each for itself.
            let (front_red, back_red) = (front_red.unwrap(), back_red.unwrap());
            assert!(front_red.abs_diff(back_red) <= 1, "{front_red} {back_red}");
            let [front, back] = [front, back].map(|counts| counts.values().sum::<usize>());
            // Half a turn exchanges the left and the right border: a column of at most 240 pixels each.
            assert!(front.abs_diff(back) <= 480, "{front} {back}");
        }
    }

    /// A deep jug, open at its top: from above, one sees the backs of its upper rows of faces.
    fn jug() -> String {
        let (mut jug, slices, rows) = (String::new(), 24, 16);
        for row in 0..=rows {
            for slice in 0..slices {
                let angle = f64::from(slice) / f64::from(slices) * std::f64::consts::TAU;
                let (x, z, y) = (angle.sin(), angle.cos(), 2.0 - f64::from(row) * 0.25);
                writeln!(jug, "v {x} {y} {z}").unwrap();
            }
        }
        for row in 0..rows {
            for slice in 0..slices {
                let at = |row: i32, slice: i32| 1 + row * slices + slice % slices;
                let [a, b] = [at(row, slice), at(row, slice + 1)];
                let [c, d] = [at(row + 1, slice), at(row + 1, slice + 1)];
                writeln!(jug, "f {a} {c} {d} {b}").unwrap();
            }
        }
        jug
    }

    /// Between the times at which the writer looks, too.
    #[test]
    fn backs_are_left_out_only_where_nobody_sees_them() {
        let words = written(&jug(), "", "jug");
        let model = Model::read(&words).unwrap();
        let sides: Vec<_> = model
            .parts()
            .map(|part| (part.is_two_sided, part.faces.len()))
            .collect();
        let seen: usize = sides
            .iter()
            .filter(|(both, _)| *both)
            .map(|(_, count)| count)
            .sum();
        let all = model.mesh().faces().len();
        assert!(0 < seen && seen < all / 2, "{seen} of {all}");

        let (size, mut missing) = ((240, 240), 0);
        for now_ms in (0..10_000).step_by(77) {
            let mut pixels = vec![Rgb565::BLACK; 240 * 240];
            let mut canvas = Canvas::new(&mut pixels, 240, 240).unwrap();
            let mvp = flash_model::view(size).unwrap() * flash_model::turn(now_ms);
            let options = DrawOptions::new().with_cull(fixel::Cull::Nothing);
            let options = options.with_mode(fixel::mode::Fast::within(fx!(0.25)));
            canvas.draw_with(&options, &model.mesh(), &mvp, &Flat::new(Rgb565::WHITE));
            let frame = bands(&words, 240, now_ms);
            let pairs = pixels.iter().zip(&frame);
            missing += pairs
                .filter(|(all, shown)| **all == Rgb565::WHITE && **shown == frame[0])
                .count();
        }
        assert_eq!(missing, 0);
    }

    #[test]
    fn holes_show_what_is_behind() {
        let all = written(SAIL, "newmtl a\nKd 1 0 0\n", "all");
        let half = written(SAIL, "newmtl a\nmap_Kd a.tga\n", "half");
        for now_ms in [0, 5000] {
            let [all, half] = [&all, &half].map(|words| colors(words, now_ms));
            assert!(
                half.keys()
                    .all(|it| it.r() > 0 && it.g() == 0 && it.b() == 0),
                "{half:?}"
            );
            let [all, half] = [all, half].map(|counts| counts.values().sum::<usize>());
            // The border of the hole is a quarter of a texel off at most, which is an eighth of the sail.
            assert!((2 * half).abs_diff(all) <= all / 4, "{half} {all}");
        }
    }

    #[test]
    fn emission_is_added_to_the_light() {
        let words = written(SAIL, "newmtl a\nKd 0 0 0\nKe 0 1 0\n", "glow");
        for now_ms in [0, 5000] {
            let colors = colors(&words, now_ms);
            assert!(colors.keys().eq([&Rgb565::GREEN]), "{colors:?}");
        }
    }

    /// The estimate is within a quarter of the figures of the emulated Pico, which `.ci/boards` checks.
    #[test]
    fn the_frame_rate_is_estimated() {
        const FIGURES: &str = include_str!("../../../.ci/boards");
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets");
        for (name, file) in [("cabin", "cabin.obj"), ("globe", "globe.ply")] {
            let start = FIGURES.split(&format!("(\"{name}\", \"st7789\", ")).nth(1);
            let cycles = start.unwrap().split(',').next().unwrap();
            let wanted = 125e6 / cycles.parse::<f64>().unwrap();
            let (path, module) = (format!("{folder}/{file}"), Module::ST7789);
            let words = write(&path, &Disk, None, Board::Pico, module, &mut Vec::new());
            let words = words.unwrap();
            let model = Model::read(&words).unwrap();
            let [pico, pico2] =
                [Board::Pico, Board::Pico2].map(|board| rate(&model, board).unwrap());
            assert!(
                (pico / wanted - 1.0).abs() < 0.25,
                "{name}: {pico} {wanted}"
            );
            // A Pico 2 is faster, unless its bus limits it: at a quarter of 150 MHz, 16 bits a pixel.
            let bus = 150e6 / 4.0 / f64::from(16 * 240 * 240);
            assert!(pico2 > (1.25 * pico).min(0.99 * bus), "{pico2}");
        }
    }

    #[test]
    fn bands_of_a_model_equal_its_frame() {
        let words = cabin();
        for now_ms in [0, 1000, 7777] {
            let whole = bands(&words, 240, now_ms);
            assert!(whole == bands(&words, 120, now_ms), "at {now_ms}");
            // It turns: the same picture comes only after ten seconds.
            assert!(whole != bands(&words, 240, now_ms + 5000), "at {now_ms}");
            assert!(whole == bands(&words, 240, now_ms + 10_000), "at {now_ms}");
        }
    }

    #[test]
    fn a_model_is_in_the_middle_of_its_panel_at_all_times() {
        let narrow = Module::parse("st7789-135x240").unwrap();
        for module in [Module::ILI9341, narrow] {
            let (words, (width, height)) = (cabin_for(module), module.size());
            for now_ms in (0..10_000).step_by(500) {
                let frame = bands(&words, height, now_ms);
                let sky = frame[0];
                let is_drawn = |x: u32, y: u32| frame[(width * y + x) as usize] != sky;
                assert!(is_drawn(width / 2, height / 2), "at {now_ms}");
                // It keeps within the ball, which is seen as a disk in the middle square.
                for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
                    let from_middle = |at: u32, size: u32| (2 * at + 1).abs_diff(size).pow(2);
                    let distance = from_middle(x, width) + from_middle(y, height);
                    // A pixel's middle lies within half a pixel.
                    let is_outside = distance > (width.min(height) + 1).pow(2);
                    assert!(!(is_outside && is_drawn(x, y)), "({x}, {y}) at {now_ms}");
                }
            }
        }
    }

    /// A pixel of 16 bits becomes three bytes, in which each level of five bits is repeated.
    #[test]
    fn pixels_become_wide() {
        let mut words = [0xf800, 0x07e0, 0x001f, 0x8410, 0x1234, 0xffff, 0, 0, 0];
        let before = words;
        boards::panel::widen(&mut words);
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_be_bytes()).collect();
        for (pixel, bytes) in before.iter().zip(bytes.as_chunks::<3>().0) {
            let [red, green, blue] = bytes.map(|byte| u16::from(byte >> 2));
            assert_eq!((red >> 1) << 11 | green << 5 | blue >> 1, *pixel);
            assert!([red, blue].iter().all(|level| level & 1 == level >> 5));
            assert!(bytes.iter().all(|byte| byte & 3 == 0));
        }
    }

    #[test]
    fn a_damaged_model_is_a_message_on_the_same_panel() {
        let mut words = cabin();
        words[100] ^= 1;
        let frame = bands(&words, 120, 0);
        assert!(!Scene::new(&words).unwrap().has_model());
        assert_eq!(frame.len(), 320 * 240);
        let count = |color| frame.iter().filter(|&&pixel| pixel == color).count();
        let (text, background) = (count(Rgb565::WHITE), count(Rgb565::BLACK));
        assert!(
            text > 300 && text + background == frame.len(),
            "{text} {background}"
        );
        // Another message, and the usual panel.
        let missing = bands(&[u32::MAX; 100], 120, 0);
        assert_eq!(missing.len(), 240 * 240);
        assert!(missing.contains(&Rgb565::WHITE));
    }
}
