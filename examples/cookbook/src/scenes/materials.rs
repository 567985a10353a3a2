//! A model with materials: colors, and a texture that the program finds by its name.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::mesh::Part;
use fixel::prelude::*;
use fixel::shade::PartColors;

static CABIN: Mesh = include_mesh!("../../../assets/cabin.obj");
static PARTS: &[Part] = include_materials!("../../../assets/cabin.obj");
static PLANKS: [[Rgb565; 32]; 32] = include_texture!("../../../assets/planks.tga");
static MEADOW: Mesh = shape!(plane(8, 8));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(45), size, fx!(0.5), fx!(50))?;
    let sun = Light::new(vec3!(2, 3, 4), fx!(0.4), fx!(0.6))?;
    canvas.clear(Rgb565::new(18, 46, 28));

    let near = projection * Camera::look_at(vec3!(4, 2.2, 7), vec3!(1.2, 1.3, 0), Vec3::Y)?;
    let meadow = Transform::translate(vec3!(0, -0.35, 0)) * Transform::scale(fx!(20));
    let grass = Flat::rgb(Rgb888::new(110, 150, 80)).lit_faces(sun);
    canvas.draw(&MEADOW, &(near * meadow), &grass);

    // Draw each part with its texture or its color.
    for part in PARTS {
        let mesh = CABIN.part(part.faces());
        match part.material.texture {
            Some("planks.tga") => {
                let planks = Textured::new(&PLANKS).lit_faces(sun);
                canvas.draw(&mesh, &near, &planks)
            }
            _ => canvas.draw(&mesh, &near, &Flat::rgb(part.material.color).lit_faces(sun)),
        };
    }

    // Draw all parts in one call, in their colors: this cabin is too far away to show its planks.
    let far = near * Transform::translate(vec3!(4, 0, -14));
    canvas.draw(&CABIN, &far, &PartColors::rgb(PARTS).lit_faces(sun));
    Ok(())
}
