//! Towers that fade with their distance.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::prelude::*;

static FLOOR: Mesh = shape!(plane(1, 1));
static TOWER: Mesh = shape!(cuboid(vec3!(1, 2.25, 1)));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(60), size, fx!(0.5), fx!(100))?;
    let camera = Camera::look_at(vec3!(-2, 2.5, 6), vec3!(1, 1, -8), Vec3::Y)?;
    let view = projection * camera;
    let sun = Light::new(vec3!(2, 3, 1), fx!(0.35), fx!(0.65))?;

    // The fog has the color of the sky, so that the horizon disappears.
    let haze = Rgb565::new(22, 48, 26);
    let fog = Fog::linear(haze, fx!(4), fx!(34))?;
    canvas.clear(haze);

    let floor = Transform::scale(fx!(60));
    let grass = Flat::rgb(Rgb888::new(60, 90, 50)).lit_faces(sun);
    canvas.draw(&FLOOR, &(view * floor), &grass.in_fog(fog).dithered());
    for row in 0..9_i16 {
        for column in -1..=1_i16 {
            let height = fx!(0.6) + Scalar::from((row * 7 + column * 15 + 40) % 5) / 4;
            let place = Vec3::from_ints(5 * column, 0, -4 * row);
            // The tower stands on the floor, so its middle is half of its height above the floor.
            let tower = Transform::translate(place + Vec3::new(fx!(0), height * 9 / 4, fx!(0)))
                * Transform::scale_axes(Vec3::new(fx!(1), height, fx!(1)));
            let brick = Flat::rgb(Rgb888::new(190, 110, 80)).lit_faces(sun);
            canvas.draw(&TOWER, &(view * tower), &brick.in_fog(fog).dithered());
        }
    }
    Ok(())
}
