//! A sky of six textures: the sides of a cube, seen from inside.

use core::array::from_fn;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::canvas::NoTest;
use fixel::prelude::*;

static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
static ROCK: Mesh = shape!(sphere(9, 6));

/// The color of stars and gas in a direction. (Your textures can come from files, with `include_texture!`.)
fn space(direction: Vec3) -> Rgb565 {
    let wave = |along: Vec3| fx!(1) * Angle::from_turns(direction.dot(along)).sin();
    let bent = wave(vec3!(0.5, 0.2, 0.6)) / 4 + wave(vec3!(0.3, 1.1, -0.7)) / 8;
    let gas = fx!(1) - (direction.dot(vec3!(0.3, 0.9, 0.2)) + bent).abs() * 2;
    let red = wave(vec3!(0.4, 0.3, 0.1)) / 2 + fx!(0.5);
    let [x, y, z] = direction.to_bits().map(|bits| bits >> 10);
    let random = x * 7919 + y * 5381 + z * 9973;
    if random.wrapping_mul(random) >> 9 & 255 < 2 {
        return Rgb565::WHITE;
    }
    let [r, g, b] = [gas * red * 20, gas * (fx!(1) - red) * 24, gas * 24]
        .map(|light| light.max(fx!(0)).floor().cast_unsigned() as u8);
    Rgb565::new(r, g, 4 + b)
}

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(60), canvas.frame_size(), fx!(0.5), fx!(50))?;
    let camera = Camera::look_at(vec3!(2, 1, 6), Vec3::ZERO, Vec3::Y)?;
    // The cube is mirrored, so that a viewer inside sees its sides the right way round.
    let around = projection * camera.sky() * Transform::scale_axes(vec3!(-10, 10, 10));
    let behind = DrawOptions::new()
        .with_depth_test(NoTest)
        .with_cull(Cull::Front);
    for side in 0..6 {
        let turn = match side {
            0..4 => Transform::rotate_y([deg!(0), deg!(-90), deg!(180), deg!(90)][side]),
            4 => Transform::rotate_x(deg!(-90)),
            _ => Transform::rotate_x(deg!(90)),
        };
        let part = |at: usize| (fx!(31.5) - Scalar::from(at as u8)) / 32;
        let texel = |y, x| space(turn.point(Vec3::new(part(x), part(y), fx!(1))));
        let texture: [[Rgb565; 64]; 64] = from_fn(|y| from_fn(|x| texel(y, x)));
        let side = CUBE.part(2 * side..2 * side + 2);
        let shader = Textured::new(&texture).clamped().bilinear();
        canvas.draw_with(&behind, &side, &around, &shader);
    }
    let sun = Light::new(vec3!(3, 2, 1), fx!(0.1), fx!(0.9))?;
    let stone = Flat::rgb(Rgb888::new(170, 150, 130)).lit_faces(sun);
    for (x, y, size) in [(-1, 0, 6_i16), (2, 1, 3), (2, -1, 2)] {
        let place = projection * camera * Transform::translate(Vec3::from_ints(x, y, 0));
        let rock = place * Transform::rotate_z(deg!(40)) * Transform::scale(Scalar::from(size) / 4);
        canvas.draw(&ROCK, &rock, &stone);
    }
    Ok(())
}
