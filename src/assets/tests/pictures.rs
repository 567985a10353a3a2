//! Pictures in all formats have the right pixels and tables; damaged pictures are refused. The tests make the pictures
//! byte by byte, or with the encoders of other crates.

mod common;

use std::fmt::Write;
use std::io::Cursor;

use common::{riff, vp8};
use fixel_assets::Picture;
use fixel_assets::picture::Table;
use image::{DynamicImage, ImageFormat, RgbaImage};

type Color = [u8; 4];

/// Four colors for tables, with alpha 255.
const COLORS: [Color; 4] = [
    [10, 20, 30, 255],
    [255, 0, 0, 255],
    [0, 255, 0, 255],
    [0, 0, 255, 255],
];

/// The indices of a picture of 5x3 pixels, from the top left.
const INDICES: [u8; 15] = [0, 1, 2, 3, 0, 3, 3, 1, 0, 2, 1, 1, 1, 2, 3];
const WIDTH: usize = 5;
const HEIGHT: usize = 3;

fn decode(bytes: &[u8]) -> Picture {
    Picture::decode(bytes).expect("a picture")
}

/// Checks a picture of 5x3 pixels.
fn assert_pixels(bytes: &[u8], wanted: &[Color], case: &str) -> Picture {
    let picture = decode(bytes);
    assert_eq!((picture.width, picture.height), (5, 3), "{case}");
    assert_eq!(picture.pixels, wanted, "{case}");
    picture
}

/// The picture of [`INDICES`] in the given colors.
fn colored(colors: &[Color]) -> Vec<Color> {
    INDICES.iter().map(|&at| colors[usize::from(at)]).collect()
}

/// Packs the values of a row into bytes. The first value is in the highest bits.
fn packed(row: &[u8], bits: usize) -> Vec<u8> {
    let mut bytes = vec![0; (row.len() * bits).div_ceil(8)];
    for (at, value) in row.iter().enumerate() {
        bytes[at * bits / 8] |= value << (8 - bits - at * bits % 8);
    }
    bytes
}

/// The parts of a BMP. The default has a header of 40 bytes and no compression.
#[derive(Default)]
struct Bmp {
    header: u32,
    height: i32,
    bits: u16,
    compression: u32,
    masks: Vec<u32>,
    colors: Vec<Color>,
    data: Vec<u8>,
}

impl Bmp {
    /// The rows of 5x3 pixels, padded to 4 bytes.
    fn rows(self, mut rows: Vec<Vec<u8>>) -> Self {
        if self.height > 0 {
            rows.reverse();
        }
        for row in &mut rows {
            row.resize(row.len().next_multiple_of(4), 0xee);
        }
        Self {
            data: rows.concat(),
            ..self
        }
    }

    fn file(&self) -> Vec<u8> {
        let mut bytes = vec![0; 14];
        bytes.extend(self.header.to_le_bytes());
        if self.header == 12 {
            bytes.extend(5_u16.to_le_bytes());
            bytes.extend(&self.height.to_le_bytes()[..2]);
        } else {
            bytes.extend(5_u32.to_le_bytes());
            bytes.extend(self.height.to_le_bytes());
        }
        bytes.extend(1_u16.to_le_bytes());
        bytes.extend(self.bits.to_le_bytes());
        if self.header > 16 {
            let used = u32::try_from(self.colors.len()).unwrap();
            for word in [self.compression, 0, 0, 0, used, 0] {
                bytes.extend(word.to_le_bytes());
            }
        }
        bytes.extend(self.masks.iter().flat_map(|mask| mask.to_le_bytes()));
        bytes.resize(bytes.len().max(14 + self.header as usize), 0);
        for [r, g, b, _] in &self.colors {
            bytes.extend([b, g, r]);
            if self.header != 12 {
                bytes.push(0);
            }
        }
        let start = u32::try_from(bytes.len()).unwrap();
        bytes[..2].copy_from_slice(b"BM");
        bytes[10..14].copy_from_slice(&start.to_le_bytes());
        [bytes, self.data.clone()].concat()
    }
}

fn bmp_rows(bits: u16, pixel: impl Fn(usize) -> Vec<u8>) -> Vec<Vec<u8>> {
    let row = |y: usize| {
        if bits <= 8 {
            packed(&INDICES[5 * y..][..5], usize::from(bits))
        } else {
            (5 * y..5 * y + 5).flat_map(&pixel).collect()
        }
    };
    (0..3).map(row).collect()
}

#[test]
fn bmp_of_all_depths_and_headers_with_the_top_or_the_bottom_row_first() {
    for header in [12, 16, 40, 52, 56, 64, 108, 124] {
        for height in [3, -3] {
            if header == 12 && height < 0 {
                continue;
            }
            for bits in [2, 4, 8, 16, 24, 32] {
                let base = Bmp {
                    header,
                    height,
                    bits,
                    colors: if bits <= 8 {
                        COLORS.to_vec()
                    } else {
                        Vec::new()
                    },
                    ..Bmp::default()
                };
                let case = format!("header {header}, height {height}, {bits} bits");
                let wanted = colored(&COLORS);
                let rows = bmp_rows(bits, |at| {
                    let [r, g, b, _] = wanted[at];
                    match bits {
                        16 => {
                            let [r, g, b] = [r, g, b].map(|x| u16::from(x >> 3));
                            (r << 10 | g << 5 | b).to_le_bytes().to_vec()
                        }
                        24 => vec![b, g, r],
                        _ => vec![b, g, r, 0],
                    }
                });
                let five = |x: u8| u8::try_from((u32::from(x >> 3) * 255 + 15) / 31).unwrap();
                let wanted: Vec<Color> = match bits {
                    16 => wanted
                        .iter()
                        .map(|&[r, g, b, _]| [five(r), five(g), five(b), 255])
                        .collect(),
                    _ => wanted,
                };
                let picture = assert_pixels(&base.rows(rows).file(), &wanted, &case);
                let table = Table {
                    indices: INDICES.to_vec(),
                    colors: COLORS.to_vec(),
                };
                assert_eq!(picture.table, (bits <= 8).then_some(table), "{case}");
            }
        }
    }
}

#[test]
fn bmp_of_1_bit() {
    let bmp = Bmp {
        header: 40,
        height: 3,
        bits: 1,
        colors: COLORS[1..3].to_vec(),
        ..Bmp::default()
    };
    let ones: Vec<u8> = INDICES.iter().map(|at| at & 1).collect();
    let rows = (0..3).map(|y| packed(&ones[5 * y..][..5], 1)).collect();
    let wanted: Vec<Color> = ones.iter().map(|&at| COLORS[1 + usize::from(at)]).collect();
    assert_pixels(&bmp.rows(rows).file(), &wanted, "1 bit");
}

#[test]
fn bmp_with_bit_fields_and_alpha() {
    let pixels: Vec<Color> = (0..15)
        .map(|at| [at * 8, 255 - at * 8, at, at * 17])
        .collect();
    let bits = |header, compression, masks: &[u32]| Bmp {
        header,
        height: -3,
        bits: 32,
        compression,
        masks: masks.to_vec(),
        ..Bmp::default()
    };
    let rgba = |at: usize| pixels[at].to_vec();
    let bgra = |at: usize| {
        let [r, g, b, alpha] = pixels[at];
        vec![b, g, r, alpha]
    };
    let masks = [0xff, 0xff00, 0x00ff_0000, 0xff00_0000];
    let opaque: Vec<Color> = pixels.iter().map(|&[r, g, b, _]| [r, g, b, 255]).collect();
    let cases = [
        (
            "masks",
            bits(108, 3, &masks).rows(bmp_rows(32, rgba)),
            &pixels,
        ),
        (
            "masks after the header",
            bits(40, 6, &masks).rows(bmp_rows(32, rgba)),
            &pixels,
        ),
        (
            "masks without alpha",
            bits(40, 3, &masks[..3]).rows(bmp_rows(32, rgba)),
            &opaque,
        ),
        (
            "no masks",
            bits(40, 0, &[]).rows(bmp_rows(32, bgra)),
            &pixels,
        ),
    ];
    for (case, bmp, wanted) in cases {
        assert_pixels(&bmp.file(), wanted, case);
    }
    let five_six_five = Bmp {
        bits: 16,
        ..bits(40, 3, &[0xf800, 0x07e0, 0x001f])
    };
    let rows = bmp_rows(16, |at| {
        let raw = [0xf800, 0x07e0, 0x001f, 0xffff, 0x8410][at % 5];
        u16::to_le_bytes(raw).to_vec()
    });
    let row = [
        [255, 0, 0, 255],
        [0, 255, 0, 255],
        [0, 0, 255, 255],
        [255; 4],
        [132, 130, 132, 255],
    ];
    assert_pixels(&five_six_five.rows(rows).file(), &row.repeat(3), "5-6-5");
}

#[test]
fn bmp_with_run_lengths() {
    let bmp = |bits, compression, data: &[u8]| Bmp {
        header: 40,
        height: 3,
        bits,
        compression,
        colors: COLORS.to_vec(),
        data: data.to_vec(),
        ..Bmp::default()
    };
    // From the bottom: a row of runs, a row with single pixels and padding, and a row with a jump over two pixels.
    let eight = [
        3, 1, 1, 2, 1, 3, 0, 0, 0, 5, 3, 3, 1, 0, 2, 99, 0, 0, 1, 1, 0, 2, 2, 0, 2, 3, 0, 1,
    ];
    let four = [
        3, 0x11, 2, 0x23, 0, 0, 0, 5, 0x33, 0x10, 0x20, 99, 0, 0, 1, 0x10, 0, 2, 2, 0, 2, 0x33, 0,
        1,
    ];
    let mut wanted = INDICES;
    wanted[..5].copy_from_slice(&[1, 0, 0, 3, 3]);
    let wanted: Vec<Color> = wanted.iter().map(|&at| COLORS[usize::from(at)]).collect();
    assert_pixels(&bmp(8, 1, &eight).file(), &wanted, "8 bits");
    assert_pixels(&bmp(4, 2, &four).file(), &wanted, "4 bits");
    // The end mark is missing, or a run continues after the end of its row.
    assert_pixels(
        &bmp(8, 1, &[5, 1, 0, 0, 5, 1, 0, 0, 5, 1]).file(),
        &[COLORS[1]; 15],
        "no end",
    );
    assert_pixels(
        &bmp(8, 1, &[9, 1, 0, 0, 9, 1, 0, 0, 9, 1, 0, 1]).file(),
        &[COLORS[1]; 15],
        "long",
    );
    let refusal = Picture::decode(&bmp(8, 1, &eight[..20]).file()).unwrap_err();
    assert_eq!(refusal, "it ends in row 2 of 3");
}

#[test]
fn bmp_refusals_name_the_cause() {
    let bmp = Bmp {
        header: 40,
        height: 3,
        bits: 8,
        colors: COLORS.to_vec(),
        ..Bmp::default()
    }
    .rows(bmp_rows(8, |_| Vec::new()));
    let file = bmp.file();
    assert_eq!(
        Picture::decode(&file[..file.len() - 9]).unwrap_err(),
        "it ends after 2 of 3 rows"
    );
    assert!(
        Picture::decode(&file[..file.len() - 3]).is_ok(),
        "padding of the last row"
    );
    let change = |at: usize, value: u8| {
        let mut file = file.clone();
        file[at] = value;
        Picture::decode(&file).unwrap_err()
    };
    assert_eq!(
        change(30, 5),
        "its compression 5 of 8 bits a pixel cannot be read"
    );
    assert_eq!(
        change(28, 7),
        "it has 7 bits a pixel: 1, 2, 4, 8, 16, 24 or 32 can be read"
    );
    assert_eq!(
        change(22, 0),
        "it is 5x0 pixels: 1 to 65536 can be read from a file of 94 bytes"
    );
    assert_eq!(
        change(file.len() - 24, 9),
        "a color index is not in its table"
    );
}

/// A TGA of this kind. `table` is the first index and the raw colors. `bits` are the bits of a color of the table, and
/// the bits of a pixel.
fn tga(
    kind: u8,
    table: (u16, &[Vec<u8>]),
    bits: [u8; 2],
    flags: u8,
    pixels: &[Vec<u8>],
) -> Vec<u8> {
    let mut bytes = vec![3, u8::from(!table.1.is_empty()), kind];
    bytes.extend(table.0.to_le_bytes());
    bytes.extend(u16::try_from(table.1.len()).unwrap().to_le_bytes());
    bytes.extend([bits[0], 0, 0, 0, 0, 5, 0, 3, 0, bits[1], flags]);
    bytes.extend(b"id!");
    bytes.extend(table.1.concat());
    if kind & 8 == 0 {
        bytes.extend(pixels.concat());
        return bytes;
    }
    let mut rest = pixels;
    while let Some((first, after)) = rest.split_first() {
        let same = after.iter().take_while(|pixel| *pixel == first).count();
        let len = if same > 0 {
            same + 1
        } else {
            rest.len().min(2)
        };
        let mark = if same > 0 { 0x80 } else { 0 };
        bytes.push(mark | u8::try_from(len - 1).unwrap());
        bytes.extend(if same > 0 {
            first.clone()
        } else {
            rest[..len].concat()
        });
        rest = &rest[len..];
    }
    bytes
}

/// Reorders pixels for a file that begins in the corner that `flags` name.
fn from_corner<T: Clone>(pixels: &[T], flags: u8) -> Vec<T> {
    let at = |x: usize, y: usize| {
        let x = if flags & 0x10 == 0 { x } else { WIDTH - 1 - x };
        let y = if flags & 0x20 == 0 { HEIGHT - 1 - y } else { y };
        pixels[y * WIDTH + x].clone()
    };
    (0..HEIGHT)
        .flat_map(|y| (0..WIDTH).map(move |x| (x, y)))
        .map(|(x, y)| at(x, y))
        .collect()
}

#[test]
fn tga_of_all_kinds_from_all_corners() {
    let alpha: Vec<Color> = COLORS
        .iter()
        .enumerate()
        .map(|(at, &[r, g, b, _])| [r, g, b, [0, 90, 160, 255][at]])
        .collect();
    let bgr = |&[r, g, b, _]: &Color| vec![b, g, r];
    let bgra = |&[r, g, b, alpha]: &Color| vec![b, g, r, alpha];
    let short = |&[r, g, b, alpha]: &Color| {
        let [r, g, b, alpha] = [r >> 3, g >> 3, b >> 3, alpha >> 7].map(u16::from);
        (alpha << 15 | r << 10 | g << 5 | b).to_le_bytes().to_vec()
    };
    let five = |x: u8| u8::try_from((u32::from(x >> 3) * 255 + 15) / 31).unwrap();
    let fives: Vec<Color> = COLORS
        .iter()
        .map(|&[r, g, b, _]| [five(r), five(g), five(b), 255])
        .collect();
    let holes: Vec<Color> = fives
        .iter()
        .zip(&alpha)
        .map(|(&[r, g, b, _], a)| [r, g, b, a[3] / 128 * 255])
        .collect();
    let gray: Vec<Color> = COLORS.iter().map(|&[r, ..]| [r, r, r, 255]).collect();
    let gray_alpha: Vec<Color> = alpha.iter().map(|&[r, _, _, a]| [r, r, r, a]).collect();
    let raw = |colors: &[Color], encode: &dyn Fn(&Color) -> Vec<u8>| -> Vec<Vec<u8>> {
        colored(colors).iter().map(encode).collect()
    };
    let indices: Vec<Vec<u8>> = INDICES.iter().map(|&at| vec![at + 2]).collect();
    let wide: Vec<Vec<u8>> = INDICES.iter().map(|&at| vec![at + 2, 0]).collect();
    let table = |colors: &[Color], encode: &dyn Fn(&Color) -> Vec<u8>| -> Vec<Vec<u8>> {
        colors.iter().map(encode).collect()
    };
    let cases = [
        (
            1,
            table(&COLORS, &bgr),
            [24, 8],
            0,
            indices.clone(),
            colored(&COLORS),
        ),
        (
            1,
            table(&alpha, &bgra),
            [32, 8],
            8,
            indices.clone(),
            colored(&alpha),
        ),
        (
            1,
            table(&COLORS, &short),
            [16, 8],
            0,
            indices,
            colored(&fives),
        ),
        (1, table(&COLORS, &bgr), [24, 16], 0, wide, colored(&COLORS)),
        (2, vec![], [0, 24], 0, raw(&COLORS, &bgr), colored(&COLORS)),
        (2, vec![], [0, 32], 8, raw(&alpha, &bgra), colored(&alpha)),
        (2, vec![], [0, 32], 0, raw(&alpha, &bgra), colored(&COLORS)),
        (2, vec![], [0, 15], 0, raw(&COLORS, &short), colored(&fives)),
        (2, vec![], [0, 16], 0, raw(&alpha, &short), colored(&fives)),
        (2, vec![], [0, 16], 1, raw(&alpha, &short), colored(&holes)),
        (
            3,
            vec![],
            [0, 8],
            0,
            raw(&COLORS, &|c| vec![c[0]]),
            colored(&gray),
        ),
        (
            3,
            vec![],
            [0, 16],
            8,
            raw(&alpha, &|c| vec![c[0], c[3]]),
            colored(&gray_alpha),
        ),
    ];
    for (kind, table, bits, flags, pixels, wanted) in cases {
        for corner in [0, 0x10, 0x20, 0x30] {
            for kind in [kind, kind | 8] {
                let case = format!("kind {kind}, bits {bits:?}, flags {flags}, corner {corner:x}");
                let pixels = from_corner(&pixels, corner);
                let file = tga(kind, (2, &table), bits, flags | corner, &pixels);
                let picture = assert_pixels(&file, &wanted, &case);
                assert_eq!(
                    picture.table.is_some(),
                    kind & 3 == 1 && bits[1] == 8,
                    "{case}"
                );
                let problem = Picture::decode(&file[..file.len() - 1]).unwrap_err();
                assert!(problem.ends_with("of 15 pixels"), "{case}: {problem}");
            }
        }
    }
}

#[test]
fn tga_keeps_its_table() {
    let table: Vec<Vec<u8>> = COLORS.iter().map(|&[r, g, b, _]| vec![b, g, r]).collect();
    let pixels: Vec<Vec<u8>> = INDICES.iter().map(|&at| vec![at]).collect();
    let picture = decode(&tga(1, (0, &table), [24, 8], 0x20, &pixels));
    assert_eq!(picture.palette(), Some((INDICES.to_vec(), COLORS.to_vec())));
}

#[test]
fn a_channel_of_alpha_that_is_0_everywhere_is_not_used() {
    let pixels = vec![vec![1, 2, 3, 0]; 15];
    let file = tga(2, (0, &[]), [0, 32], 0x28, &pixels);
    assert_pixels(&file, &[[3, 2, 1, 255]; 15], "TGA");
}

/// A PNG, with a palette and alphas if `table` has them.
fn png(
    color: png::ColorType,
    depth: png::BitDepth,
    table: Option<[Vec<u8>; 2]>,
    data: &[u8],
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 5, 3);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if let Some([colors, alphas]) = table {
        if !colors.is_empty() {
            encoder.set_palette(colors);
        }
        if !alphas.is_empty() {
            encoder.set_trns(alphas);
        }
    }
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(data).unwrap();
    writer.finish().unwrap();
    bytes
}

#[test]
fn png_of_all_kinds_and_depths() {
    use png::{BitDepth, ColorType};
    let colors: Vec<u8> = COLORS
        .iter()
        .flat_map(|color| color[..3].to_vec())
        .collect();
    let clear = [COLORS[0], [255, 0, 0, 7], COLORS[2], COLORS[3]];
    for (depth, bits) in [
        (BitDepth::Two, 2),
        (BitDepth::Four, 4),
        (BitDepth::Eight, 8),
    ] {
        let rows: Vec<u8> = INDICES
            .chunks(5)
            .flat_map(|row| packed(row, bits))
            .collect();
        let file = png(
            ColorType::Indexed,
            depth,
            Some([colors.clone(), vec![255, 7]]),
            &rows,
        );
        let picture = assert_pixels(&file, &colored(&clear), &format!("{bits} bits"));
        assert_eq!(picture.palette(), Some((INDICES.to_vec(), clear.to_vec())));

        let gray = |at: u8| u8::try_from(u32::from(at) * 255 / ((1 << bits) - 1)).unwrap();
        let wanted: Vec<Color> = INDICES
            .iter()
            .map(|&at| [gray(at), gray(at), gray(at), 255])
            .collect();
        let file = png(ColorType::Grayscale, depth, None, &rows);
        assert_pixels(&file, &wanted, &format!("gray, {bits} bits"));
        let holes: Vec<Color> = INDICES
            .iter()
            .zip(&wanted)
            .map(|(&at, &[r, g, b, _])| [r, g, b, if at == 3 { 0 } else { 255 }])
            .collect();
        let file = png(
            ColorType::Grayscale,
            depth,
            Some([vec![], vec![0, 3]]),
            &rows,
        );
        assert_pixels(&file, &holes, &format!("gray with a hole, {bits} bits"));
    }
    let ones: Vec<u8> = INDICES.iter().map(|at| at & 1).collect();
    let rows: Vec<u8> = ones.chunks(5).flat_map(|row| packed(row, 1)).collect();
    let wanted: Vec<Color> = ones
        .iter()
        .map(|&at| [at * 255, at * 255, at * 255, 255])
        .collect();
    assert_pixels(
        &png(ColorType::Grayscale, BitDepth::One, None, &rows),
        &wanted,
        "gray, 1 bit",
    );
    for (kind, channels) in [
        (ColorType::Grayscale, 1),
        (ColorType::GrayscaleAlpha, 2),
        (ColorType::Rgb, 3),
        (ColorType::Rgba, 4),
    ] {
        let samples: Vec<u8> = (0..15 * channels)
            .map(|at| u8::try_from(at * 4).unwrap())
            .collect();
        let wanted: Vec<Color> = samples
            .chunks(channels)
            .map(|s| match *s {
                [g] => [g, g, g, 255],
                [g, alpha] => [g, g, g, alpha],
                [r, g, b] => [r, g, b, 255],
                _ => s.try_into().unwrap(),
            })
            .collect();
        assert_pixels(
            &png(kind, BitDepth::Eight, None, &samples),
            &wanted,
            &format!("{kind:?}"),
        );
        let wide: Vec<u8> = samples.iter().flat_map(|&x| [x, x]).collect();
        assert_pixels(
            &png(kind, BitDepth::Sixteen, None, &wide),
            &wanted,
            &format!("{kind:?}, 16 bits"),
        );
    }
    // One color is marked as transparent: red, in 16 bits.
    let wide: Vec<u8> = colored(&COLORS)
        .iter()
        .flat_map(|c| [c[0], c[0], c[1], c[1], c[2], c[2]])
        .collect();
    let file = png(
        ColorType::Rgb,
        BitDepth::Sixteen,
        Some([vec![], vec![255, 255, 0, 0, 0, 0]]),
        &wide,
    );
    let wanted = [COLORS[0], [255, 0, 0, 0], COLORS[2], COLORS[3]];
    assert_pixels(&file, &colored(&wanted), "a transparent color of 16 bits");
}

/// A JPEG of 8x8 pixels of one color, which is given by its components. The JPEG is baseline or progressive, and has
/// Adobe's marker if the color is CMYK. All Huffman codes of DC have 4 bits; the only code of AC has 1 bit.
fn jpeg(components: &[u8], is_progressive: bool) -> Vec<u8> {
    let count = u8::try_from(components.len()).unwrap();
    let segment = |marker: u8, data: &[u8]| {
        let len = u16::try_from(data.len() + 2).unwrap().to_be_bytes();
        [&[0xff, marker][..], &len, data].concat()
    };
    let mut bytes = vec![0xff, 0xd8];
    if count == 4 {
        bytes.extend(segment(0xee, b"Adobe\0\x64\0\0\0\0\0"));
    }
    bytes.extend(segment(0xdb, &[vec![0], vec![8; 64]].concat()));
    let ids = || 1..=count;
    let frame: Vec<u8> = ids().flat_map(|id| [id, 0x11, 0]).collect();
    let start = if is_progressive { 0xc2 } else { 0xc0 };
    bytes.extend(segment(
        start,
        &[vec![8, 0, 8, 0, 8, count], frame].concat(),
    ));
    let mut counts = [0; 16];
    counts[3] = 12;
    bytes.extend(segment(
        0xc4,
        &[vec![0x00], counts.to_vec(), (0..12).collect()].concat(),
    ));
    (counts[3], counts[0]) = (0, 1);
    bytes.extend(segment(
        0xc4,
        &[vec![0x10], counts.to_vec(), vec![0]].concat(),
    ));
    let scan: Vec<u8> = ids().flat_map(|id| [id, 0]).collect();
    let end = if is_progressive { 0 } else { 63 };
    bytes.extend(segment(
        0xda,
        &[vec![count], scan, vec![0, end, 0]].concat(),
    ));
    let mut bits = String::new();
    for &component in components {
        let value = i32::from(component) - 128;
        let size = 32 - value.unsigned_abs().leading_zeros();
        let code = if value < 0 {
            value + (1 << size) - 1
        } else {
            value
        };
        write!(bits, "{size:04b}").unwrap();
        if size > 0 {
            write!(bits, "{code:0width$b}", width = size as usize).unwrap();
        }
        if !is_progressive {
            bits += "0";
        }
    }
    while !bits.len().is_multiple_of(8) {
        bits += "1";
    }
    for at in (0..bits.len()).step_by(8) {
        let byte = u8::from_str_radix(&bits[at..at + 8], 2).unwrap();
        bytes.push(byte);
        if byte == 0xff {
            bytes.push(0);
        }
    }
    bytes.extend([0xff, 0xd9]);
    bytes
}

#[test]
fn jpeg_in_gray_color_and_cmyk() {
    // Adobe's CMYK is stored inverted.
    let cases: [(&[u8], [u8; 3]); 4] = [
        (&[77], [77, 77, 77]),
        (&[150, 128, 128], [150, 150, 150]),
        (&[76, 85, 255], [254, 0, 0]),
        (&[255, 128, 0, 255], [255, 128, 0]),
    ];
    for (components, wanted) in cases {
        for is_progressive in [false, true] {
            let file = jpeg(components, is_progressive);
            let picture = decode(&file);
            assert_eq!((picture.width, picture.height), (8, 8));
            for pixel in &picture.pixels {
                let is_near = pixel
                    .iter()
                    .zip(wanted)
                    .all(|(is, wanted)| is.abs_diff(wanted) <= 1);
                assert!(
                    is_near && pixel[3] == 255,
                    "{components:?}, {is_progressive}: {pixel:?}"
                );
            }
            let problem = Picture::decode(&file[..file.len() - 2]).unwrap_err();
            assert_eq!(problem, "it ends before its end marker");
        }
    }
}

/// A GIF of 5x3 pixels. The first frame has this place, size and transparent index.
fn gif(place: [u16; 2], size: [u16; 2], transparent: Option<u8>) -> Vec<u8> {
    let mut bytes = Vec::new();
    let colors: Vec<u8> = COLORS
        .iter()
        .flat_map(|color| color[..3].to_vec())
        .collect();
    let mut encoder = gif::Encoder::new(&mut bytes, 5, 3, &colors).unwrap();
    let len = usize::from(size[0]) * usize::from(size[1]);
    let frame = gif::Frame {
        left: place[0],
        top: place[1],
        width: size[0],
        height: size[1],
        transparent,
        buffer: INDICES.repeat(4)[..len].to_vec().into(),
        ..gif::Frame::default()
    };
    encoder.write_frame(&frame).unwrap();
    let second = gif::Frame {
        width: 5,
        height: 3,
        buffer: vec![2; 15].into(),
        ..gif::Frame::default()
    };
    encoder.write_frame(&second).unwrap();
    drop(encoder);
    bytes
}

#[test]
fn gif_shows_its_first_frame() {
    let picture = assert_pixels(&gif([0, 0], [5, 3], None), &colored(&COLORS), "whole");
    assert_eq!(picture.palette(), Some((INDICES.to_vec(), COLORS.to_vec())));
    let clear = [COLORS[0], [255, 0, 0, 0], COLORS[2], COLORS[3]];
    assert_pixels(
        &gif([0, 0], [5, 3], Some(1)),
        &colored(&clear),
        "transparent",
    );
    let mut part = [[0; 4]; 15];
    part[7..10].copy_from_slice(&colored(&COLORS)[..3]);
    part[12..15].copy_from_slice(&colored(&COLORS)[3..6]);
    assert_pixels(&gif([2, 1], [3, 2], None), &part, "a part");
    let mut beyond = [[0; 4]; 15];
    beyond[14] = COLORS[0];
    assert_pixels(&gif([4, 2], [3, 2], None), &beyond, "beyond the border");
}

/// A lossy WebP of 8x8 gray pixels, with this alpha.
fn lossy(alpha: Option<u8>) -> Vec<u8> {
    let frame = vp8(8, 64, 128);
    match alpha {
        None => riff(&[(b"VP8 ", frame)]),
        Some(alpha) => riff(&[
            (b"VP8X", vec![0x10, 0, 0, 0, 7, 0, 0, 7, 0, 0]),
            (b"ALPH", [vec![0], vec![alpha; 64]].concat()),
            (b"VP8 ", frame),
        ]),
    }
}

fn lossless(pixels: &[Color]) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let image = RgbaImage::from_raw(5, 3, pixels.concat()).unwrap();
    image.write_to(&mut bytes, ImageFormat::WebP).unwrap();
    bytes.into_inner()
}

#[test]
fn webp_with_and_without_loss_and_alpha_and_animated() {
    for (file, alpha) in [(lossy(None), 255), (lossy(Some(60)), 60)] {
        let picture = decode(&file);
        assert_eq!((picture.width, picture.height), (8, 8));
        for pixel in picture.pixels {
            let wanted = [130, 130, 130, alpha];
            assert!(
                pixel
                    .iter()
                    .zip(wanted)
                    .all(|(is, wanted)| is.abs_diff(wanted) <= 2),
                "{pixel:?}"
            );
        }
    }
    let clear = [COLORS[0], [255, 0, 0, 60], COLORS[2], COLORS[3]];
    for colors in [&COLORS, &clear] {
        let file = lossless(&colored(colors));
        assert_pixels(&file, &colored(colors), "lossless");
        // A frame of an animation contains the same chunk as a still picture.
        let chunk = |pixels: &[Color]| lossless(pixels)[12..].to_vec();
        let frame = |pixels: &[Color]| {
            [
                vec![0; 6],
                vec![4, 0, 0, 2, 0, 0, 100, 0, 0, 2],
                chunk(pixels),
            ]
            .concat()
        };
        let animated = riff(&[
            (b"VP8X", vec![0x12, 0, 0, 0, 4, 0, 0, 2, 0, 0]),
            (b"ANIM", vec![0; 6]),
            (b"ANMF", frame(&colored(colors))),
            (b"ANMF", frame(&[COLORS[2]; 15])),
        ]);
        assert_pixels(&animated, &colored(colors), "animated");
    }
}

#[test]
fn files_of_another_program_are_read_alike() {
    let pixels: Vec<Color> = (0..15)
        .map(|at| [at * 16, 255 - at * 9, at * at, 255 - at])
        .collect();
    let image = RgbaImage::from_raw(5, 3, pixels.concat()).unwrap();
    let opaque: Vec<Color> = pixels.iter().map(|&[r, g, b, _]| [r, g, b, 255]).collect();
    for format in [
        ImageFormat::Png,
        ImageFormat::Bmp,
        ImageFormat::Tga,
        ImageFormat::WebP,
    ] {
        for (image, wanted) in [
            (DynamicImage::from(image.clone()), &pixels),
            (DynamicImage::from(image.clone()).to_rgb8().into(), &opaque),
        ] {
            let mut bytes = Cursor::new(Vec::new());
            image.write_to(&mut bytes, format).unwrap();
            assert_pixels(bytes.get_ref(), wanted, &format!("{format:?}"));
        }
    }
}

#[test]
fn invisible_colors_do_not_bleed() {
    let [red, clear] = [[200, 0, 0, 255], [0, 255, 0, 0]];
    let picture = Picture {
        width: 4,
        height: 1,
        pixels: vec![red, clear, clear, clear],
        table: None,
    };
    assert_eq!(picture.resampled(2, 1).pixels, [[200, 0, 0, 128], [0; 4]]);
    let nothing = Picture {
        pixels: vec![clear; 4],
        ..picture
    };
    assert_eq!(nothing.resampled(2, 1).pixels, [[0; 4]; 2]);
}

#[test]
fn means_of_opaque_colors_stay_opaque() {
    let pixels: Vec<Color> = (0..64).map(|at| [at * 4, 255 - at, at * 3, 255]).collect();
    let picture = Picture {
        width: 8,
        height: 8,
        pixels,
        table: None,
    };
    assert_eq!(picture.resampled(8, 8), picture);
    for (width, height) in [(3, 5), (16, 2), (1, 1)] {
        let other = picture.resampled(width, height);
        assert_eq!(other.pixels.len(), (width * height) as usize);
        assert!(!other.has_alpha());
    }
}

#[test]
fn a_palette_has_at_most_256_colors() {
    let of = |count: u16| {
        let pixels = (0..count).map(|at| [at.to_le_bytes()[0], at.to_le_bytes()[1], 0, 255]);
        Picture {
            width: u32::from(count),
            height: 1,
            pixels: pixels.collect(),
            table: None,
        }
    };
    let (indices, colors) = of(256).palette().unwrap();
    assert_eq!(indices, (0..=255).collect::<Vec<u8>>());
    assert_eq!(colors, of(256).pixels);
    assert_eq!(of(257).palette(), None);
    // If the pixels no longer agree with the table, the table is not used.
    let mut picture = decode(&gif([0, 0], [5, 3], None));
    picture.pixels.fill([1, 2, 3, 4]);
    assert_eq!(picture.palette(), Some((vec![0; 15], vec![[1, 2, 3, 4]])));
}

/// A JPEG of 16x8 pixels, the left half dark and the right half bright, with this orientation.
fn with_orientation(exif: &[u8]) -> Picture {
    let shade = |x, y| image::Luma([if x < 8 { 40 } else { 200 } + if y < 4 { 0 } else { 20 }]);
    let mut bytes = Cursor::new(Vec::new());
    let picture = image::GrayImage::from_fn(16, 8, shade);
    picture.write_to(&mut bytes, ImageFormat::Jpeg).unwrap();
    let bytes = bytes.into_inner();
    let length = u16::try_from(exif.len() + 8).unwrap().to_be_bytes();
    let segment = [b"\xff\xe1", &length[..], b"Exif\0\0", exif].concat();
    decode(&[&bytes[..2], &segment, &bytes[2..]].concat())
}

#[test]
fn exif_orientation_turns_jpegs() {
    // The corner that shows the file's first pixel: from the left or the right, and from the top or the bottom.
    let corners = [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
    ];
    for (value, [right, bottom]) in (1..=8_u8).zip(corners) {
        let little = [
            b"II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0",
            &[value, 0, 0, 0][..],
        ]
        .concat();
        let big = [
            b"MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01",
            &[0, value, 0, 0][..],
        ]
        .concat();
        for exif in [little, big] {
            let picture = with_orientation(&exif);
            let (width, height) = if value > 4 { (8, 16) } else { (16, 8) };
            assert_eq!((picture.width, picture.height), (width, height), "{value}");
            let at = |x: u32, y: u32| picture.pixels[(y * width + x) as usize][0];
            let (x, y) = (right * (width - 1), bottom * (height - 1));
            // The darkest quarter is at the first pixel, the brightest across. The coder moves grays by a few steps.
            assert!(at(x, y).abs_diff(40) < 12, "{value}: {}", at(x, y));
            let across = at(width - 1 - x, height - 1 - y);
            assert!(across.abs_diff(220) < 12, "{value}: {across}");
        }
    }
    for exif in [
        &b"II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x09\0\0\0"[..],
        b"II*\0\x08",
        b"",
    ] {
        assert_eq!(with_orientation(exif).width, 16);
    }
}

/// Sets the sampling factors of a file's components, and how many components its first scan has.
fn resampled(file: &[u8], factors: [u8; 3], scan: u8) -> Vec<u8> {
    let mut file = file.to_vec();
    let place = |file: &[u8], marker: u8| {
        let mut pairs = file.windows(2);
        pairs.position(|pair| pair == [0xff, marker]).unwrap()
    };
    // The frame follows the only table of quantization.
    let start = place(&file, 0xdb) + 69;
    for (at, factor) in factors.into_iter().enumerate() {
        file[start + 11 + 3 * at] = factor;
    }
    let start = place(&file, 0xda);
    file[start + 4] = scan;
    file
}

/// The decoder reads these files to their end, and returns other colors than those in them.
#[test]
fn jpegs_with_planes_in_unusual_orders_are_refused() {
    let refused = "its colors are stored in an unusual order: save it again";
    let problem = |factors, scan, is_progressive| {
        let file = jpeg(&[150, 128, 128], is_progressive);
        Picture::decode(&resampled(&file, factors, scan)).err()
    };
    let (half, same) = ([0x22, 0x11, 0x11], [0x11; 3]);
    assert_eq!(problem(half, 1, false).as_deref(), Some(refused));
    assert_eq!(problem(half, 2, false).as_deref(), Some(refused));
    assert_eq!(
        problem([0x11, 0x21, 0x21], 3, false).as_deref(),
        Some(refused)
    );
    // A progressive file always has such scans, and planes of one size lie in any order.
    for (factors, scan, is_progressive) in [(same, 3, false), (same, 1, false), (half, 1, true)] {
        let problem = problem(factors, scan, is_progressive);
        assert_ne!(problem.as_deref(), Some(refused), "{factors:?} {scan}");
    }
    // Bytes of 0xff before a marker do not hide it.
    let mut file = resampled(&jpeg(&[150, 128, 128], false), half, 1);
    file.splice(2..2, [0xff, 0xff]);
    assert_eq!(Picture::decode(&file).unwrap_err(), refused);
}
