//! Fog: the part of a surface's color, from 0 to 1, that shows through fog at a distance.

/// The part that shows through fog that begins at the distance `near` and hides everything from `far` on.
pub fn linear(distance: f64, near: f64, far: f64) -> f64 {
    ((far - distance) / (far - near)).clamp(0., 1.)
}

/// The part that shows through fog of constant density.
pub fn exponential(distance: f64, density: f64) -> f64 {
    (-density * distance).exp().min(1.)
}
