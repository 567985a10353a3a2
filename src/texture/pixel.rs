//! Pixels in the bytes of a file: how they are stored, and the loops that read them, at compile time and at run time.

/// How a pixel is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Pixel {
    /// Bytes, at these offsets for red, green and blue.
    Bytes([u8; 3]),
    /// 16 bits, the low byte first: blue in the lowest 5 bits, green in the next 5.
    Rgb555,
    /// The same with 6 bits of green.
    Rgb565,
    /// An index of this many bits: 8, 4 or 1, the first pixel in the high bits.
    Index(u32, Table),
}

/// The color table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Table {
    /// Offset of the first entry.
    pub(super) at: usize,
    /// Bytes per entry.
    pub(super) step: usize,
    /// The index that means the first entry.
    pub(super) first: usize,
    /// Number of entries, at least 1.
    pub(super) count: usize,
    pub(super) entry: Entry,
}

/// How an entry of a color table is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Entry {
    /// Blue, green, red.
    Bytes,
    /// As [`Pixel::Rgb555`].
    Rgb555,
}

// The following macros stand in place of functions: at compile time, a call takes longer than all their operations,
// and the compiler stops after two million calls and loop iterations.

/// The byte at an offset. `$length` is the number of bytes. A reader has checked that the picture lies within them,
/// so the 0 is never used.
macro_rules! byte {
    ($bytes:expr, $length:expr, $at:expr) => {{
        let at = $at;
        if at < $length { $bytes[at] } else { 0 }
    }};
}

/// The number in two bytes, the low one first.
macro_rules! word {
    ($bytes:expr, $length:expr, $at:expr) => {{
        let low = $at;
        byte!($bytes, $length, low) as u32 | (byte!($bytes, $length, low + 1) as u32) << 8
    }};
}

/// Widens a channel of 5 or 6 bits to 255 steps, rounded to nearest.
macro_rules! widened {
    ($word:expr, $shift:literal, 5) => {
        ((($word >> $shift & 0x1f) * 527 + 23) >> 6) as u8
    };
    ($word:expr, $shift:literal, 6) => {
        ((($word >> $shift & 0x3f) * 259 + 33) >> 6) as u8
    };
}

/// Red, green and blue of 16 bits. The numbers are the lowest bit of red and the width of green, in bits; red and blue
/// are 5 bits wide.
macro_rules! channels {
    ($word:expr, $red:literal, $green:tt) => {{
        let word = $word;
        [
            widened!(word, $red, 5),
            widened!(word, 5, $green),
            widened!(word, 0, 5),
        ]
    }};
}

/// The index of the pixel in column `$x`, at most 2^31, of the row that begins at offset `$row`; 0 if pixels are not
/// indices.
macro_rules! index {
    ($image:expr, $length:expr, $row:expr, $x:expr) => {
        match $image.pixel {
            Pixel::Index(8, _) => {
                let at = ($row + $x as isize * $image.right) as usize;
                byte!($image.bytes, $length, at)
            }
            Pixel::Index(4, _) => {
                let at = $row as usize + $x as usize / 2;
                byte!($image.bytes, $length, at) >> (4 * (1 - $x % 2)) & 0xf
            }
            Pixel::Index(..) => {
                let at = $row as usize + $x as usize / 8;
                byte!($image.bytes, $length, at) >> (7 - $x % 8) & 1
            }
            _ => 0,
        }
    };
}

/// Red, green and blue of an index; an index beyond the ends of the table has its first or last color.
macro_rules! entry {
    ($table:expr, $bytes:expr, $length:expr, $index:expr) => {{
        let (table, index) = ($table, $index as usize);
        let last = table.count - 1;
        let entry = if index < table.first {
            0
        } else {
            index - table.first
        };
        let at = table.at + table.step * if entry < last { entry } else { last };
        match table.entry {
            Entry::Bytes => [
                byte!($bytes, $length, at + 2),
                byte!($bytes, $length, at + 1),
                byte!($bytes, $length, at),
            ],
            Entry::Rgb555 => channels!(word!($bytes, $length, at), 10, 5),
        }
    }};
}

/// Red, green and blue of the pixel in column `$x` of the row that begins at offset `$row`.
macro_rules! rgb {
    ($image:expr, $length:expr, $row:expr, $x:expr) => {{
        let at = ($row + $x as isize * $image.right) as usize;
        match $image.pixel {
            Pixel::Bytes([r, g, b]) => [
                byte!($image.bytes, $length, at + r as usize),
                byte!($image.bytes, $length, at + g as usize),
                byte!($image.bytes, $length, at + b as usize),
            ],
            Pixel::Rgb555 => channels!(word!($image.bytes, $length, at), 10, 5),
            Pixel::Rgb565 => channels!(word!($image.bytes, $length, at), 11, 6),
            Pixel::Index(_, table) => {
                let index = index!($image, $length, $row, $x);
                entry!(table, $image.bytes, $length, index)
            }
        }
    }};
}

/// Writes a color to each of `$count` elements of a list: `$value`, computed from `$rgb`, which is red, green and
/// blue of the pixels of `$image`, row by row from the top.
macro_rules! write_colors {
    ($list:ident[..$count:expr] = $image:expr, |$rgb:ident| $value:expr) => {
        let image = $image;
        let (bytes, length) = (image.bytes, image.bytes.len());
        let (mut row, mut written) = (image.first as isize, 0);
        while written < $count {
            // The most frequent format has its own loop, which halves the compile time.
            if let Pixel::Bytes([r, g, b]) = image.pixel {
                let (r, g, b) = (r as usize, g as usize, b as usize);
                let (mut at, mut x) = (row, 0);
                while x < image.width && written < $count {
                    let pixel = at as usize;
                    let $rgb = [
                        byte!(bytes, length, pixel + r),
                        byte!(bytes, length, pixel + g),
                        byte!(bytes, length, pixel + b),
                    ];
                    $list[written] = $value;
                    written += 1;
                    x += 1;
                    at += image.right;
                }
            } else {
                let mut x = 0;
                while x < image.width && written < $count {
                    let $rgb = rgb!(image, length, row, x);
                    $list[written] = $value;
                    written += 1;
                    x += 1;
                }
            }
            row += image.down;
        }
    };
}

/// Writes to each of `$count` elements of a list the index of a pixel of `$image`, row by row from the top.
macro_rules! write_indices {
    ($list:ident[..$count:expr] = $image:expr) => {
        let image = $image;
        let length = image.bytes.len();
        let (mut row, mut written) = (image.first as isize, 0);
        while written < $count {
            let mut x = 0;
            while x < image.width && written < $count {
                $list[written] = index!(image, length, row, x);
                written += 1;
                x += 1;
            }
            row += image.down;
        }
    };
}

pub(super) use {byte, channels, entry, index, rgb, widened, word, write_colors, write_indices};
