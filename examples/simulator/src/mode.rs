//! Modes that are chosen at run time.

use fixel::mode::{Affine, Exact, Fast, Newton};
use fixel::num::scalar;

use super::Result;
use crate::args::{self, Args};

/// A way of interpolating.
#[derive(Clone, Copy, Debug)]
pub enum Mode {
    Exact(Exact),
    Newton(Newton),
    Fast(Fast),
    Affine(Affine),
}

impl Mode {
    /// The one that was asked for.
    pub fn new(args: &Args) -> Result<Self> {
        Ok(match args.mode {
            args::Mode::Exact => Self::Exact(Exact),
            args::Mode::Newton => Self::Newton(Newton),
            args::Mode::Fast => Self::Fast(Fast::within(scalar(args.tolerance)?)),
            args::Mode::Affine => Self::Affine(Affine),
        })
    }
}

/// `$draw`, with options in that mode: the library's modes are types, so that a firmware has only what it uses.
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
