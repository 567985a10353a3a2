//! Helpers for the tests of formulas: conversions between the crate's formats and f64, the steps of the formats, and
//! rows of tables in the guide.

use fixel::{Fraction, Matrix4, Scalar, Vec3};

/// The step of coordinates. A value that is rounded once has an error of up to half a step.
pub const STEP: f64 = 1.0 / 65_536.0;
/// The step of sines, cosines and fractions.
pub const UNIT_STEP: f64 = 1.0 / 1_073_741_824.0;

pub fn unit(value: f64) -> Fraction {
    Fraction::try_from(value).unwrap()
}

pub fn vec(x: f64, y: f64, z: f64) -> Vec3 {
    Vec3::try_from([x, y, z]).unwrap()
}

pub fn float(value: Scalar) -> f64 {
    f64::from(value)
}

pub fn close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} is not {expected}, within {tolerance}"
    );
}

pub fn all_close<const N: usize>(found: [f64; N], expected: [f64; N], tolerance: f64) {
    for (found, expected) in found.into_iter().zip(expected) {
        close(found, expected, tolerance);
    }
}

/// Compares two matrices entry by entry.
pub fn same_matrix(found: &Matrix4, expected: [[f64; 4]; 4], tolerance: f64) {
    for (found, expected) in found.rows().iter().zip(expected) {
        all_close(found.map(float), expected, tolerance);
    }
}

/// A number as the guide writes it, with a minus sign that is as wide as a digit.
pub fn digits(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    text.replace('-', "−")
}

/// Checks that a page of the guide has a table with this row.
pub fn assert_row(page: &str, cells: &[String]) {
    let row = format!("//! | {} |\n", cells.join(" | "));
    assert!(page.contains(&row), "the page has no row {row}");
}
