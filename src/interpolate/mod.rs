//! Interpolation in perspective.
