//! The modes that are compared. To measure another one, add a line.

use fixel::fx;
use fixel::mode::{Affine, Exact, Fast, Mode, Newton};

use super::Result;

/// Work to be done in each mode.
pub trait Visitor {
    /// Does the work in one mode.
    fn visit<I: Mode>(&mut self, name: &'static str, mode: I) -> Result<()>;
}

macro_rules! modes {
    ($($name:literal => $mode:expr,)*) => {
        /// The names of the modes, in tables, in plots, and in the output of the program `firmware`.
        pub const NAMES: &[&str] = &[$($name),*];

        /// Visits each mode.
        pub fn each(visitor: &mut impl Visitor) -> Result<()> {
            $(visitor.visit($name, $mode)?;)*
            Ok(())
        }
    };
}

modes! {
    "exact" => Exact,
    "newton" => Newton,
    "fast" => Fast::within(fx!(0.25)),
    "affine" => Affine,
}
