//! Scenes that examples share, without the parts that need the library's macros.

// What only other examples use.
#![allow(dead_code)]

#[path = "../../common/layers.rs"]
pub mod layers;
#[path = "../../common/lighthouse/scenery.rs"]
pub mod lighthouse;
#[path = "../../common/scenes.rs"]
pub mod scenes;
