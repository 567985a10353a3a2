//! A round panel: each band is only as wide as the circle is in the rows of the band.

use std::fmt::Debug;
use std::ops::Range;

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::{DrawTarget, DrawTargetExt};
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_10X20};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor, WebColors};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::Text;
use fixel::prelude::*;

/// The side of the square around the circle.
pub const SIDE: u32 = 240;
const ROWS: u32 = 16; // of a band
const BAND: usize = (SIDE * ROWS) as usize;

static GLOBE: Mesh = shape!(sphere(18, 12));

/// Returns the columns of these rows that are in the circle. The columns are symmetric about the circle's center.
fn columns(rows: Range<u32>) -> Range<u32> {
    let radius = SIDE / 2;
    // The distance from the center to the nearest of these rows.
    let up = (rows.start.max(radius) - radius).max(radius - rows.end.min(radius));
    let half = ((radius * radius - up * up).isqrt() + 1).min(radius);
    radius - half..radius + half
}

/// Draws the part of the frame with its upper left corner `at`.
pub fn draw(part: &mut Canvas<'_, Rgb565, Native, LinearDepth>, at: Point) -> Result<(), Error> {
    let frame = Rectangle::new(-at, Size::new(SIDE, SIDE));
    let options = DrawOptions::new().with_viewport(Viewport::try_from(frame)?);
    let view = Projection::perspective(deg!(42), frame.size, fx!(0.5), fx!(50))?
        * Camera::look_at(vec3!(0, 1.2, 3.4), vec3!(0, -0.15, 0), Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 2, 1), fx!(0.4), fx!(0.6))?;
    part.clear(Rgb565::new(1, 3, 5));
    let sea = Flat::rgb(Rgb888::new(30, 80, 150)).lit(sun);
    part.draw_with(&options, &GLOBE, &view, &sea);
    let lines = GLOBE.edges(LineStyle::HAIRLINE.smooth());
    part.draw_with(&options, lines, &view, &Flat::new(Rgb565::CSS_SKY_BLUE));
    let style = MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE);
    Text::new("12:45", Point::new(95, 228), style).draw(&mut part.translated(-at))?;
    Ok(())
}

pub fn run<D: DrawTarget<Color = Rgb565, Error: Debug>>(display: &mut D) -> Result<(), Error> {
    let (mut colors, mut depths) = ([Rgb565::BLACK; BAND], [0; BAND]);
    for first_row in (0..SIDE).step_by(ROWS as usize) {
        let Range { start, end } = columns(first_row..first_row + ROWS);
        let at = Point::new(start.cast_signed(), first_row.cast_signed());
        let pixels = ..((end - start) * ROWS) as usize;
        let part = Canvas::new(&mut colors[pixels], end - start, ROWS)?;
        let mut part = part.with_depth(&mut depths[pixels])?;
        draw(&mut part, at)?;
        part.show(&mut display.translated(at)).unwrap(); // this bus returns no errors
    }
    Ok(())
}
