//! The modes that are compared. To measure another mode, add a line.

use fixel::fx;
use fixel::mode::{Affine, Exact, Fast, Mode, Newton};

use super::Result;

/// Code that runs in each mode.
pub trait Visitor {
    /// Runs in one mode.
    fn visit<I: Mode>(&mut self, name: &'static str, mode: I) -> Result<()>;
}

macro_rules! modes {
    ($($name:literal => $mode:expr,)*) => {
        /// The names of the modes in tables, in plots, and in the output of the program `firmware`.
        pub const NAMES: &[&str] = &[$($name),*];

        /// Calls the visitor with each mode.
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
