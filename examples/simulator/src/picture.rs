//! Reads pictures: PNG, JPEG, BMP and TGA.
//!
//! The crate `image` would read more formats, but it takes longer to compile. fixel itself reads BMP and TGA.

use std::io::Cursor;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::Error;
use fixel::texture::Image;
use png::{ColorType, Decoder, Transformations};
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

/// The largest number of pixels that a picture may have: 16,384 x 16,384.
const MOST: u64 = 1 << 28;

/// Colors, row by row from the top.
#[derive(Debug)]
pub struct Picture {
    pub width: u32,
    pub height: u32,
    pub colors: Vec<Rgb888>,
}

impl Picture {
    /// Reads a PNG, JPEG, BMP or TGA, whatever its name.
    ///
    /// # Errors
    ///
    /// It is none of these, or damaged, or too large.
    pub fn decode(bytes: &[u8]) -> Result<Self, String> {
        let picture = if bytes.starts_with(b"\x89PNG") {
            png(bytes)
        } else if bytes.starts_with(&[0xff, 0xd8]) {
            jpeg(bytes)
        } else if bytes.starts_with(b"BM") {
            uncompressed(Image::from_bmp(bytes))
        } else if is_tga(bytes) {
            let unpacked = unpacked_tga(bytes);
            uncompressed(Image::from_tga(unpacked.as_deref().unwrap_or(bytes)))
        } else {
            Err("it is not a PNG, JPEG, BMP or TGA".into())
        }?;
        let pixels = u64::from(picture.width) * u64::from(picture.height);
        if pixels == 0 || picture.colors.len() as u64 != pixels {
            return Err("its size does not fit its pixels".into());
        }
        Ok(picture)
    }

    /// Returns the picture in another size. Each color is the mean of those around its place, weighted by a triangle
    /// that is twice as wide as a pixel of the coarser size.
    pub fn resampled(&self, width: u32, height: u32) -> Self {
        let (columns, rows) = (weights(self.width, width), weights(self.height, height));
        let stride = self.width as usize;
        let mean = |row: &[(usize, f32)], at: &dyn Fn(usize) -> [f32; 3]| {
            row.iter().fold([0.0; 3], |sum, &(from, weight)| {
                let color = at(from);
                [0, 1, 2].map(|channel| sum[channel] + color[channel] * weight)
            })
        };
        let mut wide = Vec::with_capacity(columns.len() * self.height as usize);
        for row in self.colors.chunks_exact(stride) {
            let at = |x: usize| [row[x].r(), row[x].g(), row[x].b()].map(f32::from);
            wide.extend(columns.iter().map(|column| mean(column, &at)));
        }
        let mut colors = Vec::with_capacity(columns.len() * rows.len());
        for row in &rows {
            for x in 0..columns.len() {
                let at = |y: usize| wide[y * columns.len() + x];
                #[allow(clippy::cast_sign_loss)] // a mean of bytes, and the cast saturates
                let [r, g, b] = mean(row, &at).map(|value| (value + 0.5) as u8);
                colors.push(Rgb888::new(r, g, b));
            }
        }
        Self {
            width,
            height,
            colors,
        }
    }
}

/// Returns, for each of `to` pixels in a row, which of the `from` pixels contribute to its mean, and their weights.
#[allow(clippy::cast_precision_loss, clippy::cast_sign_loss)] // below 2^24, and clamped to 0
fn weights(from: u32, to: u32) -> Vec<Vec<(usize, f32)>> {
    let ratio = from as f32 / to as f32;
    let reach = ratio.max(1.0);
    let one = |at: u32| {
        let center = (at as f32 + 0.5) * ratio;
        let first = (center - reach).floor().max(0.0) as u32;
        let end = ((center + reach).ceil() as u32).min(from);
        let weight = |pixel: u32| (1.0 - (pixel as f32 + 0.5 - center).abs() / reach).max(0.0);
        let sum: f32 = (first..end).map(weight).sum();
        (first..end)
            .map(|pixel| (pixel as usize, weight(pixel) / sum))
            .collect()
    };
    (0..to).map(one).collect()
}

fn check(width: u64, height: u64) -> Result<(), String> {
    if width * height > MOST {
        return Err(format!(
            "it is {width}x{height} pixels: at most {MOST} can be read"
        ));
    }
    Ok(())
}

fn png(bytes: &[u8]) -> Result<Picture, String> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::EXPAND | Transformations::STRIP_16);
    let mut reader = decoder.read_info().map_err(|error| error.to_string())?;
    let (width, height) = reader.info().size();
    check(width.into(), height.into())?;
    let mut buffer = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let frame = reader
        .next_frame(&mut buffer)
        .map_err(|error| error.to_string())?;
    let samples = &buffer[..frame.buffer_size()];
    // Alpha is dropped.
    let colors = match frame.color_type {
        ColorType::Grayscale => grays(samples, 1),
        ColorType::GrayscaleAlpha => grays(samples, 2),
        ColorType::Rgb => colors(samples, 3),
        ColorType::Rgba => colors(samples, 4),
        ColorType::Indexed => return Err("its palette was not read".into()),
    };
    Ok(Picture {
        width,
        height,
        colors,
    })
}

fn jpeg(bytes: &[u8]) -> Result<Picture, String> {
    let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder
        .decode_headers()
        .map_err(|error| error.to_string())?;
    let info = decoder.info().ok_or("it has no header")?;
    check(info.width.into(), info.height.into())?;
    let samples = decoder.decode().map_err(|error| error.to_string())?;
    Ok(Picture {
        width: info.width.into(),
        height: info.height.into(),
        colors: colors(&samples, 3),
    })
}

fn uncompressed(image: Result<Image<'_>, Error>) -> Result<Picture, String> {
    let image = image.map_err(|error| error.to_string())?;
    let (width, height) = (image.width(), image.height());
    check(width.into(), height.into())?;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let colors = pixels.filter_map(|(x, y)| image.pixel(x, y)).collect();
    Ok(Picture {
        width,
        height,
        colors,
    })
}

/// Whether a file may be a TGA. Because TGA has no signature at its start, this checks that the fields of its header
/// make sense.
fn is_tga(bytes: &[u8]) -> bool {
    let Some(&[_, has_table, kind, .., bits, flags]) = bytes.first_chunk::<18>() else {
        return false;
    };
    has_table <= 1
        && matches!(kind & !PACKED, 1..=3)
        && matches!(bits, 8 | 15 | 16 | 24 | 32)
        && flags >> 6 == 0
}

/// The bit that marks the run-length encoded types of TGA.
const PACKED: u8 = 8;

/// Decodes the runs of a TGA; `None` if it has none, or is damaged.
fn unpacked_tga(bytes: &[u8]) -> Option<Vec<u8>> {
    let header = bytes.first_chunk::<18>()?;
    if header[2] & PACKED == 0 {
        return None;
    }
    let word = |at: usize| usize::from(u16::from_le_bytes([header[at], header[at + 1]]));
    // Entries of the color table and pixels take whole bytes.
    let (entry, size) = (header[7].div_ceil(8), usize::from(header[16].div_ceil(8)));
    let table = usize::from(header[1]) * word(5) * usize::from(entry);
    let start = 18 + usize::from(header[0]) + table;
    let len = word(12) * word(14) * size;
    let mut unpacked = bytes.get(..start)?.to_vec();
    unpacked[2] &= !PACKED;
    let mut rest = bytes.get(start..)?;
    while unpacked.len() < start + len {
        let (&head, after) = rest.split_first()?;
        let count = usize::from(head & 0x7f) + 1;
        // Either a run that repeats one pixel, or several literal pixels.
        let (pixels, times) = if head & 0x80 == 0 {
            (after.get(..count * size)?, 1)
        } else {
            (after.get(..size)?, count)
        };
        unpacked.extend(pixels.repeat(times));
        rest = &after[pixels.len()..];
    }
    Some(unpacked)
}

fn grays(samples: &[u8], each: usize) -> Vec<Rgb888> {
    let gray = |sample: &[u8]| Rgb888::new(sample[0], sample[0], sample[0]);
    samples.chunks_exact(each).map(gray).collect()
}

fn colors(samples: &[u8], each: usize) -> Vec<Rgb888> {
    let color = |sample: &[u8]| Rgb888::new(sample[0], sample[1], sample[2]);
    samples.chunks_exact(each).map(color).collect()
}
