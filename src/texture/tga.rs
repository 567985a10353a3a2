//! TGA files, according to Truevision's specification 2.0.

use super::Image;
use super::header::{along, at_least, refused, u16_at};
use super::pixel::{Entry, Pixel, Table};
use crate::Error;
use crate::error::ok;

const HEADER: usize = 18;

/// The picture in the bytes of a file.
pub(super) const fn read(bytes: &[u8]) -> Result<Image<'_>, Error> {
    ok!(at_least(bytes, HEADER as u64));
    let (id, tables, image_type) = (bytes[0] as usize, bytes[1] as usize, bytes[2] as u32);
    if tables > 1 {
        return refused("color map type", tables as u32, "0 or 1 in a TGA file");
    }
    let (first, count, entry_bits) = (u16_at(bytes, 3), u16_at(bytes, 5), bytes[7] as u32);
    let (width, height) = (u16_at(bytes, 12), u16_at(bytes, 14));
    let (bits, descriptor) = (bytes[16] as u32, bytes[17] as u32);
    if width == 0 {
        return refused("width", 0, "at least 1");
    }
    if height == 0 {
        return refused("height", 0, "at least 1");
    }
    if descriptor & 0xc0 != 0 {
        let needed = "below 64: rows must not be interleaved";
        return refused("image descriptor", descriptor, needed);
    }
    // A file may have a map without using it.
    let step = entry_bits.div_ceil(8) as usize;
    let map = HEADER + id;
    let start = map + tables * count as usize * step;

    let pixel = match (image_type, bits) {
        (2, 24 | 32) => Pixel::Bytes([2, 1, 0]),
        (2, 15 | 16) => Pixel::Rgb555,
        (2, _) => return refused("bits per pixel", bits, "15, 16, 24 or 32"),
        (3, 8) => Pixel::Bytes([0, 0, 0]),
        (3, _) => return refused("bits per gray pixel", bits, "8"),
        (1, 8) => {
            let entry = match entry_bits {
                24 | 32 => Entry::Bytes,
                15 | 16 => Entry::Rgb555,
                _ => return refused("bits per color", entry_bits, "15, 16, 24 or 32"),
            };
            let count = tables * count as usize;
            if count == 0 {
                return refused("number of colors", 0, "at least 1");
            }
            let table = Table {
                at: map,
                step,
                first: first as usize,
                count,
                entry,
            };
            Pixel::Index(8, table)
        }
        (1, _) => return refused("bits per index", bits, "8"),
        (9..=11, _) => {
            let needed = "1, 2 or 3: the file must not be compressed";
            return refused("image type", image_type, needed);
        }
        _ => return refused("image type of the TGA file", image_type, "1, 2 or 3"),
    };

    let right = bits.div_ceil(8) as usize;
    let row = width as usize * right;
    let needed = start as u64 + row as u64 * height as u64;
    ok!(at_least(bytes, needed));
    // Every offset below lies in the file. The descriptor says on which side the first pixel is.
    let (first, right) = along(start, right, width, descriptor & 0x10 != 0);
    let (first, down) = along(first, row, height, descriptor & 0x20 == 0);
    Ok(Image {
        bytes,
        width,
        height,
        first,
        right,
        down,
        pixel,
    })
}
