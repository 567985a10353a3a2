//! A mirror, and shadows on the ground. The scene is drawn twice: in the mirror, and before it.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::canvas::{Biased, Multiply, Opacity, TestAndWrite, TestNearer, WriteOnly};
use fixel::prelude::*;

static SQUARE: Mesh = shape!(plane(1, 1));
static BOX: Mesh = shape!(cuboid(vec3!(0.6, 0.8, 0.6)));
static RING: Mesh = shape!(torus(fx!(0.35), 40, 20));

/// The scene, seen by the camera or by its mirror image.
fn scene(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>, view: Mvp) -> Result<(), Error> {
    let ground = Flat::new(Rgb565::new(17, 36, 15));
    canvas.draw(&SQUARE, &(view * Transform::scale(fx!(5))), &ground);
    let [left, right] = [vec3!(-0.8, 0.7, 0.4), vec3!(0.9, 0.4, 0.8)].map(Transform::translate);
    let tilt = Transform::rotate_x(deg!(70)) * Transform::scale(fx!(0.55));
    let ring = (&RING, left * tilt, Rgb565::new(31, 48, 8));
    let turn = Transform::rotate_y(deg!(30));
    let cube = (&BOX, right * turn, Rgb565::new(10, 34, 28));
    // A shadow is the mesh itself, pressed onto the ground. Each pixel is darkened once.
    let to_sun = vec3!(-2, 3, 1.2);
    let shadow = view * Transform::shadow(Vec3::ZERO, Vec3::Y, to_sun)?;
    let once = DrawOptions::new().with_depth_test(Biased::coplanar(TestNearer));
    let (dark, half) = (once.with_blending(Multiply), Rgb565::new(16, 32, 18));
    let sun = Light::new(to_sun, fx!(0.35), fx!(0.65))?;
    for (mesh, place, color) in [ring, cube] {
        canvas.draw_with(&dark, mesh, &(shadow * place), &Flat::new(half));
        canvas.draw(mesh, &(view * place), &Flat::new(color).lit(sun));
    }
    Ok(())
}

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(27), canvas.frame_size(), fx!(1), fx!(50))?;
    let camera = Camera::look_at(vec3!(-1.2, 4, 8), vec3!(0, 1, 0), Vec3::Y)?;
    let (middle, turn) = (vec3!(0.1, 1.4, -1), Transform::rotate_y(deg!(-6)));
    let upright = Transform::rotate_x(deg!(90));
    let size = upright * Transform::scale_axes(vec3!(2.1, 1, 1.2));
    let pane = projection * camera * Transform::translate(middle) * turn * size;
    canvas.clear(Rgb565::new(12, 32, 22));

    // An invisible cover hides all that follows, except through a hole at the mirror's pixels.
    let unseen = DrawOptions::new().with_blending(Opacity(0));
    let cover = projection * Transform::translate(vec3!(0, 0, -1.01)) * upright;
    canvas.draw_with(&unseen, &SQUARE, &cover, &Flat::new(Rgb565::BLACK));
    let hole = unseen.with_depth_test(Biased::new(WriteOnly, -65_535, fx!(0)));
    canvas.draw_with(&hole, &SQUARE, &pane, &Flat::new(Rgb565::BLACK));
    // Only the camera is mirrored. Lights and culling stay as they are.
    let mirrored = camera.mirrored(middle, turn.direction(Vec3::Z))?;
    scene(canvas, projection * mirrored)?;
    // The glass darkens the image a little, and stores its depth. Then comes the scene itself.
    canvas.clear_depth();
    let glass = DrawOptions::new().with_blending(Opacity(40));
    canvas.draw_with(&glass, &SQUARE, &pane, &Flat::new(Rgb565::BLACK));
    let frame = SQUARE.edges(LineStyle::wide(fx!(5))?);
    let in_front = DrawOptions::new().with_depth_test(Biased::new(TestAndWrite, 2, fx!(3)));
    canvas.draw_with(&in_front, frame, &pane, &Flat::new(Rgb565::new(26, 40, 12)));
    scene(canvas, projection * camera)
}
