//! Names of planets, hidden by nearer planets.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_4X6, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::{Drawable, geometry::Point, text::Text};
use fixel::prelude::*;

static BALL: Mesh = shape!(sphere(32, 24));
static RING: Mesh = shape!(torus(fx!(0.006), 96, 4));
/// Names, distances from the sun, places in their orbits, colors.
static PLANETS: [(&str, Scalar, Angle, Rgb888); 4] = [
    ("Mercury", fx!(2.1), deg!(345), Rgb888::new(190, 170, 150)),
    ("Venus", fx!(2.9), deg!(93), Rgb888::new(240, 200, 120)),
    ("Earth", fx!(3.9), deg!(190), Rgb888::new(80, 140, 255)),
    ("Mars", fx!(4.8), deg!(245), Rgb888::new(240, 100, 60)),
];

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let frame = canvas.frame_size();
    let is_wide = frame.width > 3 * frame.height / 2;
    let fov = if is_wide { deg!(34) } else { deg!(46) };
    let projection = Projection::perspective(fov, frame, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(0, 2.8, 10), vec3!(0, 0, 0.4), Vec3::Y)?;
    let options = DrawOptions::new();
    canvas.clear(Rgb565::new(0, 1, 3));
    let sun = Flat::rgb(Rgb888::new(255, 220, 90));
    canvas.draw(&BALL, &(view * Transform::scale(fx!(1.3))), &sun);
    let light = PointLight::new(Vec3::ZERO, fx!(1), fx!(60))?;
    let dim = Light::new(vec3!(0, 1, 1), fx!(0.3), fx!(0.2))?;
    for &(_, distance, angle, color) in &PLANETS {
        let orbit = view * Transform::scale(distance);
        canvas.draw(&RING, &orbit, &Flat::new(Rgb565::new(6, 12, 8)));
        let place = Transform::translate(place(distance, angle));
        let planet = view * place * Transform::scale(fx!(0.34));
        canvas.draw(&BALL, &planet, &Flat::rgb(color).lit((light, dim)));
    }

    // Text keeps its size. Its place and its depth are those of a point of the scene.
    let font = [&FONT_4X6, &FONT_6X10][usize::from(frame.height > 100)];
    let offset = frame.height.cast_signed() / 20;
    for &(name, distance, angle, color) in &PLANETS {
        let style = MonoTextStyle::new(font, color.into());
        if let Some(at) = canvas.project(&options, &view, place(distance, angle)) {
            let text = Text::new(name, Point::new(offset, -offset), style);
            text.draw(&mut canvas.label(at))?;
        }
    }
    Ok(())
}

/// A place in an orbit about the origin.
fn place(distance: Scalar, angle: Angle) -> Vec3 {
    Transform::rotate_y(angle).point(Vec3::X * distance)
}
