//! A function of the color of each pixel.

use super::{Fragment, Output, Shader};
use crate::mesh::Primitive;

/// A shader and a function of each pixel that it colors; see [`Shader::map`].
#[doc(hidden)]
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
