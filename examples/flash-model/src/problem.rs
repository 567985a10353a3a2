//! Why there is no model.

use core::fmt;

use crate::header::VERSION;

/// Why a model cannot be read. Each message is at most three lines of 36 letters, for a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Problem {
    /// Flash does not have the model's first word.
    Missing,
    /// The model's format has this version.
    Version(u32),
    /// This number of bytes does not fit the header and the flash.
    Length(u32),
    /// The model's bytes have another checksum than its header.
    Checksum {
        /// The checksum of the bytes.
        is: u32,
        /// The checksum in the header.
        wanted: u32,
    },
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
            Self::Lists => f.write_str("The model's lists do not fit\neach other."),
        }
    }
}
