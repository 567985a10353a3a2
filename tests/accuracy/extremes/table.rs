//! The table of the worst errors: every run writes it, and it must be no worse than the table in the guide.

use std::fmt::Write;
use std::sync::LazyLock;
use std::{env, fs};

use super::verdict::{Verdict, Worst};

/// Rows of the table. Each row is measured only once, for its own test and for the table.
pub type Cases = LazyLock<Vec<Row>>;

/// A row of the table.
pub struct Row {
    pub case: String,
    pub cells: Cells,
}

/// The measured errors of a row.
pub enum Cells {
    /// The differences between the crate's picture and the model's picture.
    Picture(Verdict),
    /// Any other error, with its unit.
    Figure(&'static str, Worst),
}

/// Makes a row for a picture. At least one pixel must be drawn.
pub fn picture(case: &str, verdict: Verdict) -> Row {
    assert!(verdict.pixels > 0, "{case}: nothing was drawn");
    Row {
        case: case.to_owned(),
        cells: Cells::Picture(verdict),
    }
}

/// Makes a row for a single error with its unit, instead of a picture. The error must be within its bound.
pub fn figure(case: &str, unit: &'static str, worst: Worst) -> Row {
    assert!(worst.measured <= worst.bound, "{case}: {worst:?}");
    Row {
        case: case.to_owned(),
        cells: Cells::Figure(unit, worst),
    }
}

/// Formats a number with two significant digits.
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
    // A bound of 0 means that the error was never measured.
    if worst.bound == 0. {
        return "–".to_owned();
    }
    format!("{} ≤ {}", digits(worst.measured), digits(worst.bound))
}

/// The table of pictures and the table of other errors, as Markdown.
fn markdown(rows: &[&Row]) -> String {
    let mut text = String::from(
        "| case | pixels | texels, `Newton::NARROW` | texels, `Exact` | texels, `Fast` to ¼ | depth steps |\n|---|---|---|---|---|---|\n",
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
    text.push_str("\n| case | error |\n|---|---|\n");
    for row in rows {
        if let Cells::Figure(unit, worst) = row.cells {
            writeln!(text, "| {} | {} {unit} |", row.case, cell(worst)).unwrap();
        }
    }
    text
}

/// Whether the table `found` has the same rows as the table `shown`, and no error exceeds the shown error by more than
/// a fifth plus 10⁻⁴. The margin is needed because sines of another computer can change the last bit of a corner. If an
/// error is smaller than shown, its bound can differ, because the error can be from another pixel.
fn is_no_worse(found: &str, shown: &str) -> bool {
    let found: Vec<&str> = found.split_whitespace().collect();
    let shown: Vec<&str> = shown.split_whitespace().collect();
    let figures = |at: usize| Some((found[at].parse().ok()?, shown[at].parse().ok()?));
    let is_smaller =
        |at: usize| figures(at).is_some_and(|(found, shown): (f64, f64)| found < shown);
    let is_larger =
        |at: usize| figures(at).is_none_or(|(found, shown): (f64, f64)| found > 1.2 * shown + 1e-4);
    let is_kept = |at: usize| {
        if found[at] == shown[at] {
            true
        } else if found.get(at + 1) == Some(&"≤") {
            !is_larger(at)
        } else {
            at > 1 && found[at - 1] == "≤" && (is_smaller(at - 2) || !is_larger(at))
        }
    };
    found.len() == shown.len() && (0..found.len()).all(is_kept)
}

#[test]
fn only_larger_errors_and_other_lines_are_worse() {
    let shown = "| 2 of a | 0.050 ≤ 0.28 |";
    for alike in [
        shown,
        "| 2 of a | 0.055 ≤ 0.28 |",
        "| 2 of a | 0.010 ≤ 0.28 |",
        "| 2 of a | 0 ≤ 3 |",
    ] {
        assert!(is_no_worse(alike, shown), "{alike}");
    }
    assert!(is_no_worse("| a | 4e-5 ≤ 1 |", "| a | 0 ≤ 1 |"));
    for worse in [
        "| 2 of a | 0.070 ≤ 0.28 |",
        "| 2 of a | 0.050 ≤ 0.40 |",
        "| 1 of a | 0.050 ≤ 0.28 |",
        "| 2 of b | 0.050 ≤ 0.28 |",
        "| 2 of a | – |",
        "| 2 of a | 0.050 ≤ 0.28 |\n| b |",
    ] {
        assert!(!is_no_worse(worse, shown), "{worse}");
    }
}

/// The table in the guide.
const SHOWN: &str = include_str!("../../../src/guide/extremes.md");

#[test]
fn nothing_is_worse_than_the_guide_shows() {
    let all: [&Cases; 10] = [
        &super::planes::CASES,
        &super::depth::CASES,
        &super::coordinates::CASES,
        &super::outlines::CASES,
        &super::small::CASES,
        &super::canvases::CASES,
        &super::textures::CASES,
        &super::meshes::CASES,
        &super::parallel::CASES,
        &super::rotations::CASES,
    ];
    let rows: Vec<&Row> = all.iter().flat_map(|cases| cases.iter()).collect();
    let text = markdown(&rows);
    let target = env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    let path = std::path::Path::new(&target).join("extremes.md");
    fs::create_dir_all(&target).unwrap();
    fs::write(&path, &text).unwrap();
    assert!(
        is_no_worse(&text, SHOWN),
        "worse than src/guide/extremes.md: look at {0}, and if the change is intended, copy it there",
        path.display()
    );
}
