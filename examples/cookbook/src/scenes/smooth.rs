//! A ring and a box with jagged edges on the left, and smoothed on the right.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::prelude::*;

static RING: Mesh = shape!(torus(fx!(0.3), 48, 20));
static BOX: Mesh = shape!(cuboid(vec3!(0.4, 0.9, 0.4)));
// A ring has silhouettes only. The sides of a box differ in color, so its creases are smoothed, too.
static OF_RING: Outline = outline!(RING, deg!(180));
static OF_BOX: Outline = outline!(BOX, deg!(30));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let half = size.width / 2;
    let projection = Projection::perspective(deg!(40), (half, size.height), fx!(1), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 1.4, 5), Vec3::ZERO, Vec3::Y)?;
    let view = projection * camera;
    let sun = Light::new(vec3!(-1, 2, 2), fx!(0.3), fx!(0.7))?;
    let orange = Flat::rgb(Rgb888::new(255, 150, 50)).lit(sun);
    let white = Flat::rgb(Rgb888::new(235, 235, 225)).lit_faces(sun);
    let ring = view * Transform::rotate_z(deg!(20)) * Transform::rotate_x(deg!(25));
    let column = view * Transform::rotate_z(deg!(-17)) * Transform::rotate_y(deg!(30));

    canvas.clear(Rgb565::new(3, 8, 8));
    for (left, is_smooth) in [(0, false), (half.cast_signed(), true)] {
        let part = Viewport::new(left, 0, half, size.height)?;
        let options = DrawOptions::new().with_viewport(part);
        canvas.draw_with(&options, &RING, &ring, &orange);
        canvas.draw_with(&options, &BOX, &column, &white);
        if is_smooth {
            canvas.smooth_edges(&options, &RING, &OF_RING, &ring);
            canvas.smooth_edges(&options, &BOX, &OF_BOX, &column);
        }
    }
    Ok(())
}
