//! A walled garden at dusk: a first-person scene that uses most of the crate. The program is in
//! `examples/common/world`.

#[path = "../../common/world/mod.rs"]
mod garden;

use fixel::mode::Newton;
use fixel::prelude::*;

pub use garden::{LOOK, WALK, viewer};

use super::scenes::Frame;

/// The number of frames a second of the walk's animation.
pub const RATE: u64 = 15;

/// The number of frames of the walk around the pond.
pub const FRAMES: u32 = 96;

/// The moment of the walk that a frame shows.
#[must_use]
pub fn turn_of(frame: u32) -> Angle {
    Angle::from_bits(u32::MAX / FRAMES * frame)
}

/// Draws the world at a moment of the walk.
///
/// # Errors
///
/// None.
pub fn walk(canvas: &mut Frame<'_>, turn: Angle) -> Result<(), Error> {
    garden::draw(canvas, Newton::default(), turn)
}

/// Draws the moment that the documentation shows. The firmware draws the same moment.
///
/// # Errors
///
/// None.
pub fn draw(canvas: &mut Frame<'_>) -> Result<(), Error> {
    walk(canvas, Angle::from_bits(u32::MAX / 64 * 13))
}
