//! A model and its texture, from the files that a modeling program saves.

use embedded_graphics::pixelcolor::Rgb565;
use fixel::mesh::Part;
use fixel::prelude::*;

static BALLOON: Mesh = include_mesh!("../../../assets/balloon.glb", quantized);
static PARTS: &[Part] = include_materials!("../../../assets/balloon.glb");
static SILK: [[Rgb565; 64]; 64] = include_texture!("../../../assets/balloon.png");

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>, ms: u64) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(45), size, fx!(0.5), fx!(100))?;
    let view = projection * Camera::look_at(vec3!(0, 0.4, 6), vec3!(0, 0.8, 0), Vec3::Y)?;
    let sun = Light::new(vec3!(-2, 2, 3), fx!(0.45), fx!(0.55))?;
    canvas.clear(Rgb565::new(17, 45, 29));

    let places = [
        vec3!(-1, 0.3, 0.8),
        vec3!(2, 0.9, -3),
        vec3!(-8.4, -4.2, -14),
        vec3!(5, -3, -12),
    ];
    let turn = Rate::millihertz(250).angle_at(ms);
    for (at, place) in (0..).zip(places) {
        let phase = turn + Angle::from_degrees(25 * at);
        let rise = Vec3::Y * (fx!(0.2) * phase.sin());
        let mvp = view * Transform::translate(place + rise) * Transform::rotate_y(phase);
        for part in PARTS {
            let mesh = BALLOON.part(part.faces());
            match part.material.texture {
                Some(_) => canvas.draw(&mesh, &mvp, &Textured::new(&SILK).lit(sun)),
                None => canvas.draw(&mesh, &mvp, &Flat::rgb(part.material.color).lit_faces(sun)),
            };
        }
    }
    Ok(())
}
