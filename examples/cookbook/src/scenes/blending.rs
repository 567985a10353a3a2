//! Glass, a shadow, the glow of a lamp and smoke.

use embedded_graphics::pixelcolor::{Gray8, Rgb565, Rgb888, RgbColor};
use fixel::canvas::{Add, Multiply, Opacity, TestOnly};
use fixel::prelude::*;

static SQUARE: Mesh = shape!(plane(1, 1));
static BALL: Mesh = shape!(sphere(32, 24));
static WHITE: [[Rgb565; 32]; 32] = [[Rgb565::WHITE; 32]; 32];
/// A round cloud, which is thickest in the middle.
static CLOUD: [[Gray8; 32]; 32] = {
    let mut texels = [[Gray8::new(0); 32]; 32];
    let mut at = 0_usize;
    while at < 1024 {
        let (x, y) = ((2 * (at % 32)).abs_diff(31), (2 * (at / 32)).abs_diff(31));
        texels[at / 32][at % 32] = Gray8::new((961_usize.saturating_sub(x * x + y * y) / 5) as u8);
        at += 1;
    }
    texels
};

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(40), canvas.frame_size(), fx!(0.5), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(1, 2.4, 7), vec3!(0.2, 1.2, 0), Vec3::Y)?;
    let at = |place, size| view * Transform::translate(place) * Transform::scale(size);

    // Opaque surfaces come first.
    canvas.clear(Rgb565::new(5, 12, 9));
    let sand = Flat::new(Rgb565::new(19, 36, 15));
    canvas.draw(&SQUARE, &at(Vec3::ZERO, fx!(4)), &sand);
    let sun = Light::new(vec3!(-2, 4, 3), fx!(0.3), fx!(0.7))?;
    let red = Flat::rgb(Rgb888::new(230, 60, 40)).lit(sun);
    canvas.draw(&BALL, &at(vec3!(-0.2, 0.8, -0.5), fx!(0.8)), &red);

    // Blended surfaces follow, from back to front. Blended surfaces write no depths.
    let seen = DrawOptions::new().with_depth_test(TestOnly);
    let shadow = at(vec3!(0.3, 0.02, -1.1), fx!(1)) * Transform::scale_axes(vec3!(1, 0.01, 0.8));
    let dark = Flat::new(Rgb565::new(14, 28, 16));
    canvas.draw_with(&seen.with_blending(Multiply), &BALL, &shadow, &dark);
    let cloud = Textured::new(&WHITE).clamped().bilinear().masked(&CLOUD)?;
    let light = cloud.map(|_, at| Some(Rgb565::new(at.opacity >> 3, at.opacity >> 3, 0)));
    let lamp = [vec3!(-0.2, 2.6, -0.5)];
    let glow = Sprites::new(&lamp, (fx!(3.2), fx!(3.2)))?;
    canvas.draw_with(&seen.with_blending(Add), &glow, &view, &light);
    let glass = seen.with_cull(Cull::Nothing).with_blending(Opacity(120));
    let blue = (vec3!(-1.3, 1.1, 0.9), deg!(35), Rgb565::new(4, 34, 31));
    let yellow = (vec3!(0.6, 1.1, 0.9), deg!(-30), Rgb565::new(31, 44, 4));
    for (place, turn, color) in [blue, yellow] {
        let turn = Transform::rotate_y(turn) * Transform::rotate_x(deg!(90));
        let pane = at(place, fx!(1)) * turn;
        canvas.draw_with(&glass, &SQUARE, &pane, &Flat::new(color));
    }
    let puffs = [fx!(0.5), fx!(1.2), fx!(2)].map(|y| Vec3::new(fx!(2.3), y, fx!(0.8)));
    let smoke = Sprites::new(&puffs, (fx!(2), fx!(2)))?;
    let smoke = smoke.with_scales(&[fx!(0.5), fx!(0.7), fx!(0.9)])?;
    canvas.draw_with(&seen, &smoke, &view, &cloud);
    Ok(())
}
