//! Dithering by choice.

use super::{ColorOf, Fragment, Output, PixelFormat, PreciseOf, Shader};
use crate::mesh::Primitive;

/// A surface that is dithered in any format; see [`Shader::dithered`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dithered<S> {
    pub(super) surface: S,
}

impl<S: Shader<Color: Output<Color: PixelFormat>>> Shader for Dithered<S> {
    type Color = PreciseOf<S>;
    type Varyings = S::Varyings;

    const READS_DEPTH: bool = S::READS_DEPTH;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.surface.varyings(primitive)
    }

    #[inline]
    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<PreciseOf<S>> {
        let output = self.surface.shade(at, varyings)?;
        Some(output.map::<ColorOf<S>>(|color| color.dithered(at.point)))
    }
}
