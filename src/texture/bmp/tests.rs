//! Files of every kind, against the crate `image`.

use super::*;
use embedded_graphics::pixelcolor::{Gray8, Rgb888, RgbColor};
use std::format;
use std::vec::Vec;

/// Columns and rows of the pictures: an odd row length, so that rows are filled up.
const SIZE: (u32, u32) = (5, 3);

/// A file, field by field.
#[derive(Clone)]
struct Fields {
    /// Bytes of the second header.
    header: u32,
    width: u32,
    height: i32,
    bits: u32,
    compression: u32,
    used: u32,
    masks: [u32; 3],
    /// Blue, green, red and nothing.
    table: Vec<[u8; 4]>,
    /// The rows in the order of the file, without what fills them up.
    rows: Vec<Vec<u8>>,
}

impl Fields {
    /// Of `pixel` for each column and row, the bottom row first.
    fn of(bits: u32, pixel: impl Fn(u32, u32) -> Vec<u8>) -> Self {
        let row = |y| (0..SIZE.0).flat_map(|x| pixel(x, y)).collect();
        Self {
            header: 40,
            width: SIZE.0,
            height: SIZE.1.cast_signed(),
            bits,
            compression: 0,
            used: 0,
            masks: [0; 3],
            table: Vec::new(),
            rows: (0..SIZE.1).rev().map(row).collect(),
        }
    }

    fn bytes(&self) -> Vec<u8> {
        let mut header = Vec::new();
        let words = [self.header, self.width, self.height.cast_unsigned()];
        for word in words {
            header.extend(word.to_le_bytes());
        }
        header.extend([1, 0, self.bits as u8, 0]);
        for word in [self.compression, 0, 2835, 2835, self.used, 0] {
            header.extend(word.to_le_bytes());
        }
        if self.header > 40 || self.compression == 3 {
            for mask in self.masks {
                header.extend(mask.to_le_bytes());
            }
        }
        if self.header > 40 {
            header.resize(self.header as usize, 0);
        }
        header.extend(self.table.as_flattened());
        let start = 14 + header.len() as u32;
        let mut pixels = Vec::new();
        for row in &self.rows {
            pixels.extend(row);
            pixels.resize(pixels.len().next_multiple_of(4), 0xee);
        }
        let mut bytes = Vec::from(*b"BM");
        for word in [start + pixels.len() as u32, 0, start] {
            bytes.extend(word.to_le_bytes());
        }
        bytes.extend(header);
        bytes.extend(pixels);
        bytes
    }
}

/// Some color for each column and row.
fn color(x: u32, y: u32) -> [u8; 3] {
    let seed = x * 5 + y * 23;
    [seed * 7 + 3, u32::MAX - seed * 3, (seed * 91) ^ 0x5c].map(|channel| channel as u8)
}

fn blue_first(x: u32, y: u32) -> Vec<u8> {
    color(x, y).into_iter().rev().collect()
}

/// Blue, green, red and a byte that is nothing.
fn padded(x: u32, y: u32) -> Vec<u8> {
    let mut pixel = blue_first(x, y);
    pixel.push(0x77);
    pixel
}

/// A word whose channels are narrower than those of [`color`]: red begins at `red`, green has `green` bits.
fn word(x: u32, y: u32, red: u32, green: u32) -> u32 {
    let [r, g, b] = color(x, y).map(u32::from);
    (r >> 3) << red | (g >> (8 - green)) << 5 | b >> 3
}

/// What both read is `expected`.
fn holds(bytes: &[u8], expected: impl Fn(u32, u32) -> [u8; 3]) {
    let image = Image::from_bmp(bytes).unwrap();
    let other = image::load_from_memory_with_format(bytes, image::ImageFormat::Bmp)
        .unwrap()
        .into_rgb8();
    assert_eq!((image.width(), image.height()), SIZE);
    assert_eq!(other.dimensions(), SIZE);
    for (x, y, &image::Rgb(theirs)) in other.enumerate_pixels() {
        let [r, g, b] = expected(x, y);
        assert_eq!(theirs, [r, g, b], "column {x}, row {y}: by the image crate");
        let ours = Some(Rgb888::new(r, g, b));
        assert_eq!(image.pixel(x, y), ours, "column {x}, row {y}");
    }
    assert_eq!(image.pixel(SIZE.0, 0), None);
    assert_eq!(image.pixel(0, SIZE.1), None);
}

/// The same file with its rows from the top.
fn top_down(fields: &Fields) -> Vec<u8> {
    let mut fields = fields.clone();
    fields.height = -fields.height;
    fields.rows.reverse();
    fields.bytes()
}

#[test]
fn bytes_of_24_and_32_bits() {
    for header in [40, 108, 124] {
        for fields in [Fields::of(24, blue_first), Fields::of(32, padded)] {
            let fields = Fields { header, ..fields };
            holds(&fields.bytes(), color);
            holds(&top_down(&fields), color);
        }
    }
}

#[test]
fn bit_fields_of_32_bits() {
    for header in [40, 108, 124] {
        let mut fields = Fields::of(32, padded);
        (fields.header, fields.compression) = (header, 3);
        fields.masks = [0xff_0000, 0xff00, 0xff];
        holds(&fields.bytes(), color);
        // Red first.
        let mut fields = Fields::of(32, |x, y| padded(x, y).into_iter().rev().collect());
        (fields.header, fields.compression) = (header, 3);
        fields.masks = [0xff00, 0xff_0000, 0xff00_0000];
        holds(&top_down(&fields), color);
    }
}

#[test]
fn words_of_16_bits() {
    let widened = |value: u32, max: u32| ((value * 510 + max) / (2 * max)) as u8;
    let pixel = |x, y| (word(x, y, 10, 5) as u16).to_le_bytes().to_vec();
    let expected = |x, y| {
        let word = word(x, y, 10, 5);
        [word >> 10, word >> 5 & 31, word & 31].map(|value| widened(value, 31))
    };
    let mut fields = Fields::of(16, pixel);
    holds(&fields.bytes(), expected);
    (fields.compression, fields.masks) = (3, [0x7c00, 0x3e0, 0x1f]);
    holds(&fields.bytes(), expected);

    let pixel = |x, y| (word(x, y, 11, 6) as u16).to_le_bytes().to_vec();
    let mut fields = Fields::of(16, pixel);
    (fields.compression, fields.masks) = (3, [0xf800, 0x7e0, 0x1f]);
    holds(&top_down(&fields), |x, y| {
        let word = word(x, y, 11, 6);
        let [red, blue] = [word >> 11, word & 31].map(|value| widened(value, 31));
        [red, widened(word >> 5 & 63, 63), blue]
    });
}

/// Pixels of `bits` bits with the index (x + 2 y) mod `colors`, packed.
fn indexed(bits: u32, used: u32, colors: u32) -> Fields {
    let mut fields = Fields::of(bits, |_, _| Vec::new());
    let row = |y: u32| {
        let mut bytes = std::vec![0; (SIZE.0 * bits).div_ceil(8) as usize];
        for x in 0..SIZE.0 {
            let index = (x + 2 * y) % colors;
            let at = x * bits;
            bytes[at as usize / 8] |= (index << (8 - bits - at % 8)) as u8;
        }
        bytes
    };
    fields.rows = (0..SIZE.1).rev().map(row).collect();
    fields.used = used;
    let [count, entry] = [colors, 0];
    let of = |index| {
        let [r, g, b] = color(index, entry);
        [b, g, r, 0]
    };
    fields.table = (0..count).map(of).collect();
    fields
}

#[test]
fn indices_of_8_4_and_1_bits() {
    for (bits, used, colors) in [(8, 0, 256), (8, 5, 5), (4, 0, 16), (4, 3, 3), (1, 0, 2)] {
        let fields = indexed(bits, used, colors);
        let expected = |x, y| color((x + 2 * y) % colors, 0);
        holds(&fields.bytes(), expected);
        holds(&top_down(&fields), expected);
    }
}

#[test]
fn read_at_run_time() {
    let mut fields = indexed(4, 3, 3);
    // The first rows, of four columns.
    (fields.width, fields.height) = (4, 2);
    for row in &mut fields.rows {
        row.truncate(2);
    }
    fields.rows.remove(0);
    let bytes = fields.bytes();
    let image = Image::from_bmp(&bytes).unwrap();
    let (mut texels, mut indices) = ([Rgb888::BLACK; 8], [9; 8]);
    let mut colors = [Gray8::new(0); 256];
    let skin = image.read_texture(&mut texels).unwrap();
    assert_eq!((skin.width(), skin.height()), (4, 2));
    let palette = image.read_palette(&mut indices, &mut colors).unwrap();
    assert_eq!((palette.width(), palette.height()), (4, 2));
    assert_eq!(palette.indices(), [0, 1, 2, 0, 2, 0, 1, 2]);
    for (&texel, &index) in skin.texels().iter().zip(palette.indices()) {
        let [r, g, b] = color(index.into(), 0);
        assert_eq!(texel, Rgb888::new(r, g, b));
        let luma = crate::texture::ImageColor::nearest([r, g, b]);
        assert_eq!(palette.colors()[usize::from(index)], luma);
    }
    // Beyond the table, its last color.
    assert_eq!(palette.colors()[255], palette.colors()[2]);

    let mut short = [Rgb888::BLACK; 7];
    let (given, needed) = (7, 8);
    let error = image.read_texture(&mut short).unwrap_err();
    assert_eq!(error, Error::Length { given, needed });
    let error = image.read_palette(&mut [0; 7], &mut colors).unwrap_err();
    assert_eq!(error, Error::Length { given, needed });
}

#[test]
fn what_cannot_be_a_texture_or_palette() {
    let bytes = Fields::of(24, blue_first).bytes();
    let image = Image::from_bmp(&bytes).unwrap();
    let mut texels = [Rgb888::BLACK; 15];
    let error = image.read_texture(&mut texels).unwrap_err();
    let of = "width";
    let (given, max) = (5, 32768);
    assert_eq!(error, Error::PowerOfTwo { of, given, max });
    let (mut indices, mut colors) = ([0; 15], [Rgb888::BLACK; 256]);
    let error = image.read_palette(&mut indices, &mut colors);
    assert_eq!(
        format!("{}", error.unwrap_err()),
        "bits per pixel is 24: it must be 8 (BMP: or 4 or 1) with a color table, for a palette"
    );
}

#[test]
fn malformed_files_say_what_is_wrong() {
    fn says(change: impl FnOnce(&mut Fields), expected: &str) {
        let mut fields = Fields::of(24, blue_first);
        change(&mut fields);
        let error = Image::from_bmp(&fields.bytes()).unwrap_err();
        assert_eq!(format!("{error}"), expected);
    }
    says(
        |fields| fields.header = 64,
        "header length is 64: it must be 40, 108 or 124 bytes",
    );
    says(
        |fields| fields.width = 0,
        "width is 0: it must be at least 1 and at most 2147483647",
    );
    says(
        |fields| fields.height = 0,
        "height is 0: it must be at least 1",
    );
    says(
        |fields| fields.compression = 1,
        "compression is 1: it must be 0 or 3: the file must not be compressed",
    );
    says(
        |fields| fields.bits = 2,
        "bits per pixel is 2: it must be 1, 4, 8, 16, 24 or 32",
    );
    says(
        |fields| fields.compression = 3,
        "bits per pixel is 24: it must be 16 or 32 with bit fields",
    );
    says(
        |fields| (fields.bits, fields.used) = (8, 257),
        "number of colors is 257: it must be at most 2 to the bits per pixel",
    );
    says(
        |fields| (fields.bits, fields.compression, fields.masks) = (32, 3, [0x3ff, 0, 0]),
        "red mask is 1023: it must be a whole byte",
    );
    says(
        |fields| (fields.bits, fields.compression, fields.masks) = (16, 3, [0xf00, 0xf0, 0xf]),
        "red mask is 3840: it must be 31744 (5-5-5) or 63488 (5-6-5), green and blue below it",
    );
    // 5 · 3 bytes filled up to 16, four rows in place of three.
    says(
        |fields| fields.height = 4,
        "file has 102 bytes: it needs at least 118",
    );
    says(
        |fields| (fields.width, fields.height) = (i32::MAX as u32, i32::MIN),
        &format!(
            "file has 102 bytes: it needs at least {}",
            (6_442_450_944_u64 << 31) + 54
        ),
    );
    let bytes = Fields::of(24, blue_first).bytes();
    let error = Image::from_bmp(&bytes[..53]).unwrap_err();
    assert_eq!(
        format!("{error}"),
        "file has 53 bytes: it needs at least 54"
    );
    let mut other = bytes.clone();
    other[0] = b'P';
    let error = Image::from_bmp(&other).unwrap_err();
    let expected = "signature of the BMP file is 19792: it must be 19778, the letters BM";
    assert_eq!(format!("{error}"), expected);
    for length in 0..bytes.len() {
        let error = Image::from_bmp(&bytes[..length]).unwrap_err();
        assert!(matches!(error, Error::Truncated { given, .. } if given == length));
    }
}

/// Whatever the header says, reading neither panics nor leaves the file.
#[test]
fn any_header_is_survived() {
    let files = [
        Fields::of(24, blue_first),
        Fields::of(32, padded),
        indexed(8, 5, 5),
        indexed(1, 0, 2),
    ];
    for bytes in files.map(|fields| fields.bytes()) {
        for at in 0..54 {
            for value in 0..=255 {
                let mut bytes = bytes.clone();
                bytes[at] = value;
                if let Ok(image) = Image::from_bmp(&bytes) {
                    let (x, y) = (image.width() - 1, image.height() - 1);
                    let places = [(0, 0), (x, 0), (0, y), (x, y)];
                    assert!(places.iter().all(|&(x, y)| image.pixel(x, y).is_some()));
                }
            }
        }
    }
}
