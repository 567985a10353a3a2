//! Fog: what is left of a surface at a distance.

/// What is left between two distances, where the fog begins and where it hides everything.
pub fn linear(distance: f64, near: f64, far: f64) -> f64 {
    ((far - distance) / (far - near)).clamp(0., 1.)
}

/// What is left in fog that is equally thick everywhere.
pub fn exponential(distance: f64, density: f64) -> f64 {
    (-density * distance).exp().min(1.)
}
