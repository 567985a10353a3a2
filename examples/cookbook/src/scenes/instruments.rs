//! An attitude indicator and a speedometer: rims, ball, needle and marks are meshes.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_4X6, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor, WebColors};
use embedded_graphics::text::{Alignment, Baseline, Text, TextStyle, TextStyleBuilder};
use embedded_graphics::{Drawable, geometry::Point};
use fixel::{Window, prelude::*};

static BALL: Mesh = shape!(sphere(32, 24));
static RIM: Mesh = shape!(torus(fx!(0.05), 64, 8));
static NEEDLE: Mesh = shape!(cone(12));
static MARK: Mesh = shape!(cuboid(vec3!(0.02, 0.07, 0.01)));
const CENTERED: TextStyle = TextStyleBuilder::new()
    .alignment(Alignment::Center)
    .baseline(Baseline::Middle)
    .build();

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

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>, ms: u64) -> Result<(), Error> {
    let size = canvas.frame_size();
    let aspect = Scalar::try_from(size.width)? / Scalar::try_from(size.height)?;
    let window = Window::centered(aspect * 5 / 2, fx!(2.5));
    let view = Projection::orthographic(window, fx!(-2), fx!(2))? * Transform::IDENTITY;
    let sun = Light::new(vec3!(-1, 2, 3), fx!(0.3), fx!(0.7))?;
    let of = |r, g, b| Flat::rgb(Rgb888::new(r, g, b)).lit(sun);
    let sway = Rate::millihertz(400).angle_at(ms) + deg!(140);
    canvas.clear(Rgb565::new(2, 4, 3));

    let [left, right] = [vec3!(-0.83, 0, 0), vec3!(0.83, 0, 0)].map(Transform::translate);
    for place in [left, right] {
        let upright = Transform::rotate_x(deg!(90)) * Transform::scale(fx!(0.78));
        canvas.draw(&RIM, &(view * place * upright), &of(150, 155, 165));
    }
    let bank = Transform::rotate_z(Angle::from_turns(fx!(0.07) * sway.sin()));
    let ball = left * bank * Transform::rotate_x(deg!(12)) * Transform::scale(fx!(0.68));
    canvas.draw(&BALL, &(view * ball), &Textured::new(&SKIN).lit(sun));

    // From 0 to 200 knots, the needle turns by 270 degrees.
    let turn = |knots| Transform::rotate_z(Angle::from_turns((fx!(100) - knots) * 3 / 800));
    let font = [&FONT_4X6, &FONT_6X10][usize::from(size.height > 100)];
    let style = MonoTextStyle::new(font, Rgb565::WHITE);
    for (step, name) in (0..).zip(["0", "", "50", "", "100", "", "150", "", "200"]) {
        let dial = right * turn(fx!(25) * step);
        let mark = dial * Transform::translate(vec3!(0, 0.64, 0));
        canvas.draw(&MARK, &(view * mark), &Flat::new(Rgb565::WHITE));
        let place = dial.point(vec3!(0, 0.45, 0));
        if let Some(at) = canvas.viewport().project(place, &view) {
            Text::with_text_style(name, Point::zero(), style, CENTERED)
                .draw(&mut canvas.label(at))?;
        }
    }
    let shape =
        Transform::translate(vec3!(0, 0.22, 0.1)) * Transform::scale_axes(vec3!(0.06, 0.4, 0.06));
    let needle = right * turn(fx!(110) + fx!(40) * sway.cos()) * shape;
    canvas.draw(&NEEDLE, &(view * needle), &of(255, 70, 50));
    Ok(())
}
