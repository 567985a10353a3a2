//! Names of planets. The sun hides a part of a name, because each name has the depth of its planet.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_4X6, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::{Drawable, geometry::Point, text::Alignment, text::Text};
use fixel::canvas::TestOnly;
use fixel::prelude::*;

static BALL: Mesh = shape!(sphere(32, 24));
static RING: Mesh = shape!(torus(fx!(0.002), 96, 3));
static ORBIT: Outline = outline!(RING, deg!(180));
/// Names, distances from the sun, places in their orbits, colors.
static PLANETS: [(&str, Scalar, Angle, Rgb888); 4] = [
    ("Mercury", fx!(2.1), deg!(325), Rgb888::new(190, 170, 150)),
    ("Venus", fx!(2.9), deg!(113), Rgb888::new(240, 200, 120)),
    ("Earth", fx!(3.9), deg!(190), Rgb888::new(80, 140, 255)),
    ("Mars", fx!(4.8), deg!(245), Rgb888::new(240, 100, 60)),
];

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let frame = canvas.frame_size();
    let fov = [deg!(46), deg!(34)][usize::from(frame.width > 3 * frame.height / 2)];
    let projection = Projection::perspective(fov, frame, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(0, 4.6, 9.4), vec3!(0, 0, 0.3), Vec3::Y)?;
    let options = DrawOptions::new();
    canvas.clear(Rgb565::new(0, 1, 3));
    let sun = view * Transform::scale(fx!(1.3));
    canvas.draw(&BALL, &sun, &Flat::rgb(Rgb888::new(255, 220, 90)));
    let light = PointLight::new(Vec3::ZERO, fx!(1), fx!(60))?;
    let lights = (light, Light::new(vec3!(0, 1, 1), fx!(0.3), fx!(0.2))?);
    for &(_, distance, angle, color) in &PLANETS {
        let place = Transform::translate(place(distance, angle));
        let planet = view * place * Transform::scale(fx!(0.34));
        canvas.draw(&BALL, &planet, &Flat::rgb(color).lit(lights));
    }
    // Anti-aliased lines do not write depths, because they must not hide one another where they meet.
    let behind = options.with_depth_test(TestOnly);
    let line = RING.outline(&ORBIT, LineStyle::HAIRLINE.smooth());
    for &(_, distance, ..) in &PLANETS {
        let orbit = view * Transform::scale(distance);
        canvas.draw_with(&behind, line, &orbit, &Flat::new(Rgb565::new(14, 28, 16)));
    }

    // A name has the place and the depth of its planet, but the same size at any distance.
    let font = [&FONT_4X6, &FONT_6X10][usize::from(frame.height > 100)];
    let above = Point::new(0, frame.height.cast_signed() / -12);
    for &(name, distance, angle, color) in &PLANETS {
        let style = MonoTextStyle::new(font, color.into());
        if let Some(at) = canvas.viewport().project(place(distance, angle), &view) {
            let text = Text::with_alignment(name, above, style, Alignment::Center);
            text.draw(&mut canvas.label(at))?;
        }
    }
    Ok(())
}

/// A place on an orbit about the origin.
fn place(distance: Scalar, angle: Angle) -> Vec3 {
    Transform::rotate_y(angle).point(Vec3::X * distance)
}
