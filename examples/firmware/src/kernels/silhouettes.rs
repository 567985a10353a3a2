//! Measures lit meshes in six poses, and the smoothing of their silhouettes.

use core::hint::black_box;

use embedded_graphics::pixelcolor::Rgb888;
use fixel::prelude::*;

use super::common::scenes::{HEIGHT, WIDTH};
use super::frames::Frame;
use super::ticks::Stopwatch;

static RING: Mesh = shape!(torus(fx!(0.4), 32, 16));
static BOX: Mesh = shape!(cuboid(vec3!(0.9, 0.9, 0.9)));
static MODEL: Mesh = include_mesh!("../../../assets/lighthouse.obj");
static OF_RING: Outline = outline!(RING, deg!(180));
static OF_BOX: Outline = outline!(BOX, deg!(180));
static OF_MODEL: Outline = outline!(MODEL, deg!(180));

const POSES: i32 = 6;

/// Draws the meshes on frames with a depth buffer, and prints the cost of a frame and of its smoothing.
pub fn measure(watch: &mut Stopwatch, frame: &mut Frame) -> Result<(), Error> {
    let options = DrawOptions::new();
    let sun = black_box(Light::new(vec3!(-2, 3, 1), fx!(0.3), fx!(0.7))?);
    let clay = Flat::rgb(Rgb888::new(236, 214, 190)).lit(sun);
    let projection = Projection::perspective(deg!(40), (WIDTH, HEIGHT), fx!(1), fx!(50))?;
    for (names, mesh, outline) in [
        (["ring", "ring-smoothed"], &RING, &OF_RING),
        (["box", "box-smoothed"], &BOX, &OF_BOX),
        (["model", "model-smoothed"], &MODEL, &OF_MODEL),
    ] {
        let (mut drawing, mut smoothing) = (0, 0);
        for pose in 0..POSES {
            let turn = Transform::rotate_y(Angle::from_degrees(pose * 61))
                * Transform::rotate_x(Angle::from_degrees(pose * 37 + 10));
            let mvp = projection * Transform::translate(vec3!(0, 0, -4)) * turn;
            let mut canvas = frame.canvas_with_depth()?;
            drawing +=
                watch.time(|| Ok::<_, Error>(_ = canvas.draw_with(&options, mesh, &mvp, &clay)))?;
            smoothing += watch
                .time(|| Ok::<_, Error>(_ = canvas.smooth_edges(&options, mesh, outline, &mvp)))?;
        }
        for (name, ticks) in names.into_iter().zip([drawing, smoothing]) {
            watch.print(name, "frame", POSES.cast_unsigned(), ticks);
        }
    }
    Ok(())
}
