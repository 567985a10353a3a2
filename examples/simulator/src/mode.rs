//! Modes and depth formats, chosen at run time. In the library, modes and formats are types, so that firmware links
//! only the modes and formats that it uses.

use fixel::Scalar;
use fixel::mode::{Affine, Exact, Fast, Newton};

use super::Result;
use crate::args;

/// The tolerance of mode fast, in texels.
const TOLERANCE: f64 = 0.25;

/// An interpolation mode.
#[derive(Clone, Copy, Debug)]
pub enum Mode {
    Exact(Exact),
    Newton(Newton),
    Fast(Fast),
    Affine(Affine),
}

impl Mode {
    /// Returns the chosen mode. `texel` is the number of units of the tolerance in a texel.
    pub fn new(mode: args::Mode, texel: f64) -> Result<Self> {
        Ok(match mode {
            args::Mode::Exact => Self::Exact(Exact),
            args::Mode::Newton => Self::Newton(Newton::default()),
            // The tolerance is limited to the number format. A larger tolerance would exceed any texture.
            args::Mode::Fast => Self::Fast(Fast::within(Scalar::try_from(
                (TOLERANCE * texel).min(32_767.0),
            )?)),
            args::Mode::Affine => Self::Affine(Affine),
        })
    }
}

/// Runs `$draw` with options in this mode.
macro_rules! in_mode {
    ($mode:expr, $options:expr, |$in_mode:ident| $draw:expr) => {
        $crate::mode::in_mode!($mode, $options, $in_mode, $draw, Exact Newton Fast Affine)
    };
    ($mode:expr, $options:expr, $in_mode:ident, $draw:expr, $($Mode:ident)+) => {
        match $mode {
            $($crate::mode::Mode::$Mode(mode) => {
                let $in_mode = &$options.with_mode(mode);
                $draw
            })+
        }
    };
}
pub(crate) use in_mode;

/// Runs `$draw` on `$canvas` with a depth buffer in `$format` over `$depth`.
macro_rules! with_depth {
    ($format:expr, $canvas:expr, $depth:expr, |$with:ident| $draw:expr) => {
        $crate::mode::with_depth!(
            $format, $canvas, $depth, $with, $draw,
            Linear LinearDepth, Float FloatDepth, Wide WideFloatDepth
        )
    };
    (
        $format:expr, $canvas:expr, $depth:expr, $with:ident, $draw:expr,
        $($Choice:ident $Format:ident),+
    ) => {
        match $format {
            $($crate::args::DepthBuffer::$Choice => {
                let $with = &mut $canvas.with_depth_format::<fixel::canvas::$Format>($depth)?;
                $draw
            })+
        }
    };
}
pub(crate) use with_depth;
