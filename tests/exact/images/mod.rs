//! BMP and TGA files as the crate reads them. (tests/images shows the same files to another reader.)

use embedded_graphics::pixelcolor::Rgb888;
use fixel::Error;
use fixel::texture::Image;

#[path = "../../image_files/mod.rs"]
mod files;

mod bmp;
mod tga;

use files::{File, SIZE};

/// One of the crate's readers.
type Read = for<'a> fn(&'a [u8]) -> Result<Image<'a>, Error>;

/// Checks that the reader returns the files' pixels.
fn holds(files: &[File], read: Read) {
    for file in files {
        let name = &file.name;
        let image = read(&file.bytes).unwrap();
        assert_eq!((image.width(), image.height()), SIZE, "{name}");
        let mut pixels = file.pixels.iter();
        for (x, y) in (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y))) {
            let expected = pixels.next().map(|&[r, g, b]| Rgb888::new(r, g, b));
            assert_eq!(image.pixel(x, y), expected, "{name}: column {x}, row {y}");
        }
        assert_eq!(image.pixel(SIZE.0, 0), None, "{name}");
        assert_eq!(image.pixel(0, SIZE.1), None, "{name}");
    }
}

/// Sets each byte of the header to each value in turn, and reads the files: no pixel may lie outside the file.
fn survives_any_header(files: &[Vec<u8>], header: usize, read: Read) {
    for file in files {
        for at in 0..header {
            for value in 0..=255 {
                let mut bytes = file.clone();
                bytes[at] = value;
                if let Ok(image) = read(&bytes) {
                    let (x, y) = (image.width() - 1, image.height() - 1);
                    let places = [(0, 0), (x, 0), (0, y), (x, y)];
                    assert!(places.iter().all(|&(x, y)| image.pixel(x, y).is_some()));
                }
            }
        }
    }
}
