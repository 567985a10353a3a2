//! The smallest scene: two linked rings in the sun.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::prelude::*;

static RING: Mesh = shape!(torus(fx!(0.25), 64, 24));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(45), size, fx!(0.5), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    let view = projection * camera;
    let sun = Light::new(vec3!(-1, 3, 2), fx!(0.25), fx!(0.75))?;

    canvas.clear(Rgb565::new(3, 8, 8));
    let orange = Flat::rgb(Rgb888::new(255, 150, 50)).lit(sun);
    let left = view * Transform::translate(vec3!(-0.4, 0, 0)) * Transform::rotate_z(deg!(25));
    canvas.draw(&RING, &left, &orange);

    let blue = Flat::rgb(Rgb888::new(70, 140, 230)).lit(sun);
    let right = view * Transform::translate(vec3!(0.4, 0, 0)) * Transform::rotate_x(deg!(70));
    canvas.draw(&RING, &right, &blue);
    Ok(())
}
