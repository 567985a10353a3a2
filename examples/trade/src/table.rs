//! The results as rows: as CSV for programs, and as Markdown for people.

use std::collections::HashMap;
use std::fmt::Write;
use std::fs;

use super::Result;
use super::measure::{MODES, Scene};

const COUNTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/instructions.csv");
/// The targets of the costs.
const TARGETS: [&str; 2] = ["thumbv7em-none-eabi", "thumbv6m-none-eabi"];

/// A scene in a mode.
struct Row {
    scene: &'static str,
    mode: &'static str,
    /// The largest error, in texels.
    max: f64,
    mean: f64,
    /// Instructions of a frame on each of the [`TARGETS`]; `None` if the scene is not drawn there.
    costs: [Option<f64>; 2],
}

/// All rows, and the counts of instructions that the project keeps.
pub struct Table {
    rows: Vec<Row>,
    /// The number in the last column of tests/instructions.csv, by the text of the columns before it.
    counts: HashMap<String, f64>,
}

impl Table {
    pub fn new() -> Result<Self> {
        let text = fs::read_to_string(COUNTS).map_err(|error| format!("{COUNTS}: {error}"))?;
        let count = |line: &str| {
            let (names, count) = line.rsplit_once(',')?;
            Some((names.to_owned(), count.parse().ok()?))
        };
        Ok(Self {
            rows: Vec::new(),
            counts: text.lines().filter_map(count).collect(),
        })
    }

    /// Adds a row for each mode.
    pub fn add(&mut self, scene: &Scene) {
        for ((mode, _), errors) in MODES.into_iter().zip(&scene.errors) {
            let name = scene.name;
            let costs = TARGETS.map(|target| {
                let key = format!("{target},3,{mode},{name},mean-of-poses");
                self.counts.get(&key).copied()
            });
            self.rows.push(Row {
                scene: name,
                mode,
                max: errors.max,
                mean: errors.mean(),
                costs,
            });
        }
    }

    /// Missing figures are empty.
    pub fn csv(&self) -> String {
        let [m4, m0] = TARGETS;
        let mut text = format!("scene,mode,texel_error_max,texel_error_mean,{m4},{m0}\n");
        for row in &self.rows {
            let [max, mean] = [row.max, row.mean].map(|error| digits(error, 4));
            let [m4, m0] = row
                .costs
                .map(|cost| cost.map_or(String::new(), |count| count.to_string()));
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{},{},{max},{mean},{m4},{m0}", row.scene, row.mode);
        }
        text
    }

    pub fn markdown(&self) -> String {
        let mut text = String::from(
            "| scene | mode | texel error: max | mean | Cortex-M4: million instructions a frame | Cortex-M0+ |\n\
             |---|---|---:|---:|---:|---:|\n",
        );
        for row in &self.rows {
            let [max, mean] = [row.max, row.mean].map(|error| digits(error, 2));
            let [m4, m0] = row
                .costs
                .map(|cost| cost.map_or("–".into(), |count| format!("{:.2}", count / 1e6)));
            let _ = writeln!(
                text,
                "| {} | {} | {max} | {mean} | {m4} | {m0} |",
                row.scene, row.mode
            );
        }
        text
    }
}

/// Formats a number with this many significant digits, or with all digits of a larger integer, without an exponent.
fn digits(value: f64, significant: i32) -> String {
    if value == 0. {
        return "0".into();
    }
    let places = significant - 1 - value.abs().log10().floor() as i32;
    format!("{value:.*}", places.clamp(0, 12) as usize)
}
