//! Measures meshes whose rows have different numbers of vertices: no number may take much more than the next.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::mesh::{Buffers, Shape};
use fixel::prelude::*;
use static_cell::ConstStaticCell;

use super::common::scenes;
use super::frames::Frame;
use super::ticks::Stopwatch;

/// How many vertices the rows of a sphere have: numbers around powers of two, and around the number of vertices that a
/// draw call keeps.
const ROWS: [(&str, u32); 17] = [
    ("rows-of-31", 31),
    ("rows-of-32", 32),
    ("rows-of-33", 33),
    ("rows-of-47", 47),
    ("rows-of-48", 48),
    ("rows-of-62", 62),
    ("rows-of-63", 63),
    ("rows-of-64", 64),
    ("rows-of-65", 65),
    ("rows-of-96", 96),
    ("rows-of-127", 127),
    ("rows-of-128", 128),
    ("rows-of-129", 129),
    ("rows-of-200", 200),
    ("rows-of-255", 255),
    ("rows-of-256", 256),
    ("rows-of-300", 300),
];

/// Each sphere has about this many triangles.
const TRIANGLES: u32 = 2000;

static POSITIONS: ConstStaticCell<[Vec3; 2000]> = ConstStaticCell::new([Vec3::ZERO; 2000]);
static FACES: ConstStaticCell<[[u16; 3]; 2400]> = ConstStaticCell::new([[0; 3]; 2400]);

/// Draws the spheres in one color, without a depth buffer.
pub fn measure(watch: &mut Stopwatch, frame: &mut Frame) -> Result<(), Error> {
    let (positions, faces) = (POSITIONS.take(), FACES.take());
    let mvp = scenes::sphere_mvp(0)?;
    for (name, length) in ROWS {
        let slices = length - 1;
        let sphere = Shape::sphere(slices, TRIANGLES / (2 * slices) + 1)?;
        let ball = sphere.build(Buffers::new(positions, faces))?;
        let mut canvas = frame.canvas()?;
        let red = Flat::new(Rgb565::RED);
        let ticks = watch.time(|| {
            let drawn = canvas.draw(&ball, &mvp, &red);
            assert!(drawn.drawn > 0 && drawn.clipped == 0);
            Ok::<_, Error>(())
        })?;
        watch.print(name, "triangle", ball.faces().len() as u32, ticks);
    }
    Ok(())
}
