//! TGA files, as Truevision's specification 2.0 has them.

use super::image::{Entry, Image, Pixel, Table, at_least, refused, u16_at};
use crate::Error;
use crate::error::ok;

const HEADER: usize = 18;

/// The picture in the bytes of a file.
pub(super) const fn read(bytes: &[u8]) -> Result<Image<'_>, Error> {
    ok!(at_least(bytes, HEADER as u64));
    let (id, tables, image_type) = (bytes[0] as usize, bytes[1] as usize, bytes[2] as u32);
    if tables > 1 {
        return refused("color map type", tables as u32, "0 or 1");
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
    // A map may be there and not be used.
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
    // All that follows lies in the file. The descriptor says on which side the first pixel is.
    let (last_column, last_row) = (right * (width as usize - 1), row * (height as usize - 1));
    let (first, right) = if descriptor & 0x10 == 0 {
        (start, right as isize)
    } else {
        (start + last_column, -(right as isize))
    };
    let (first, down) = if descriptor & 0x20 != 0 {
        (first, row as isize)
    } else {
        (first + last_row, -(row as isize))
    };
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

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics::pixelcolor::Rgb888;
    use std::format;
    use std::vec::Vec;

    const SIZE: (u32, u32) = (5, 3);

    /// A file, field by field.
    #[derive(Clone)]
    struct Fields {
        id: Vec<u8>,
        image_type: u8,
        /// The first index, and bits per entry.
        first: u8,
        entry_bits: u8,
        table: Vec<Vec<u8>>,
        width: u16,
        bits: u8,
        descriptor: u8,
        pixels: Vec<u8>,
    }

    impl Fields {
        /// Of `pixel` for each column and row, from the corner that the descriptor names.
        fn of(
            image_type: u8,
            bits: u8,
            descriptor: u8,
            pixel: impl Fn(u32, u32) -> Vec<u8>,
        ) -> Self {
            let mut pixels = Vec::new();
            for row in 0..SIZE.1 {
                let y = if descriptor & 0x20 == 0 {
                    SIZE.1 - 1 - row
                } else {
                    row
                };
                for column in 0..SIZE.0 {
                    let x = if descriptor & 0x10 == 0 {
                        column
                    } else {
                        SIZE.0 - 1 - column
                    };
                    pixels.extend(pixel(x, y));
                }
            }
            Self {
                id: Vec::new(),
                image_type,
                first: 0,
                entry_bits: 0,
                table: Vec::new(),
                width: SIZE.0 as u16,
                bits,
                descriptor,
                pixels,
            }
        }

        fn bytes(&self) -> Vec<u8> {
            let mapped = u8::from(!self.table.is_empty());
            let mut bytes = std::vec![self.id.len() as u8, mapped, self.image_type];
            bytes.extend([self.first, 0, self.table.len() as u8, 0, self.entry_bits]);
            bytes.extend([0; 4]); // where on a screen
            for size in [self.width, SIZE.1 as u16] {
                bytes.extend(size.to_le_bytes());
            }
            bytes.extend([self.bits, self.descriptor]);
            bytes.extend(&self.id);
            bytes.extend(self.table.iter().flatten());
            bytes.extend(&self.pixels);
            bytes
        }
    }

    /// The corners that can come first.
    const ORIGINS: [u8; 4] = [0x00, 0x10, 0x20, 0x30];

    fn color(x: u32, y: u32) -> [u8; 3] {
        let seed = x * 5 + y * 23;
        [seed * 7 + 3, u32::MAX - seed * 3, (seed * 91) ^ 0x5c].map(|channel| channel as u8)
    }

    fn blue_first(x: u32, y: u32) -> Vec<u8> {
        color(x, y).into_iter().rev().collect()
    }

    fn with_alpha(x: u32, y: u32) -> Vec<u8> {
        let mut pixel = blue_first(x, y);
        pixel.push(0x77);
        pixel
    }

    fn word(x: u32, y: u32) -> u16 {
        let [r, g, b] = color(x, y).map(|channel| u16::from(channel >> 3));
        r << 10 | g << 5 | b
    }

    fn of_word(word: u16) -> [u8; 3] {
        [word >> 10 & 31, word >> 5 & 31, word & 31].map(|value| ((value * 510 + 31) / 62) as u8)
    }

    /// This crate reads `expected`; so does the image crate, if it `can`.
    fn holds(fields: &Fields, can: bool, expected: impl Fn(u32, u32) -> [u8; 3]) {
        let bytes = fields.bytes();
        let image = Image::from_tga(&bytes).unwrap();
        assert_eq!((image.width(), image.height()), SIZE);
        for (x, y) in (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y))) {
            let [r, g, b] = expected(x, y);
            let ours = Some(Rgb888::new(r, g, b));
            assert_eq!(image.pixel(x, y), ours, "column {x}, row {y}");
        }
        let format = image::ImageFormat::Tga;
        if can {
            let other = image::load_from_memory_with_format(&bytes, format).unwrap();
            for (x, y, &image::Rgb(theirs)) in other.into_rgb8().enumerate_pixels() {
                assert_eq!(
                    theirs,
                    expected(x, y),
                    "column {x}, row {y}: by the image crate"
                );
            }
        }
    }

    #[test]
    fn true_color_from_any_corner() {
        for origin in ORIGINS {
            let mut fields = Fields::of(2, 24, origin, blue_first);
            holds(&fields, origin & 0x10 == 0, color);
            fields.id = b"a remark".to_vec();
            holds(&fields, origin & 0x10 == 0, color);
            let fields = Fields::of(2, 32, origin | 8, with_alpha);
            holds(&fields, origin & 0x10 == 0, color);
            for bits in [15, 16] {
                let pixel = |x, y| (word(x, y) | 0x8000).to_le_bytes().to_vec();
                let fields = Fields::of(2, bits, origin, pixel);
                holds(&fields, false, |x, y| of_word(word(x, y)));
            }
        }
    }

    #[test]
    fn gray_from_any_corner() {
        for origin in ORIGINS {
            let fields = Fields::of(3, 8, origin, |x, y| color(x, y)[..1].to_vec());
            let expected = |x, y| [color(x, y)[0]; 3];
            holds(&fields, origin & 0x10 == 0, expected);
        }
    }

    #[test]
    fn indices_with_a_color_map() {
        let index = |x: u32, y: u32| (x + 2 * y) % 6;
        for origin in ORIGINS {
            let pixel = |x, y| [index(x, y) as u8].to_vec();
            let mut fields = Fields::of(1, 8, origin, pixel);
            (fields.entry_bits, fields.id) = (24, b"id".to_vec());
            fields.table = (0..6).map(|index| blue_first(index, 0)).collect();
            holds(&fields, origin & 0x10 == 0, |x, y| color(index(x, y), 0));
            fields.entry_bits = 32;
            fields.table = (0..6).map(|index| with_alpha(index, 0)).collect();
            holds(&fields, origin & 0x10 == 0, |x, y| color(index(x, y), 0));
            fields.entry_bits = 16;
            let entry = |index| word(index, 0).to_le_bytes().to_vec();
            fields.table = (0..6).map(entry).collect();
            holds(&fields, false, |x, y| of_word(word(index(x, y), 0)));
        }
        // Of three entries from index 2 on, the ends stand for all beyond.
        let mut fields = Fields::of(1, 8, 0, |x, y| [index(x, y) as u8].to_vec());
        (fields.first, fields.entry_bits) = (2, 24);
        fields.table = (2..5).map(|index| blue_first(index, 0)).collect();
        holds(&fields, false, |x, y| color(index(x, y).clamp(2, 4), 0));
    }

    #[test]
    fn a_map_of_true_color_is_skipped() {
        let mut fields = Fields::of(2, 24, 0, blue_first);
        fields.entry_bits = 24;
        fields.table = (0..3).map(|index| blue_first(index, 9)).collect();
        holds(&fields, false, color);
    }

    #[test]
    fn malformed_files_say_what_is_wrong() {
        fn says(change: impl FnOnce(&mut Fields), expected: &str) {
            let mut fields = Fields::of(2, 24, 0, blue_first);
            change(&mut fields);
            let error = Image::from_tga(&fields.bytes()).unwrap_err();
            assert_eq!(format!("{error}"), expected);
        }
        says(
            |fields| fields.image_type = 10,
            "image type is 10: it must be 1, 2 or 3: the file must not be compressed",
        );
        says(
            |fields| fields.image_type = 0,
            "image type of the TGA file is 0: it must be 1, 2 or 3",
        );
        says(
            |fields| fields.width = 0,
            "width is 0: it must be at least 1",
        );
        says(
            |fields| fields.bits = 8,
            "bits per pixel is 8: it must be 15, 16, 24 or 32",
        );
        says(
            |fields| fields.image_type = 3,
            "bits per gray pixel is 24: it must be 8",
        );
        says(
            |fields| fields.image_type = 1,
            "bits per index is 24: it must be 8",
        );
        says(
            |fields| (fields.image_type, fields.bits) = (1, 8),
            "bits per color is 0: it must be 15, 16, 24 or 32",
        );
        says(
            |fields| (fields.image_type, fields.bits, fields.entry_bits) = (1, 8, 24),
            "number of colors is 0: it must be at least 1",
        );
        says(
            |fields| fields.descriptor = 0x40,
            "image descriptor is 64: it must be below 64: rows must not be interleaved",
        );
        says(
            |fields| fields.width = 6,
            "file has 63 bytes: it needs at least 72",
        );
        let mut bytes = Fields::of(2, 24, 0, blue_first).bytes();
        for length in 0..bytes.len() {
            let error = Image::from_tga(&bytes[..length]).unwrap_err();
            assert!(matches!(error, Error::Truncated { given, .. } if given == length));
        }
        bytes[1] = 2;
        let error = Image::from_tga(&bytes).unwrap_err();
        assert_eq!(format!("{error}"), "color map type is 2: it must be 0 or 1");
    }

    /// Whatever the header says, reading neither panics nor leaves the file.
    #[test]
    fn any_header_is_survived() {
        let mut mapped = Fields::of(1, 8, 0, |x, y| [(x + y) as u8].to_vec());
        mapped.entry_bits = 24;
        mapped.table = (0..6).map(|index| blue_first(index, 0)).collect();
        for bytes in [Fields::of(2, 24, 0, blue_first), mapped].map(|fields| fields.bytes()) {
            for at in 0..18 {
                for value in 0..=255 {
                    let mut bytes = bytes.clone();
                    bytes[at] = value;
                    if let Ok(image) = Image::from_tga(&bytes) {
                        let (x, y) = (image.width() - 1, image.height() - 1);
                        let places = [(0, 0), (x, 0), (0, y), (x, y)];
                        assert!(places.iter().all(|&(x, y)| image.pixel(x, y).is_some()));
                    }
                }
            }
        }
    }
}
