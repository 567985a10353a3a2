//! Runs the simulator as a user would: what it makes of good input, and what it says to bad.
#![cfg(not(target_os = "none"))]

mod dumps;
mod files;
mod looks;
mod models;
mod program;
mod refused;
