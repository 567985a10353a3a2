//! Guides: longer than the page of an item, and all of their drawing code is compiled and run.

#[doc = include_str!("firmware.md")]
pub mod firmware {}

#[doc = include_str!("modes.md")]
pub mod modes {}

#[doc = include_str!("limits.md")]
#[doc = include_str!("extremes.md")]
pub mod limits {}
