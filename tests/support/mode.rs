//! The interpolation modes as values of one type, so that tests can iterate over them.

use embedded_graphics::pixelcolor::Gray8;
use fixel::canvas::DepthBuffer;
use fixel::mode::{Affine, Compact, Exact, Fast, Newton};
use fixel::prelude::*;
use fixel::view::ProjectionKind;

/// A mode with its tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    Exact,
    Compact,
    /// `Newton::default()`.
    Newton,
    /// `Newton::NARROW`.
    NewtonNarrow,
    /// `Fast` with a tolerance in texels.
    Fast(Scalar),
    Affine,
}

impl Mode {
    /// `Fast::NARROW`, which promises 1/16 texel: its tolerance of 1/32, plus the 1/32 that every `Fast` adds.
    pub const NARROW: Self = Self::Fast(fx!(0.03125));

    /// The modes that interpolate with perspective correction.
    pub const PERSPECTIVE: [Self; 9] = [
        Self::Exact,
        Self::Compact,
        Self::Newton,
        Self::NewtonNarrow,
        Self::Fast(fx!(0)),
        Self::NARROW,
        Self::Fast(fx!(0.0625)),
        Self::Fast(fx!(0.5)),
        Self::Fast(fx!(4)),
    ];

    /// The modes that are tested under a parallel projection. Every other mode equals one of these modes.
    pub const PARALLEL: [Self; 5] = [
        Self::Exact,
        Self::Compact,
        Self::Newton,
        Self::Fast(fx!(0.25)),
        Self::Affine,
    ];

    /// The mode that this mode equals under a parallel projection.
    pub fn in_parallel(self) -> Self {
        match self {
            Self::Exact | Self::Compact => self,
            Self::Newton | Self::NewtonNarrow | Self::Fast(_) | Self::Affine => Self::Affine,
        }
    }

    /// The largest error that the mode promises, in texels, if the model has the snapped vertices. The promise is for a
    /// texture of 256 texels in a picture of 320x240.
    pub fn promised(self) -> f64 {
        match self {
            Self::Exact | Self::Compact | Self::NewtonNarrow => 0.001,
            Self::Newton => self.tolerance() + 0.001,
            Self::Fast(_) => self.tolerance() + 1. / 32.,
            Self::Affine => f64::INFINITY,
        }
    }

    /// The tolerance of this mode, in texels.
    pub fn tolerance(self) -> f64 {
        match self {
            Self::Newton => 1. / 32.,
            Self::Fast(texels) => f64::from(texels),
            _ => 0.,
        }
    }

    /// Draws in this mode; the mode of `options` is ignored.
    pub fn draw<K: ProjectionKind, F: ShaderFor<Gray8>, D: DepthBuffer>(
        self,
        canvas: &mut Canvas<'_, Gray8, Native, D>,
        options: &DrawOptions,
        mesh: &Mesh<'_>,
        mvp: &Mvp<K>,
        shader: &F,
    ) {
        match self {
            Self::Exact => canvas.draw_with(&options.with_mode(Exact), mesh, mvp, shader),
            Self::Compact => canvas.draw_with(&options.with_mode(Compact), mesh, mvp, shader),
            Self::Newton => {
                canvas.draw_with(&options.with_mode(Newton::default()), mesh, mvp, shader)
            }
            Self::NewtonNarrow => {
                canvas.draw_with(&options.with_mode(Newton::NARROW), mesh, mvp, shader)
            }
            Self::Fast(texels) => {
                canvas.draw_with(&options.with_mode(Fast::within(texels)), mesh, mvp, shader)
            }
            Self::Affine => canvas.draw_with(&options.with_mode(Affine), mesh, mvp, shader),
        };
    }
}
