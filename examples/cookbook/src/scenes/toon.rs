//! A cartoon: light in three steps, and a black line around each shape.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::canvas::{Biased, TestAndWrite};
use fixel::prelude::*;

static BALL: Mesh = shape!(sphere(32, 24));
static EDGES: Outline = outline!(BALL, deg!(60));
static RIPPLE: Mesh = shape!(torus(fx!(0.02), 64, 6));

/// The colors in shadow, in light and in a highlight.
type Ink = [Rgb565; 3];
#[rustfmt::skip]
const YELLOW: Ink = [Rgb565::new(27, 38, 1), Rgb565::new(31, 53, 4), Rgb565::new(31, 60, 18)];
#[rustfmt::skip]
const ORANGE: Ink = [Rgb565::new(24, 20, 1), Rgb565::new(31, 32, 2), Rgb565::new(31, 44, 10)];
const BLACK: Ink = [Rgb565::BLACK, Rgb565::BLACK, Rgb565::WHITE];

/// The parts of a duck: their places, their radii along the axes, and their colors.
static DUCK: [(Vec3, Vec3, Ink); 6] = [
    (vec3!(0, 0, 0), vec3!(1.25, 0.8, 0.95), YELLOW),
    (vec3!(-1.1, 0.45, 0), vec3!(0.4, 0.3, 0.3), YELLOW),
    (vec3!(0.75, 1.2, 0), vec3!(0.7, 0.66, 0.66), YELLOW),
    (vec3!(-0.1, 0.15, 0.85), vec3!(0.65, 0.38, 0.2), YELLOW),
    (vec3!(1.4, 1.1, 0), vec3!(0.42, 0.13, 0.34), ORANGE),
    (vec3!(1.1, 1.4, 0.52), vec3!(0.1, 0.13, 0.1), BLACK),
];

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>, ms: u64) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(35), size, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(1.5, 2.4, 6), vec3!(0.1, 0.55, 0), Vec3::Y)?;
    let sun = Light::new(vec3!(1, 3, 2), fx!(0), fx!(1))?;
    let width = LineStyle::wide(fx!(1) + Scalar::try_from(size.height)? / 120)?;
    let in_front = DrawOptions::new().with_depth_test(Biased::in_front(TestAndWrite));
    canvas.clear(Rgb565::new(10, 45, 29));
    // The duck rocks once in two seconds, and each ripple takes the place of the next one.
    let wave = Rate::millihertz(500).angle_at(ms);
    let rocking = view * Transform::rotate_z(Angle::from_turns(fx!(0.015) * wave.sin()));
    let way = Scalar::from((ms % 1000) as i16) / 1000;
    for at in 0..3_i16 {
        let radius = fx!(1.5) + fx!(0.6) * (way + Scalar::from(at));
        let ripple = view * Transform::translate(vec3!(0, -0.35, 0)) * Transform::scale(radius);
        canvas.draw(&RIPPLE, &ripple, &Flat::new(Rgb565::new(22, 57, 31)));
    }
    for (place, radii, ink) in DUCK {
        let mvp = rocking * Transform::translate(place) * Transform::scale_axes(radii);
        let steps = Flat::new(Rgb565::WHITE).lit(sun).map(move |at, lit| {
            let green = lit.finish(at.point).g(); // white is 63
            let step = usize::from(green > 26) + usize::from(green > 59);
            Some(ink[step])
        });
        canvas.draw(&BALL, &mvp, &steps);
        let lines = BALL.outline(&EDGES, width);
        canvas.draw_with(&in_front, lines, &mvp, &Flat::new(Rgb565::BLACK));
    }
    Ok(())
}
