//! The guide's programs that drive displays, each with a driver from another project.

use std::fs;
use std::path::Path;

use cookbook::bus::mipi::Command;
use cookbook::bus::tearing::{Ignored, Scan, scanned};
use cookbook::bus::{NoDelay, Wires};
use cookbook::displays::{
    self, epaper, frames, ili9341, ili9488, is_round, needle, oled, round, tearing, window,
};
use cookbook::{DISPLAYS, display};
use embassy_futures::block_on;
use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::raw::{BigEndian, RawData, RawU16};
use embedded_graphics::pixelcolor::{BinaryColor, Rgb565, Rgb888, RgbColor};
use embedded_graphics_simulator::SimulatorDisplay;
use epd_waveshare::epd2in13_v2::Display2in13;
use fixel::canvas::Words;
use fixel::prelude::*;
use mipidsi::models::ST7789;

use super::assert_same;

#[test]
fn pictures_are_those_of_the_documentation() {
    for &(name, show) in DISPLAYS {
        let shown = SimulatorDisplay::<Rgb888>::load_png(display(name)).unwrap();
        assert!(show().unwrap().diff(&shown).is_none(), "{name} has changed");
    }
}

#[test]
fn programs_are_short() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/displays");
    for (name, _) in DISPLAYS {
        let text = fs::read_to_string(folder.join(name).with_extension("rs")).unwrap();
        let lines = text.lines().count();
        assert!(lines <= 72, "{name} has {lines} lines");
    }
}

fn raw(colors: impl Iterator<Item = Rgb565>) -> Vec<u32> {
    colors
        .map(|color| RawU16::from(color).into_inner().into())
        .collect()
}

/// After the window was sent, the panel shows the same picture as if the whole frame had been sent again.
#[test]
fn a_window_is_that_part_of_the_frame() {
    let turns = [deg!(10), deg!(70)];
    let all = (240, 240);
    let ran = displays::run_window(&turns).unwrap();
    let [first, last] = turns.map(|turn| displays::run_window(&[turn]).unwrap());
    assert_same(&ran.panel.picture(all), &last.panel.picture(all), 240);
    assert_ne!(first.panel.picture(all), last.panel.picture(all));
    let size = window::WINDOW.size;
    assert_eq!(
        ran.sent() - first.sent(),
        2 * (size.width * size.height) as usize
    );
}

/// The page has this number.
fn states(what: &str) -> bool {
    // A sentence may be on several lines.
    let page = include_str!("../../../../src/guide/displays.rs").replace("\n//!", "");
    page.contains(what)
}

/// The needle leaves no trace. Only its rectangles are sent, and nothing while it rests.
#[test]
fn a_needle_is_sent_where_it_was_and_is() {
    let turns: Vec<_> = (0..=60).map(|step| Angle::from_degrees(6 * step)).collect();
    let whole = 2 * 240 * 240;
    let mut bytes = 0;
    for pair in turns.windows(2) {
        let [ran, rested] = [pair.to_vec(), vec![pair[0], pair[1], pair[1]]]
            .map(|turns| displays::run_needle(&turns).unwrap());
        let last = displays::run_needle(&pair[1..]).unwrap();
        assert_same(
            &ran.panel.picture((240, 240)),
            &last.panel.picture((240, 240)),
            240,
        );
        assert_eq!(rested.sent(), ran.sent());
        let size = needle::changed(pair[0], pair[1]).unwrap().size;
        assert_eq!(ran.sent() - whole, 2 * (size.width * size.height) as usize);
        bytes += ran.sent() - whole;
    }
    let mean = bytes / 60;
    assert!(
        states(&format!(
            "{},{:03} of the frame's 115,200 bytes",
            mean / 1000,
            mean % 1000
        )),
        "{mean}"
    );
}

/// How often the drivers take the bus for a frame of 240x240 pixels in six bands.
#[test]
fn transactions_of_a_frame() {
    let mut pixels = vec![[0; 2]; 240 * 40];
    let mut bands = |show: &mut dyn FnMut(u16, Canvas<'_, Rgb565, BigEndian>)| {
        for first_row in (0..240).step_by(40) {
            let band = Canvas::band(&mut pixels, 240, 240, first_row.into()).unwrap();
            show(first_row, band);
        }
    };
    let mut rows = vec![];
    for length in [64, 512, 4096] {
        let (wires, mut buffer) = (Wires::default(), vec![0; length]);
        let mut display = displays::driver(ST7789, (240, 240), &wires, &mut buffer);
        let before = wires.transactions();
        bands(&mut |_, band| band.show(&mut display).unwrap());
        let count = wires.transactions() - before;
        rows.push(format!("| mipidsi, {length} bytes | {count} |"));
    }
    let wires = Wires::default();
    let interface = lcd_async::interface::SpiInterface::new(wires.clone(), wires.clone());
    let panel = lcd_async::Builder::new(lcd_async::models::ST7789, interface);
    let mut panel = block_on(panel.display_size(240, 240).init(&mut NoDelay)).unwrap();
    let before = wires.transactions();
    bands(&mut |first_row, band| {
        block_on(panel.show_raw_data(0, first_row, 240, 40, band.as_bytes())).unwrap();
    });
    let count = wires.transactions() - before;
    rows.push(format!("| lcd-async | {count} |"));
    rows.retain(|row| !states(row));
    assert!(rows.is_empty(), "{rows:#?}");
}

/// Inside the circle, the round panel shows the same pixels as a whole frame. At least 15 % of the bytes are not sent.
#[test]
fn a_round_panel_gets_its_circle() {
    let ran = displays::run_round().unwrap();
    let (mut colors, mut depths) = (vec![Rgb565::BLACK; 240 * 240], vec![0; 240 * 240]);
    let frame = Canvas::new(&mut colors, 240, 240).unwrap();
    let mut frame = frame.with_depth(&mut depths).unwrap();
    round::draw(&mut frame, Point::zero()).unwrap();
    let mut missing = 0;
    for ((at, pixel), expected) in (0..).zip(ran.panel.pixels()).zip(raw(frame.pixels())) {
        let (column, row) = (at % 240, at / 240);
        if let Some(pixel) = pixel {
            assert_eq!(*pixel, expected, "({column}, {row})");
        } else {
            assert!(!is_round(column, row), "({column}, {row}) was not sent");
            missing += 1;
        }
    }
    assert_eq!(ran.sent(), 2 * (240 * 240 - missing));
    // A circle leaves 1 - pi/4 of its square free: 21.5 %. Bands of 16 rows save only a part of this.
    assert!((8640..12_384).contains(&missing), "{missing} of 57600");
}

#[test]
fn an_oled_shows_the_frame() {
    let (mut colors, mut depths) = ([BinaryColor::Off; 128 * 64], [0; 128 * 64]);
    let frame = Canvas::new(&mut colors, 128, 64).unwrap();
    let mut frame = frame.with_depth(&mut depths).unwrap();
    oled::draw(&mut frame).unwrap();
    let expected: Vec<_> = frame.pixels().map(BinaryColor::is_on).collect();
    assert!(displays::run_oled().unwrap() == expected);
    assert!(expected.iter().filter(|lit| **lit).count() > 1000);
}

/// After the full refresh and after each quick refresh, the paper shows the picture that was drawn. Quick refreshes
/// drive only a small part of the pixels.
#[test]
fn paper_is_refreshed_where_it_changes() {
    let turns = [0, 10, 30, 55].map(Angle::from_degrees);
    let panel = displays::run_epaper(&turns).unwrap();
    let mut drawn = Display2in13::default();
    epaper::draw(&mut drawn, turns[3]).unwrap();
    for (row, (paper, drawn)) in panel
        .paper
        .iter()
        .zip(drawn.buffer().chunks(16))
        .enumerate()
    {
        // The last six bits of a row are not on the glass.
        assert_eq!(paper[..15], drawn[..15], "row {row}");
        assert_eq!((paper[15] ^ drawn[15]) & 0xc0, 0, "row {row}");
    }
    let are_full: Vec<_> = panel.refreshes.iter().map(|refresh| refresh.0).collect();
    assert_eq!(are_full, [true, false, false, false]);
    for (_, changed) in &panel.refreshes[1..] {
        // Each of the two sails has 110x13 pixels, before and after the turn. The panel has 30,500 pixels.
        assert!((1000..4 * 110 * 13).contains(changed), "{changed}");
    }
}

#[test]
fn eighteen_bits_are_the_upper_ones_of_24() {
    let ran = displays::run_ili9488().unwrap();
    let pixels = (ili9488::WIDTH * ili9488::HEIGHT) as usize;
    let (mut colors, mut depths) = (vec![[0; 3]; pixels], vec![0; pixels]);
    let frame = Canvas::<Rgb888, BigEndian>::new(&mut colors, ili9488::WIDTH, ili9488::HEIGHT);
    let mut frame = frame.unwrap().with_depth(&mut depths).unwrap();
    ili9488::draw(&mut frame).unwrap();
    let six = |color: Rgb888| {
        let [red, green, blue] =
            [color.r(), color.g(), color.b()].map(|level| u32::from(level) / 4);
        (red * 64 + green) * 64 + blue
    };
    let expected: Vec<_> = frame.pixels().map(six).collect();
    let picture = ran.panel.picture((ili9488::WIDTH, ili9488::HEIGHT));
    assert_same(&picture, &expected, ili9488::WIDTH);
}

#[test]
fn words_are_sent_as_they_are() {
    let ran = displays::run_ili9341().unwrap();
    let pixels = (ili9341::WIDTH * ili9341::HEIGHT) as usize;
    let (mut words, mut depths) = (vec![0; pixels], vec![0; pixels]);
    let frame = Canvas::<Rgb565, Words>::new(&mut words, ili9341::WIDTH, ili9341::HEIGHT);
    let mut frame = frame.unwrap().with_depth(&mut depths).unwrap();
    ili9341::draw(&mut frame).unwrap();
    let expected: Vec<_> = frame.as_cells().iter().map(|&word| word.into()).collect();
    let picture = ran.panel.picture((ili9341::WIDTH, ili9341::HEIGHT));
    assert_same(&picture, &expected, ili9341::WIDTH);
}

/// Every frame arrives as it was drawn, although the next frame is drawn while it is sent.
#[test]
fn a_frame_is_not_drawn_into_while_it_is_sent() {
    let turns = [10, 40, 80, 130].map(Angle::from_degrees);
    let ran = displays::run_frames(&turns).unwrap();
    let writes = ran.commands.iter().filter(|command| command.code == 0x2c);
    let sent: Vec<_> = writes.map(|command| &command.data).collect();
    assert_eq!(sent.len(), turns.len());
    for (turn, sent) in turns.into_iter().zip(sent) {
        let mut frame = vec![[0; 2]; frames::PIXELS];
        frames::draw(&mut frame, turn).unwrap();
        assert!(*sent == frame.as_flattened(), "{turn:?}");
    }
}

/// For each scan, returns the frames that its rows come from, from top to bottom; consecutive rows of the same frame
/// count once. The scans are all scans that begin after the first frame has arrived and while other frames are sent.
/// `None` stands for a row that is written while the panel reads it.
fn frames_of_scans(commands: &[Command]) -> Vec<Vec<Option<usize>>> {
    let side = tearing::SIDE as usize;
    let writes = commands.iter().filter(|command| command.code == 0x2c);
    let writes: Vec<_> = writes.collect();
    let end = |write: &Command| write.start + write.data.len() as u64;
    let first = end(writes[0]).div_ceil(Scan::PERIOD);
    let last = end(writes[writes.len() - 1]) / Scan::PERIOD;
    let frames = (first..=last).map(|scan| {
        let seen = scanned(commands, scan, tearing::SIDE);
        let rows = seen.chunks(side).enumerate().map(|(row, seen)| {
            let seen: Vec<_> = seen
                .iter()
                .flat_map(|pixel| pixel.unwrap().to_be_bytes())
                .collect();
            let shows = |write: &&Command| write.data[2 * side * row..][..2 * side] == seen;
            writes.iter().position(shows)
        });
        let mut rows: Vec<_> = rows.collect();
        rows.dedup();
        rows
    });
    frames.collect()
}

/// Whenever the program is ready to draw, no scan shows rows of two frames. Without the panel's signal, some scans show
/// rows of two frames.
#[test]
fn no_frame_is_torn() {
    let ways = [0_i16, 1, 2, 3, 4, 5].map(|step| fx!(0.3) * Scalar::from(step));
    let mut torn = 0;
    for ready in (0..Scan::PERIOD).step_by(9001) {
        let wires = Wires::default();
        wires.wait(ready);
        let ran = displays::run_tearing(&wires, Scan(wires.clone()), &ways).unwrap();
        let scans = frames_of_scans(&ran.commands);
        assert!(scans.len() >= 4, "{scans:?}");
        assert!(
            scans.iter().all(|frames| matches!(frames[..], [Some(_)])),
            "{ready}: {scans:?}"
        );

        let wires = Wires::default();
        wires.wait(ready);
        let ignored = Ignored(wires.clone());
        let ran = displays::run_tearing(&wires, ignored, &ways).unwrap();
        let scans = frames_of_scans(&ran.commands);
        torn += usize::from(scans.iter().any(|frames| frames.len() > 1));
    }
    assert!(torn > 2, "{torn} of 15");
}
