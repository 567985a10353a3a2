//! A walled garden at dusk: a first-person scene that uses most of the crate. The program is in
//! `examples/common/world`.

#[path = "../../common/world/mod.rs"]
mod garden;

use fixel::prelude::*;

use super::scenes::Frame;

/// Frames of the walk, once around.
pub const FRAMES: u32 = 64;

/// The moment of a frame.
pub fn turn_of(frame: u32) -> Angle {
    Angle::from_bits(u32::MAX / FRAMES * frame)
}

pub fn walk(canvas: &mut Frame<'_>, turn: Angle) -> Result<(), Error> {
    garden::draw(canvas, turn)
}

pub fn draw(canvas: &mut Frame<'_>) -> Result<(), Error> {
    walk(canvas, turn_of(13))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{SIZE, picture};
    use embedded_graphics::geometry::Point;
    use embedded_graphics::pixelcolor::{Rgb565, RgbColor};

    /// Bands show the same reflection, blended lights and labels as the frame.
    #[test]
    fn bands_equal_frames() {
        const WIDTH: u32 = SIZE.width;
        const HEIGHT: u32 = SIZE.height;
        const ROWS: u32 = 48;
        let turn = turn_of(FRAMES / 2);
        let frame = picture(|canvas| walk(canvas, turn), SIZE).unwrap();
        let mut colors = vec![Rgb565::BLACK; (WIDTH * ROWS) as usize];
        let mut depths = vec![0; colors.len()];
        for first_row in (0..HEIGHT).step_by(ROWS as usize) {
            let band = Canvas::band(&mut colors, WIDTH, HEIGHT, first_row).unwrap();
            let mut band = band.with_depth(&mut depths).unwrap();
            walk(&mut band, turn).unwrap();
            for (at, color) in (0..).zip(band.pixels()) {
                let (x, y) = (at % WIDTH, first_row + at / WIDTH);
                let at = Point::new(x.cast_signed(), y.cast_signed());
                assert_eq!(color, frame.get_pixel(at), "{at}");
            }
        }
    }
}
