//! The reasons why a model cannot be read.

use core::fmt;

use crate::ModuleProblem;
use crate::header::VERSION;

/// Why a model cannot be read. A message has at most three lines of 36 characters, so that it fits on a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Problem {
    /// Flash does not have the model's first word.
    Missing,
    /// The model's format has this version, and the program cannot read it.
    Version(u32),
    /// The header states this length in bytes, but the length is not a multiple of 4, is less than the length of the
    /// header, or reaches beyond the flash.
    Length(u32),
    /// The checksum of the model's bytes differs from the checksum in its header.
    Checksum {
        /// The checksum of the bytes.
        is: u32,
        /// The checksum in the header.
        wanted: u32,
    },
    /// No program can use the module.
    Module(ModuleProblem),
    /// The lists do not fit each other, although the checksum is right.
    Lists,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing => f.write_str("There is no model in flash."),
            Self::Version(version) => write!(
                f,
                "The model has version {version}.\nThis program reads {VERSION}."
            ),
            Self::Length(length) => {
                write!(f, "The model's length is wrong:\n{length} bytes.")
            }
            Self::Checksum { is, wanted } => write!(
                f,
                "The model is damaged.\nIts checksum is {is:08x}.\nIt should be {wanted:08x}."
            ),
            // The problem itself is too long for a line. The command that writes a model prints it.
            Self::Module(_) => f.write_str("The display's module has\nwrong values."),
            Self::Lists => f.write_str("The model's lists do not fit\neach other."),
        }
    }
}
