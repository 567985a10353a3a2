//! Without tearing: a frame is sent when the panel has just begun to read its memory, and never overtakes the panel.

use std::fmt::Debug;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{InputPin, OutputPin};
use embedded_hal::spi::SpiDevice;
use fixel::prelude::*;
use mipidsi::models::ST7789;
use mipidsi::options::TearingEffect;
use mipidsi::{Builder, interface::SpiInterface};

pub const SIDE: u32 = 240;
const PIXELS: usize = (SIDE * SIDE) as usize;

static COLUMN: Mesh = shape!(cylinder(12));

/// Draws a row of columns. The viewer moves along the row.
pub fn draw(frame: &mut Canvas<'_, Rgb565>, passed: Scalar) -> Result<(), Error> {
    let eye = Vec3::new(passed, fx!(0), fx!(5));
    let view = Projection::perspective(deg!(50), (SIDE, SIDE), fx!(0.5), fx!(50))?
        * Camera::look_at(eye, Vec3::new(passed, fx!(0), fx!(0)), Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 2, 3), fx!(0.3), fx!(0.7))?;
    frame.clear(Rgb565::new(4, 12, 12));
    let stone = Flat::rgb(Rgb888::new(240, 200, 150)).lit_faces(sun);
    for column in -2..=4 {
        let place = Transform::translate(vec3!(1.3, 0, 0) * column);
        let size = Transform::scale_axes(vec3!(0.35, 2.6, 0.35));
        frame.draw(&COLUMN, &(view * place * size), &stone);
    }
    Ok(())
}

/// Shows frames. `te` is the panel's TE output, which is high while the panel reads no row of its memory.
pub fn run<T: InputPin<Error: Debug>>(
    spi: impl SpiDevice<Error: Debug>,
    dc: impl OutputPin<Error: Debug>,
    mut te: T,
    mut delay: impl DelayNs,
    ways: &[Scalar],
) -> Result<(), Error> {
    let (mut pixels, mut buffer) = (vec![Rgb565::BLACK; PIXELS], [0; 512]); // on a chip, statics
    let panel = Builder::new(ST7789, SpiInterface::new(spi, dc, &mut buffer));
    let mut panel = panel.display_size(240, 240).init(&mut delay).unwrap();
    panel.set_tearing_effect(TearingEffect::Vertical).unwrap();
    for &passed in ways {
        let mut frame = Canvas::new(&mut pixels, SIDE, SIDE)?;
        draw(&mut frame, passed)?;
        // The panel reads its 320 rows in 16 ms. The bus writes 240 rows in 15 ms, so it takes
        // longer per row. At first, the panel reads ahead of the bus, and shows the old frame once
        // more. Its next reading shows the new frame, because all rows have arrived.
        while te.is_low().unwrap() {}
        while te.is_high().unwrap() {}
        frame.show(&mut panel).unwrap();
    }
    Ok(())
}
