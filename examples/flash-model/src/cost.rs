//! Estimates the time of a frame.

use embedded_graphics::pixelcolor::BinaryColor;
use fixel::prelude::*;

use crate::{Board, Model};

/// The cycles that a Pico takes on one core, fitted to the cycles of emulated Picos: for a frame; for the draw calls of a
/// part, for a triangle and for the light of a vertex, in all bands of the frame; for a pixel; and in addition for a
/// texel, and for the triangles and pixels of surfaces that are [`Painted`](crate::Painted).
const FRAME: f64 = 1.58e6;
const CALL: f64 = 1.5e5;
const TRIANGLE: f64 = 1270.0;
const VERTEX: f64 = 2130.0;
const PIXEL: f64 = 92.0;
const TEXEL: f64 = 108.0;
const PAINT: [f64; 2] = [5240.0, 71.0];
/// The cycles of a Pico's processors in a second, and of a Pico 2's.
const CLOCK: f64 = 125e6;
const CLOCK_2: f64 = 150e6;
/// How many times faster a core of a Pico 2 is: it takes 0.34 instructions for a cycle of a Pico, 1.5 cycles of its own
/// for an instruction, and has 150 million cycles in a second.
const PICO2: f64 = 2.4;
/// How many times faster both cores are than one, on a Pico and on a Pico 2.
const CORES: [f64; 2] = [1.65, 2.0];
/// The number of the frames in which pixels are counted, and the time between two of them.
const VIEWS: usize = 4;
const STEP_MS: usize = 2500;

/// Estimates how many frames of a model a board shows in a second. On emulated Picos, models of 14 to 16,000 triangles
/// showed up to a quarter more or fewer.
///
/// # Errors
///
/// None: the sizes are constant.
pub fn rate(model: &Model<'_>, board: Board) -> Result<f64, Error> {
    let (width, height) = model.module().size();
    let mut pixels = vec![BinaryColor::Off; (width * height) as usize];
    let mut depths = vec![0_u16; pixels.len()];
    let mut covered = 0;
    for time in (0..).step_by(STEP_MS).take(VIEWS) {
        let mvp = crate::view((width, height))? * crate::turn(time);
        let mut canvas = Canvas::new(&mut pixels, width, height)?.with_depth(&mut depths)?;
        canvas.clear(BinaryColor::Off);
        let both = DrawOptions::new().with_cull(Cull::Nothing);
        canvas.draw_with(&both, &model.mesh(), &mvp, &Flat::new(BinaryColor::On));
        covered += pixels
            .iter()
            .filter(|&&pixel| pixel == BinaryColor::On)
            .count();
    }
    let covered = real(covered) / real(VIEWS);
    let faces = real(model.mesh().faces().len());
    let lit = lit(model);
    let mut cycles = FRAME;
    for part in model.parts() {
        let share = real(part.faces.len()) / faces;
        // Pixels of backs are mostly hidden, but take time, too.
        let sides = if part.is_two_sided { 2.5 } else { 1.0 };
        let texel = if part.texture.is_some() { TEXEL } else { 0.0 };
        let [triangle, pixel] = if part.is_plain() { [0.0; 2] } else { PAINT };
        cycles += share * sides * (faces * (TRIANGLE + triangle) + real(lit) * VERTEX);
        cycles += sides * CALL + share * covered * (PIXEL + texel + pixel);
    }
    let (clock, speed) = match board {
        Board::Pico => (CLOCK, CORES[0]),
        Board::Pico2 => (CLOCK_2, PICO2 * CORES[1]),
    };
    // The bus has the processor's clock, divided by an even number.
    let module = model.module();
    let divider = 2.0 * (clock / 2.0 / f64::from(module.clock_hz)).ceil();
    let bits = f64::from(8 * module.bytes_of_pixel() * width * height);
    Ok(1.0 / (cycles / speed / CLOCK).max(bits * divider / clock))
}

/// Below this many frames a second, a turning model jerks.
const SLOW: f64 = 5.0;

/// Says what a model takes of a board's flash and time.
///
/// # Errors
///
/// The words are not a model.
pub fn cost(words: &[u32], board: Board) -> Result<String, String> {
    let model = Model::read(words).map_err(|problem| problem.to_string())?;
    let triangles = model.mesh().faces().len();
    let (kilobytes, most) = (words.len().div_ceil(256), board.words() / 256);
    let rate = rate(&model, board).map_err(|error| error.to_string())?;
    let slow = if rate < SLOW {
        ", which is slow: save the model with fewer triangles"
    } else {
        ""
    };
    Ok(format!(
        "{triangles} triangles; {kilobytes} of {most} KB of flash for models; an estimate of {rate:.1} frames a second{slow}"
    ))
}

/// How often the light of a vertex is computed. Drawing keeps the light of a vertex until it meets the vertex with another
/// normal.
fn lit(model: &Model<'_>) -> usize {
    let mut kept = vec![None; model.mesh().positions().len()];
    let corners = model.mesh.faces().as_flattened();
    let normals = if model.normal_faces.is_empty() {
        corners
    } else {
        model.normal_faces.as_flattened()
    };
    let pairs = corners.iter().zip(normals);
    let new = pairs
        .filter(|(vertex, normal)| kept[usize::from(**vertex)].replace(**normal) != Some(**normal));
    new.count()
}

/// A count as a number that can be multiplied.
#[allow(clippy::cast_precision_loss)] // below 2^53
const fn real(count: usize) -> f64 {
    count as f64
}
