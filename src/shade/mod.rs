//! From interpolated values to a colour: the fragment trait and the fragments that come with the crate.

mod fragment;

pub use fragment::{Fragment, Sample};
