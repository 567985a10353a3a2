//! A driver that takes words of 16 bits gets the memory of the canvas without conversion.

use display_interface::WriteOnlyDataCommand;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use fixel::canvas::Words;
use fixel::prelude::*;
use ili9341::{DisplaySize240x320, Ili9341, Orientation};

pub const WIDTH: u32 = 320;
pub const HEIGHT: u32 = 240;
const ROWS: u32 = 24; // of a band
const BAND: usize = (WIDTH * ROWS) as usize;

static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));

/// Draws some rows of the frame.
pub fn draw(canvas: &mut Canvas<'_, Rgb565, Words, LinearDepth>) -> Result<(), Error> {
    let view = Projection::perspective(deg!(30), canvas.frame_size(), fx!(0.5), fx!(50))?
        * Camera::look_at(vec3!(3, 4, 6), vec3!(0, 0.4, 0), Vec3::Y)?;
    let sun = Light::new(vec3!(1, 3, 2), fx!(0.3), fx!(0.7))?;
    canvas.clear(Rgb565::new(5, 11, 9));
    let paint = |red, green, blue| Flat::rgb(Rgb888::new(red, green, blue)).lit_faces(sun);
    let floor = Transform::scale_axes(vec3!(1.6, 0.04, 1.6));
    canvas.draw(&CUBE, &(view * floor), &paint(235, 230, 215));
    let colors = [paint(235, 90, 70), paint(245, 190, 70), paint(70, 160, 220)];
    let columns = (0_i16..).zip([4_i16, 3, 2, 3, 2, 4, 1, 2, 3]);
    for ((at, height), color) in columns.zip(colors.iter().cycle()) {
        let height = Scalar::from(height) / 6;
        let [x, z] = [at % 3 - 1, at / 3 - 1].map(Scalar::from);
        let place = Transform::translate(Vec3::new(x, height, z));
        let size = Transform::scale_axes(Vec3::new(fx!(0.4), height, fx!(0.4)));
        canvas.draw(&CUBE, &(view * place * size), color);
    }
    Ok(())
}

/// `interface` is the bus, for example `SPIInterface::new(spi, dc)` of display-interface-spi.
pub fn run<DI: WriteOnlyDataCommand>(
    interface: DI,
    reset: impl OutputPin,
    mut delay: impl DelayNs,
) -> Result<(), Error> {
    let size = DisplaySize240x320;
    let panel = Ili9341::new(interface, reset, &mut delay, Orientation::Landscape, size);
    let mut panel = panel.unwrap();
    let (mut words, mut depths) = ([0; BAND], [0; BAND]);
    for first_row in (0..HEIGHT).step_by(ROWS as usize) {
        let band = Canvas::<Rgb565, Words>::band(&mut words, WIDTH, HEIGHT, first_row)?;
        let mut band = band.with_depth(&mut depths)?;
        draw(&mut band)?;
        let (first, last) = (first_row as u16, (first_row + ROWS) as u16 - 1);
        panel
            .draw_raw_slice(0, first, WIDTH as u16 - 1, last, band.as_cells())
            .unwrap();
    }
    Ok(())
}
