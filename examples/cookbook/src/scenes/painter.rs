//! Rings within rings without a depth buffer: all triangles are sorted from back to front.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::canvas::NoTest;
use fixel::prelude::*;

static RING: Mesh = shape!(torus(fx!(0.14), 36, 8));
static BALL: Mesh = shape!(sphere(20, 14));

/// Memory for the visible triangles: 45 KiB. A depth buffer of 320x240 takes 150 KiB.
type List = DrawList<1300, 1600>;

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let frame = canvas.frame_size();
    let projection = Projection::perspective(deg!(40), frame, fx!(1), fx!(20))?;
    let view = projection * Camera::look_at(vec3!(0, 1.5, 3.3), Vec3::ZERO, Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 4, 3), fx!(0.25), fx!(0.75))?;
    let color = |r, g, b| Flat::rgb(Rgb888::new(r, g, b)).lit(sun);

    // Each ring hangs in the ring around it. Each object has a mesh, a transform and a shader.
    let upright = Transform::rotate_x(deg!(80));
    let outer = Transform::rotate_y(deg!(30)) * upright;
    let middle = outer * Transform::rotate_x(deg!(50)) * Transform::scale(fx!(0.74));
    let inner = middle * Transform::rotate_z(deg!(60)) * upright * Transform::scale(fx!(0.74));
    let mut objects = [
        Object::new(&BALL, Transform::scale(fx!(0.3)), color(255, 230, 150)),
        Object::new(&RING, inner, color(90, 200, 170)),
        Object::new(&RING, middle, color(90, 140, 230)),
        Object::new(&RING, outer, color(230, 110, 90)),
    ];

    // Sort once a frame, for all of its bands. On a microcontroller, the list is a static.
    let mut list = List::new();
    let options = DrawOptions::new().with_depth_test(NoTest);
    let scene = list.prepare_back_to_front(&options, frame, &mut objects, &view)?;

    canvas.clear(Rgb565::new(2, 5, 5));
    for (shader, triangles) in scene.parts(canvas)? {
        canvas.draw_prepared(&triangles, shader)?;
    }
    Ok(())
}
