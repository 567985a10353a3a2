//! The command line.

use std::path::{Path, PathBuf};

use clap::Parser;

const EXAMPLES: &str = "\
Examples:
  trade                                        everything, into target/trade/
  trade --quick                                the same from fewer planes and repetitions
  trade --firmware target/ci/thumbv7em-none-eabi --firmware m0p=target/thumbv6m
                                               with the cost on two Cortex-M cores
  trade --firmware target/thumbv7em --sizes thumbv7em=target/sizes
                                               and the code that each mode takes
  trade --summary src/assets/macros/pictures/trade.png  one picture from the figures that the project keeps";

/// Measures every interpolation mode: its error against a model in f64, and its cost.
#[derive(Clone, Debug, Parser)]
#[command(name = "trade", version, after_help = EXAMPLES, max_term_width = 100)]
pub struct Args {
    /// Fewer planes, repetitions and steps: less than a minute.
    #[arg(long)]
    pub quick: bool,

    /// Output of the program `firmware` on a target. Without TARGET=, the file's name is the target's. May be
    /// repeated.
    #[arg(long, value_name = "[TARGET=]FILE", value_parser = named)]
    pub firmware: Vec<Named>,

    /// Bytes of code on a target of --firmware, lines of MODE,BYTES, as `.ci/sizes --modes` prints them. May be
    /// repeated.
    #[arg(long, value_name = "[TARGET=]FILE", value_parser = named)]
    pub sizes: Vec<Named>,

    /// Triangles in each set of planes. [default: 400, with --quick 60]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub planes: Option<u32>,

    /// Repetitions of each drawing; their median time counts. [default: 41, with --quick 9]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub repeats: Option<u32>,

    /// Measure only the scenes and planes, and leave out the sweeps.
    #[arg(long)]
    pub no_sweeps: bool,

    /// Measure nothing, and draw what tests/instructions.csv and tests/figures.csv say as one picture.
    #[arg(long, value_name = "PNG")]
    pub summary: Option<PathBuf>,

    /// Directory for the results.
    #[arg(long, value_name = "DIR", default_value = "target/trade")]
    pub out: PathBuf,
}

/// A file with the name of its target.
#[derive(Clone, Debug)]
pub struct Named {
    pub target: String,
    pub file: PathBuf,
}

impl Args {
    pub fn planes(&self) -> u32 {
        self.planes.unwrap_or(if self.quick { 60 } else { 400 })
    }

    pub fn repeats(&self) -> u32 {
        self.repeats.unwrap_or(if self.quick { 9 } else { 41 })
    }
}

fn named(text: &str) -> Result<Named, String> {
    let (target, file) = if let Some((target, file)) = text.split_once('=') {
        (target.to_owned(), Path::new(file))
    } else {
        let file = Path::new(text);
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        // The name is not the file stem, because thumbv8m.main is a target.
        let endings = [".txt", ".log", ".csv"].into_iter();
        let target = endings.fold(name.as_ref(), |name, end| {
            name.strip_suffix(end).unwrap_or(name)
        });
        (target.to_owned(), file)
    };
    if target.is_empty() || file.as_os_str().is_empty() {
        return Err("it must be a file, or TARGET=FILE".into());
    }
    Ok(Named {
        target,
        file: file.into(),
    })
}
