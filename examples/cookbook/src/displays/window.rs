//! Only a window of the frame: after the first frame, only the pixels around the moving part are drawn and sent.

use std::fmt::Debug;

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::{DrawTarget, DrawTargetExt};
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_10X20};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::Text;
use fixel::prelude::*;

pub const FRAME: Size = Size::new(240, 240);
/// The moving part stays in this window. With depths, it takes 25 KiB; a frame takes 225 KiB.
pub const WINDOW: Rectangle = Rectangle::new(Point::new(80, 80), Size::new(80, 80));

static RING: Mesh = shape!(torus(fx!(0.4), 24, 12));
static ROD: Mesh = shape!(cylinder(16));

/// Draws a part of the frame that is as large as the window, and sends it to its place.
fn show<D>(display: &mut D, at: Point, turn: Angle) -> Result<(), Error>
where
    D: DrawTarget<Color = Rgb565, Error: Debug>,
{
    let (mut colors, mut depths) = ([Rgb565::BLACK; 6400], [0; 6400]);
    let mut canvas = Canvas::new(&mut colors, 80, 80)?.with_depth(&mut depths)?;
    // The viewport is the whole frame, moved so that this part of the frame is on the canvas.
    let frame = Viewport::try_from(Rectangle::new(-at, FRAME))?;
    let options = DrawOptions::new().with_viewport(frame);
    let view = Projection::perspective(deg!(40), FRAME, fx!(0.5), fx!(50))?
        * Camera::look_at(vec3!(0, 2, 6), Vec3::ZERO, Vec3::Y)?;
    let sun = Light::new(vec3!(-1, 3, 2), fx!(0.3), fx!(0.7))?;
    canvas.clear(Rgb565::new(3, 8, 8));
    let steel = Flat::rgb(Rgb888::new(150, 160, 170)).lit(sun);
    let rod = view * Transform::scale_axes(vec3!(0.16, 1.6, 0.16));
    canvas.draw_with(&options, &ROD, &rod, &steel);
    let tilt = Transform::rotate_y(turn) * Transform::rotate_z(deg!(20));
    let ring = view * tilt * Transform::scale(fx!(0.52));
    let orange = Flat::rgb(Rgb888::new(255, 150, 50)).lit(sun);
    canvas.draw_with(&options, &RING, &ring, &orange);
    let style = MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE);
    Text::new("120 rpm", Point::new(85, 225), style).draw(&mut canvas.translated(-at))?;
    canvas.show(&mut display.translated(at)).unwrap(); // this bus returns no errors
    Ok(())
}

/// Shows the frame of the first turn in nine parts. For each other turn, shows only the window.
pub fn run<D>(display: &mut D, turns: &[Angle]) -> Result<(), Error>
where
    D: DrawTarget<Color = Rgb565, Error: Debug>,
{
    for at in (0..9).map(|part| Point::new(part % 3 * 80, part / 3 * 80)) {
        show(display, at, turns[0])?;
    }
    for &turn in &turns[1..] {
        show(display, WINDOW.top_left, turn)?;
    }
    Ok(())
}
