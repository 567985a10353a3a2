//! The f64 model compared with numbers worked out by hand, so that the model can be trusted to judge the crate.

// As in the model: formulas keep textbook names, and f64 represents every integer used here exactly.
#![allow(clippy::cast_precision_loss)]

mod helpers;

mod clipping;
mod covering;
mod interpolation;
mod linear_algebra;
mod measured;
mod outline;
mod pictures;
mod projecting;
mod screen;
mod segments;

use helpers::{EPSILON, Random, Torus, close, close_matrix};
use support::reference::coverage::{Bounds, Corners, center};
use support::reference::linear::{IDENTITY, Matrix, Vec3};
use support::reference::{
    attributes, clip, coverage, distance, linear, lines, projection, raster, scenes, silhouette,
    view,
};
