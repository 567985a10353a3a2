//! How often the faces of a model cover a picture. Hidden faces take time, too: a short file can name a face a hundred
//! thousand times.

use core::cell::Cell;

use embedded_graphics::pixelcolor::BinaryColor;
use fixel::prelude::*;
use fixel::view::AsMvp;
use fixel::{Cull, Fragment, Primitive};

/// The longer side of the small picture that is drawn to count.
const SIDE: u32 = 24;

/// A shader that counts how often pixels are drawn.
#[derive(Clone, Copy)]
struct Counter<'a>(&'a Cell<u64>);

impl Shader for Counter<'_> {
    type Color = BinaryColor;
    type Varyings = ();

    fn varyings(&self, _: &Primitive<'_>) -> [(); 3] {
        [(); 3]
    }

    fn shade(&self, _: &Fragment, (): ()) -> Option<BinaryColor> {
        self.0.set(self.0.get() + 1);
        None
    }
}

/// Returns how often a pixel of a picture of this shape is drawn by all faces of some meshes, on average.
///
/// # Errors
///
/// None.
pub fn count<'a>(
    meshes: impl IntoIterator<Item = &'a Mesh<'a>>,
    mvp: &impl AsMvp,
    (width, height): (u32, u32),
) -> Result<u64, Error> {
    let longest = width.max(height);
    let [width, height] = [width, height].map(|side| (side * SIDE / longest).max(1));
    let mut pixels = vec![BinaryColor::Off; (width * height) as usize];
    let mut canvas = Canvas::new(&mut pixels, width, height)?;
    let drawn = Cell::new(0);
    let both = DrawOptions::new().with_cull(Cull::Nothing);
    for mesh in meshes {
        canvas.draw_with(&both, mesh, mvp, &Counter(&drawn));
    }
    Ok(drawn.get() / u64::from(width * height))
}

/// Refuses a picture that is covered more than `most` times.
///
/// # Errors
///
/// The message names both numbers, and says what to do; `remedy` is what else helps.
pub fn check(layers: u64, most: u64, remedy: &str) -> Result<(), String> {
    if layers <= most {
        return Ok(());
    }
    Err(format!(
        "faces cover the picture {layers} times, and at most {most} times can be drawn: leave out faces that others \
         hide{remedy}"
    ))
}
