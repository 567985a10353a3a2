//! BMP files.

use embedded_graphics::pixelcolor::{Gray8, Rgb888, RgbColor};
use fixel::Error;
use fixel::texture::{Image, ImageColor};

use super::files::bmp::{self, Fields, indexed};
use super::files::{blue_first, color, padded};
use super::{holds, survives_any_header};

fn read(bytes: &[u8]) -> Result<Image<'_>, Error> {
    Image::from_bmp(bytes)
}

#[test]
fn bytes_of_24_and_32_bits() {
    holds(&bmp::bytes_of_24_and_32_bits(), read);
}

#[test]
fn bit_fields_of_32_bits() {
    holds(&bmp::bit_fields_of_32_bits(), read);
}

#[test]
fn words_of_16_bits() {
    holds(&bmp::words_of_16_bits(), read);
}

#[test]
fn indices_of_8_4_and_1_bits() {
    holds(&bmp::indices_of_8_4_and_1_bits(), read);
}

#[test]
fn read_at_run_time() {
    let mut fields = indexed(4, 3, 3);
    // Only the first two rows of four columns.
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
        let luma = ImageColor::nearest([r, g, b]);
        assert_eq!(palette.colors()[usize::from(index)], luma);
    }
    // An index beyond the table selects its last color.
    assert_eq!(palette.colors()[255], palette.colors()[2]);

    let mut short = [Rgb888::BLACK; 7];
    let short_by_one = "slice has 7 elements: exactly 8 are needed";
    let error = image.read_texture(&mut short).unwrap_err();
    assert_eq!(format!("{error}"), short_by_one);
    let error = image.read_palette(&mut [0; 7], &mut colors).unwrap_err();
    assert_eq!(format!("{error}"), short_by_one);
}

#[test]
fn unsuitable_images_are_refused_as_texture_or_palette() {
    let bytes = Fields::of(24, &blue_first).bytes();
    let image = Image::from_bmp(&bytes).unwrap();
    let mut texels = [Rgb888::BLACK; 15];
    let error = image.read_texture(&mut texels).unwrap_err();
    assert_eq!(
        format!("{error}"),
        "width is 5: it must be a power of two, at most 32768"
    );
    let (mut indices, mut colors) = ([0; 15], [Rgb888::BLACK; 256]);
    let error = image.read_palette(&mut indices, &mut colors);
    assert_eq!(
        format!("{}", error.unwrap_err()),
        "bits per pixel is 24: it must be 8 (BMP: or 4 or 1) with a color table, for a palette"
    );
}

#[test]
fn malformed_files_say_what_is_wrong() {
    fn says(change: fn(&mut Fields), expected: &str) {
        let mut fields = Fields::of(24, &blue_first);
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
    // A row of 5 · 3 bytes is padded to 16; the header promises four rows, and the file has three.
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
    let bytes = Fields::of(24, &blue_first).bytes();
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

/// With any header, reading neither panics nor reads outside the file.
#[test]
fn no_header_causes_a_panic() {
    let files = [
        Fields::of(24, &blue_first),
        Fields::of(32, &padded),
        indexed(8, 5, 5),
        indexed(1, 0, 2),
    ];
    survives_any_header(&files.map(|fields| fields.bytes()), 54, read);
}
