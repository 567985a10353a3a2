//! TGA files.

use fixel::Error;
use fixel::texture::Image;

use super::files::blue_first;
use super::files::tga::{self, Fields};
use super::{holds, survives_any_header};

fn read(bytes: &[u8]) -> Result<Image<'_>, Error> {
    Image::from_tga(bytes)
}

#[test]
fn true_color_from_any_corner() {
    holds(&tga::true_color_from_any_corner(), read);
}

#[test]
fn gray_from_any_corner() {
    holds(&tga::gray_from_any_corner(), read);
}

#[test]
fn indices_with_a_color_map() {
    holds(&tga::indices_with_a_color_map(), read);
}

#[test]
fn a_map_of_true_color_is_skipped() {
    holds(&tga::a_map_of_true_color(), read);
}

#[test]
fn malformed_files_say_what_is_wrong() {
    fn says(change: fn(&mut Fields), expected: &str) {
        let mut fields = Fields::of(2, 24, 0, &blue_first);
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
    let mut bytes = Fields::of(2, 24, 0, &blue_first).bytes();
    for length in 0..bytes.len() {
        let error = Image::from_tga(&bytes[..length]).unwrap_err();
        assert!(matches!(error, Error::Truncated { given, .. } if given == length));
    }
    bytes[1] = 2;
    let error = Image::from_tga(&bytes).unwrap_err();
    assert_eq!(
        format!("{error}"),
        "color map type is 2: it must be 0 or 1 in a TGA file"
    );
}

/// With any header, reading neither panics nor reads outside the file.
#[test]
fn no_header_causes_a_panic() {
    let mut mapped = Fields::of(1, 8, 0, &|x, y| [(x + y) as u8].to_vec());
    mapped.entry_bits = 24;
    mapped.table = (0..6).map(|index| blue_first(index, 0)).collect();
    let files = [Fields::of(2, 24, 0, &blue_first), mapped].map(|fields| fields.bytes());
    survives_any_header(&files, 18, read);
}
