//! Draws models on a computer as a microcontroller would: into a framebuffer, with integers only.
//!
//! `cargo run --release -p simulator -- --help` lists its options. A run goes through the modules in this order:
//!
//! 1. Read the command line: [`args`]. [`idle`] notes options without effect.
//! 2. Read files: [`model`] reads a mesh of any size in f64; [`picture`] and [`skin`] read textures.
//! 3. Choose the camera in the model's units: [`framing`], with the vectors of [`vector`].
//! 4. Convert to fixed point: [`units`] chooses the scale, [`view`] makes camera and light, and [`parts`] makes meshes
//!    of 16-bit indices. [`subject`] holds all of it; a [`piece`] is a mesh with its material.
//! 5. Choose shaders: [`look`] has light and fog, and [`draw`] a shader for each piece. [`surface`] hides their types,
//!    and [`tinted`] is a shader that the library lacks. [`mode`] and [`depth`] choose the library's types at run time.
//! 6. Check that something is visible: [`sight`].
//! 7. Draw: [`job`] draws a band of a frame, [`tiles`] a picture of bands and tiles, and [`samples`] smooths edges.
//!    [`render`] runs all of it in the chosen color.
//! 8. Write: [`targets`] opens and fills all outputs: [`encoder`] writes pictures, [`dump`] tables, and [`export`] Rust
//!    source. [`output`] makes sure that no file is lost.
//! 9. Tell the user: [`report`] prints lines, [`progress`] shows long tasks, and [`window`] shows the picture.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]

mod args;
#[path = "../../common/mod.rs"]
mod common;
mod depth;
mod draw;
mod dump;
mod encoder;
mod export;
mod framing;
mod idle;
mod job;
mod look;
mod mode;
mod output;
mod parts;
mod piece;
mod progress;
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

use clap::FromArgMatches;

use args::Args;

/// An error, in words for the user.
type Result<T, E = Box<dyn Error>> = std::result::Result<T, E>;

fn main() -> ExitCode {
    let matches = args::command().get_matches();
    let args = Args::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    let done = output::remove_on_interrupt().and_then(|()| render::run(&args, &matches));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            // Not eprintln!, which panics if standard error is closed.
            let _ = writeln!(io::stderr(), "error: {error}");
            ExitCode::FAILURE
        }
    }
}
