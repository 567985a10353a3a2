//! Reading OBJ text: all its forms, messages about mistakes, and a comparison with another reader.
#![allow(clippy::format_push_string)] // clearer here, and speed does not matter

mod attributes;
mod elements;
mod layout;
mod mistakes;
mod numbers;
mod other_reader;
#[path = "../../common/owned.rs"]
mod owned;
mod reading;
mod room;
