//! A picture has at most as many pixels as its format can store in the bytes of its file. Pictures of one color, which
//! compress best, are still read.

mod common;

use std::io::Cursor;

use common::{riff, vp8};
use fixel_assets::Picture;
use image::{ImageFormat, RgbImage};
use png::{BitDepth, ColorType};

/// The side of the large pictures.
const SIDE: u16 = 2048;

/// A side of the refused pictures. Their 256 million pixels are few enough for a file that has the bytes.
const HUGE: u16 = 16_000;

/// A BMP with a table of one color.
fn bmp(side: u16, bits: u16, compression: u32, data: &[u8]) -> Vec<u8> {
    let side = u32::from(side);
    let words = [58, 40, side, side, u32::from(bits) << 16 | 1, compression];
    let words = [&words[..], &[0, 0, 0, 1, 0]].concat();
    let mut bytes = b"BM\0\0\0\0\0\0\0\0".to_vec();
    bytes.extend(words.iter().flat_map(|word| word.to_le_bytes()));
    [&bytes[..], &[30, 20, 10, 0], data].concat()
}

/// A gray TGA.
fn tga(side: u16, kind: u8, data: &[u8]) -> Vec<u8> {
    let [low, high] = side.to_le_bytes();
    let header = [
        0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0, low, high, low, high, 8, 0,
    ];
    [&header[..], data].concat()
}

/// A PNG with the inflated bytes of its rows.
fn png(side: u16, color: ColorType, depth: BitDepth, rows: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side.into(), side.into());
    encoder.set_color(color);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().unwrap();
    let mut deflate = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
    std::io::Write::write_all(&mut deflate, rows).unwrap();
    writer
        .write_chunk(png::chunk::IDAT, &deflate.finish().unwrap())
        .unwrap();
    drop(writer);
    bytes
}

/// A gray JPEG. The code of a block without details is one bit 0 for its brightness and, in a baseline file, one for its
/// details.
fn jpeg(side: u16, is_progressive: bool, data: &[u8]) -> Vec<u8> {
    let [high, low] = side.to_be_bytes();
    let mut bytes = vec![0xff, 0xd8, 0xff, 0xdb, 0, 67, 0];
    bytes.extend([8; 64]);
    let start = if is_progressive { 0xc2 } else { 0xc0 };
    bytes.extend([0xff, start, 0, 11, 8, high, low, high, low, 1, 1, 0x11, 0]);
    for table in [0x00, 0x10] {
        bytes.extend([0xff, 0xc4, 0, 20, table, 1]);
        bytes.extend([0; 16]);
    }
    let end = if is_progressive { 0 } else { 63 };
    bytes.extend([0xff, 0xda, 0, 8, 1, 1, 0, 0, end, 0]);
    [&bytes[..], data, &[0xff, 0xd9]].concat()
}

/// A GIF with a first frame of another size.
fn gif(side: u16, frame: u16) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = gif::Encoder::new(&mut bytes, side, side, &[10, 20, 30]).unwrap();
    let pixels = vec![0; usize::from(frame) * usize::from(frame)];
    let frame = gif::Frame::from_indexed_pixels(frame, frame, pixels, None);
    encoder.write_frame(&frame).unwrap();
    drop(encoder);
    bytes
}

/// A WebP with loss and without details. 12 bits suffice for 16x16 pixels: two fifths of them in the first part of the
/// data, and the others in the second part.
fn lossy(side: u16, data: usize) -> Vec<u8> {
    riff(&[(b"VP8 ", vp8(side, data * 2 / 5, data))])
}

/// A WebP without loss: each of the five codes has one symbol, so pixels take no bits.
fn lossless(side: u16) -> Vec<u8> {
    let side = u64::from(side) - 1;
    let (mut bits, mut len) = (0x2f | u128::from(side << 8 | side << 22), 40);
    for symbol in [20, 10, 30, 255, 0] {
        // No transforms, tables of colors or further codes come before the first code.
        len += if len == 40 { 3 } else { 0 };
        bits |= (0b101 | symbol << 3) << len;
        len += 11;
    }
    riff(&[(b"VP8L", bits.to_le_bytes()[..13].to_vec())])
}

/// Reads a picture of one color. Colors of a WebP with loss differ by at most 2, because borders predict other colors.
#[track_caller]
fn assert_read(case: &str, side: u16, bytes: &[u8]) {
    let picture = Picture::decode(bytes).expect(case);
    let side = u32::from(side);
    assert_eq!((picture.width, picture.height), (side, side), "{case}");
    let first = picture.pixels[0];
    let is_near = |pixel: &[u8; 4]| pixel.iter().zip(first).all(|(a, b)| a.abs_diff(b) <= 2);
    assert!(picture.pixels.iter().all(is_near), "{case}");
}

#[test]
fn pictures_of_one_color_are_read() {
    let side = usize::from(SIDE);
    let pixels = side * side;
    // A row of 2048 pixels is 8 runs of 255 pixels, a run of 8, and the end of the row; or 16 runs of 128.
    let row = [[255, 0].repeat(8), vec![8, 0, 0, 0]].concat();
    let (run, blocks) = ([0x80 | 127, 7], pixels / 64);
    let rows = |bytes: usize| vec![0; side * (1 + bytes)];
    let cases = [
        ("BMP", bmp(SIDE, 1, 0, &vec![0; pixels / 8])),
        ("BMP, runs of 8 bits", bmp(SIDE, 8, 1, &row.repeat(side))),
        ("BMP, runs of 4 bits", bmp(SIDE, 4, 2, &row.repeat(side))),
        ("TGA", tga(SIDE, 3, &vec![7; pixels])),
        ("TGA, runs", tga(SIDE, 11, &run.repeat(pixels / 128))),
        (
            "PNG of 1 bit",
            png(SIDE, ColorType::Grayscale, BitDepth::One, &rows(side / 8)),
        ),
        (
            "PNG in color",
            png(SIDE, ColorType::Rgb, BitDepth::Eight, &rows(side * 3)),
        ),
        ("JPEG", jpeg(SIDE, false, &vec![0; blocks / 4])),
        ("progressive JPEG", jpeg(SIDE, true, &vec![0; blocks / 8])),
        ("GIF", gif(SIDE, SIDE)),
        ("WebP with loss", lossy(SIDE, pixels / 256 * 12 / 8)),
    ];
    for (case, file) in cases {
        assert_read(case, SIDE, &file);
    }
    assert_read("WebP without loss", 4096, &lossless(4096));
    let mut bytes = Cursor::new(Vec::new());
    let image = RgbImage::from_pixel(SIDE.into(), SIDE.into(), image::Rgb([10, 20, 30]));
    image.write_to(&mut bytes, ImageFormat::WebP).unwrap();
    assert_read("WebP of another program", SIDE, bytes.get_ref());
}

/// Some pictures have more pixels than this per byte because all or most of them are not stored.
#[test]
fn small_pictures_are_read_however_few_bytes_they_have() {
    // The end of a picture comes at once, or the first frame is small.
    assert_read("BMP", 256, &bmp(256, 8, 1, &[0, 1]));
    let picture = Picture::decode(&gif(256, 1)).unwrap();
    assert_eq!((picture.width, picture.pixels[1]), (256, [0; 4]));
}

#[test]
fn pictures_too_large_for_their_bytes_are_refused() {
    let data = &[0; 1000];
    // For each file, the most pixels per byte, as a fraction.
    let cases = [
        (bmp(HUGE, 1, 0, data), (8, 1)),
        (bmp(HUGE, 8, 1, data), (255, 2)),
        (bmp(HUGE, 4, 2, data), (255, 2)),
        (tga(HUGE, 3, &vec![0; 100_000]), (1, 1)),
        (tga(HUGE, 11, data), (64, 1)),
        (
            png(HUGE, ColorType::Grayscale, BitDepth::One, data),
            (8256, 1),
        ),
        (png(HUGE, ColorType::Rgb, BitDepth::Eight, data), (344, 1)),
        (
            png(
                HUGE,
                ColorType::Rgba,
                BitDepth::Sixteen,
                &vec![0; 1_000_000],
            ),
            (129, 1),
        ),
        (jpeg(HUGE, false, data), (1024, 1)),
        (jpeg(HUGE, true, data), (1024, 1)),
        (gif(HUGE, 5), (32_768, 12)),
        (lossy(HUGE, 1000), (204_800, 167)),
        (lossless(HUGE), (0, 1)),
    ];
    for (file, (most, per)) in cases {
        let kind = String::from_utf8_lossy(&file[..16]);
        let len = file.len() as u64;
        let least = if kind.contains("VP8L") {
            4096 * 4096
        } else {
            256 * 256
        };
        let most = (len * most / per).max(least);
        let wanted = format!(
            "it is {HUGE}x{HUGE} pixels: 1 to {most} can be read from a file of {len} bytes"
        );
        assert_eq!(Picture::decode(&file).unwrap_err(), wanted, "{kind}");
    }
    // The canvas is small, and the frame is huge: its size comes after the table of 2 colors.
    let mut file = gif(5, 5);
    let at = file.iter().position(|&byte| byte == b',').unwrap();
    file[at + 5..at + 9].copy_from_slice(&[HUGE.to_le_bytes(), HUGE.to_le_bytes()].concat());
    let refused = Picture::decode(&file).unwrap_err();
    assert!(
        refused.starts_with("it is 16000x16000 pixels: 1 to "),
        "{refused}"
    );
}
