//! Measures the set-up of triangles. The triangles cover at most one visible pixel.

use core::hint::black_box;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;

use super::ticks::Stopwatch;

/// The numbers of triangles in the two lists that are compared.
const COUNTS: [usize; 2] = [32, 160];
const FACES: [[u16; 3]; COUNTS[1]] = [[0, 1, 2]; COUNTS[1]];

/// The distance from the eye to the screen, in pixels.
const FOCAL: i32 = 4;
/// Corners and their distances. The corners are in sixteenths of a pixel from the top left corner of the window's only
/// pixel. The triangles have about 8x8 pixels, a usual size. The window shows one of these pixels or none.
const COVERING: [([i32; 2], i32); 3] = [([-48, 3], 4), ([16, 128], 5), ([80, 5], 6)];
/// Corners and distances of a triangle that does not contain the pixel's center, although its bounds do.
const MISSING: [([i32; 2], i32); 3] = [([-128, 3], 4), ([-128, 128], 5), ([14, 128], 6)];
const PALETTE: [Rgb888; 3] = [
    Rgb888::new(255, 100, 0),
    Rgb888::new(0, 255, 100),
    Rgb888::new(100, 0, 255),
];

/// The part of the triangles that the window shows.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// No pixel, although the bounds of the triangles contain a pixel's center.
    Missing,
    /// One pixel.
    Covering,
}

/// Draws triangles with three attributes from a prepared list, in the default mode. Returns the number of triangles and
/// the ticks.
pub fn measure(watch: &mut Stopwatch, kind: Kind) -> Result<(u32, u64), Error> {
    let [few, many] = COUNTS;
    let ticks = |watch: &mut Stopwatch, count: usize| draw(watch, kind, &FACES[..count]);
    Ok((
        (many - few) as u32,
        ticks(watch, many)? - ticks(watch, few)?,
    ))
}

fn draw(watch: &mut Stopwatch, kind: Kind, faces: &[[u16; 3]]) -> Result<u64, Error> {
    let corners = match kind {
        Kind::Missing => MISSING,
        Kind::Covering => COVERING,
    };
    let positions = corners.map(|([x, y], distance)| {
        // Coordinates are relative to the pixel's center, which is the center of the frame, too.
        let eye = |sixteenths: i32| fx!(1) * (sixteenths * distance) / (16 * FOCAL);
        Vec3::new(eye(x - 8), eye(8 - y), fx!(-1) * distance)
    });
    let mesh = Mesh::new(&positions, faces)?.with_colors(&PALETTE, None)?;
    let frame = (1, 1);
    let projection = Projection::from_focal_length(fx!(const FOCAL), frame, fx!(1), fx!(10))?;
    let mut list: DrawList<{ COUNTS[1] }, 8> = DrawList::new();
    let triangles = list.prepare(&DrawOptions::new(), frame, &mesh, &projection)?;

    let mut pixel = [Rgb565::BLACK];
    let mut canvas = Canvas::new(&mut pixel, 1, 1)?;
    let shade = black_box(Gouraud::new());
    let ticks = watch.time(|| {
        let drawn = canvas.draw_prepared(&triangles, &shade)?;
        assert_eq!((drawn.drawn as usize, drawn.clipped), (faces.len(), 0));
        Ok::<_, Error>(())
    })?;
    assert_eq!(pixel != [Rgb565::BLACK], kind == Kind::Covering);
    Ok(ticks)
}
