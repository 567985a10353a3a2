//! Blending formulas in f64, for channels from 0 (black) to 1.

/// Opacity: a color covers another color by a share from 0 to 1.
pub fn over(above: f64, below: f64, share: f64) -> f64 {
    share * above + (1. - share) * below
}

/// The sum of two colors, clamped to white.
pub fn add(a: f64, b: f64) -> f64 {
    (a + b).min(1.)
}

/// The product of two colors: light through a filter.
pub fn multiply(a: f64, b: f64) -> f64 {
    a * b
}
