//! Runs the simulator as a user does, and checks its output for good input and its messages for bad input.
#![cfg(not(target_os = "none"))]

mod dumps;
mod formats;
mod framing;
mod kinds;
mod looks;
mod materials;
mod models;
mod options;
mod output;
mod program;
mod random;
mod refused;
mod scenery;
mod textures;
