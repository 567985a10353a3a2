//! A model in anti-aliased lines: its silhouettes and its creases, without hidden lines.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use fixel::canvas::{Biased, TestOnly};
use fixel::prelude::*;

static ISLAND: Mesh = include_mesh!("../../../assets/lighthouse.obj");
// An edge is a crease if the normals of its faces differ by more than 50 degrees.
static OUTLINE: Outline = include_outline!("../../../assets/lighthouse.obj", crease = 50);

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let size = canvas.frame_size();
    let projection = Projection::perspective(deg!(43), size, fx!(1), fx!(50))?;
    let camera = Camera::look_at(vec3!(3.6, 3.3, 9.4), vec3!(0.1, 1.45, 0), Vec3::Y)?;
    let view = projection * camera;
    let (paper, ink) = (Rgb888::new(244, 238, 222), Rgb888::new(24, 44, 96));
    canvas.clear(paper.into());

    // The faces hide the lines behind them. So that its own two faces do not hide a line, the line
    // is drawn nearer to the eye: by two steps of the depth buffer, and by the change of depth
    // within half a pixel.
    canvas.draw(&ISLAND, &view, &Flat::rgb(paper));
    let lines = ISLAND.outline(&OUTLINE, LineStyle::HAIRLINE.smooth());
    let in_front = DrawOptions::new().with_depth_test(Biased::new(TestOnly, 2, fx!(0.5)));
    canvas.draw_with(&in_front, lines, &view, &Flat::rgb(ink));
    Ok(())
}
