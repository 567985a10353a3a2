//! A function of the color of each pixel.

use super::{Fragment, Output, Shader};
use crate::mesh::Primitive;

/// A shader and a function of each pixel that it colors; see [`Shader::map`].
///
#[cfg_attr(doc, doc = page_picture!("map", "A ring with three steps of brightness, like a cartoon"))]
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
/// use fixel::prelude::*;
/// static FLOOR: Mesh = shape!(plane(1, 1));
/// let projection = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.5), fx!(8))?;
/// // Eight units wide and long, half a unit below the eye.
/// let mvp = projection * Transform::translate(vec3!(0, -0.5, -4)) * Transform::scale(fx!(4));
/// let mut pixels = [Gray4::BLACK; 32];
/// let mut canvas = Canvas::new(&mut pixels, 4, 8)?;
/// // Fog: the farther, the whiter. Depth is 65535 · near / distance.
/// let fog = Flat::new(Gray4::BLACK).map(|at, _| Some(Gray4::new(15 - (at.depth >> 12) as u8)));
/// canvas.draw(&FLOOR, &mvp, &fog);
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "0000", "0000", "0000", "0000", "EEEE", "AAAA", "6666", "2222",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Map<S, F> {
    pub(super) shader: S,
    pub(super) effect: F,
}

impl<S: Shader, C: Output, F: Fn(&Fragment, S::Color) -> Option<C> + Copy> Shader for Map<S, F> {
    type Color = C;
    type Varyings = S::Varyings;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.shader.varyings(primitive)
    }

    #[inline]
    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<C> {
        (self.effect)(at, self.shader.shade(at, varyings)?)
    }
}
