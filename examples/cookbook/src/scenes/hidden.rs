//! A ring is seen through a wall, a box shows its hidden lines, and a shadow darkens each pixel once.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::canvas::{Biased, Multiply, Opacity, TestAndWrite, TestBehind, TestNearer};
use fixel::prelude::*;

static SQUARE: Mesh = shape!(plane(1, 1));
static RING: Mesh = shape!(torus(fx!(0.4), 32, 16));
static BOX: Mesh = shape!(cuboid(vec3!(0.9, 0.9, 0.9)));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(36), canvas.frame_size(), fx!(1), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(0, 4.4, 9), vec3!(0, 0.9, 0), Vec3::Y)?;
    let at = |place| view * Transform::translate(place);
    let upright = Transform::rotate_x(deg!(90));
    let to_sun = vec3!(-2, 3, 1);
    let sun = Light::new(to_sun, fx!(0.3), fx!(0.7))?;
    let paint = |red, green, blue| Flat::new(Rgb565::new(red, green, blue));
    canvas.clear(Rgb565::new(6, 16, 12));

    // A shadow is the ring, pressed flat onto the ground along the rays of the sun. Each pixel of the
    // shadow is darkened once.
    let floor = at(Vec3::ZERO) * Transform::scale(fx!(6));
    canvas.draw(&SQUARE, &floor, &paint(15, 30, 12));
    let turn = Transform::rotate_y(deg!(-25)) * upright;
    let ring = Transform::translate(vec3!(-2.7, 1.5, -0.6)) * turn;
    let shadow = view * Transform::shadow(Vec3::ZERO, Vec3::Y, to_sun)? * ring;
    let once = DrawOptions::new().with_depth_test(Biased::coplanar(TestNearer));
    let dark = once.with_blending(Multiply);
    canvas.draw_with(&dark, &RING, &shadow, &paint(14, 28, 18));

    // A wall hides the ring. Behind the wall, the ring is drawn in one color.
    let wall = at(vec3!(-2.9, 0.7, 1)) * upright * Transform::scale_axes(vec3!(0.9, 1, 0.7));
    canvas.draw(&SQUARE, &wall, &paint(20, 36, 18));
    let gold = Flat::rgb(Rgb888::new(255, 196, 64)).lit(sun);
    canvas.draw(&RING, &(view * ring), &gold);
    let behind = DrawOptions::new().with_depth_test(TestBehind);
    canvas.draw_with(&behind, &RING, &(view * ring), &paint(26, 40, 12));

    // The faces of a box only store depths. Its visible lines are white, its hidden lines are gray.
    let turned = at(vec3!(0.7, 0.95, 1.2)) * Transform::rotate_y(deg!(28));
    let faces = DrawOptions::new().with_depth_test(Biased::behind(TestAndWrite));
    canvas.draw_with(
        &faces.with_blending(Opacity(0)),
        &BOX,
        &turned,
        &paint(0, 0, 0),
    );
    let lines = BOX.edges(LineStyle::wide(fx!(1.5))?);
    canvas.draw_with(&behind, lines, &turned, &paint(12, 24, 12));
    canvas.draw(lines, &turned, &Flat::new(Rgb565::WHITE));
    Ok(())
}
