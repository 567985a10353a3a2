//! BMP and TGA files of every kind that the crate reads, byte by byte, and the colors of their pixels.
//!
//! tests/exact/images holds the crate against these files, tests/images another reader.

// Each test binary uses a part of it.
#![allow(dead_code)]

pub mod bmp;
pub mod tga;

/// Columns and rows of the pictures: an odd row length, so that rows of a BMP file are filled up.
pub const SIZE: (u32, u32) = (5, 3);

/// A file, and what it shows.
pub struct File {
    /// What a failure calls it.
    pub name: String,
    pub bytes: Vec<u8>,
    /// Red, green and blue of each pixel, row by row from the top.
    pub pixels: Vec<[u8; 3]>,
    /// Whether the `image` crate reads it, and the same.
    pub others_agree: bool,
}

impl File {
    /// A file that shows `pixel` in each column and row.
    fn new(name: String, bytes: Vec<u8>, pixel: impl Fn(u32, u32) -> [u8; 3]) -> Self {
        let row = |y| (0..SIZE.0).map(move |x| (x, y));
        let pixels = (0..SIZE.1).flat_map(row).map(|(x, y)| pixel(x, y));
        Self {
            name,
            bytes,
            pixels: pixels.collect(),
            others_agree: true,
        }
    }
}

/// Some color for each column and row.
pub fn color(x: u32, y: u32) -> [u8; 3] {
    let seed = x * 5 + y * 23;
    [seed * 7 + 3, u32::MAX - seed * 3, (seed * 91) ^ 0x5c].map(|channel| channel as u8)
}

/// Blue, green and red.
pub fn blue_first(x: u32, y: u32) -> Vec<u8> {
    color(x, y).into_iter().rev().collect()
}

/// Blue, green, red and a byte that is nothing, or an opacity.
pub fn padded(x: u32, y: u32) -> Vec<u8> {
    let mut pixel = blue_first(x, y);
    pixel.push(0x77);
    pixel
}
