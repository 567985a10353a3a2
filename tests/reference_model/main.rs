//! The f64 model against numbers worked by hand, so that it may judge the crate.

// As in the model: textbook names, and f64 holds every integer used here.
#![allow(clippy::many_single_char_names, clippy::cast_precision_loss)]

#[path = "../reference/mod.rs"]
mod reference;

mod given;

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

use given::{EPSILON, Random, Torus, close, close_matrix};
use reference::coverage::{Bounds, Corners, centre};
use reference::linear::{IDENTITY, Matrix, Vec3};
use reference::{
    attributes, clip, coverage, distance, linear, lines, projection, raster, scenes, silhouette,
    view,
};
