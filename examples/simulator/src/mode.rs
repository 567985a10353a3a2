//! Modes chosen at run time.

use fixel::mode::{Affine, Exact, Fast, Newton};
use fixel::num::scalar;

use super::Result;
use crate::args::{self, Args};

/// An interpolation mode.
#[derive(Clone, Copy, Debug)]
pub enum Mode {
    Exact(Exact),
    Newton(Newton),
    Fast(Fast),
    Affine(Affine),
}

impl Mode {
    /// Returns the mode that the user asked for.
    pub fn new(args: &Args) -> Result<Self> {
        Ok(match args.mode {
            args::Mode::Exact => Self::Exact(Exact),
            args::Mode::Newton => Self::Newton(Newton),
            args::Mode::Fast => Self::Fast(Fast::within(scalar(args.tolerance)?)),
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
