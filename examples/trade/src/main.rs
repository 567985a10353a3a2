//! Speed against accuracy: measures every interpolation mode.
//!
//! `cargo run --release -p trade` draws the four measured scenes, and sets of random and adversarial planes, in every
//! mode. The program compares each pixel with a model in f64 that gets the same snapped vertices, and measures the time
//! of the draw calls. The program writes to target/trade/:
//! | file | what |
//! |---|---|
//! | trade.csv, trade.md | a row for each scene, mode and target: cost, texel error, PSNR, code |
//! | trade.png, trade.svg | texel error against cost |
//! | sweeps.csv, sweep-….png, sweep-….svg | error and cost against depth ratio, slope of 1/w, size of the texture, resolution |
//!
//! The cost on a Cortex-M comes from the output of the program `firmware`:
//!
//! ```sh
//! cargo run --profile speed -p firmware --target thumbv7em-none-eabi > target/thumbv7em
//! .ci/sizes --modes > target/sizes
//! cargo run --release -p trade -- --firmware target/thumbv7em --sizes thumbv7em=target/sizes
//! ```
//!
//! The size of the code is the size of the smallest firmware that draws textured triangles with a depth buffer in the
//! mode, minus the size of a firmware that draws nothing, at opt-level "s". Instructions are counted at opt-level 3.
//!
//! With `--summary`, the program measures nothing. It draws the figures that the project keeps as one picture, for
//! README.
//!
//! A texel error is the larger of the errors of column and row, on a texture of 256x256, whatever the scene's shader
//! is. PSNR compares the RGB565 picture with the model's picture at the pixels that the scene covers. The background
//! would only raise the PSNR.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]
// f64 holds every integer used here exactly, and no pixel lies left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

mod args;
mod case;
mod firmware;
mod measure;
mod measured;
mod modes;
mod planes;
mod plot;
mod record;
mod run;
#[allow(dead_code)] // what programs that draw these scenes need
#[path = "../../common/scenes.rs"]
mod scenes;
mod spread;
mod surface;
mod sweep;
mod table;
mod texture;
mod time;
mod truth;

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;

use args::Args;

/// An error message for the user.
type Result<T, E = Box<dyn Error>> = std::result::Result<T, E>;

fn main() -> ExitCode {
    match run::run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
