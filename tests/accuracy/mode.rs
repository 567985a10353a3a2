//! The modes of interpolation as values, to be gone through.

use embedded_graphics::pixelcolor::Gray8;
use fixel::mode::{Affine, Exact, Fast, Newton};
use fixel::prelude::*;
use fixel::target::{DepthBuffer, Native};
use fixel::view::ProjectionKind;

/// A mode, and what it was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    Exact,
    Newton,
    /// To so many texels.
    Fast(Scalar),
    Affine,
}

impl Mode {
    /// `Fast::NARROW`, of which 1/16 is promised: 1/32 as any, and 1/32 more.
    pub const NARROW: Self = Self::Fast(fx!(0.03125));

    /// Those that are right in perspective.
    pub const PERSPECTIVE: [Self; 7] = [
        Self::Exact,
        Self::Newton,
        Self::Fast(fx!(0)),
        Self::NARROW,
        Self::Fast(fx!(0.0625)),
        Self::Fast(fx!(0.5)),
        Self::Fast(fx!(4)),
    ];

    /// Those that differ in a parallel projection, and those that are to be the same as they.
    pub const PARALLEL: [Self; 4] = [
        Self::Exact,
        Self::Newton,
        Self::Fast(fx!(0.25)),
        Self::Affine,
    ];

    /// The mode that this one is in a parallel projection.
    pub fn in_parallel(self) -> Self {
        match self {
            Self::Exact => Self::Exact,
            Self::Newton | Self::Fast(_) | Self::Affine => Self::Affine,
        }
    }

    /// Texels of 256 that it promises to be off by at most, in a picture of 320x240, given where vertices are.
    pub fn promised(self) -> f64 {
        match self {
            Self::Exact | Self::Newton => 0.001,
            Self::Fast(_) => self.tolerance() + 1. / 32.,
            Self::Affine => f64::INFINITY,
        }
    }

    /// Texels that it was told it may be off by.
    pub fn tolerance(self) -> f64 {
        match self {
            Self::Fast(texels) => texels.to_num(),
            _ => 0.,
        }
    }

    /// Draws in this mode, whatever mode the pass has.
    pub fn draw<K: ProjectionKind, F: Shader<Color = Gray8>, D: DepthBuffer>(
        self,
        canvas: &mut Canvas<'_, Gray8, Native, D>,
        options: &DrawOptions,
        mesh: &Mesh<'_>,
        mvp: &Mvp<K>,
        shader: &F,
    ) {
        match self {
            Self::Exact => canvas.draw_with(&options.with_mode(Exact), mesh, mvp, shader),
            Self::Newton => canvas.draw_with(&options.with_mode(Newton), mesh, mvp, shader),
            Self::Fast(texels) => {
                canvas.draw_with(&options.with_mode(Fast::within(texels)), mesh, mvp, shader)
            }
            Self::Affine => canvas.draw_with(&options.with_mode(Affine), mesh, mvp, shader),
        };
    }
}
