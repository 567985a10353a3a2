//! Runs the simulator as a user would: its output for good input, and its messages for bad input.
#![cfg(not(target_os = "none"))]

mod dumps;
mod files;
mod flags;
mod framing;
mod looks;
mod models;
mod program;
mod refused;
