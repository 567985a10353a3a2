//! OBJ text in all its forms, its mistakes, and compared with another reader.
#![allow(clippy::format_push_string)] // clearer here, and speed is no matter

mod attributes;
mod elements;
mod layout;
mod mistakes;
mod numbers;
mod other_reader;
mod reading;
mod room;
