//! Draws models on a computer as a microcontroller would: into a framebuffer, and with integers only.
//!
//! `cargo run --release -p simulator -- --help` lists the options. A run goes through the modules in this order:
//!
//! 1. Read the command line: [`args`]. [`idle`] notes options without effect.
//! 2. Read files: `fixel_assets` reads a model of any size in f64, and [`skin`] reads textures.
//! 3. Choose the camera in the model's units: [`framing`].
//! 4. Convert to fixed point: [`units`] chooses the scale, [`view`] makes camera and light, and [`part`] makes meshes
//!    of 16-bit indices. [`subject`] holds the result, and [`scene`] draws it.
//! 5. Look at it: [`sight`] checks that something will be visible, and [`advice`] what the user should know.
//! 6. Choose shaders: [`look`] has light and fog, and [`paint`] a shader for each piece. [`surface`] hides their types,
//!    and [`mode`] chooses the library's types at run time.
//! 7. Draw: [`draw`].
//! 8. Write: [`targets`] opens and fills all outputs: [`encoder`] writes pictures, and [`dump`] tables. [`output`]
//!    makes sure that no file is lost.
//! 9. Tell the user: [`report`] prints lines, [`progress`] shows long tasks, and [`window`] shows the picture.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]

mod advice;
mod args;
mod common;
mod draw;
mod dump;
mod encoder;
mod framing;
mod idle;
mod look;
mod mode;
mod output;
mod paint;
mod part;
mod progress;
mod report;
mod run;
mod scene;
mod sight;
mod skin;
mod subject;
mod surface;
mod targets;
mod units;
mod view;
mod window;

use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;

use args::Args;

/// An error message for the user.
type Result<T, E = Box<dyn Error>> = std::result::Result<T, E>;

fn main() -> ExitCode {
    let (error, code) = match Args::parse() {
        Err(error) => (format!("{error}\n\nFor more information, try '--help'."), 2),
        Ok(args) => match run::run(&args) {
            Err(error) => (error.to_string(), 1),
            Ok(()) => return ExitCode::SUCCESS,
        },
    };
    // Not eprintln!, which panics if standard error is closed.
    let _ = writeln!(io::stderr(), "error: {error}");
    ExitCode::from(code)
}
