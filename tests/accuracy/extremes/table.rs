//! The table of the worst errors: written by every run, and held to what the guide shows.

use std::fmt::Write;
use std::sync::LazyLock;
use std::{env, fs};

use super::verdict::{Verdict, Worst};

/// What is measured once, for its own test and for the table.
pub type Cases = LazyLock<Vec<Row>>;

/// A line of the table.
pub struct Row {
    pub case: String,
    pub cells: Cells,
}

/// What was measured.
pub enum Cells {
    /// A picture against the model's.
    Picture(Verdict),
    /// Anything else, in a unit of its own.
    Figure(&'static str, Worst),
}

/// A line for a picture, which must not be empty.
pub fn picture(case: &str, verdict: Verdict) -> Row {
    assert!(verdict.pixels > 0, "{case}: nothing was drawn");
    Row {
        case: case.to_owned(),
        cells: Cells::Picture(verdict),
    }
}

/// A line for a figure.
pub fn figure(case: &str, unit: &'static str, worst: Worst) -> Row {
    assert!(worst.measured <= worst.bound, "{case}: {worst:?}");
    Row {
        case: case.to_owned(),
        cells: Cells::Figure(unit, worst),
    }
}

/// Two digits that count.
fn digits(x: f64) -> String {
    match x {
        0. => "0".to_owned(),
        x if x < 0.000_95 => format!("{x:.0e}"),
        x if x < 0.0095 => format!("{x:.4}"),
        x if x < 0.095 => format!("{x:.3}"),
        x if x < 0.95 => format!("{x:.2}"),
        x if x < 9.5 => format!("{x:.1}"),
        x => format!("{x:.0}"),
    }
}

fn cell(worst: Worst) -> String {
    // What was never compared has no bound.
    if worst.bound == 0. {
        return "–".to_owned();
    }
    format!("{} ≤ {}", digits(worst.measured), digits(worst.bound))
}

/// Both tables as Markdown.
fn markdown(rows: &[&Row]) -> String {
    let mut text = String::from(
        "| case | pixels | texels, `Newton` | texels, `Exact` | texels, `Fast` to ¼ | depth steps |\n|---|---|---|---|---|---|\n",
    );
    for row in rows {
        if let Cells::Picture(verdict) = &row.cells {
            let [newton, exact, fast] = verdict.texels.map(cell);
            let (pixels, depth) = (cell(verdict.coverage), cell(verdict.depth));
            let case = &row.case;
            writeln!(
                text,
                "| {case} | {pixels} | {newton} | {exact} | {fast} | {depth} |"
            )
            .unwrap();
        }
    }
    text.push_str("\n| case | off by at most |\n|---|---|\n");
    for row in rows {
        if let Cells::Figure(unit, worst) = row.cells {
            writeln!(text, "| {} | {} {unit} |", row.case, cell(worst)).unwrap();
        }
    }
    text
}

/// Whether two tables differ in figures alone, and those by no more than a fifth, or by less than 10⁻⁴: sines that are
/// another computer's put a corner elsewhere by the last bit.
fn are_alike(a: &str, b: &str) -> bool {
    let are_alike = |(a, b): (&str, &str)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 0.2 * a.max(b) + 1e-4,
        _ => a == b,
    };
    let (a, b) = (a.split_whitespace(), b.split_whitespace());
    a.clone().count() == b.clone().count() && a.zip(b).all(are_alike)
}

#[test]
fn tables_that_differ_are_told_apart() {
    assert!(are_alike("| a | 0.050 ≤ 0.28 |", "| a | 0.055 ≤ 0.28 |"));
    assert!(are_alike("| a | 0 ≤ 1 |", "| a | 4e-5 ≤ 1 |"));
    for other in [
        "| a | 0.070 ≤ 0.28 |",
        "| b | 0.050 ≤ 0.28 |",
        "| a | 0.050 ≤ 0.28 |\n| b |",
    ] {
        assert!(!are_alike("| a | 0.050 ≤ 0.28 |", other), "{other}");
    }
}

/// The table's state in the guide.
const SHOWN: &str = include_str!("../../../src/guide/extremes.md");

#[test]
fn the_guide_shows_what_is_measured() {
    let all: [&Cases; 9] = [
        &super::planes::CASES,
        &super::depth::CASES,
        &super::coordinates::CASES,
        &super::outlines::CASES,
        &super::small::CASES,
        &super::canvases::CASES,
        &super::textures::CASES,
        &super::meshes::CASES,
        &super::rotations::CASES,
    ];
    let rows: Vec<&Row> = all.iter().flat_map(|cases| cases.iter()).collect();
    let text = markdown(&rows);
    let target = env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    let path = std::path::Path::new(&target).join("extremes.md");
    fs::create_dir_all(&target).unwrap();
    fs::write(&path, &text).unwrap();
    assert!(
        are_alike(&text, SHOWN),
        "src/guide/extremes.md is not what was measured: look at {0}, and if all is well, copy it there",
        path.display()
    );
}
