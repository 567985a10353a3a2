//! Lamps of several colors, a spot light, and a highlight.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

static FLOOR: Mesh = shape!(plane(40, 40));
static BALL: Mesh = shape!(sphere(32, 24));
static PILLAR: Mesh = shape!(cylinder(24));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(42), size, fx!(0.5), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 3, 7), vec3!(0, 0.9, 0), Vec3::Y)?;
    let view = projection * camera;
    let viewer = Viewer::of(&view);

    // Lights are in world space, and are added up. The light of a lamp ends at the lamp's range.
    let night = Light::new(vec3!(0, 1, 0.5), fx!(0.1), fx!(0.15))?;
    let red = PointLight::new(vec3!(-3, 1.5, 1), fx!(1), fx!(6))?;
    let blue = PointLight::new(vec3!(3, 1.5, 1), fx!(1), fx!(6))?;
    let cone = (deg!(12), deg!(20));
    let spot = SpotLight::new(vec3!(0, 7, 0), vec3!(0, -1, -0.1), cone, fx!(1), fx!(14))?;
    let lights = (
        night,
        [
            red.colored(Rgb888::new(255, 60, 30)),
            blue.colored(Rgb888::new(50, 90, 255)),
        ],
        spot.shiny(viewer, 40, fx!(0.9))?,
    );

    canvas.clear(Rgb565::BLACK);
    let floor = Transform::scale(fx!(7));
    canvas.draw(
        &FLOOR,
        &(view * floor),
        &Flat::rgb(Rgb888::WHITE).lit(lights),
    );
    let ball = Transform::translate(vec3!(0, 1, 0));
    canvas.draw(&BALL, &(view * ball), &Flat::rgb(Rgb888::WHITE).lit(lights));
    for x in [fx!(-2), fx!(2)] {
        let pillar = Transform::translate(Vec3::new(x, fx!(1), fx!(-1.5)))
            * Transform::scale_axes(vec3!(0.4, 1, 0.4));
        let stone = Flat::rgb(Rgb888::new(220, 210, 190));
        canvas.draw(&PILLAR, &(view * pillar), &stone.lit(lights));
    }
    Ok(())
}
