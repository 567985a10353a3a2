//! Modes chosen at run time.

use fixel::mode::{Affine, Exact, Fast, Newton};
use fixel::num::scalar;

use super::Result;
use crate::args::{self, Args};

/// Default tolerance of mode fast, in texels.
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
    /// Returns the chosen mode. `texels` is the size of the drawn texture relative to the given one, to which the
    /// tolerance refers.
    pub fn new(args: &Args, texels: f64) -> Result<Self> {
        let tolerance = args.tolerance.unwrap_or(TOLERANCE) * texels;
        Ok(match args.mode {
            args::Mode::Exact => Self::Exact(Exact),
            args::Mode::Newton => Self::Newton(Newton),
            // A tolerance that exceeds the format is larger than any texture.
            args::Mode::Fast => Self::Fast(Fast::within(scalar(tolerance.min(32_767.0))?)),
            args::Mode::Affine => Self::Affine(Affine),
        })
    }
}

/// Runs `$draw` with options in that mode. The library's modes are types, so that firmware links only the ones it
/// uses.
macro_rules! in_mode {
    ($mode:expr, $options:expr, |$in_mode:ident| $draw:expr) => {
        match $mode {
            Mode::Exact(mode) => {
                let $in_mode = &$options.with_mode(mode);
                $draw
            }
            Mode::Newton(mode) => {
                let $in_mode = &$options.with_mode(mode);
                $draw
            }
            Mode::Fast(mode) => {
                let $in_mode = &$options.with_mode(mode);
                $draw
            }
            Mode::Affine(mode) => {
                let $in_mode = &$options.with_mode(mode);
                $draw
            }
        }
    };
}
pub(crate) use in_mode;
