//! The pictures behind the checksums: a kept picture shows which pixels of a new one differ.

use std::fmt::Write;
use std::fs::{self, File};
use std::io::{BufReader, BufWriter};
use std::path::Path;

/// The factor by which a picture of a difference is brighter than the difference. One step of 255 is then visible.
const AMPLIFIED: u8 = 64;

/// A picture that a test has drawn.
pub struct Picture {
    pub name: String,
    /// The checksum that the test states.
    pub stated: u32,
    pub checksum: u32,
    /// Red, green and blue of each pixel, row by row.
    pub rgb: Vec<u8>,
}

/// Fails if a picture's checksum is not the stated one, or if one of the first pictures, up to the number `kept`,
/// differs from the same picture in the file NAME.png beside this module. With `FIXEL_RENEW`, writes this file first.
///
/// The file has up to eight pictures in a row. All pictures are `width` pixels wide.
pub fn check(name: &str, width: usize, kept: usize, pictures: &[Picture]) {
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join(file!());
    let file = here.with_file_name(format!("{name}.png"));
    let renews = std::env::var_os("FIXEL_RENEW").is_some();
    let found = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("golden");
    let before = if kept == 0 { Vec::new() } else { read(&file) };
    // A sheet has the first row of pixels of eight pictures, then their second row, and so on.
    let (row, rows) = (3 * width, pictures[0].rgb.len() / (3 * width));
    let columns = kept.min(8);
    let mut sheet = vec![0; row * columns * rows * kept.div_ceil(8)];
    let (mut report, mut is_wrong) = (String::new(), false);
    for (k, picture) in pictures.iter().enumerate() {
        let mut difference = Vec::new();
        for (y, new) in picture
            .rgb
            .chunks_exact(row)
            .enumerate()
            .take_while(|_| k < kept)
        {
            let at = row * ((k / 8 * rows + y) * columns + k % 8);
            sheet[at..at + row].copy_from_slice(new);
            let old = before.iter().skip(at).chain(std::iter::repeat(&0));
            let channels = new.iter().zip(old);
            difference.extend(channels.map(|(a, b)| a.abs_diff(*b).saturating_mul(AMPLIFIED)));
        }
        let pixels = difference
            .chunks_exact(3)
            .filter(|pixel| **pixel != [0; 3])
            .count();
        let is_stated = picture.checksum == picture.stated;
        if is_stated && pixels == 0 {
            continue;
        }
        is_wrong |= !is_stated || !renews;
        fs::create_dir_all(&found).unwrap();
        let word = &picture.name;
        let path = |of| found.join(format!("{name} {word}{of}.png").replace([' ', ':'], "-"));
        write_png(&path(""), width, &picture.rgb);
        let [new, old] = [picture.checksum, picture.stated].map(|n| [n >> 16, n & 0xffff]);
        let [new, old] = [new, old].map(|[high, low]| format!("0x{high:04x}_{low:04x}"));
        write!(report, "{word}: checksum {new}, stated {old}; ").unwrap();
        if k < kept {
            write_png(&path(" difference"), width, &difference);
            writeln!(report, "{pixels} pixels differ from {}", file.display()).unwrap();
        } else {
            report += "no picture of it is kept\n";
        }
    }
    if kept > 0 && renews {
        write_png(&file, width * columns, &sheet);
    }
    assert!(
        !is_wrong,
        "\n{report}The new pictures, and the differences {AMPLIFIED} times as bright, are in {}.\nIf the new pictures are \
         right, state their checksums in the test, and run it with FIXEL_RENEW=1, which writes the kept pictures.",
        found.display()
    );
}

/// The bytes of a picture; none if there is no such file.
fn read(path: &Path) -> Vec<u8> {
    let Ok(file) = File::open(path) else {
        return Vec::new();
    };
    let mut reader = png::Decoder::new(BufReader::new(file)).read_info().unwrap();
    let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut rgb).unwrap();
    rgb
}

fn write_png(path: &Path, width: usize, rgb: &[u8]) {
    let file = BufWriter::new(File::create(path).unwrap());
    let mut encoder = png::Encoder::new(file, width as u32, (rgb.len() / 3 / width) as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder
        .write_header()
        .unwrap()
        .write_image_data(rgb)
        .unwrap();
}
