//! BMP and TGA files of every kind that the crate reads, made byte by byte, and the colors of their pixels.
//!
//! tests/exact/images checks the crate with these files, and tests/images another reader.

// Each test binary uses only a part of it.
#![allow(dead_code)]

pub mod bmp;
pub mod tga;

/// Width and height of the pictures. The width is odd, so that rows of a BMP file are padded.
pub const SIZE: (u32, u32) = (5, 3);

/// A file, and the picture that it shows.
pub struct File {
    /// The name that messages give it.
    pub name: String,
    pub bytes: Vec<u8>,
    /// Red, green and blue of each pixel, row by row from the top.
    pub pixels: Vec<[u8; 3]>,
    /// Whether the `image` crate reads it, and reads the same pixels.
    pub others_agree: bool,
}

impl File {
    /// A file that shows the color `pixel(column, row)`.
    fn new(name: String, bytes: Vec<u8>, pixel: &dyn Fn(u32, u32) -> [u8; 3]) -> Self {
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

/// A different color for each column and row.
pub fn color(x: u32, y: u32) -> [u8; 3] {
    let seed = x * 5 + y * 23;
    [seed * 7 + 3, u32::MAX - seed * 3, (seed * 91) ^ 0x5c].map(|channel| channel as u8)
}

/// The color's bytes: blue, green and red.
pub fn blue_first(x: u32, y: u32) -> Vec<u8> {
    color(x, y).into_iter().rev().collect()
}

/// The color's bytes: blue, green and red, and a byte that is unused or an opacity.
pub fn padded(x: u32, y: u32) -> Vec<u8> {
    let mut pixel = blue_first(x, y);
    pixel.push(0x77);
    pixel
}
