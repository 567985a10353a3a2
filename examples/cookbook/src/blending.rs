//! Glass, a shadow, the glow of a lamp and smoke.

use embedded_graphics::pixelcolor::{Gray8, Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::target::{Add, Alpha, Depth, Multiply, Native, Opacity, TestOnly};

static SQUARE: Mesh = shape!(plane(1, 1));
static BALL: Mesh = shape!(sphere(32, 24));
static WHITE: TextureArray<Rgb565, 32, 32> = TextureArray::from_texels([[Rgb565::WHITE; 32]; 32]);
/// A round cloud, which is thickest in the middle.
static CLOUD: TextureArray<Gray8, 32, 32> = {
    let mut texels = [[Gray8::new(0); 32]; 32];
    let mut at = 0_usize;
    while at < 1024 {
        let (x, y) = ((2 * (at % 32)).abs_diff(31), (2 * (at / 32)).abs_diff(31));
        if x * x + y * y < 961 {
            texels[at / 32][at % 32] = Gray8::new(((961 - x * x - y * y) / 5) as u8);
        }
        at += 1;
    }
    TextureArray::from_texels(texels)
};

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, Depth<'_>>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(45), (4, 3), fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(1, 2.4, 7), vec3!(0, 1, 0), Vec3::Y)?;
    let at =
        |place, turn, size| view * (Transform::translate(place) * turn * Transform::scale(size));
    let upright = Transform::rotate_x(deg!(90));

    // Opaque surfaces come first.
    canvas.clear(Rgb565::new(5, 12, 9));
    let floor = Flat::new(Rgb565::new(19, 36, 15));
    canvas.draw(
        &SQUARE,
        &at(Vec3::ZERO, Transform::IDENTITY, fx!(4)),
        &floor,
    );
    let sun = Light::new(vec3!(-2, 4, 3), fx!(0.3), fx!(0.7))?;
    let red = Flat::rgb(Rgb888::new(230, 60, 40)).lit(sun);
    canvas.draw(&BALL, &at(vec3!(-0.2, 0.8, -0.5), upright, fx!(0.8)), &red);

    // Blended surfaces follow, from back to front. They do not write depth, so they hide nothing that is drawn later.
    let seen = DrawOptions::new()
        .with_depth(TestOnly)
        .with_cull(Cull::Nothing);
    let flat = Transform::scale_axes(vec3!(1, 0.01, 0.8));
    let (shadow, dark) = (
        at(vec3!(0.3, 0.02, -1.1), flat, fx!(1)),
        Rgb565::new(14, 28, 16),
    );
    canvas.draw_with(
        &seen.with_blending(Multiply).with_cull(Cull::Back),
        &BALL,
        &shadow,
        &Flat::new(dark),
    );
    let cloud = Textured::new(&WHITE).clamped().bilinear().masked(&CLOUD)?;
    let glow = cloud.map(|_, white| Some(Rgb565::new(white.opacity >> 3, white.opacity >> 3, 0)));
    let lamp = at(vec3!(-0.2, 2.6, -0.5), upright, fx!(1.6));
    canvas.draw_with(&seen.with_blending(Add), &SQUARE, &lamp, &glow);
    for (x, turn, color) in [
        (fx!(-1.3), 35, Rgb565::new(4, 34, 31)),
        (fx!(0.6), -30, Rgb565::new(31, 44, 4)),
    ] {
        let turn = Transform::rotate_y(Angle::from_degrees(turn)) * upright;
        let pane = at(Vec3::new(x, fx!(1.1), fx!(0.9)), turn, fx!(1));
        canvas.draw_with(
            &seen.with_blending(Opacity(120)),
            &SQUARE,
            &pane,
            &Flat::new(color),
        );
    }
    for (height, size) in [
        (fx!(0.5), fx!(0.5)),
        (fx!(1.2), fx!(0.7)),
        (fx!(2), fx!(0.9)),
    ] {
        let puff = at(Vec3::new(fx!(2.3), height, fx!(0.8)), upright, size);
        canvas.draw_with(&seen.with_blending(Alpha), &SQUARE, &puff, &cloud);
    }
    Ok(())
}
