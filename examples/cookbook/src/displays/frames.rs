//! Two frames in slow PSRAM: while one frame is sent, the other is drawn, in bands in fast SRAM.

use std::fmt::Debug;
use std::mem;

use embassy_futures::join::join;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, raw::BigEndian};
use embedded_hal::digital::OutputPin;
use embedded_hal_async::{delay::DelayNs, spi::SpiDevice};
use fixel::prelude::*;
use lcd_async::{Builder, interface::SpiInterface, models::ST7789};

const SIDE: u32 = 240;
const ROWS: u32 = 24; // of a band
const BAND: usize = (SIDE * ROWS) as usize;
/// The number of pixels of a frame. A frame takes 112 KiB.
pub const PIXELS: usize = (SIDE * SIDE) as usize;

static KNOT: Mesh = shape!(torus(fx!(0.3), 32, 16));

/// Depths are read and written often, so each band is drawn in SRAM, and then copied to PSRAM.
pub fn draw(frame: &mut [[u8; 2]], turn: Angle) -> Result<(), Error> {
    let view = Projection::perspective(deg!(45), (SIDE, SIDE), fx!(0.5), fx!(50))?
        * Camera::look_at(vec3!(0, 1, 3.6), Vec3::ZERO, Vec3::Y)?;
    let sun = Light::new(vec3!(-1, 3, 2), fx!(0.25), fx!(0.75))?;
    let (mut colors, mut depths) = ([[0; 2]; BAND], [0; BAND]);
    for (first_row, rows) in (0..).step_by(ROWS as usize).zip(frame.chunks_mut(BAND)) {
        let band = Canvas::<Rgb565, BigEndian>::band(&mut colors, SIDE, SIDE, first_row)?;
        let mut band = band.with_depth(&mut depths)?;
        band.clear(Rgb565::new(3, 8, 8));
        for (angle, color) in [(turn, (90, 200, 160)), (turn + deg!(90), (230, 120, 200))] {
            let place = Transform::rotate_y(turn) * Transform::rotate_x(angle);
            let color = Flat::rgb(Rgb888::new(color.0, color.1, color.2)).lit(sun);
            band.draw(&KNOT, &(view * place), &color);
        }
        rows.copy_from_slice(band.as_cells());
    }
    Ok(())
}

pub async fn run<S: SpiDevice<Error: Debug>, P: OutputPin<Error: Debug>>(
    (spi, dc, mut delay): (S, P, impl DelayNs),
    [mut shown, mut next]: [&mut [[u8; 2]]; 2],
    turns: &[Angle],
) -> Result<(), Error> {
    let panel = Builder::new(ST7789, SpiInterface::new(spi, dc)).display_size(240, 240);
    let mut panel = panel.init(&mut delay).await.unwrap();
    draw(next, turns[0])?;
    for turn in &turns[1..] {
        mem::swap(&mut shown, &mut next);
        // `join` starts the transfer first: the DMA sends while this core draws.
        let sending = panel.show_raw_data(0, 0, 240, 240, shown.as_flattened());
        let (sent, drawn) = join(sending, async { draw(next, *turn) }).await;
        sent.unwrap();
        drawn?;
    }
    let last = panel.show_raw_data(0, 0, 240, 240, next.as_flattened());
    last.await.unwrap();
    Ok(())
}
