//! The results as rows: as CSV for programs, and as Markdown for people.

use std::fmt::Write;
use std::path::Path;

use super::Result;
use super::spread::Spread;

/// The name of the computer on which this program runs, as a target.
pub const HOST: &str = "host";

/// A row: a scene in a mode on a target, and its figures.
#[derive(Clone, Debug)]
pub struct Row {
    pub scene: &'static str,
    pub mode: &'static str,
    pub target: String,
    /// The cost of a frame: in nanoseconds on the host, in instructions on other targets.
    pub per_frame: f64,
    pub per_pixel: f64,
    pub error: Option<Spread>,
    pub psnr: f64,
    /// The number of bytes of code that is optimized for size.
    pub code: Option<u64>,
}

impl Row {
    pub fn unit(&self) -> &'static str {
        unit(&self.target)
    }
}

/// Returns the unit of the cost on a target.
pub fn unit(target: &str) -> &'static str {
    if target == HOST { "ns" } else { "instructions" }
}

/// Writes all rows, with a column for each figure. Missing figures are empty.
pub fn write_csv(path: &Path, rows: &[Row]) -> Result<()> {
    let mut out = csv::Writer::from_path(path)?;
    out.write_record([
        "scene",
        "mode",
        "target",
        "unit",
        "cost_per_frame",
        "cost_per_pixel",
        "texel_error_max",
        "texel_error_p99",
        "texel_error_mean",
        "psnr_db",
        "code_bytes",
    ])?;
    for row in rows {
        let error = |figure: fn(&Spread) -> f64| {
            row.error.as_ref().map(figure).map_or(String::new(), number)
        };
        out.write_record([
            row.scene.to_owned(),
            row.mode.to_owned(),
            row.target.clone(),
            row.unit().to_owned(),
            format!("{:.0}", row.per_frame),
            format!("{:.3}", row.per_pixel),
            error(|error| error.max),
            error(|error| error.p99),
            error(|error| error.mean),
            format!("{:.2}", row.psnr),
            row.code.map_or(String::new(), |code| code.to_string()),
        ])?;
    }
    Ok(out.flush()?)
}

/// Formats a number with four significant digits, without an exponent.
pub fn number(value: f64) -> String {
    if value == 0. {
        return "0".into();
    }
    let digits = 3 - value.abs().log10().floor() as i32;
    format!("{value:.*}", digits.clamp(0, 12) as usize)
}

/// A table with a row for each scene and mode, and a column with the cost on each target.
pub fn markdown(rows: &[Row]) -> String {
    let mut targets: Vec<&str> = rows.iter().map(|row| row.target.as_str()).collect();
    let mut seen = std::collections::HashSet::new();
    targets.retain(|target| seen.insert(*target));

    let has_code = |target: &str| {
        rows.iter()
            .any(|row| row.target == target && row.code.is_some())
    };

    let mut head = String::from("| scene | mode | texel error: max | 99 % | mean | PSNR, dB |");
    let mut rule = String::from("|---|---|---:|---:|---:|---:|");
    for &target in &targets {
        if target == HOST {
            head += " host: ns per pixel |";
            rule += "---:|";
        } else {
            // Writing to a string cannot fail.
            let _ = write!(
                head,
                " {target}: million instructions a frame | per pixel |"
            );
            rule += "---:|---:|";
        }
        if has_code(target) {
            let _ = write!(head, " {target}: bytes of code, for size |");
            rule += "---:|";
        }
    }
    let mut text = format!("{head}\n{rule}\n");
    for row in rows.iter().filter(|row| row.target == HOST) {
        let error =
            |figure: fn(&Spread) -> f64| row.error.as_ref().map(figure).map_or("–".into(), short);
        let _ = write!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            row.scene,
            row.mode,
            error(|error| error.max),
            error(|error| error.p99),
            error(|error| error.mean),
            if row.psnr.is_finite() {
                format!("{:.1}", row.psnr)
            } else {
                "all alike".into()
            },
        );
        for &target in &targets {
            let here = rows.iter().find(|other| {
                (other.scene, other.mode, other.target.as_str()) == (row.scene, row.mode, target)
            });
            let cell = |text: Option<String>| format!(" {} |", text.unwrap_or_else(|| "–".into()));
            if target != HOST {
                text += &cell(here.map(|row| format!("{:.2}", row.per_frame / 1e6)));
            }
            text += &cell(here.map(|row| format!("{:.1}", row.per_pixel)));
            if has_code(target) {
                text += &cell(here.and_then(|row| row.code).map(|code| code.to_string()));
            }
        }
        text.push('\n');
    }
    text
}

/// Formats a number with two significant digits.
fn short(value: f64) -> String {
    if value == 0. {
        return "0".into();
    }
    let digits = 1 - value.abs().log10().floor() as i32;
    format!("{value:.*}", digits.clamp(0, 12) as usize)
}
