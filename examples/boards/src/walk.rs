//! The walk through the little world of the README: a garden at dusk.

#[path = "../../common/world/mod.rs"]
mod world;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::canvas::{DepthBuffer, Storage};
use fixel::mode::Fast;
use fixel::prelude::*;

/// Draws the part of the frame that belongs to the canvas, at the time `now_ms`.
///
/// # Errors
///
/// None.
pub fn draw(
    now_ms: u64,
    canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
) -> Result<(), Error> {
    let turn = Rate::rpm(6).angle_at(now_ms);
    world::draw(canvas, Fast::within(fx!(2)), turn)
}
