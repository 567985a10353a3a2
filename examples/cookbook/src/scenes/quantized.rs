//! A ring with numbers of 32 bits, and a ring with numbers of 8 bits that takes a third of the flash.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::text::{Alignment, Text};
use embedded_graphics::{Drawable, geometry::Point};
use fixel::prelude::*;

static RING: Mesh = shape!(torus(fx!(0.45), 48, 24));
static SMALL_RING: Mesh = shape!(torus(fx!(0.45), 48, 24), quantized_8);
/// Stripes around the tube. One half of each stripe is darker.
static GLAZE: [[Rgb565; 64]; 64] = {
    let mut texels = [[Rgb565::new(30, 54, 22); 64]; 64];
    let mut at = 0_usize;
    while at < 64 * 64 {
        let (x, y) = (at % 64, at / 64);
        if (x + y) % 16 < 5 {
            texels[y][x] = Rgb565::new(6, 24, 23);
        } else if y % 32 < 3 {
            texels[y][x] = Rgb565::new(27, 20, 5);
        }
        at += 1;
    }
    texels
};

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(34), size, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(0, 4.2, 6), Vec3::ZERO, Vec3::Y)?;
    let at = |x: Scalar| {
        let place = Transform::translate(Vec3::new(x, fx!(0.1), fx!(0)));
        view * place * Transform::rotate_z(deg!(20)) * Transform::scale(fx!(0.9))
    };
    let sun = Light::new(vec3!(-1, 3, 2), fx!(0.3), fx!(0.7))?;
    let glaze = Textured::new(&GLAZE).bilinear().lit(sun);
    canvas.clear(Rgb565::new(4, 9, 10));
    canvas.draw(&RING, &at(fx!(-1.5)), &glaze);
    // The attributes of a triangle are unpacked each time it is drawn.
    canvas.draw(&SMALL_RING, &at(fx!(1.5)), &glaze);

    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    let (quarter, bottom) = (size.width.cast_signed() / 4, size.height.cast_signed() - 4);
    for (text, x) in [("32 bits", quarter), ("8 bits", 3 * quarter)] {
        Text::with_alignment(text, Point::new(x, bottom), style, Alignment::Center).draw(canvas)?;
    }
    Ok(())
}
