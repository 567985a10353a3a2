//! An evening sky: its colors change with height, and the glow of the sun is added.

use embedded_graphics::pixelcolor::{Gray8, GrayColor, Rgb565, Rgb888};
use fixel::canvas::{Add, NoTest};
use fixel::prelude::*;
use fixel::shade::Gradient;

static DOME: Mesh = shape!(sphere(24, 16));
static SEA: Mesh = shape!(plane(1, 1));
static ROCK: Mesh = shape!(sphere(7, 4));
/// A texture of the light around the sun, which fades from the middle to the edge.
static GLOW: [[Gray8; 64]; 64] = {
    let mut texels = [[Gray8::new(0); 64]; 64];
    let mut at = 0_usize;
    while at < 64 * 64 {
        let (x, y) = ((2 * (at % 64)).abs_diff(63), (2 * (at / 64)).abs_diff(63));
        let inside = 3969_usize.saturating_sub(x * x + y * y);
        texels[at / 64][at % 64] = Gray8::new((inside * inside / 61_776) as u8);
        at += 1;
    }
    texels
};

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(60), canvas.frame_size(), fx!(0.5), fx!(200))?;
    let camera = Camera::look_at(vec3!(3, 3, 20), vec3!(0, 6.5, -10), Vec3::Y)?;

    // The camera stays in the center of the sky. Nothing is behind the sky, so depths are not needed.
    let around = projection * camera.sky();
    let behind = DrawOptions::new()
        .with_depth_test(NoTest)
        .with_cull(Cull::Front);
    let horizon = Rgb888::new(255, 170, 90);
    let evening = Gradient::new((fx!(0), horizon), (fx!(0.7), Rgb888::new(30, 50, 120)))?;
    let dome = around * Transform::scale(fx!(100));
    canvas.draw_with(&behind, &DOME, &dome, &evening);
    let sun = [vec3!(20, 10, -80)];
    let light = Textured::new(&GLOW).clamped().bilinear().map(|_, gray| {
        let red = gray.luma() >> 3;
        Some(Rgb565::new(red, red + red / 2, red / 3))
    });
    for size in [fx!(70), fx!(44)] {
        let glow = Sprites::new(&sun, (size, size))?;
        canvas.draw_with(&behind.with_blending(Add), &glow, &around, &light);
    }

    let fog = Fog::linear(Rgb565::from(horizon), fx!(20), fx!(150))?;
    let water = Flat::rgb(Rgb888::new(60, 70, 110)).in_fog(fog);
    let view = projection * camera;
    canvas.draw(&SEA, &(view * Transform::scale(fx!(200))), &water);
    let low_sun = Light::new(vec3!(2, 1, -3), fx!(0.25), fx!(0.75))?;
    let stone = Flat::rgb(Rgb888::new(110, 90, 90)).lit_faces(low_sun);
    for (x, z, size) in [(-9, -6, 3_i16), (-4, -22, 5), (12, -30, 7), (8, 4, 2)] {
        let place = view * Transform::translate(Vec3::from_ints(x, 0, z));
        let rock = place * Transform::scale(Scalar::from(size));
        canvas.draw(&ROCK, &rock, &stone.in_fog(fog));
    }
    Ok(())
}
