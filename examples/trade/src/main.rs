//! Accuracy against speed: measures the error of every interpolation mode, beside its cost on a microcontroller.
//!
//! `cargo run --release -p trade` draws the measured scenes, and sets of random and adversarial planes, in every mode.
//! It compares each pixel with a model in f64 that gets the same snapped vertices, and writes to target/trade/:
//!
//! | file | contents |
//! |---|---|
//! | trade.csv, trade.md | a row for each scene and mode: texel errors, and instructions on Cortex-M |
//!
//! A texel error is the larger of the errors of column and row, on a texture of 256x256, whatever the scene's shader
//! is. The instructions are from tests/instructions.csv: `.ci/firmware --renew` counts them.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg(not(target_os = "none"))]
// f64 holds every integer used here exactly, and no pixel lies left of or above the picture.
#![allow(clippy::cast_precision_loss, clippy::cast_sign_loss)]

mod measure;
mod planes;
mod poses;
#[allow(dead_code)] // what programs that draw these scenes need
#[path = "../../common/scenes.rs"]
mod scenes;
mod table;

use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;

use table::Table;

/// An error message for the user.
type Result<T, E = Box<dyn Error>> = std::result::Result<T, E>;

/// Measures the error of every interpolation mode against a model in f64, and shows it beside the mode's cost on a
/// Cortex-M. Writes trade.csv and trade.md to target/trade/.
#[derive(Debug, Parser)]
#[command(name = "trade", version, max_term_width = 100)]
struct Args {
    /// Fewer planes: 20 in each set instead of 400.
    #[arg(long)]
    quick: bool,
}

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(args: &Args) -> Result<()> {
    let mut table = Table::new()?;
    table.add(&poses::floor()?);
    table.add(&poses::cube()?);
    table.add(&poses::sphere()?);
    table.add(&planes::wall()?);
    for scene in planes::sets(if args.quick { 20 } else { 400 }) {
        table.add(&scene?);
    }

    let folder = Path::new("target/trade");
    fs::create_dir_all(folder)?;
    fs::write(folder.join("trade.csv"), table.csv())?;
    fs::write(folder.join("trade.md"), table.markdown())?;
    println!("{}\nsaved in {}", table.markdown(), folder.display());
    Ok(())
}
