//! An attitude indicator (a ball in 3D) between two gauges drawn by embedded-graphics.

use embedded_graphics::geometry::{AngleUnit, Dimensions, Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10, ascii::FONT_7X13};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor, WebColors};
use embedded_graphics::primitives::{Arc, Line, Primitive as _, PrimitiveStyle};
use embedded_graphics::{Drawable, text::Alignment, text::Text};
use fixel::Window;
use fixel::prelude::*;

static BALL: Mesh = shape!(sphere(32, 24));
/// Sky above ground, and a line every 10 degrees (every 7 rows of the texture).
static SKIN: [[Rgb565; 64]; 128] = {
    let mut texels = [[Rgb565::CSS_DODGER_BLUE; 64]; 128];
    let mut at = 0_usize;
    while at < 64 * 128 {
        let (x, y) = (at % 64, at / 64);
        if y == 64 || y % 7 == 1 && y.abs_diff(64) < 43 && (x + 4) % 64 < 8 {
            texels[y][x] = Rgb565::WHITE;
        } else if y > 64 {
            texels[y][x] = Rgb565::CSS_SIENNA;
        }
        at += 1;
    }
    texels
};

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let (Size { width, height }, center) = (canvas.frame_size(), canvas.bounding_box().center());
    canvas.clear(Rgb565::new(2, 4, 3));
    let aspect = Scalar::try_from(width)? / Scalar::try_from(height)?;
    let window = Window::centered(aspect * 5 / 2, fx!(2.5)); // the ball is 2 units wide
    let projection = Projection::orthographic(window, fx!(-1), fx!(1))?;
    let ball = projection * Transform::rotate_z(deg!(-20)) * Transform::rotate_x(deg!(10));
    let sun = Light::new(vec3!(0, 1, 2), fx!(0.4), fx!(0.6))?;
    canvas.draw(&BALL, &ball, &Textured::new(&SKIN).lit(sun));
    let (ring, gauge) = (height * 7 / 8, width.saturating_sub(height) / 2);
    let stroke = |color, part| PrimitiveStyle::with_stroke(color, 1 + height / part);
    for degrees in [-150_i16, -135, -120, -110, -100, -80, -70, -60, -45, -30] {
        let tick = Arc::with_center(center, ring, f32::from(degrees).deg(), f32::deg(1.));
        tick.into_styled(stroke(Rgb565::WHITE, 30)).draw(canvas)?;
    }
    let font = [&FONT_6X10, &FONT_7X13][usize::from(height > 100)];
    let white = MonoTextStyle::new(font, Rgb565::WHITE);
    for (side, text, sweep) in [(-1, "118\nKT", 160.), (1, "84\nRPM", 110.)] {
        let at = |x: u32| center + Point::new(side * x.cast_signed(), 0);
        let (wing, middle) = (
            Line::new(at(height / 8), at(height / 3)),
            at((width + ring) / 4),
        );
        wing.into_styled(stroke(Rgb565::YELLOW, 80)).draw(canvas)?;
        for (sweep, color) in [(240., Rgb565::CSS_DIM_GRAY), (sweep, Rgb565::CSS_LIME)] {
            let arc = Arc::with_center(middle, gauge, f32::deg(150.), f32::deg(sweep));
            arc.into_styled(stroke(color, 40)).draw(canvas)?;
        }
        Text::with_alignment(text, middle, white, Alignment::Center).draw(canvas)?;
    }
    Ok(())
}
