//! BMP files: Microsoft's `BITMAPFILEHEADER`, then a `BITMAPINFOHEADER` or its versions 4 and 5.

use super::Image;
use super::header::{along, at_least, refused, u16_at, u32_at};
use super::pixel::{Entry, Pixel, Table};
use crate::Error;
use crate::error::ok;

/// Length of the file header: signature, file size, and offset of the pixels.
const FILE_HEADER: usize = 14;

/// `BI_RGB` and `BI_BITFIELDS`: the uncompressed formats.
const RGB: u32 = 0;
const BIT_FIELDS: u32 = 3;

/// The picture in the bytes of a file.
pub(super) const fn read(bytes: &[u8]) -> Result<Image<'_>, Error> {
    ok!(at_least(bytes, FILE_HEADER as u64 + 40));
    if u16_at(bytes, 0) != 0x4d42 {
        return refused(
            "signature of the BMP file",
            u16_at(bytes, 0),
            "19778, the letters BM",
        );
    }
    let header = u32_at(bytes, 14);
    if !matches!(header, 40 | 52 | 56 | 108 | 124) {
        return refused("header length", header, "40, 108 or 124 bytes");
    }
    let width = u32_at(bytes, 18);
    if width == 0 || width > i32::MAX as u32 {
        return refused("width", width, "at least 1 and at most 2147483647");
    }
    // A negative height means that the top row comes first.
    let height = u32_at(bytes, 22).cast_signed();
    let (top_down, height) = (height < 0, height.unsigned_abs());
    if height == 0 {
        return refused("height", 0, "at least 1");
    }
    let (bits, compression) = (u16_at(bytes, 28), u32_at(bytes, 30));
    if compression != RGB && compression != BIT_FIELDS {
        let needed = "0 or 3: the file must not be compressed";
        return refused("compression", compression, needed);
    }
    let pixel = ok!(pixel(bytes, header as usize, bits, compression));

    let start = u32_at(bytes, 10) as u64;
    // Rows are padded to 4 bytes.
    let row = (width as u64 * bits as u64).div_ceil(32) * 4;
    let needed = start.saturating_add(row.saturating_mul(height as u64));
    ok!(at_least(bytes, needed));
    // Every offset below lies in the file.
    let (start, row) = (start as usize, row as usize);
    let (first, down) = along(start, row, height, !top_down);
    let right = bits as isize / 8;
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

/// How pixels of `bits` bits are stored.
const fn pixel(bytes: &[u8], header: usize, bits: u32, compression: u32) -> Result<Pixel, Error> {
    // The masks follow the 40 bytes that all headers share; longer headers contain them.
    const MASKS: usize = FILE_HEADER + 40;
    let masked = compression == BIT_FIELDS;
    match bits {
        1 | 4 | 8 if !masked => {
            let used = u32_at(bytes, 46) as usize;
            let most = 1 << bits;
            let count = if used == 0 { most } else { used };
            if count > most {
                let needed = "at most 2 to the bits per pixel";
                return refused("number of colors", count as u32, needed);
            }
            let at = FILE_HEADER + header;
            ok!(at_least(bytes, (at + 4 * count) as u64));
            Ok(Pixel::Index(
                bits,
                Table {
                    at,
                    step: 4,
                    first: 0,
                    count,
                    entry: Entry::Bytes,
                },
            ))
        }
        16 if !masked => Ok(Pixel::Rgb555),
        24 | 32 if !masked => Ok(Pixel::Bytes([2, 1, 0])),
        16 | 32 => {
            ok!(at_least(bytes, MASKS as u64 + 12));
            let red = u32_at(bytes, MASKS);
            let green = u32_at(bytes, MASKS + 4);
            let blue = u32_at(bytes, MASKS + 8);
            match (bits, red, green, blue) {
                (16, 0x7c00, 0x03e0, 0x001f) => Ok(Pixel::Rgb555),
                (16, 0xf800, 0x07e0, 0x001f) => Ok(Pixel::Rgb565),
                (16, ..) => refused(
                    "red mask",
                    red,
                    "31744 (5-5-5) or 63488 (5-6-5), green and blue below it",
                ),
                _ => match (byte_of(red), byte_of(green), byte_of(blue)) {
                    (Some(red), Some(green), Some(blue)) => Ok(Pixel::Bytes([red, green, blue])),
                    (None, ..) => refused("red mask", red, "a whole byte"),
                    (_, None, _) => refused("green mask", green, "a whole byte"),
                    _ => refused("blue mask", blue, "a whole byte"),
                },
            }
        }
        _ if masked => refused("bits per pixel", bits, "16 or 32 with bit fields"),
        _ => refused("bits per pixel", bits, "1, 4, 8, 16, 24 or 32"),
    }
}

/// The byte of a pixel that a mask selects; 0 is the lowest.
const fn byte_of(mask: u32) -> Option<u8> {
    match mask {
        0x0000_00ff => Some(0),
        0x0000_ff00 => Some(1),
        0x00ff_0000 => Some(2),
        0xff00_0000 => Some(3),
        _ => None,
    }
}
