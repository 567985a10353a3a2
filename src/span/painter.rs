//! A shader with the blending of its draw call.

use crate::mesh::Primitive;
use crate::shade::{ColorOf, Fragment, Shader, Varyings};
use crate::target::Blending;

/// What the pixels of a draw call are colored by: a [`Shader`] and a [`Blending`].
pub(crate) trait Painter: Copy {
    /// The color of the canvas.
    type Color;

    /// As for [`Shader`].
    type Varyings: Varyings;

    /// As for [`Shader`].
    const READS_DEPTH: bool;

    /// Whether [`paint`](Self::paint) reads the color below.
    const READS_COLOR: bool;

    /// As for [`Shader`].
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3];

    /// A pixel's color, of which `below` was there; `None` leaves its color and its depth as they are.
    fn paint(
        &self,
        at: &Fragment,
        varyings: Self::Varyings,
        below: impl FnOnce() -> Self::Color,
    ) -> Option<Self::Color>;
}

impl<S: Shader, B: Blending<ColorOf<S>, Source = S::Color>> Painter for (S, B) {
    type Color = ColorOf<S>;
    type Varyings = S::Varyings;

    const READS_DEPTH: bool = S::READS_DEPTH;
    const READS_COLOR: bool = B::READS;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.0.varyings(primitive)
    }

    #[inline]
    fn paint(
        &self,
        at: &Fragment,
        varyings: S::Varyings,
        below: impl FnOnce() -> ColorOf<S>,
    ) -> Option<ColorOf<S>> {
        let (shader, blending) = self;
        let source = shader.shade(at, varyings)?;
        Some(blending.blend(source, below, at.point))
    }
}
