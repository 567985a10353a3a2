//! A bird in two poses, and a flock of birds in poses between them.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics::{Drawable, geometry::Point, text::Text};
use fixel::mesh::Keyframes;
use fixel::prelude::*;

/// Wings up. Beak, back, two ends of the tail; for each wing, two roots, two elbows and a tip.
#[rustfmt::skip]
const UP: [Vec3; 14] = [
    vec3!(0, 0, -1), vec3!(0, 0.2, 0), vec3!(-0.3, 0.1, 1), vec3!(0.3, 0.1, 1),
    vec3!(-0.2, 0, -0.4), vec3!(-0.2, 0, 0.4), vec3!(-0.8, 0.6, -0.4), vec3!(-0.8, 0.6, 0.3),
    vec3!(-1.5, 1.5, 0.3),
    vec3!(0.2, 0, -0.4), vec3!(0.2, 0, 0.4), vec3!(0.8, 0.6, -0.4), vec3!(0.8, 0.6, 0.3),
    vec3!(1.5, 1.5, 0.3),
];

/// The same bird with its wings down.
const DOWN: [Vec3; 14] = {
    let mut pose = UP;
    (pose[6], pose[11]) = (vec3!(-1, -0.1, -0.4), vec3!(1, -0.1, -0.4));
    (pose[7], pose[12]) = (vec3!(-1, -0.1, 0.3), vec3!(1, -0.1, 0.3));
    (pose[8], pose[13]) = (vec3!(-1.7, -0.8, 0.3), vec3!(1.7, -0.8, 0.3));
    pose
};

#[rustfmt::skip]
static FACES: [[u16; 3]; 14] = [
    [0, 1, 4], [4, 1, 5], [5, 1, 2], [1, 3, 2], [1, 10, 3], [1, 9, 10], [0, 9, 1],
    [4, 7, 6], [4, 5, 7], [6, 7, 8], [9, 11, 12], [9, 12, 10], [11, 13, 12], [0, 4, 9],
];

static STROKE: Keyframes = Keyframes::checked(Keyframes::new(
    &Mesh::checked(Mesh::new(&UP, &FACES)),
    &Mesh::checked(Mesh::new(&DOWN, &FACES)),
));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let (size, screen) = (canvas.frame_size(), canvas.viewport());
    let projection = Projection::perspective(deg!(40), size, fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(0, 5, 8), vec3!(0, 0.4, 0), Vec3::Y)?;
    let sun = Light::new(vec3!(-1, 2, 1), fx!(0.35), fx!(0.65))?.two_sided(Viewer::of(&view));
    let white = Flat::rgb(Rgb888::new(250, 240, 225)).lit_faces(sun);
    let both_sides = DrawOptions::new().with_cull(Cull::Nothing);
    canvas.clear(Rgb565::new(9, 30, 22));
    let text = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    let mut positions = [Vec3::ZERO; UP.len()]; // one bird at a time
    for (i, share) in (0..5).zip(["0", "1/4", "1/2", "3/4", "1"]) {
        let bird = STROKE.blend(fx!(0.25) * i, &mut positions, &mut [])?;
        let place = vec3!(-3, -1.2, 1.2) + vec3!(1.5, 0.55, -0.8) * i;
        let mvp = view * Transform::translate(place) * Transform::rotate_y(deg!(140));
        canvas.draw_with(&both_sides, &bird, &mvp, &white);
        // The number stands below the bird's body.
        if let Some(at) = screen.project(place + vec3!(0.3, -0.6, 0), &view) {
            Text::new(share, Point::zero(), text).draw(&mut canvas.label(at))?;
        }
    }
    Ok(())
}
