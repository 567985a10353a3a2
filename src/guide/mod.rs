//! Guides, longer than an item's page. Their drawing code is compiled and run as doctests.

#[doc = include_str!("firmware.md")]
pub mod firmware {}

#[doc = include_str!("modes.md")]
pub mod modes {}

#[doc = include_str!("benchmarks.md")]
pub mod benchmarks {}

#[doc = include_str!("limits.md")]
#[doc = include_str!("extremes.md")]
pub mod limits {}
