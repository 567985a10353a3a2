//! Picking: finds the touched face and the touched point.

use core::fmt::Write as _;

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_4X6, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::{Circle, Primitive as _, PrimitiveStyle};
use embedded_graphics::{Drawable, geometry::Dimensions, geometry::Point, text::Text};
use fixel::canvas::{Biased, TestAndWrite};
use fixel::prelude::*;
use heapless::String;

static RING: Mesh = shape!(torus(fx!(0.4), 28, 14));
static BALL: Mesh = shape!(sphere(12, 8));

pub fn draw(canvas: &mut Canvas<'_, Rgb565, Native, LinearDepth>, ms: u64) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(50), canvas.frame_size(), fx!(0.5), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 2, 3), Vec3::ZERO, Vec3::Y)?;
    let ring = Transform::rotate_z(deg!(20)) * Transform::scale(fx!(1.1));
    let (view, mvp) = (projection * camera, projection * camera * ring);
    let sun = Light::new(vec3!(2, 3, 2), fx!(0.3), fx!(0.7))?;
    let blue = Flat::rgb(Rgb888::new(90, 140, 200));
    let options = DrawOptions::new();
    canvas.clear(Rgb565::new(2, 5, 4));
    let behind = options.with_depth_test(Biased::behind(TestAndWrite));
    canvas.draw_with(&behind, &RING, &mvp, &blue.lit_faces(sun));
    let gray = Flat::new(Rgb565::new(6, 16, 12));
    canvas.draw(RING.edges(LineStyle::HAIRLINE), &mvp, &gray);

    let frame = canvas.bounding_box();
    // The finger follows the ring.
    let (sin, cos) = (Rate::millihertz(250).angle_at(ms) + deg!(50)).sin_cos();
    let [x, y] = [fx!(80) * cos, fx!(46) * sin - fx!(26) * cos].map(Scalar::round);
    let middle = frame.center() + Point::new(2, 12);
    let touch = middle + Point::new(x, y) * frame.size.height.cast_signed() / 240;
    let Some(hit) = canvas
        .viewport()
        .ray(touch, &mvp)
        .and_then(|ray| ray.hit(&RING))
    else {
        return Ok(());
    };
    // The face is drawn as a part of the mesh. The hit's point is in the model space of the ring.
    let face = RING.part(hit.face..hit.face + 1);
    canvas.draw(&face, &mvp, &Flat::new(Rgb565::new(31, 40, 4)));
    let pin = Transform::translate(ring.point(hit.point)) * Transform::scale(fx!(0.03));
    let red = Flat::rgb(Rgb888::new(255, 60, 40));
    canvas.draw(&BALL, &(view * pin), &red.lit(sun));

    let style = PrimitiveStyle::with_stroke(Rgb565::WHITE, 1);
    Circle::with_center(touch, frame.size.height / 10)
        .into_styled(style)
        .draw(canvas)?;
    let Vec3 { x, y, z } = hit.point;
    let mut text = String::<48>::new(); // without an allocator
    _ = write!(text, "face {} at ({x:.2}, {y:.2}, {z:.2})", hit.face);
    let font = [&FONT_4X6, &FONT_6X10][usize::from(frame.size.height > 100)];
    let style = MonoTextStyle::new(font, Rgb565::WHITE);
    Text::new(
        &text,
        Point::new(3, frame.size.height.cast_signed() - 4),
        style,
    )
    .draw(canvas)?;
    Ok(())
}
