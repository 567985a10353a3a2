//! Levels of detail: the fewer pixels an apple covers, the fewer triangles it has.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::canvas::{Biased, Opacity, TestAndWrite};
use fixel::mesh::Bounds;
use fixel::prelude::*;

static FLOOR: Mesh = shape!(plane(1, 1));
static FINE: Mesh = shape!(sphere(24, 16));
static MIDDLE: Mesh = shape!(sphere(12, 8));
static COARSE: Mesh = shape!(sphere(6, 4));
static BOUNDS: Bounds = FINE.bounds();

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(50), size, fx!(0.5), fx!(100))?;
    let view = projection * Camera::look_at(vec3!(-3, 3, 5), vec3!(0, 0, -6), Vec3::Y)?;
    let sun = Light::new(vec3!(2, 3, 2), fx!(0.4), fx!(0.6))?;
    let haze = Rgb565::new(21, 46, 26);
    let fog = Fog::exponential(haze, fx!(0.025))?;
    let options = DrawOptions::new();
    let lines = options.with_blending(Opacity(90));
    let behind = options.with_depth_test(Biased::behind(TestAndWrite));

    canvas.clear(haze);
    let grass = Flat::rgb(Rgb888::new(105, 150, 75)).in_fog(fog);
    let floor = Transform::translate(vec3!(0, -1, 0)) * Transform::scale(fx!(90));
    canvas.draw(&FLOOR, &(view * floor), &grass);
    for row in 0..8_i16 {
        for column in -3..=3_i16 {
            let place = Vec3::from_ints(4 * column, 0, -4 * row);
            let mvp = view * Transform::translate(place);
            // This test takes less time than a draw call that draws nothing.
            if !canvas.is_in_view(&options, &BOUNDS, &mvp) {
                continue;
            }
            // The diagonal of the box around the apple, in pixels and then in percent of the frame's height.
            let pixels = canvas.viewport().size_on_screen(&BOUNDS, &mvp);
            let (mesh, color) = match pixels.saturating_mul(100) / size.height {
                40.. => (&FINE, Rgb888::new(235, 60, 40)),
                20.. => (&MIDDLE, Rgb888::new(245, 190, 50)),
                _ => (&COARSE, Rgb888::new(70, 120, 230)),
            };
            let skin = Flat::rgb(color).lit_faces(sun).in_fog(fog);
            canvas.draw_with(&behind, mesh, &mvp, &skin);
            let (edges, black) = (mesh.edges(LineStyle::HAIRLINE), Flat::new(Rgb565::BLACK));
            canvas.draw_with(&lines, edges, &mvp, &black.in_fog(fog));
        }
    }
    Ok(())
}
