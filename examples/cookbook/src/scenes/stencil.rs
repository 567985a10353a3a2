//! Windows into another world: invisible panes store depths, and a planet is drawn only behind them.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::canvas::{Biased, Opacity, TestAndWrite, TestBehind};
use fixel::prelude::*;

static SQUARE: Mesh = shape!(plane(1, 1));
static BALL: Mesh = shape!(sphere(32, 24));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(40), canvas.frame_size(), fx!(1), fx!(50))?;
    let camera = Camera::look_at(vec3!(0.6, 2.4, 7), vec3!(0, 1.2, 0), Vec3::Y)?;
    let view = projection * camera;
    let sun = Light::new(vec3!(-2, 3, 1), fx!(0.3), fx!(0.7))?;
    let options = DrawOptions::new();
    canvas.clear(Rgb565::new(2, 6, 8));

    // A pane of opacity 0 changes no color, and stores its depth.
    let panes = [(fx!(-1.5), 24), (fx!(0), 0), (fx!(1.5), -24)].map(|(x, turn)| {
        let place = Vec3::new(x, fx!(1.3), fx!(0));
        let turn = Transform::rotate_y(Angle::from_degrees(turn)) * Transform::rotate_x(deg!(90));
        view * Transform::translate(place) * turn * Transform::scale_axes(vec3!(0.6, 1, 1))
    });
    let only_depth = options.with_blending(Opacity(0));
    for pane in &panes {
        canvas.draw_with(&only_depth, &SQUARE, pane, &Flat::new(Rgb565::BLACK));
    }
    // Elsewhere, the stored depth is infinitely far, and nothing is behind it. So the planet is seen
    // only through the panes. `TestBehind` stores no depths: draw the farthest things first.
    let behind = options.with_depth_test(TestBehind);
    let planet = Flat::rgb(Rgb888::new(120, 190, 255)).lit(sun);
    let far = view * Transform::translate(vec3!(0, 1.3, -2.5)) * Transform::scale(fx!(2));
    canvas.draw_with(&behind, &BALL, &far, &planet);

    // What comes later is hidden by the panes, as if there were glass.
    let floor = view * Transform::scale(fx!(4));
    canvas.draw(&SQUARE, &floor, &Flat::new(Rgb565::new(12, 22, 8)));
    // A pixel of a frame is up to two pixels from the pane's edge, so its depth moves by two steps.
    let frame = SQUARE.edges(LineStyle::wide(fx!(4))?);
    let in_front = options.with_depth_test(Biased::new(TestAndWrite, 2, fx!(2)));
    for pane in &panes {
        canvas.draw_with(&in_front, frame, pane, &Flat::new(Rgb565::new(26, 44, 14)));
    }
    Ok(())
}
