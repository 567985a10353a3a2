//! Draws models on a computer as a microcontroller would: into a framebuffer, with integers only.
//!
//! `cargo run --release -p simulator -- --help` lists its options.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]

mod args;
#[path = "../../common/mod.rs"]
mod common;
mod dump;
mod export;
mod fit;
mod framing;
mod job;
mod mode;
mod model;
mod normals;
mod notes;
mod output;
mod paint;
mod parts;
mod piece;
mod render;
mod sight;
mod skin;
mod subject;
mod targets;
mod turntable;
mod units;
mod view;
mod window;

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;

use args::Args;

/// An error, in words for the user.
type Result<T, E = Box<dyn Error>> = std::result::Result<T, E>;

fn main() -> ExitCode {
    match render::run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
