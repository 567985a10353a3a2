//! Prints lines for the user.

use std::fmt::Display;
use std::io::{self, Write};

use super::Result;
use crate::args::Args;
use crate::output;

/// Prints a line as [`answer`] does, but prints nothing if the user wants no lines.
///
/// # Errors
///
/// The line cannot be written, for example because the disk is full, or the reader of a pipe has ended.
pub fn say(args: &Args, line: impl Display) -> Result<()> {
    if args.quiet {
        return Ok(());
    }
    answer(args, line)
}

/// Prints a line that the user asked for. The line goes to standard output, or to standard error if standard output
/// gets a file.
///
/// # Errors
///
/// The line cannot be written, for example because the disk is full, or the reader of a pipe has ended.
pub fn answer(args: &Args, line: impl Display) -> Result<()> {
    let is_taken = [&args.out, &args.dump]
        .into_iter()
        .flatten()
        .any(|path| output::is_stdout(path));
    if is_taken {
        writeln!(io::stderr(), "{line}")
            .map_err(|error| format!("cannot write to standard error: {error}").into())
    } else {
        print(line)
    }
}

/// Prints a line to standard output.
///
/// # Errors
///
/// As for [`answer`].
pub fn print(line: impl Display) -> Result<()> {
    writeln!(io::stdout(), "{line}")
        .map_err(|error| format!("cannot write to standard output: {error}").into())
}

/// Prints remarks to standard error.
///
/// # Errors
///
/// Standard error cannot be written.
pub fn notes(args: &Args, notes: impl IntoIterator<Item = impl Display>) -> Result<()> {
    if args.quiet {
        return Ok(());
    }
    for note in notes {
        writeln!(io::stderr(), "note: {note}")?;
    }
    Ok(())
}
