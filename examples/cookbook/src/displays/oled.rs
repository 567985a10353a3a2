//! A panel of 128x64 pixels in black and white, without the driver's buffer of 1 KiB: 8 rows at a
//! time are drawn, packed and sent.

use embedded_graphics::Drawable;
use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{BinaryColor, Rgb888};
use embedded_graphics::text::Text;
use fixel::prelude::*;
use ssd1306::prelude::{DisplayRotation, DisplaySize128x64, WriteOnlyDataCommand};
use ssd1306::{Ssd1306, command::AddrMode};

const WIDTH: u32 = 128;
const HEIGHT: u32 = 64;
const ROWS: u32 = 8; // of a page: a byte for each column
const PAGE: usize = (WIDTH * ROWS) as usize;

static RING: Mesh = shape!(torus(fx!(0.45), 24, 12));

/// Draws some rows of the frame.
pub fn draw(canvas: &mut Canvas<'_, BinaryColor, Native, LinearDepth>) -> Result<(), Error> {
    let view = Projection::perspective(deg!(34), canvas.frame_size(), fx!(0.5), fx!(20))?
        * Camera::look_at(vec3!(0, 3, 3.4), Vec3::ZERO, Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 3, 1), fx!(0.1), fx!(0.9))?;
    canvas.clear(BinaryColor::Off);
    let white = Flat::rgb(Rgb888::new(255, 255, 255)).lit(sun);
    canvas.draw(&RING, &view, &white); // gray by ordered dithering
    let style = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
    Text::new("-12 dB", Point::new(0, 8), style).draw(canvas)?;
    Ok(())
}

/// `interface` is the bus: `I2CDisplayInterface::new(i2c)` or `SPIInterface::new(spi, dc)`.
pub fn run<DI: WriteOnlyDataCommand>(interface: DI) -> Result<(), Error> {
    // Not `into_buffered_graphics_mode`, because this mode has a buffer of 1 KiB.
    let mut panel = Ssd1306::new(interface, DisplaySize128x64, DisplayRotation::Rotate0);
    panel.init_with_addr_mode(AddrMode::Horizontal).unwrap();
    panel
        .set_draw_area((0, 0), (WIDTH as u8, HEIGHT as u8))
        .unwrap();

    let (mut pixels, mut depths) = ([BinaryColor::Off; PAGE], [0; PAGE]);
    let mut page = [0; WIDTH as usize];
    for first_row in (0..HEIGHT).step_by(ROWS as usize) {
        let band = Canvas::band(&mut pixels, WIDTH, HEIGHT, first_row)?;
        let mut band = band.with_depth(&mut depths)?;
        draw(&mut band)?;
        for (byte, rows) in page.iter_mut().zip(band.pages()) {
            *byte = rows;
        }
        panel.draw(&page).unwrap(); // this bus returns no errors
    }
    Ok(())
}
