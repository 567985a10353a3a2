//! The smallest scene: a ring in the sun.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::prelude::*;

static RING: Mesh = shape!(torus(fx!(0.45), 48, 24));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(45), size, fx!(0.1), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    let tilt = Transform::rotate_z(deg!(25));
    let sun = Light::new(vec3!(-1, 3, 2), fx!(0.25), fx!(0.75))?;

    canvas.clear(Rgb565::new(3, 8, 8));
    let orange = Flat::rgb(Rgb888::new(255, 150, 50));
    canvas.draw(&RING, &(projection * camera * tilt), &orange.lit(sun));
    Ok(())
}
