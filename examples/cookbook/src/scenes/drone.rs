//! A drone's display: first gates over a meadow in fog, then text and lines of embedded-graphics.

use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_4X6, ascii::FONT_7X13};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::{Circle, Primitive as _, PrimitiveStyle};
use embedded_graphics::{Drawable, text::Alignment, text::Text};
use fixel::prelude::*;

static GATE: Mesh = shape!(torus(fx!(0.12), 32, 8));
static MEADOW: Mesh = shape!(plane(16, 16));
const ORANGE: Rgb888 = Rgb888::new(255, 120, 30);
const BLUE: Rgb888 = Rgb888::new(60, 120, 220);
/// For each gate: its place, its turn about the vertical, its color, and its distance as text.
static GATES: [(Vec3, Angle, Rgb888, &str); 3] = [
    (vec3!(-0.6, 2.4, -7), deg!(10), ORANGE, "7 m"),
    (vec3!(5, 3.2, -14), deg!(-25), BLUE, "15 m"),
    (vec3!(-11.5, 3.6, -26), deg!(50), BLUE, "28 m"),
];

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>, ms: u64) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(60), size, fx!(0.25), fx!(100))?;
    // The drone sways: it rolls to the side to which it then flies.
    let sway = Rate::millihertz(400).angle_at(ms);
    let place = vec3!(0, 2.6, 0) + Vec3::X * (fx!(0.9) * sway.sin());
    let roll = Transform::rotate_z(Angle::from_turns(fx!(0.039) * sway.cos()));
    let pose = Transform::translate(place) * Transform::rotate_x(deg!(-6)) * roll;
    let view = projection * Camera::at_pose(pose);
    let sun = Light::new(vec3!(1, 2, 1), fx!(0.4), fx!(0.6))?;
    let sky = Rgb565::new(20, 46, 28);
    let fog = Fog::linear(sky, fx!(4), fx!(42))?;
    canvas.clear(sky);
    let squares: [[Rgb565; 64]; 64] = core::array::from_fn(|row| {
        core::array::from_fn(|column| [6, 9][(row + column) % 2]).map(|red| Rgb565::new(red, 26, 4))
    });
    let meadow = view * Transform::scale(fx!(60));
    canvas.draw(&MEADOW, &meadow, &Textured::new(&squares).in_fog(fog));
    let font = [&FONT_4X6, &FONT_7X13][usize::from(size.height > 100)];
    let style = MonoTextStyle::new(font, Rgb565::WHITE);
    for &(place, turn, color, distance) in &GATES {
        let stand = view * Transform::translate(place) * Transform::rotate_y(turn);
        let gate = stand * Transform::rotate_x(deg!(90)) * Transform::scale(fx!(1.5));
        canvas.draw(&GATE, &gate, &Flat::rgb(color).lit(sun).in_fog(fog));
        if let Some(at) = canvas.viewport().project(place + vec3!(0, 2.1, 0), &view) {
            Text::with_alignment(distance, Point::zero(), style, Alignment::Center)
                .draw(&mut canvas.label(at.on_top()))?;
        }
    }

    let circle = Circle::with_center(canvas.bounding_box().center(), size.height / 10);
    let line = PrimitiveStyle::with_stroke(Rgb565::WHITE, 1);
    circle.into_styled(line).draw(canvas)?;
    let (right, bottom) = (size.width.cast_signed() - 4, size.height.cast_signed() - 5);
    let top = font.character_size.height.cast_signed();
    let mut text =
        |text, x, y, side| Text::with_alignment(text, Point::new(x, y), style, side).draw(canvas);
    text("ALT 2.6 m", 4, top, Alignment::Left)?;
    text("SPD 14 m/s", right, top, Alignment::Right)?;
    text("BAT 78 %", 4, bottom, Alignment::Left)?;
    text("01:24.6", right, bottom, Alignment::Right)?;
    Ok(())
}
