//! A walled garden at dusk: a first-person scene with everything in it. The program is in `examples/common/world`.

#[path = "../../common/world/mod.rs"]
mod garden;

use fixel::prelude::*;

use super::Frame;

/// Frames of the walk, once around.
pub const FRAMES: u32 = 84;

/// The moment of a frame.
pub fn turn_of(frame: u32) -> Angle {
    Angle::from_bits(u32::MAX / FRAMES * frame)
}

pub fn walk(canvas: &mut Frame<'_>, turn: Angle) -> Result<(), Error> {
    garden::draw(canvas, turn)
}

pub fn draw(canvas: &mut Frame<'_>) -> Result<(), Error> {
    walk(canvas, turn_of(18))
}
