//! Pictures of the programs on pages.

use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::{Drawable, text::Text};
use fixel::prelude::*;

use super::{CUBE, Drawn};
use crate::scenes::Frame;

/// The scene of the crate's page: a cube with a texture of four texels, and a text.
pub(super) fn first(canvas: &mut Frame<'_>) -> Drawn {
    static SKIN: [[Rgb565; 2]; 2] = [[Rgb565::WHITE, Rgb565::BLUE], [Rgb565::BLUE, Rgb565::WHITE]];
    let projection = Projection::perspective(deg!(60), canvas.frame_size(), fx!(0.5), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 1.5, 4), Vec3::ZERO, Vec3::Y)?;
    let spin = Transform::rotate_y(Rate::rpm(10).angle_at(600));
    let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
    canvas.clear(Rgb565::BLACK);
    let mvp = projection * camera * spin;
    canvas.draw(&CUBE, &mvp, &Textured::new(&SKIN).lit(sun));
    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::YELLOW);
    Text::new("Hello", Point::new(4, 12), style).draw(canvas)?;
    Ok(())
}

/// The scene in the guide for firmware: a ring with a caption.
pub(super) fn firmware(canvas: &mut Frame<'_>) -> Drawn {
    static RING: Mesh = shape!(torus(fx!(0.4), 24, 12));
    let projection = Projection::perspective(deg!(50), canvas.frame_size(), fx!(0.5), fx!(20))?;
    let camera = Camera::look_at(vec3!(0, 2, 3), Vec3::ZERO, Vec3::Y)?;
    let mvp = projection * camera * Transform::rotate_x(Rate::rpm(10).angle_at(5_800));
    let light = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?;
    canvas.clear(Rgb565::BLACK);
    canvas.draw(
        &RING,
        &mvp,
        &Flat::new(Rgb565::new(31, 40, 8)).lit_faces(light),
    );
    let style = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    Text::new("10 rpm", Point::new(4, 12), style).draw(canvas)?;
    Ok(())
}
