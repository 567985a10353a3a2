//! A model without normals: lit face by face, with creased normals, and with smooth normals.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics::text::{Alignment, Text};
use embedded_graphics::{Drawable, geometry::Point};
use fixel::prelude::*;

/// The front and the back are concave polygons of 32 corners. The macro cuts the polygons into triangles.
static CLOVER: Mesh = include_mesh!("../../../assets/clover.obj");
/// The compiler computes the normals, and stores them in flash.
static CREASED: Mesh = include_mesh!("../../../assets/clover.obj", normals);

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(34), size, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(0, 5, 9), Vec3::ZERO, Vec3::Y)?;
    let at = |x: Scalar| {
        let place = Transform::translate(Vec3::new(x, fx!(0), fx!(0)));
        view * place * Transform::rotate_y(deg!(20)) * Transform::rotate_x(deg!(-90))
    };
    let sun = Light::new(vec3!(-2, 3, 4), fx!(0.15), fx!(0.85))?;
    let jade = Flat::rgb(Rgb888::new(120, 225, 150));
    canvas.clear(Rgb565::new(4, 8, 8));

    // Light is computed once per triangle. No normals are stored.
    canvas.draw(&CLOVER, &at(fx!(-2.5)), &jade.lit_faces(sun));

    // Light is computed once per corner. Edges that turn by more than 60 degrees stay sharp.
    canvas.draw(&CREASED, &at(fx!(0)), &jade.lit(sun));

    // Light is computed once per corner. No edge looks sharp. These normals are computed when the program runs.
    let mut normals = [Vec3::ZERO; 64];
    let smooth = CLOVER.with_smooth_normals(&mut normals)?;
    canvas.draw(&smooth, &at(fx!(2.5)), &jade.lit(sun));

    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    let bottom = size.height.cast_signed() * 5 / 6;
    for (third, name) in (0..).zip(["faces", "creased", "smooth"]) {
        let middle = Point::new(size.width.cast_signed() * (2 * third + 1) / 6, bottom);
        Text::with_alignment(name, middle, style, Alignment::Center).draw(canvas)?;
    }
    Ok(())
}
