//! A needle over a still dial: if it has moved, only the rectangle in which it was and is.

use core::fmt::Debug;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::{
    DrawTarget, DrawTargetExt, Drawable, Point, Primitive, RgbColor, Size,
};
use embedded_graphics::primitives::{Circle, PrimitiveStyle, Rectangle};
use fixel::{mesh::Bounds, prelude::*};

pub const FRAME: Rectangle = Rectangle::new(Point::zero(), Size::new(240, 240));
static NEEDLE: Mesh = shape!(cuboid(vec3!(0.04, 0.45, 0.04)));
static BOUNDS: Bounds = NEEDLE.bounds();

/// The needle's place, and the pixels that it may change.
fn needle(turn: Angle) -> Result<(Mvp, Rectangle), Error> {
    let camera = Camera::look_at(vec3!(0, 0, 3.4), Vec3::ZERO, Vec3::Y)?;
    let view = Projection::perspective(deg!(40), FRAME.size, fx!(0.5), fx!(20))? * camera;
    let mvp = view * Transform::rotate_z(turn) * Transform::translate(vec3!(0, 0.35, 0));
    let area = Viewport::try_from(FRAME)?.rectangle_on_screen(&BOUNDS, &mvp, 0);
    Ok((mvp, area.unwrap_or(FRAME)))
}

/// The pixels that change as the needle turns: where it was, and where it is.
pub fn changed(from: Angle, to: Angle) -> Result<Rectangle, Error> {
    let [a, b] = [needle(from)?.1, needle(to)?.1];
    let end = (a.top_left + a.size).component_max(b.top_left + b.size);
    let start = a.top_left.component_min(b.top_left);
    Ok(Rectangle::with_corners(start, end - Point::new_equal(1)))
}

/// Draws a part of the frame and sends it, as many rows at a time as there is memory for.
pub fn show<D>(display: &mut D, part: Rectangle, turn: Angle) -> Result<(), Error>
where
    D: DrawTarget<Color = Rgb565, Error: Debug>,
{
    let (mut colors, width) = ([Rgb565::BLACK; 4800], part.size.width);
    let most = Size::new(width, 4800 / width);
    for y in part.rows().step_by(most.height as usize) {
        let area = Rectangle::new(Point::new(part.top_left.x, y), most).intersection(&part);
        let len = (width * area.size.height) as usize;
        let mut canvas = Canvas::new(&mut colors[..len], width, area.size.height)?;
        // The viewport is the whole frame, moved so that this part of it is on the canvas.
        let frame = Viewport::try_from(Rectangle::new(-area.top_left, FRAME.size))?;
        let options = DrawOptions::new().with_viewport(frame);
        canvas.clear(Rgb565::new(3, 8, 8));
        let dial = Circle::with_center(FRAME.center() - area.top_left, 220);
        let line = PrimitiveStyle::with_stroke(Rgb565::WHITE, 3);
        dial.into_styled(line).draw(&mut canvas)?;
        let sun = Light::new(vec3!(-1, 2, 3), fx!(0.3), fx!(0.7))?;
        let red = Flat::new(Rgb565::new(31, 16, 4)).lit(sun);
        canvas.draw_with(&options, &NEEDLE, &needle(turn)?.0, &red);
        canvas.show(&mut display.translated(area.top_left)).unwrap(); // this bus returns no errors
    }
    Ok(())
}

/// Shows each turn that differs from the one before. `sleep` waits until the next is known.
pub fn run<D>(display: &mut D, turns: &[Angle], mut sleep: impl FnMut()) -> Result<(), Error>
where
    D: DrawTarget<Color = Rgb565, Error: Debug>,
{
    show(display, FRAME, turns[0])?;
    for pair in turns.windows(2) {
        sleep();
        if pair[0] != pair[1] {
            show(display, changed(pair[0], pair[1])?, pair[1])?;
        }
    }
    Ok(())
}
