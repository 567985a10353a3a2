//! Pictures of options, modes and formats of pixels.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::{Drawable, text::Text};
use fixel::Window;
use fixel::canvas::{Add, Blending, Multiply, Opacity, Replace, TestOnly};
use fixel::mode::Affine;
use fixel::prelude::*;

use super::{
    BALL, CHECKERS, COARSE_RING, CUBE, Drawn, ORANGE, RING, SHEET, SIZE, SLATE, benchmarks,
    shown_in, sun, view,
};
use crate::scenes::Frame;

/// Four viewports: default options, front faces culled, lines, and points.
pub(super) fn options(canvas: &mut Frame<'_>) -> Drawn {
    let view = view(canvas)?;
    let ring = view * Transform::rotate_z(deg!(25));
    let orange = Flat::rgb(ORANGE);
    let surface = orange.lit(sun()?);
    canvas.clear(SLATE);
    let (width, height) = (SIZE.width / 2, SIZE.height / 2);
    let part = |column: u32, row: u32| -> Result<DrawOptions, Error> {
        let (x, y) = (column * width, row * height);
        Ok(DrawOptions::new().with_viewport(Viewport::new(
            x.cast_signed(),
            y.cast_signed(),
            width,
            height,
        )?))
    };
    canvas.draw_with(&part(0, 0)?, &RING, &ring, &surface);
    canvas.draw_with(&part(1, 0)?.with_cull(Cull::Front), &RING, &ring, &surface);
    canvas.draw_with(
        &part(0, 1)?,
        COARSE_RING.edges(LineStyle::HAIRLINE),
        &ring,
        &orange,
    );
    canvas.draw_with(&part(1, 1)?, RING.points(PointStyle::PIXEL), &ring, &orange);
    Ok(())
}

/// A ring and a cube with jagged edges, and smoothed. Each pixel of the canvas has four pixels of the picture.
pub(super) fn smooth_edges(canvas: &mut Frame<'_>) -> Drawn {
    static SILHOUETTE: Outline = outline!(RING, deg!(180));
    static CREASES: Outline = outline!(CUBE, deg!(30));
    const SIDES: (u32, u32) = (60, 80);
    let mut colors = [SLATE; 60 * 80];
    let mut depths = [0; 60 * 80];
    let mut small = Canvas::new(&mut colors, SIDES.0, SIDES.1)?.with_depth(&mut depths)?;
    let projection = Projection::perspective(deg!(58), SIDES, fx!(1), fx!(50))?;
    let view = projection * Camera::look_at(vec3!(0, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    let ring = view * Transform::rotate_z(deg!(25));
    let cube = view * Transform::rotate_y(deg!(35)) * Transform::scale(fx!(0.3));
    let options = DrawOptions::new();
    small.draw(&RING, &ring, &Flat::rgb(ORANGE).lit(sun()?));
    small.draw(&CUBE, &cube, &Flat::rgb(Rgb888::WHITE).lit_faces(sun()?));
    for left in [0, 1] {
        let cells = (0..).zip(small.pixels());
        for (at, color) in cells {
            let corner = Point::new(left * 120 + at % 60 * 2, at / 60 * 2);
            canvas.fill_solid(&Rectangle::new(corner, Size::new(2, 2)), color)?;
        }
        small.smooth_edges(&options, &RING, &SILHOUETTE, &ring);
        small.smooth_edges(&options, &CUBE, &CREASES, &cube);
    }
    Ok(())
}

/// A pane over stripes, blended in four ways.
pub(super) fn blending(canvas: &mut Frame<'_>) -> Drawn {
    fn pane<B: Blending<Rgb565>>(canvas: &mut Frame<'_>, at: i32, blending: B) -> Drawn {
        let projection =
            Projection::orthographic(Window::centered(fx!(3), fx!(2)), fx!(0), fx!(4))?;
        let mvp = projection
            * Camera::top(Vec3::ZERO, fx!(2))
            * Transform::translate(Vec3::new(fx!(-1.1) + fx!(0.73) * at, fx!(0), fx!(0)));
        let options = DrawOptions::new()
            .with_depth_test(TestOnly)
            .with_blending(blending);
        let shader = Flat::new(Rgb565::new(28, 30, 8));
        canvas.draw_with(
            &options,
            &SHEET,
            &(mvp * Transform::scale_axes(vec3!(0.3, 1, 0.7))),
            &shader,
        );
        Ok(())
    }
    canvas.clear(SLATE);
    let stripes = [
        Rgb565::new(3, 10, 22),
        Rgb565::new(20, 52, 28),
        Rgb565::new(10, 26, 10),
    ];
    for (at, color) in (0..12).zip(stripes.iter().cycle()) {
        canvas.fill_solid(
            &Rectangle::new(Point::new(0, 14 * at), Size::new(SIZE.width, 14)),
            *color,
        )?;
    }
    pane(canvas, 0, Replace)?;
    pane(canvas, 1, Opacity(128))?;
    pane(canvas, 2, Add)?;
    pane(canvas, 3, Multiply)
}

/// A floor in mode `Affine`, and in the default mode.
pub(super) fn modes(canvas: &mut Frame<'_>) -> Drawn {
    canvas.clear(SLATE);
    let (half, size) = (SIZE.width / 2, canvas.frame_size());
    let projection = Projection::perspective(deg!(70), (half, size.height), fx!(0.1), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 1.1, 1.75), vec3!(0, -0.35, 0), Vec3::Y)?;
    let mvp = projection * camera * Transform::rotate_y(deg!(20));
    let part = |x| -> Result<DrawOptions, Error> {
        Ok(DrawOptions::new().with_viewport(Viewport::new(x, 0, half - 2, size.height)?))
    };
    let floor = Textured::new(&CHECKERS);
    canvas.draw_with(&part(0)?.with_mode(Affine), &SHEET, &mvp, &floor);
    canvas.draw_with(&part(half.cast_signed() + 2)?, &SHEET, &mvp, &floor);
    let white = MonoTextStyle::new(&FONT_6X10, Rgb565::WHITE);
    Text::new("Affine", Point::new(4, 12), white).draw(canvas)?;
    Text::new("Newton", Point::new(half.cast_signed() + 6, 12), white).draw(canvas)?;
    Ok(())
}

/// A ball in 16 bits of color, in four grays, in black and white.
pub(super) fn formats(canvas: &mut Frame<'_>) -> Drawn {
    fn ball(canvas: &mut Frame<'_>, at: i32, shader: &impl ShaderFor<Rgb565>) -> Drawn {
        let (third, height) = (SIZE.width / 3, SIZE.height);
        let projection = Projection::perspective(deg!(52), (third, height), fx!(0.1), fx!(50))?;
        let camera = Camera::front(Vec3::ZERO, fx!(5));
        let part = Viewport::new(at * third.cast_signed(), 0, third, height)?;
        let options = DrawOptions::new().with_viewport(part);
        canvas.draw_with(
            &options,
            &BALL,
            &(projection * camera * Transform::IDENTITY),
            shader,
        );
        Ok(())
    }
    canvas.clear(Rgb565::BLACK);
    let surface = Flat::new(ORANGE).lit(sun()?);
    ball(canvas, 0, &shown_in::<Rgb565>(surface))?;
    ball(canvas, 1, &shown_in::<Gray2>(surface))?;
    ball(canvas, 2, &shown_in::<BinaryColor>(surface))
}

/// The scenes that are measured: floor, cube, sphere, sphere with flat triangles.
pub(super) fn measured(canvas: &mut Frame<'_>) -> Drawn {
    canvas.clear(SLATE);
    // The viewport has the proportions of 320x240, because the scenes are made for a frame of this size.
    let (width, height) = (106, SIZE.height / 2);
    let part = |column: i32, row: i32| -> Result<DrawOptions, Error> {
        let corner = (7 + 120 * column, row * height.cast_signed());
        Ok(DrawOptions::new().with_viewport(Viewport::new(corner.0, corner.1, width, height)?))
    };
    benchmarks::floor(canvas, &part(0, 0)?, &benchmarks::floor_mvp(0)?);
    benchmarks::cube(canvas, &part(1, 0)?, &benchmarks::cube_mvp(0)?);
    benchmarks::sphere(canvas, &part(0, 1)?, &benchmarks::sphere_mvp(0)?);
    benchmarks::sphere_flat(canvas, &part(1, 1)?, &benchmarks::sphere_mvp(0)?);
    Ok(())
}
