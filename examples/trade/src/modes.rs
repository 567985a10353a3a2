//! The modes that are compared. To measure one more, add its line.

use fixel::fx;
use fixel::mode::{Affine, Exact, Fast, Mode, Newton};

use super::Result;

/// Something that is done in each mode.
pub trait Visitor {
    /// Does it in one mode.
    fn visit<I: Mode>(&mut self, name: &'static str, mode: I) -> Result<()>;
}

macro_rules! modes {
    ($($name:literal => $mode:expr,)*) => {
        /// What the modes are called: in tables, plots, and by the program `firmware`.
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
