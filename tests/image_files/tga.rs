//! TGA files.

use super::{File, SIZE, blue_first, color, padded};

/// A file, field by field.
#[derive(Clone)]
pub struct Fields {
    pub id: Vec<u8>,
    pub image_type: u8,
    /// The first index of the color map.
    pub first: u8,
    /// Bits per entry of the color map.
    pub entry_bits: u8,
    pub table: Vec<Vec<u8>>,
    pub width: u16,
    pub bits: u8,
    pub descriptor: u8,
    pub pixels: Vec<u8>,
}

impl Fields {
    /// The fields of a file that stores `pixel(column, row)`, starting at the corner that the descriptor names.
    pub fn of(
        image_type: u8,
        bits: u8,
        descriptor: u8,
        pixel: &dyn Fn(u32, u32) -> Vec<u8>,
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

    pub fn bytes(&self) -> Vec<u8> {
        let mapped = u8::from(!self.table.is_empty());
        let mut bytes = vec![self.id.len() as u8, mapped, self.image_type];
        bytes.extend([self.first, 0, self.table.len() as u8, 0, self.entry_bits]);
        bytes.extend([0; 4]); // the position on a screen
        for size in [self.width, SIZE.1 as u16] {
            bytes.extend(size.to_le_bytes());
        }
        bytes.extend([self.bits, self.descriptor]);
        bytes.extend(&self.id);
        bytes.extend(self.table.iter().flatten());
        bytes.extend(&self.pixels);
        bytes
    }

    /// The file, which shows the color `pixel(column, row)`.
    fn file(&self, pixel: &dyn Fn(u32, u32) -> [u8; 3]) -> File {
        let (kind, bits, descriptor) = (self.image_type, self.bits, self.descriptor);
        let (id, first, entry_bits) = (self.id.len(), self.first, self.entry_bits);
        let name = format!(
            "TGA of type {kind}, {bits} bits, descriptor {descriptor:#x}, {id} bytes of id, \
             entries of {entry_bits} bits from index {first}"
        );
        let mut file = File::new(name, self.bytes(), pixel);
        // The other reader ignores the bit for columns from the right.
        file.others_agree = descriptor & 0x10 == 0;
        file
    }
}

/// Marks a file that the other reader does not read.
fn ours(mut file: File) -> File {
    file.others_agree = false;
    file
}

/// The descriptors for the corners at which a file can start.
const ORIGINS: [u8; 4] = [0x00, 0x10, 0x20, 0x30];

fn word(x: u32, y: u32) -> u16 {
    let [r, g, b] = color(x, y).map(|channel| u16::from(channel >> 3));
    r << 10 | g << 5 | b
}

fn of_word(word: u16) -> [u8; 3] {
    [word >> 10 & 31, word >> 5 & 31, word & 31].map(|value| ((value * 510 + 31) / 62) as u8)
}

pub fn true_color_from_any_corner() -> Vec<File> {
    let mut files = Vec::new();
    for origin in ORIGINS {
        let mut fields = Fields::of(2, 24, origin, &blue_first);
        files.push(fields.file(&color));
        fields.id = b"a remark".to_vec();
        files.push(fields.file(&color));
        files.push(Fields::of(2, 32, origin | 8, &padded).file(&color));
        for bits in [15, 16] {
            let pixel = |x, y| (word(x, y) | 0x8000).to_le_bytes().to_vec();
            let fields = Fields::of(2, bits, origin, &pixel);
            files.push(ours(fields.file(&|x, y| of_word(word(x, y)))));
        }
    }
    files
}

pub fn gray_from_any_corner() -> Vec<File> {
    let of = |origin| {
        let fields = Fields::of(3, 8, origin, &|x, y| color(x, y)[..1].to_vec());
        fields.file(&|x, y| [color(x, y)[0]; 3])
    };
    ORIGINS.map(of).into()
}

pub fn indices_with_a_color_map() -> Vec<File> {
    let index = |x: u32, y: u32| (x + 2 * y) % 6;
    let expected = |x, y| color(index(x, y), 0);
    let mut files = Vec::new();
    for origin in ORIGINS {
        let pixel = |x, y| [index(x, y) as u8].to_vec();
        let mut fields = Fields::of(1, 8, origin, &pixel);
        (fields.entry_bits, fields.id) = (24, b"id".to_vec());
        fields.table = (0..6).map(|index| blue_first(index, 0)).collect();
        files.push(fields.file(&expected));
        fields.entry_bits = 32;
        fields.table = (0..6).map(|index| padded(index, 0)).collect();
        files.push(fields.file(&expected));
        fields.entry_bits = 16;
        let entry = |index| word(index, 0).to_le_bytes().to_vec();
        fields.table = (0..6).map(entry).collect();
        files.push(ours(fields.file(&|x, y| of_word(word(index(x, y), 0)))));
    }
    // The map has three entries from index 2 on. Its first and last entries stand for all indices before and after
    // them.
    let mut fields = Fields::of(1, 8, 0, &|x, y| [index(x, y) as u8].to_vec());
    (fields.first, fields.entry_bits) = (2, 24);
    fields.table = (2..5).map(|index| blue_first(index, 0)).collect();
    files.push(ours(fields.file(&|x, y| color(index(x, y).clamp(2, 4), 0))));
    files
}

pub fn a_map_of_true_color() -> Vec<File> {
    let mut fields = Fields::of(2, 24, 0, &blue_first);
    fields.entry_bits = 24;
    fields.table = (0..3).map(|index| blue_first(index, 9)).collect();
    vec![ours(fields.file(&color))]
}
