//! Draws models on a computer as a microcontroller would: into a framebuffer, with integers only.
//!
//! `cargo run --release -p simulator -- --help` lists its options.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]

mod args;
#[path = "../../common/mod.rs"]
mod common;
mod depth;
mod dump;
mod encoder;
mod export;
mod framing;
mod idle;
mod job;
mod look;
mod mode;
mod model;
mod output;
mod paint;
mod parts;
mod picture;
mod piece;
mod render;
mod report;
mod samples;
mod sight;
mod skin;
mod subject;
mod surface;
mod targets;
mod tiles;
mod tinted;
mod units;
mod view;
mod window;

use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches};

use args::Args;

/// An error, in words for the user.
type Result<T, E = Box<dyn Error>> = std::result::Result<T, E>;

fn main() -> ExitCode {
    let given = Args::command().get_matches();
    let args = Args::from_arg_matches(&given).unwrap_or_else(|error| error.exit());
    let done = output::remove_on_interrupt().and_then(|()| render::run(&args, &given));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Not eprintln!, which panics if nobody reads.
            let _ = writeln!(io::stderr(), "error: {error}");
            ExitCode::FAILURE
        }
    }
}
