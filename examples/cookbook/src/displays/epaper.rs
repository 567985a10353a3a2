//! Electronic paper: after a full refresh, which flashes, quick refreshes drive only the pixels that have changed.

use std::fmt::Debug;

use embedded_graphics::pixelcolor::{BinaryColor, Rgb888};
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::{InputPin, OutputPin};
use embedded_hal::spi::SpiDevice;
use epd_waveshare::color::Color;
use epd_waveshare::epd2in13_v2::{Display2in13, Epd2in13, HEIGHT, WIDTH};
use epd_waveshare::prelude::{RefreshLut, WaveshareDisplay};
use fixel::prelude::*;

const ROWS: u32 = 10; // of a band
const BAND: usize = (WIDTH * ROWS) as usize;

static TOWER: Mesh = shape!(cylinder(24));
static SAIL: Mesh = shape!(cuboid(vec3!(1, 0.12, 0.02)));

/// Draws a windmill into the driver's buffer of 4 KB. A band takes 5 KB, with depths.
pub fn draw(paper: &mut Display2in13, turn: Angle) -> Result<(), Error> {
    let view = Projection::perspective(deg!(40), (WIDTH, HEIGHT), fx!(0.5), fx!(50))?
        * Camera::look_at(vec3!(1, 1, 7), vec3!(0, 0.5, 0), Vec3::Y)?;
    // Ordered dithering keeps its pattern where nothing moves. Error diffusion would not.
    let sun = Light::new(vec3!(-2, 2, 3), fx!(0.2), fx!(0.8))?;
    let white = Flat::rgb(Rgb888::new(255, 255, 255)).lit(sun);
    let (mut pixels, mut depths) = ([BinaryColor::On; BAND], [0; BAND]);
    for first_row in (0..HEIGHT).step_by(ROWS as usize) {
        let band = Canvas::band(&mut pixels, WIDTH, HEIGHT, first_row)?;
        let mut band = band.with_depth(&mut depths)?;
        band.clear(BinaryColor::On);
        let tower = view * Transform::scale_axes(vec3!(0.55, 1.2, 0.55));
        band.draw(&TOWER, &tower, &white);
        for angle in [turn, turn + deg!(90)] {
            let sail = Transform::translate(vec3!(0, 1, 0.8)) * Transform::rotate_z(angle);
            band.draw(&SAIL, &(view * sail), &Flat::new(BinaryColor::Off));
        }
        band.show_with(paper, |_, pixel| Color::from(u8::from(pixel.is_on())))?;
    }
    Ok(())
}

pub fn run(
    mut spi: impl SpiDevice<Error: Debug>,
    (busy, dc, reset): (impl InputPin, impl OutputPin, impl OutputPin),
    mut delay: impl DelayNs,
    turns: &[Angle],
) -> Result<(), Error> {
    let mut panel = Epd2in13::new(&mut spi, busy, dc, reset, &mut delay, None).unwrap();
    let mut paper = Display2in13::default();
    for &turn in turns {
        draw(&mut paper, turn)?;
        // The panel keeps the picture, and compares the next picture with it.
        let shown = panel.update_and_display_frame(&mut spi, paper.buffer(), &mut delay);
        shown.unwrap(); // this bus returns no errors
        let quick = panel.set_refresh(&mut spi, &mut delay, RefreshLut::Quick);
        quick.unwrap();
    }
    Ok(())
}
