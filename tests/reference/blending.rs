//! Blending as formulas of f64: channels from 0 (black) to 1.

/// A color that covers another by a share.
pub fn over(above: f64, below: f64, share: f64) -> f64 {
    share * above + (1. - share) * below
}

/// Two lights on one place, at most white.
pub fn add(a: f64, b: f64) -> f64 {
    (a + b).min(1.)
}

/// A light through a filter.
pub fn multiply(a: f64, b: f64) -> f64 {
    a * b
}
