//! Textures in every form of PNG, JPEG, BMP and TGA.

use std::fs;

use image::{DynamicImage, ImageFormat, Rgb, RgbImage};

use super::program::{directory, good, printed, refused};

/// A smooth picture, which is the same in all forms except for rounding.
fn colors(width: u32, height: u32) -> DynamicImage {
    let color = |x, y| Rgb([x * 255 / width, y * 255 / height, 128].map(|value| value as u8));
    RgbImage::from_fn(width, height, color).into()
}

#[test]
fn every_form_of_picture_is_read() {
    let directory = directory("textures");
    // A square of one unit, four units from the eye, fills the picture with one texel for each pixel.
    let square =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    fs::write(directory.join("s.obj"), square).unwrap();
    let view = "--eye 0.5,0.5,2 --look-at 0.5,0.5,0 --fov 28.072486935852957 --near 1 --far 3";
    let look = "--size 64x64 --shade texture --color rgb888";
    let drawn = |name: &str| {
        let said = good(
            &directory,
            &format!("s.obj --texture {name} {view} {look} --out o.png"),
        );
        assert_eq!(printed(&said, "pixels"), "4096");
        image::open(directory.join("o.png")).unwrap().into_rgb8()
    };
    let close = |found: &RgbImage, wanted: &RgbImage, within: i32, what: &str| {
        for (x, y, pixel) in found.enumerate_pixels() {
            for (a, b) in pixel.0.iter().zip(wanted.get_pixel(x, y).0) {
                assert!(
                    (i32::from(*a) - i32::from(b)).abs() <= within,
                    "{what} at {x},{y}"
                );
            }
        }
    };
    let picture = colors(64, 64);
    let gray = DynamicImage::from(picture.to_luma8());
    for (name, image) in [
        ("rgb", picture.clone()),
        ("rgba", picture.to_rgba8().into()),
        ("rgb16", picture.to_rgb16().into()),
        ("gray", gray.clone()),
        ("gray-alpha", gray.to_luma_alpha8().into()),
        ("gray16", gray.to_luma16().into()),
    ] {
        // The ending of the name does not matter.
        let file = directory.join("texture.jpg");
        image.save_with_format(file, ImageFormat::Png).unwrap();
        close(&drawn("texture.jpg"), &image.to_rgb8(), 0, name);
    }
    for (name, image) in [("rgb", &picture), ("gray", &gray)] {
        let file = directory.join("texture.png");
        image.save_with_format(file, ImageFormat::Jpeg).unwrap();
        // The tolerance allows for what the compression loses.
        close(&drawn("texture.png"), &image.to_rgb8(), 12, name);
    }
    let save = |name: &str, image: &DynamicImage, format| {
        let file = directory.join(name);
        image.save_with_format(file, format).unwrap();
        drawn(name)
    };
    // A stripe of one color, which becomes runs in a packed TGA.
    let mut striped = picture.to_rgb8();
    for (_, y, pixel) in striped.enumerate_pixels_mut() {
        if y / 8 == 3 {
            *pixel = Rgb([200, 100, 50]);
        }
    }
    let striped = DynamicImage::from(striped);
    for (image, name) in [(&striped, "rgb"), (&gray, "gray")] {
        let wanted = image.to_rgb8();
        close(&save("t.bmp", image, ImageFormat::Bmp), &wanted, 0, name);
        close(&save("t.tga", image, ImageFormat::Tga), &wanted, 0, name);
        // The file is packed in runs.
        assert!(fs::read(directory.join("t.tga")).unwrap()[2] >= 9);
    }
    // This TGA is neither packed nor named after its format, and its bottom row comes first.
    let mut plain = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64, 0, 64, 0, 24, 0];
    for row in striped.to_rgb8().rows().rev() {
        plain.extend(row.flat_map(|pixel| [pixel[2], pixel[1], pixel[0]]));
    }
    fs::write(directory.join("texture"), &plain).unwrap();
    close(&drawn("texture"), &striped.to_rgb8(), 0, "plain TGA");
    // This file ends within a run.
    let packed = fs::read(directory.join("t.tga")).unwrap();
    fs::write(directory.join("cut.tga"), &packed[..packed.len() / 2]).unwrap();
    refused(
        &directory,
        "s.obj --texture cut.tga",
        &["cannot read texture cut.tga: "],
    );
    // Other sizes are resampled: a ramp stays a ramp, except at its border, which lacks neighbors.
    for (width, height) in [(48, 80), (85, 52), (64, 64)] {
        let file = directory.join("other.png");
        colors(width, height).save(file).unwrap();
        let (found, wanted) = (drawn("other.png"), picture.to_rgb8());
        close(&found, &wanted, 8, "resampled");
    }
}
