//! Draws two linked rings in the sun, and saves the picture as rings.png.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, raw::ToBytes};
use fixel::prelude::*;

// A tube of radius 0.25, in flash. For your own model: include_mesh!("model.glb").
static RING: Mesh = shape!(torus(fx!(0.25), 64, 24));

fn draw(color: &mut [Rgb565], depth: &mut [u16]) -> Result<(), Error> {
    let mut canvas = Canvas::new(color, 320, 240)?.with_depth(depth)?; // your memory
    let projection = Projection::perspective(deg!(45), (320, 240), fx!(0.5), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    let view = projection * camera;
    let sun = Light::new(vec3!(-1, 3, 2), fx!(0.25), fx!(0.75))?; // ambient, diffuse
    let orange = Flat::rgb(Rgb888::new(255, 150, 50)).lit(sun);
    let blue = Flat::rgb(Rgb888::new(70, 140, 230)).lit(sun);
    let left = view * Transform::translate(vec3!(-0.4, 0, 0)) * Transform::rotate_z(deg!(25));
    let right = view * Transform::translate(vec3!(0.4, 0, 0)) * Transform::rotate_x(deg!(70));
    canvas.clear(Rgb565::new(3, 8, 8));
    canvas.draw(&RING, &left, &orange);
    canvas.draw(&RING, &right, &blue);
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (mut color, mut depth) = (vec![Rgb565::default(); 320 * 240], vec![0; 320 * 240]);
    draw(&mut color, &mut depth)?;
    let bytes = |&pixel| Rgb888::from(pixel).to_be_bytes();
    let bytes: Vec<u8> = color.iter().flat_map(bytes).collect();
    let mut picture = png::Encoder::new(std::fs::File::create("rings.png")?, 320, 240);
    picture.set_color(png::ColorType::Rgb);
    Ok(picture.write_header()?.write_image_data(&bytes)?)
}
