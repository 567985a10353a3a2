//! 18 bits a pixel: on SPI, an ILI9488 takes three bytes a pixel, and reads the upper six bits of each.

use embedded_graphics::pixelcolor::{Rgb888, raw::BigEndian};
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;
use fixel::prelude::*;
use mipidsi::dcs::{InterfaceExt, SetColumnAddress, SetPageAddress, WriteMemoryStart};
use mipidsi::models::ILI9488Rgb666;
use mipidsi::options::{Orientation, Rotation};
use mipidsi::{Builder, interface::SpiInterface};

pub const WIDTH: u32 = 480;
pub const HEIGHT: u32 = 320;
const ROWS: u32 = 10; // of a band: 14 KB of colors and 10 KB of depths
const BAND: usize = (WIDTH * ROWS) as usize;

static BALL: Mesh = shape!(sphere(32, 24));

/// Draws some rows of the frame. `Rgb666` would take four bytes a pixel in memory; the bus needs three.
pub fn draw(canvas: &mut Canvas<'_, Rgb888, BigEndian, LinearDepth>) -> Result<(), Error> {
    let view = Projection::perspective(deg!(24), canvas.frame_size(), fx!(0.5), fx!(50))?
        * Camera::look_at(vec3!(0, 6, 15), Vec3::ZERO, Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 2, 3), fx!(0.15), fx!(0.85))?;
    canvas.clear(Rgb888::new(208, 200, 188));
    let shadow = view * Transform::shadow(-Vec3::Y, Vec3::Y, vec3!(-2, 5, 3))?;
    let shade = Flat::new(Rgb888::new(150, 140, 130));
    let colors = [(230, 60, 60), (240, 200, 60), (60, 180, 90), (70, 110, 230)];
    for (column, (red, green, blue)) in (0_i16..).zip(colors) {
        let place = Transform::translate(vec3!(2.4, 0, 0) * (Scalar::from(column) - fx!(1.5)));
        canvas.draw(&BALL, &(shadow * place), &shade);
        let color = Flat::new(Rgb888::new(red, green, blue)).lit(sun);
        canvas.draw(&BALL, &(view * place), &color);
    }
    Ok(())
}

pub fn run<S: SpiDevice>(
    mut spi: S,
    mut dc: impl OutputPin,
    mut delay: impl DelayNs,
) -> Result<(), Error> {
    let mut buffer = [0; 16];
    let interface = SpiInterface::new(&mut spi, &mut dc, &mut buffer);
    let sideways = Orientation::new().rotate(Rotation::Deg90);
    let panel = Builder::new(ILI9488Rgb666, interface).orientation(sideways);
    let (mut interface, ..) = panel.init(&mut delay).ok().unwrap().release();
    let (right, bottom) = (WIDTH as u16 - 1, HEIGHT as u16 - 1);
    _ = interface.write_command(SetColumnAddress::new(0, right));
    _ = interface.write_command(SetPageAddress::new(0, bottom));
    _ = interface.write_command(WriteMemoryStart);
    let (mut colors, mut depths) = ([[0; 3]; BAND], [0; BAND]);
    for first_row in (0..HEIGHT).step_by(ROWS as usize) {
        let band = Canvas::band(&mut colors, WIDTH, HEIGHT, first_row)?;
        let mut band = band.with_depth(&mut depths)?;
        draw(&mut band)?;
        spi.write(band.as_bytes()).unwrap(); // or lend the bytes to a DMA channel
    }
    Ok(())
}
