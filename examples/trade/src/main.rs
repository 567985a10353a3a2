//! Speed against accuracy: every mode of interpolation, measured.
//!
//! `cargo run --release -p trade` draws the four measured scenes and sets of random and
//! adversarial planes in every mode, compares each pixel with a model in f64 that is given the same
//! snapped vertices, and takes the time of the drawing calls. Into target/trade/ go
//!
//! | file | what |
//! |---|---|
//! | trade.csv, trade.md | a row for each scene, mode and target: cost, texel error, PSNR, code |
//! | trade.png, trade.svg | texel error against cost |
//! | sweeps.csv, sweep-….png, sweep-….svg | error and cost against depth ratio, slope of 1/w, size of the texture, resolution |
//!
//! Cortex-M's cost is taken from what the program `firmware` prints:
//!
//! ```sh
//! cargo run --release -p firmware --target thumbv7em-none-eabi > target/thumbv7em
//! .ci/sizes --modes > target/sizes
//! cargo run --release -p trade -- --firmware target/thumbv7em --sizes thumbv7em=target/sizes
//! ```
//!
//! Code is that of the smallest firmware which draws textured triangles with a depth buffer in the mode, beyond one that draws
//! nothing, at opt-level "s"; instructions are those of opt-level 3.
//!
//! Texel errors are the greater of column's and row's, on a texture of 256x256, whatever the scene is
//! painted with. PSNR is that of the RGB565 picture against the model's, of the pixels that the scene
//! covers; the background would only flatter it.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]
// f64 holds every integer used here, and no pixel is left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

mod args;
mod case;
#[path = "../../common/mod.rs"]
mod common;
mod firmware;
mod measure;
mod measured;
mod modes;
mod paint;
mod planes;
mod plot;
mod record;
#[path = "../../../tests/reference/mod.rs"]
mod reference;
mod run;
mod spread;
mod sweep;
mod table;
mod texture;
mod time;
mod truth;

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;

use args::Args;

/// What went wrong, in words for the user.
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
