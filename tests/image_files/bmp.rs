//! BMP files.

use super::{File, SIZE, blue_first, color, padded};

/// A file, field by field.
#[derive(Clone)]
pub struct Fields {
    /// Length of the second header, in bytes.
    pub header: u32,
    pub width: u32,
    pub height: i32,
    pub bits: u32,
    pub compression: u32,
    pub used: u32,
    pub masks: [u32; 3],
    /// The color table: blue, green, red and an unused byte.
    pub table: Vec<[u8; 4]>,
    /// The rows in the order of the file, without padding.
    pub rows: Vec<Vec<u8>>,
}

impl Fields {
    /// The fields of a file that stores `pixel(column, row)`, with the bottom row first.
    pub fn of(bits: u32, pixel: &dyn Fn(u32, u32) -> Vec<u8>) -> Self {
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

    pub fn bytes(&self) -> Vec<u8> {
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

    /// The file, which shows the color `pixel(column, row)`.
    fn file(&self, pixel: &dyn Fn(u32, u32) -> [u8; 3]) -> File {
        let (bits, header, used) = (self.bits, self.header, self.used);
        let (first, masks) = (if self.height < 0 { "top" } else { "bottom" }, self.masks);
        let name = format!(
            "BMP of {bits} bits, {used} colors, masks {masks:x?}, header {header}, {first} row first"
        );
        File::new(name, self.bytes(), pixel)
    }

    /// The same file with the top row first.
    fn top_down(&self) -> Self {
        let mut fields = self.clone();
        fields.height = -fields.height;
        fields.rows.reverse();
        fields
    }
}

/// A word with [`color`] in narrower channels: red begins at bit `red`, and green has `green` bits.
fn word(x: u32, y: u32, red: u32, green: u32) -> u32 {
    let [r, g, b] = color(x, y).map(u32::from);
    (r >> 3) << red | (g >> (8 - green)) << 5 | b >> 3
}

pub fn bytes_of_24_and_32_bits() -> Vec<File> {
    let mut files = Vec::new();
    for header in [40, 108, 124] {
        for fields in [Fields::of(24, &blue_first), Fields::of(32, &padded)] {
            let fields = Fields { header, ..fields };
            files.extend([fields.file(&color), fields.top_down().file(&color)]);
        }
    }
    files
}

pub fn bit_fields_of_32_bits() -> Vec<File> {
    let mut files = Vec::new();
    for header in [40, 108, 124] {
        let mut fields = Fields::of(32, &padded);
        (fields.header, fields.compression) = (header, 3);
        fields.masks = [0xff_0000, 0xff00, 0xff];
        files.push(fields.file(&color));
        // With red first.
        let mut fields = Fields::of(32, &|x, y| padded(x, y).into_iter().rev().collect());
        (fields.header, fields.compression) = (header, 3);
        fields.masks = [0xff00, 0xff_0000, 0xff00_0000];
        files.push(fields.top_down().file(&color));
    }
    files
}

pub fn words_of_16_bits() -> Vec<File> {
    let widened = |value: u32, max: u32| ((value * 510 + max) / (2 * max)) as u8;
    let pixel = |x, y| (word(x, y, 10, 5) as u16).to_le_bytes().to_vec();
    let expected = |x, y| {
        let word = word(x, y, 10, 5);
        [word >> 10, word >> 5 & 31, word & 31].map(|value| widened(value, 31))
    };
    let mut fields = Fields::of(16, &pixel);
    let plain = fields.file(&expected);
    (fields.compression, fields.masks) = (3, [0x7c00, 0x3e0, 0x1f]);
    let masked = fields.file(&expected);

    let pixel = |x, y| (word(x, y, 11, 6) as u16).to_le_bytes().to_vec();
    let mut fields = Fields::of(16, &pixel);
    (fields.compression, fields.masks) = (3, [0xf800, 0x7e0, 0x1f]);
    let wide_green = fields.top_down().file(&|x, y| {
        let word = word(x, y, 11, 6);
        let [red, blue] = [word >> 11, word & 31].map(|value| widened(value, 31));
        [red, widened(word >> 5 & 63, 63), blue]
    });
    vec![plain, masked, wide_green]
}

/// Packed pixels of `bits` bits with the index (x + 2 y) mod `colors`.
pub fn indexed(bits: u32, used: u32, colors: u32) -> Fields {
    let mut fields = Fields::of(bits, &|_, _| Vec::new());
    let row = |y: u32| {
        let mut bytes = vec![0; (SIZE.0 * bits).div_ceil(8) as usize];
        for x in 0..SIZE.0 {
            let index = (x + 2 * y) % colors;
            let at = x * bits;
            bytes[at as usize / 8] |= (index << (8 - bits - at % 8)) as u8;
        }
        bytes
    };
    fields.rows = (0..SIZE.1).rev().map(row).collect();
    fields.used = used;
    let of = |index| {
        let [r, g, b] = color(index, 0);
        [b, g, r, 0]
    };
    fields.table = (0..colors).map(of).collect();
    fields
}

pub fn indices_of_8_4_and_1_bits() -> Vec<File> {
    let mut files = Vec::new();
    for (bits, used, colors) in [(8, 0, 256), (8, 5, 5), (4, 0, 16), (4, 3, 3), (1, 0, 2)] {
        let fields = indexed(bits, used, colors);
        let expected = |x, y| color((x + 2 * y) % colors, 0);
        files.extend([fields.file(&expected), fields.top_down().file(&expected)]);
    }
    files
}
