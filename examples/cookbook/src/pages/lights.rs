//! Pictures of lights.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

use super::{BALL, Drawn, FLOOR, RING, SLATE, ring, view};
use crate::scenes::Frame;

/// A lamp above a floor and a ball.
fn under<L: Lighting>(canvas: &mut Frame<'_>, light: L) -> Drawn {
    let projection = Projection::perspective(deg!(32), canvas.frame_size(), fx!(0.5), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 3, 6), vec3!(0, 0.5, 0), Vec3::Y)?;
    canvas.clear(Rgb565::BLACK);
    let white = Flat::rgb(Rgb888::new(240, 235, 225)).lit(light);
    let at = |y| projection * camera * Transform::translate(Vec3::new(fx!(0), y, fx!(0)));
    canvas.draw(&FLOOR, &(at(fx!(0)) * Transform::scale(fx!(5))), &white);
    canvas.draw(&BALL, &(at(fx!(0.8)) * Transform::scale(fx!(0.8))), &white);
    Ok(())
}

pub(super) fn light(canvas: &mut Frame<'_>) -> Drawn {
    under(canvas, Light::new(vec3!(-2, 2, 1), fx!(0.2), fx!(0.8))?)
}

pub(super) fn point_light(canvas: &mut Frame<'_>) -> Drawn {
    under(
        canvas,
        PointLight::new(vec3!(-1.5, 0.9, 0.9), fx!(1), fx!(4))?,
    )
}

pub(super) fn spot_light(canvas: &mut Frame<'_>) -> Drawn {
    let axis = vec3!(2, -3, -0.5);
    under(
        canvas,
        SpotLight::new(
            vec3!(-2, 3.5, 0.6),
            axis,
            (deg!(14), deg!(20)),
            fx!(1),
            fx!(9),
        )?,
    )
}

pub(super) fn shiny(canvas: &mut Frame<'_>) -> Drawn {
    let viewer = Viewer::of(&view(canvas)?);
    let light = Light::new(vec3!(-1, 3, 2), fx!(0.2), fx!(0.5))?.shiny(viewer, 30, fx!(0.7))?;
    ring(
        canvas,
        &RING,
        &Flat::rgb(Rgb888::new(200, 60, 40)).lit(light),
    )
}

pub(super) fn colored(canvas: &mut Frame<'_>) -> Drawn {
    let red =
        PointLight::new(vec3!(-2, 1.2, 0.8), fx!(1), fx!(5))?.colored(Rgb888::new(255, 70, 40));
    let blue =
        PointLight::new(vec3!(2, 1.2, 0.8), fx!(1), fx!(5))?.colored(Rgb888::new(60, 100, 255));
    under(canvas, [red, blue])
}

/// The same open bowl twice: without and with the adapter for two-sided light.
pub(super) fn two_sided(canvas: &mut Frame<'_>) -> Drawn {
    const PROFILE: &[(Scalar, Scalar)] = &[
        (fx!(1), fx!(0.6)),
        (fx!(0.95), fx!(0.2)),
        (fx!(0.75), fx!(-0.2)),
        (fx!(0.4), fx!(-0.45)),
        (fx!(0), fx!(-0.52)),
    ];
    static BOWL: Mesh = shape!(lathe(32, PROFILE));
    let view = view(canvas)?;
    let lamp = Light::new(vec3!(-1, 3, 2), fx!(0.2), fx!(0.8))?;
    let both = DrawOptions::new().with_cull(Cull::Nothing);
    canvas.clear(SLATE);
    let at = |x| {
        let place = Transform::translate(Vec3::new(x, fx!(0), fx!(0)));
        view * place * Transform::scale(fx!(0.8))
    };
    let [left, right] = [fx!(-0.9), fx!(0.9)].map(at);
    let green = Flat::rgb(Rgb888::new(130, 210, 120));
    canvas.draw_with(&both, &BOWL, &left, &green.lit(lamp));
    let two_sided = lamp.two_sided(Viewer::of(&right));
    canvas.draw_with(&both, &BOWL, &right, &green.lit(two_sided));
    Ok(())
}
