//! Programs that drive displays, each with a driver from another project, and the pictures that their panels show.
//!
//! The library's guide shows the programs. Here, their buses are wires that record, and their panels are models.

// The functions are parts of programs. The guide explains them.
#![allow(missing_docs, clippy::missing_errors_doc, clippy::missing_panics_doc)]

pub mod epaper;
pub mod frames;
pub mod ili9341;
pub mod ili9488;
pub mod needle;
pub mod oled;
pub mod round;
pub mod tearing;
pub mod window;

use std::fmt::Debug;

use display_interface_spi::SPIInterface;
use embassy_futures::block_on;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::{PointsIter, PrimitiveStyle, Rectangle, StyledDrawable};
use embedded_graphics_simulator::SimulatorDisplay;
use embedded_hal::digital::InputPin;
use epd_waveshare::epd2in13_v2;
use fixel::prelude::*;
use mipidsi::interface::SpiInterface;
use mipidsi::models::{GC9A01, Model, ST7789};
use mipidsi::{Builder, Display, NoResetPin};

use crate::bus::mipi::{self, Command};
use crate::bus::tearing::{Ignored, Scan, scanned};
use crate::bus::{NoDelay, Unconnected, Wires, commands, ssd1306, ssd1680};

/// A picture of the panels.
pub type Picture = SimulatorDisplay<Rgb888>;

/// Runs a program, and returns a picture of its panel.
pub type Show = fn() -> Result<Picture, Error>;

/// The programs by name.
pub const DISPLAYS: &[(&str, Show)] = &[
    ("epaper", epaper_picture),
    ("frames", frames_picture),
    ("ili9341", ili9341_picture),
    ("ili9488", ili9488_picture),
    ("needle", needle_picture),
    ("oled", oled_picture),
    ("round", round_picture),
    ("tearing", tearing_picture),
    ("window", window_picture),
];

/// A picture of a dark table with room for panels side by side.
fn table(panels: u32, size: Size) -> Picture {
    let width = panels * (size.width + GAP) + GAP;
    SimulatorDisplay::with_default_color(
        Size::new(width, size.height + 2 * GAP),
        Rgb888::new(40, 42, 46),
    )
}

/// The distance between panels, in pixels.
const GAP: u32 = 8;

/// The place of a panel's upper left corner.
fn corner(panel: u32, width: u32) -> Point {
    let [x, y] = [panel * (width + GAP) + GAP, GAP].map(u32::cast_signed);
    Point::new(x, y)
}

/// Draws a panel on the table. `panel` is the panel's number from the left. Where a pixel has no color, the table stays
/// visible.
fn lay(
    picture: &mut Picture,
    panel: u32,
    size: Size,
    side: u32,
    pixels: impl IntoIterator<Item = Option<Rgb888>>,
) {
    let corner = corner(panel, size.width * side);
    let points = Rectangle::new(Point::zero(), size);
    for (at, color) in points.points().zip(pixels) {
        if let Some(color) = color {
            let at = corner + at * side.cast_signed();
            let square = Rectangle::new(at, Size::new_equal(side));
            let Ok(()) = picture.fill_solid(&square, color);
        }
    }
}

/// A picture of one panel.
fn one(size: Size, side: u32, pixels: impl IntoIterator<Item = Option<Rgb888>>) -> Picture {
    let mut picture = table(1, size * side);
    lay(&mut picture, 0, size, side, pixels);
    picture
}

/// A driver with wires for its bus and its D/C line.
pub type Driver<'b, M> = Display<SpiInterface<'b, Wires, Wires>, M, NoResetPin>;

/// Makes the driver of a panel at the end of these wires.
pub fn driver<'b, M: Model<ColorFormat = Rgb565>>(
    model: M,
    (width, height): (u16, u16),
    wires: &Wires,
    buffer: &'b mut [u8],
) -> Driver<'b, M> {
    let interface = SpiInterface::new(wires.clone(), wires.clone(), buffer);
    let builder = Builder::new(model, interface).display_size(width, height);
    builder
        .init(&mut NoDelay)
        .expect("a size that the driver knows")
}

/// A panel after a program has run, and the commands that it received.
pub struct Ran {
    pub panel: mipi::Panel,
    pub commands: Vec<Command>,
}

impl Ran {
    fn new(mut panel: mipi::Panel, wires: &Wires) -> Self {
        let commands = commands(wires.take());
        panel.read(&commands);
        Self { panel, commands }
    }

    fn colors(&self) -> impl Iterator<Item = Option<Rgb888>> {
        let pixels = self.panel.pixels().iter();
        pixels.map(|pixel| pixel.map(|raw| self.panel.color(raw)))
    }

    /// Returns the number of bytes of pixel data that were sent.
    #[must_use]
    pub fn sent(&self) -> usize {
        let writes = self.commands.iter().filter(|command| command.code == 0x2c);
        writes.map(|command| command.data.len()).sum()
    }
}

/// Runs [`window`].
pub fn run_window(turns: &[Angle]) -> Result<Ran, Error> {
    let (wires, mut buffer) = (Wires::default(), [0; 512]);
    window::run(&mut driver(ST7789, (240, 240), &wires, &mut buffer), turns)?;
    Ok(Ran::new(mipi::Panel::new(240, 320), &wires))
}

fn window_picture() -> Result<Picture, Error> {
    let turns = [deg!(10), deg!(70)];
    let mut picture = table(2, window::FRAME);
    for panel in [0, 1] {
        let ran = run_window(&turns[..=panel as usize])?;
        lay(&mut picture, panel, window::FRAME, 1, ran.colors());
    }
    // The part of the frame that was sent again.
    let mut sent = window::WINDOW;
    sent.top_left += corner(1, window::FRAME.width);
    let line = PrimitiveStyle::with_stroke(Rgb888::YELLOW, 1);
    let Ok(()) = sent.offset(1).draw_styled(&line, &mut picture);
    Ok(picture)
}

/// Runs [`needle`].
pub fn run_needle(turns: &[Angle]) -> Result<Ran, Error> {
    let (wires, mut buffer) = (Wires::default(), [0; 512]);
    let mut display = driver(ST7789, (240, 240), &wires, &mut buffer);
    needle::run(&mut display, turns, || ())?;
    Ok(Ran::new(mipi::Panel::new(240, 320), &wires))
}

fn needle_picture() -> Result<Picture, Error> {
    let (turns, size) = ([deg!(40), deg!(15)], needle::FRAME.size);
    let mut picture = table(2, size);
    for panel in [0, 1] {
        let ran = run_needle(&turns[..=panel as usize])?;
        lay(&mut picture, panel, size, 1, ran.colors());
    }
    let mut sent = needle::changed(turns[0], turns[1])?;
    sent.top_left += corner(1, size.width);
    let line = PrimitiveStyle::with_stroke(Rgb888::YELLOW, 1);
    let Ok(()) = sent.offset(1).draw_styled(&line, &mut picture);
    Ok(picture)
}

/// Runs [`round`].
pub fn run_round() -> Result<Ran, Error> {
    let (wires, mut buffer) = (Wires::default(), [0; 512]);
    round::run(&mut driver(GC9A01, (240, 240), &wires, &mut buffer))?;
    Ok(Ran::new(mipi::Panel::new(240, 240), &wires))
}

/// Whether a pixel of the round panel is on the glass, that is, whether its center is in the circle.
#[must_use]
pub fn is_round(column: u32, row: u32) -> bool {
    let [x, y] = [column, row].map(|at| (2 * at + 1).abs_diff(round::SIDE));
    x * x + y * y <= round::SIDE * round::SIDE
}

fn round_picture() -> Result<Picture, Error> {
    let (ran, size) = (run_round()?, Size::new_equal(round::SIDE));
    let mut picture = table(2, size);
    let glass = |at: u32| is_round(at % round::SIDE, at / round::SIDE);
    let shown = (0..).zip(ran.colors());
    let shown = shown.map(|(at, color)| color.filter(|_| glass(at)));
    lay(&mut picture, 0, size, 1, shown);
    lay(&mut picture, 1, size, 1, ran.colors());
    Ok(picture)
}

/// Runs [`oled`].
pub fn run_oled() -> Result<Vec<bool>, Error> {
    let wires = Wires::default();
    oled::run(SPIInterface::new(wires.clone(), wires.clone()))?;
    let mut panel = ssd1306::Panel::default();
    panel.read(&wires.take());
    Ok(panel.picture())
}

fn oled_picture() -> Result<Picture, Error> {
    let color = |is_lit| {
        Some(if is_lit {
            Rgb888::new(160, 235, 255)
        } else {
            Rgb888::BLACK
        })
    };
    Ok(one(
        Size::new(128, 64),
        3,
        run_oled()?.into_iter().map(color),
    ))
}

/// Runs [`epaper`].
pub fn run_epaper(turns: &[Angle]) -> Result<ssd1680::Panel, Error> {
    let wires = Wires::default();
    let pins = (Unconnected, wires.clone(), Unconnected);
    epaper::run(wires.clone(), pins, NoDelay, turns)?;
    let mut panel = ssd1680::Panel::default();
    panel.read(&commands(wires.take()));
    Ok(panel)
}

fn epaper_picture() -> Result<Picture, Error> {
    let turns = [deg!(20), deg!(50)];
    let size = Size::new(epd2in13_v2::WIDTH, epd2in13_v2::HEIGHT);
    let mut picture = table(3, size);
    let papers = [run_epaper(&turns[..1])?.paper, run_epaper(&turns)?.paper];
    let is_white = |paper: usize, at: u32| {
        let (column, row) = (at % size.width, at / size.width);
        papers[paper][row as usize][column as usize / 8] << (column % 8) & 0x80 != 0
    };
    let pixels = 0..size.width * size.height;
    for paper in [0, 1] {
        let color = |at| {
            if is_white(paper, at) {
                Rgb888::WHITE
            } else {
                Rgb888::BLACK
            }
        };
        lay(
            &mut picture,
            paper as u32,
            size,
            1,
            pixels.clone().map(color).map(Some),
        );
    }
    // The colors show which pixels the quick refresh drove. The other pixels are pale.
    let color = |at| match (is_white(0, at), is_white(1, at)) {
        (true, false) => Rgb888::new(200, 60, 40),
        (false, true) => Rgb888::new(60, 120, 220),
        (true, true) => Rgb888::WHITE,
        (false, false) => Rgb888::new(190, 190, 190),
    };
    lay(&mut picture, 2, size, 1, pixels.map(color).map(Some));
    Ok(picture)
}

/// Runs [`ili9488`].
pub fn run_ili9488() -> Result<Ran, Error> {
    let wires = Wires::default();
    ili9488::run(wires.clone(), wires.clone(), NoDelay)?;
    Ok(Ran::new(mipi::Panel::new(320, 480), &wires))
}

fn ili9488_picture() -> Result<Picture, Error> {
    let size = Size::new(ili9488::WIDTH, ili9488::HEIGHT);
    Ok(one(size, 1, run_ili9488()?.colors()))
}

/// Runs [`ili9341`].
pub fn run_ili9341() -> Result<Ran, Error> {
    let wires = Wires::default();
    let interface = SPIInterface::new(wires.clone(), wires.clone());
    ili9341::run(interface, Unconnected, NoDelay)?;
    // On most modules with this controller, the glass has blue where the controller has red. The `ili9341` driver
    // assumes such a module.
    Ok(Ran::new(
        mipi::Panel::new(240, 320).with_blue_first(),
        &wires,
    ))
}

fn ili9341_picture() -> Result<Picture, Error> {
    let size = Size::new(ili9341::WIDTH, ili9341::HEIGHT);
    Ok(one(size, 1, run_ili9341()?.colors()))
}

/// Runs [`frames`].
pub fn run_frames(turns: &[Angle]) -> Result<Ran, Error> {
    let wires = Wires::default();
    let [mut first, mut second] = [(); 2].map(|()| vec![[0; 2]; frames::PIXELS]);
    let device = (wires.clone(), wires.clone(), NoDelay);
    block_on(frames::run(device, [&mut first, &mut second], turns))?;
    Ok(Ran::new(mipi::Panel::new(240, 320), &wires))
}

fn frames_picture() -> Result<Picture, Error> {
    let ran = run_frames(&[deg!(20), deg!(50)])?;
    Ok(one(Size::new(240, 240), 1, ran.colors()))
}

/// Runs [`tearing`] on these wires, with this TE output.
pub fn run_tearing(
    wires: &Wires,
    te: impl InputPin<Error: Debug>,
    ways: &[Scalar],
) -> Result<Ran, Error> {
    tearing::run(wires.clone(), wires.clone(), te, NoDelay, ways)?;
    Ok(Ran::new(mipi::Panel::new(240, 320), wires))
}

fn tearing_picture() -> Result<Picture, Error> {
    let (size, ways) = (Size::new_equal(tearing::SIDE), [fx!(0), fx!(0.5), fx!(1)]);
    let mut picture = table(2, size);
    let (free, bound) = (Wires::default(), Wires::default());
    let free = run_tearing(&free, Ignored(free.clone()), &ways)?;
    let bound = run_tearing(&bound, Scan(bound.clone()), &ways)?;
    for (place, ran) in [(0, free), (1, bound)] {
        // The picture that a person sees while the last frame is sent, or just after it was sent.
        let mut writes = ran.commands.iter().filter(|command| command.code == 0x2c);
        let scan = writes.next_back().map_or(0, |write| write.start) / Scan::PERIOD + 1;
        let seen = scanned(&ran.commands, scan, tearing::SIDE);
        let colors = seen
            .into_iter()
            .map(|raw| raw.map(|raw| ran.panel.color(raw.into())));
        lay(&mut picture, place, size, 1, colors);
    }
    Ok(picture)
}
