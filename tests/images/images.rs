//! Checks the files of tests/exact/images with another project's reader: it must see the same pictures. And what takes
//! the compiler seconds: a texture of the documented size.

#[path = "../image_files/mod.rs"]
mod files;

use embedded_graphics::pixelcolor::Rgb565;
use files::{File, SIZE, bmp, tga};
use fixel::texture::TextureArray;
use image::{ImageFormat, Rgb};

/// Checks that the `image` crate returns the files' pixels, for the files that it reads.
fn holds(format: ImageFormat, kinds: impl IntoIterator<Item = Vec<File>>) {
    let mut count = 0;
    for file in kinds.into_iter().flatten().filter(|file| file.others_agree) {
        let name = &file.name;
        let image = image::load_from_memory_with_format(&file.bytes, format).unwrap();
        let image = image.into_rgb8();
        assert_eq!(image.dimensions(), SIZE, "{name}");
        for ((x, y, &Rgb(found)), expected) in image.enumerate_pixels().zip(&file.pixels) {
            assert_eq!(found, *expected, "{name}: column {x}, row {y}");
        }
        count += 1;
    }
    assert!(count > 10, "{count} files");
}

#[test]
fn the_image_crate_reads_the_same_bmp_files() {
    let kinds = [
        bmp::bytes_of_24_and_32_bits(),
        bmp::bit_fields_of_32_bits(),
        bmp::words_of_16_bits(),
        bmp::indices_of_8_4_and_1_bits(),
    ];
    holds(ImageFormat::Bmp, kinds);
}

#[test]
fn the_image_crate_reads_the_same_tga_files() {
    let kinds = [
        tga::true_color_from_any_corner(),
        tga::gray_from_any_corner(),
        tga::indices_with_a_color_map(),
        tga::a_map_of_true_color(),
    ];
    holds(ImageFormat::Tga, kinds);
}

#[test]
fn a_texture_of_the_documented_size_compiles() {
    static LARGE: TextureArray<Rgb565, 512, 512> = TextureArray::rgb565(&[0x12; 512 * 512 * 2]);
    assert_eq!(LARGE.texels()[511][511], Rgb565::new(2, 16, 18));
}
