//! Measures sprites, lines, points, lists, rays, and meshes that change.

use core::hint::black_box;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mesh::Keyframes;
use fixel::prelude::*;
use fixel::{Index, Prepared, ShadeList};
use static_cell::ConstStaticCell;

use super::ticks::Stopwatch;

const SIZE: u32 = 64;
/// The number of sprites in a row, and the number of rows.
const SIDE: usize = 8;
const SPRITES: usize = SIDE * SIDE;

static COLORS: ConstStaticCell<[Rgb565; 64 * 64]> = ConstStaticCell::new([Rgb565::BLACK; 64 * 64]);
static BALL: Mesh = shape!(sphere(16, 12));
static SMALL_BALL: Mesh = shape!(sphere(16, 12), quantized_8).without_uvs();
static OUTLINE: Outline = outline!(BALL, deg!(30));
static LIST: ConstStaticCell<DrawList<400, 250>> = ConstStaticCell::new(DrawList::new());
static EDGES: ConstStaticCell<DrawList<400, 400>> = ConstStaticCell::new(DrawList::new());

/// Measures calls, and prints the cost per sprite, line, point, triangle or vertex.
pub fn measure(watch: &mut Stopwatch) -> Result<(), Error> {
    let mut canvas = Canvas::new(COLORS.take(), SIZE, SIZE)?;
    let projection = Projection::perspective(deg!(60), (1, 1), fx!(1), fx!(10))?;
    let mvp = projection * Transform::translate(vec3!(0, 0, -3));
    let (options, white) = black_box((DrawOptions::new(), Flat::new(Rgb565::WHITE)));

    // Compare a sprite of 4x4 pixels with two triangles of a mesh that cover the same pixels.
    let (middles, corners, faces) = squares();
    let quads = Mesh::new(&corners, &faces)?;
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, &quads, &mvp, &white).drawn))?;
    watch.print("two-triangles", "pair", SPRITES as u32, ticks);
    let sprites = Sprites::new(&middles, (SQUARE, SQUARE))?;
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, &sprites, &mvp, &white).drawn))?;
    watch.print("sprite", "sprite", SPRITES as u32, ticks);
    let sprites = sprites.with_axis(Vec3::Y)?;
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, &sprites, &mvp, &white).drawn))?;
    watch.print("sprite-on-axis", "sprite", SPRITES as u32, ticks);

    let edges = BALL.edge_indices().len() as u32;
    let hair = BALL.edges(LineStyle::HAIRLINE);
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, hair, &mvp, &white).drawn))?;
    watch.print("line", "edge", edges, ticks);
    let wide = BALL.edges(LineStyle::wide(fx!(3))?);
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, wide, &mvp, &white).drawn))?;
    watch.print("line-3-wide", "edge", edges, ticks);
    let smooth = BALL.edges(LineStyle::HAIRLINE.smooth());
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, smooth, &mvp, &white).drawn))?;
    watch.print("line-smooth", "edge", edges, ticks);
    let prepared = EDGES.take();
    let ticks = watch.time(|| {
        let prepared = prepared.prepare(&options, (SIZE, SIZE), hair, &mvp);
        prepared.map(|_| ())
    })?;
    watch.print("prepare-line", "edge", edges, ticks);
    let prepared = prepared.prepare(&options, (SIZE, SIZE), hair, &mvp)?;
    let ticks = watch.time(|| drawn(canvas.draw_prepared(&prepared, &white)?.drawn))?;
    watch.print("prepared-line", "edge", edges, ticks);
    let edges = OUTLINE.edges().len() as u32;
    let outline = BALL.outline(&OUTLINE, LineStyle::HAIRLINE);
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, outline, &mvp, &white).drawn))?;
    watch.print("outline", "edge", edges, ticks);

    let points = BALL.positions().len() as u32;
    let pixels = BALL.points(PointStyle::PIXEL);
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, pixels, &mvp, &white).drawn))?;
    watch.print("point", "point", points, ticks);
    let discs = BALL.points(PointStyle::round(fx!(3))?);
    let ticks = watch.time(|| drawn(canvas.draw_with(&options, discs, &mvp, &white).drawn))?;
    watch.print("disc-3-wide", "point", points, ticks);

    let (list, triangles) = (LIST.take(), BALL.faces().len() as u32);
    let plain = watch.time(|| {
        list.prepare(&options, (SIZE, SIZE), &BALL, &mvp)
            .map(|_| ())
    })?;
    watch.print("prepare", "triangle", triangles, plain);
    let sorted = watch.time(|| {
        let sorted = list.prepare_back_to_front(&options, (SIZE, SIZE), &BALL, &mvp);
        sorted.map(|_| ())
    })?;
    watch.print("sort", "triangle", triangles, sorted - plain);

    lit_in_bands(watch, list)?;

    let ray = canvas.viewport().ray(Point::new(32, 32), &mvp);
    let ticks = watch.time(|| drawn(u32::from(ray.and_then(|ray| ray.hit(&BALL)).is_some())))?;
    watch.print("ray", "triangle", triangles, ticks);

    let mut positions = [Vec3::ZERO; 17 * 13];
    let mut normals = [Vec3::ZERO; 17 * 13];
    let keys = Keyframes::new(&BALL, &BALL)?;
    let half = black_box(fx!(0.5));
    let ticks = watch.time(|| keys.blend(half, &mut positions, &mut normals).map(|_| ()))?;
    watch.print("keyframe", "vertex", points, ticks);
    let ticks = watch.time(|| BALL.with_smooth_normals(&mut normals).map(|_| ()))?;
    watch.print("smooth-normals", "triangle", triangles, ticks);

    // The first mesh has attributes of 32 bits, the second of 8 bits.
    let sun = black_box(Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?);
    let clay = Flat::rgb(Rgb888::new(236, 214, 190)).lit(sun);
    for (name, ball) in [("lit", &BALL), ("lit-quantized", &SMALL_BALL)] {
        let ticks = watch.time(|| drawn(canvas.draw_with(&options, ball, &mvp, &clay).drawn))?;
        watch.print(name, "triangle", triangles, ticks);
    }
    Ok(())
}

/// Measures a lit ball, prepared for bands of eight rows. The ball is lit in each band, and then only once for all
/// bands.
fn lit_in_bands(watch: &mut Stopwatch, list: &mut DrawList<400, 250>) -> Result<(), Error> {
    let projection = Projection::perspective(deg!(60), (1, 1), fx!(1), fx!(10))?;
    let mvp = projection * Transform::translate(vec3!(0, 0, -2.2));
    let ball = list.prepare(&DrawOptions::new(), (SIZE, SIZE), &BALL, &mvp)?;
    let sun = black_box(Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7))?);
    let white = Flat::new(Rgb565::WHITE);
    bands(watch, &ball, ["lit-bands", "lit-once"], white.lit(sun))?;
    bands(
        watch,
        &ball,
        ["lit-faces-bands", "lit-faces-once"],
        white.lit_faces(sun),
    )
}

/// Draws a list in bands of eight rows. Then draws the list again, with stored values of the shader.
fn bands<S: ShaderFor<Rgb565>>(
    watch: &mut Stopwatch,
    ball: &Prepared<'_, (), &Mesh<'_>>,
    [in_bands, once]: [&str; 2],
    shader: S,
) -> Result<(), Error> {
    let triangles = BALL.faces().len() as u32;
    let mut colors = [Rgb565::BLACK; (SIZE * 8) as usize];
    let mut all = |shader: &dyn Fn(&mut Canvas<'_, Rgb565>) -> Result<Drawn, Error>| {
        for first in (0..SIZE).step_by(8) {
            shader(&mut Canvas::band(&mut colors, SIZE, SIZE, first)?)?;
        }
        Ok::<_, Error>(())
    };
    let ticks = watch.time(|| all(&|band| band.draw_prepared(ball, &shader)))?;
    watch.print(in_bands, "triangle", triangles, ticks);
    let mut memory = ShadeList::<S, 250>::new();
    let ticks = watch.time(|| {
        let shaded = ball.shade(&mut memory, |()| shader)?(&());
        all(&|band| band.draw_prepared(ball, &shaded))
    })?;
    watch.print(once, "triangle", triangles, ticks);
    Ok(())
}

/// The side of a square that is 4 pixels wide at distance 3.
const SQUARE: Scalar = fx!(0.2165);

/// The centers, corners and faces of a grid of squares. There are gaps between some of the squares.
fn squares() -> (
    [Vec3; SPRITES],
    [Vec3; 4 * SPRITES],
    [[Index; 3]; 2 * SPRITES],
) {
    let middles: [Vec3; SPRITES] = core::array::from_fn(|at| {
        let place = |at: usize| (Scalar::from(at as u8) - fx!(3.5)) * fx!(0.3);
        Vec3::new(place(at % SIDE), place(at / SIDE), fx!(0))
    });
    let half = SQUARE / 2;
    let corners = core::array::from_fn(|at| {
        let side = |is_far: bool| if is_far { half } else { -half };
        middles[at / 4] + Vec3::new(side(at % 2 > 0), side(at % 4 > 1), fx!(0))
    });
    let faces = core::array::from_fn(|at| {
        let first = (at / 2 * 4) as Index;
        if at % 2 == 0 {
            [first, first + 1, first + 2]
        } else {
            [first + 1, first + 3, first + 2]
        }
    });
    (middles, corners, faces)
}

/// Checks that something was drawn.
fn drawn(count: u32) -> Result<(), Error> {
    assert!(count > 0, "something is drawn");
    Ok(())
}
