//! Measures what a draw call costs apart from its triangles, and what clearing a frame costs.

use core::hint::black_box;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::prelude::*;

use super::frames::Frame;
use super::ticks::Stopwatch;

static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));

/// Prints the cost of a call without triangles, of 12 triangles behind the eye, of the product of four transforms, and
/// of clearing colors and depths.
pub fn measure(watch: &mut Stopwatch, frame: &mut Frame) -> Result<(), Error> {
    const CALLS: u32 = 16;
    let mut canvas = frame.canvas_with_depth()?;
    let ticks = watch.time(|| Ok::<_, Error>(canvas.clear(black_box(Rgb565::BLUE))))?;
    watch.print("clear", "frame", 1, ticks);

    let projection = Projection::perspective(deg!(60), canvas.frame_size(), fx!(1), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 1, 5), Vec3::ZERO, Vec3::Y)?;
    let turn = Transform::rotate_y(deg!(30));
    let behind = projection * camera * Transform::translate(vec3!(0, 0, 20)) * turn;
    let empty = Mesh::new(&[], &[])?;
    let white = Flat::new(Rgb565::WHITE);
    for (name, mesh) in [("call-empty", &empty), ("call-behind", &CUBE)] {
        let mesh = black_box(mesh);
        let ticks = watch.time(|| {
            for _ in 0..CALLS {
                assert_eq!(canvas.draw(mesh, &behind, &white).drawn, 0);
            }
            Ok::<_, Error>(())
        })?;
        watch.print(name, "call", CALLS, ticks);
    }
    let ticks = watch.time(|| {
        for _ in 0..CALLS {
            let model = black_box(turn) * black_box(turn) * black_box(turn);
            black_box(projection * black_box(camera) * model);
        }
        Ok::<_, Error>(())
    })?;
    watch.print("mvp", "product", CALLS, ticks);
    Ok(())
}
