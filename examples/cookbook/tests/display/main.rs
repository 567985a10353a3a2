//! The picture on a real panel. A display driver from another project writes the canvas to recorded wires. A model of
//! the controller, made from its data sheet, reads the record. The model's picture must equal the canvas.

mod recipes;

#[path = "../../../common/mod.rs"]
mod common;

use std::collections::BTreeSet;

use cookbook::bus::mipi::{Command, Panel};
use cookbook::bus::{Wires, commands};
use cookbook::displays::{Driver, driver};
use embedded_graphics::pixelcolor::raw::{BigEndian, RawData, RawU16};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_hal::spi::SpiDevice;
use fixel::canvas::{DepthBuffer, Storage};
use fixel::prelude::*;
use mipidsi::dcs::{InterfaceExt, SetColumnAddress, SetPageAddress, WriteMemoryStart};
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;

use common::lighthouse;

/// A square panel of 240x240 pixels, not rotated.
const SQUARE: (u32, u32) = (240, 240);

fn square<'b>(wires: &Wires, buffer: &'b mut [u8]) -> Driver<'b, ST7789> {
    driver(ST7789, (240, 240), wires, buffer)
}

/// Draws the lighthouse, with depth, textures and light, and text over it.
fn draw<O: Storage<Rgb565>, D: DepthBuffer>(canvas: &mut Canvas<'_, Rgb565, O, D>) {
    let projection = lighthouse::projection(canvas.frame_size()).unwrap();
    let mvp = projection * lighthouse::camera().unwrap() * Transform::IDENTITY;
    lighthouse::sky(canvas);
    lighthouse::draw(canvas, &DrawOptions::new(), &mvp).unwrap();
    lighthouse::caption(canvas);
}

fn raw(color: Rgb565) -> u32 {
    RawU16::from(color).into_inner().into()
}

/// Draws the whole frame, and passes it to `show`. Returns the colors that the panel must show.
fn frame(
    (width, height): (u32, u32),
    show: impl FnOnce(&Canvas<'_, Rgb565, Native, LinearDepth>),
) -> Vec<u32> {
    let mut pixels = vec![Rgb565::BLACK; (width * height) as usize];
    let mut depths = vec![0; pixels.len()];
    let canvas = Canvas::new(&mut pixels, width, height).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    draw(&mut canvas);
    show(&canvas);
    let pixels: Vec<_> = canvas.pixels().map(raw).collect();
    let colors: BTreeSet<_> = pixels.iter().collect();
    assert!(
        colors.len() > 500,
        "the picture has too few colors: {}",
        colors.len()
    );
    pixels
}

/// Draws the frame in bands of `rows` rows, all in the same memory. Passes each band to `show`. The last band has the
/// remaining rows.
fn in_bands(size: (u32, u32), rows: u32, mut show: impl FnMut(&Bytes<'_>)) {
    let (width, height) = size;
    let mut pixels = vec![[0; 2]; (width * rows) as usize];
    let mut depths = vec![0; pixels.len()];
    for first in (0..height).step_by(rows as usize) {
        let length = (width * rows.min(height - first)) as usize;
        let band =
            Canvas::<Rgb565, BigEndian>::band(&mut pixels[..length], width, height, first).unwrap();
        let mut band = band.with_depth(&mut depths[..length]).unwrap();
        draw(&mut band);
        show(&band);
    }
}

/// A canvas with bytes in the order of the bus.
type Bytes<'a> = Canvas<'a, Rgb565, BigEndian, LinearDepth>;

/// The panel's picture after all commands.
fn shown(wires: &Wires, size: (u32, u32)) -> Vec<u32> {
    let mut panel = Panel::new(240, 320);
    panel.read(&commands(wires.take()));
    panel.picture(size)
}

/// The data bytes of the commands that write pixels.
fn written(commands: Vec<Command>) -> Vec<Vec<u8>> {
    let pixels = commands.into_iter().filter(|command| command.code == 0x2c);
    pixels.map(|command| command.data).collect()
}

/// Compares pictures. Names only the first pixel that differs.
fn assert_same(shown: &[u32], expected: &[u32], width: u32) {
    assert_eq!(shown.len(), expected.len());
    if let Some(at) = (0..shown.len()).find(|&at| shown[at] != expected[at]) {
        let (x, y) = (at % width as usize, at / width as usize);
        panic!(
            "({x}, {y}) shows {:#06x}, not {:#06x}",
            shown[at], expected[at]
        );
    }
}

/// The driver converts colors to bytes. These bytes equal the bytes of a canvas of bytes, so a DMA channel that gets
/// `as_bytes()` sends the same bytes as the driver.
#[test]
fn bytes_equal_those_that_the_driver_sends() {
    let (wires, mut buffer) = (Wires::default(), [0; 512]);
    let mut display = square(&wires, &mut buffer);
    wires.take();
    frame(SQUARE, |canvas| canvas.show(&mut display).unwrap());
    let sent = written(commands(wires.take()));
    for rows in [SQUARE.1, 16, 37] {
        let mut bytes = vec![];
        in_bands(SQUARE, rows, |band| {
            bytes.extend_from_slice(band.as_bytes());
            // Bands are sent in the same way as frames.
            band.show(&mut display).unwrap();
            assert!(written(commands(wires.take())) == [band.as_bytes()]);
        });
        assert!(sent == [bytes], "bands of {rows} rows");
    }
}

/// The driver sets up the panel and opens one window of the frame's size, as in the guide for firmware. After that,
/// only the bytes of the bands follow, one band after the other.
#[test]
fn bands_follow_each_other_through_one_window() {
    let (mut wires, mut buffer) = (Wires::default(), [0; 512]);
    drop(square(&wires, &mut buffer));
    let mut interface = SpiInterface::new(wires.clone(), wires.clone(), &mut []);
    for _ in 0..2 {
        interface
            .write_command(SetColumnAddress::new(0, 239))
            .unwrap();
        interface
            .write_command(SetPageAddress::new(0, 239))
            .unwrap();
        interface.write_command(WriteMemoryStart).unwrap();
        in_bands(SQUARE, 40, |band| wires.write(band.as_bytes()).unwrap());
    }
    assert_same(&shown(&wires, SQUARE), &frame(SQUARE, |_| ()), SQUARE.0);
}
