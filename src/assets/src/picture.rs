//! Reads pictures: PNG, JPEG, BMP, TGA, GIF and WebP.
//!
//! Each format has a reader of its own. The crate `image` would bring all of them, but also color management, which
//! takes longer to compile than all of these readers together.

use std::io::Cursor;

use png::{ColorType, Decoder, Transformations};
use tinytga::{Bpp, DataType, RawTga};
use zune_bmp::BmpDecoder;
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

/// The largest number of pixels that a picture may have: 16,384 x 16,384.
const MOST: u64 = 1 << 28;

/// Pixels, row by row from the top: red, green, blue and alpha.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Columns, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// As many as columns times rows.
    pub pixels: Vec<[u8; 4]>,
}

impl Picture {
    /// Reads a picture in the format that its bytes show, whatever its name.
    ///
    /// # Errors
    ///
    /// Its format is unknown, or it is damaged or too large.
    pub fn decode(bytes: &[u8]) -> Result<Self, String> {
        let picture = if bytes.starts_with(b"\x89PNG") {
            png(bytes)
        } else if bytes.starts_with(&[0xff, 0xd8]) {
            jpeg(bytes)
        } else if bytes.starts_with(b"BM") {
            bmp(bytes)
        } else if bytes.starts_with(b"GIF8") {
            gif(bytes)
        } else if bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
            webp(bytes)
        } else if is_tga(bytes) {
            tga(bytes)
        } else {
            Err("it is not a PNG, JPEG, BMP, TGA, GIF or WebP".into())
        }?;
        let pixels = u64::from(picture.width) * u64::from(picture.height);
        if pixels == 0 || picture.pixels.len() as u64 != pixels {
            return Err("its size does not fit its pixels".into());
        }
        Ok(picture)
    }

    /// Whether some pixel is not opaque.
    #[must_use]
    pub fn has_alpha(&self) -> bool {
        self.pixels.iter().any(|pixel| pixel[3] < 255)
    }

    /// Returns the picture in another size. Each color is the mean of those around its place, weighted by a triangle
    /// that is twice as wide as a pixel of the coarser size.
    #[must_use]
    pub fn resampled(&self, width: u32, height: u32) -> Self {
        let (columns, rows) = (weights(self.width, width), weights(self.height, height));
        let stride = self.width as usize;
        let mean = |row: &[(usize, f32)], at: &dyn Fn(usize) -> [f32; 4]| {
            row.iter().fold([0.0; 4], |sum, &(from, weight)| {
                let color = at(from);
                [0, 1, 2, 3].map(|channel| sum[channel] + color[channel] * weight)
            })
        };
        let mut wide = Vec::with_capacity(columns.len() * self.height as usize);
        for row in self.pixels.chunks_exact(stride) {
            let at = |x: usize| row[x].map(f32::from);
            wide.extend(columns.iter().map(|column| mean(column, &at)));
        }
        let mut pixels = Vec::with_capacity(columns.len() * rows.len());
        for row in &rows {
            for x in 0..columns.len() {
                let at = |y: usize| wide[y * columns.len() + x];
                #[allow(clippy::cast_sign_loss)] // a mean of bytes, and the cast saturates
                let pixel = mean(row, &at).map(|value| (value + 0.5) as u8);
                pixels.push(pixel);
            }
        }
        Self {
            width,
            height,
            pixels,
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

/// A picture of samples of this many channels: gray, gray and alpha, RGB or RGBA.
fn picture(
    width: usize,
    height: usize,
    samples: &[u8],
    channels: usize,
) -> Result<Picture, String> {
    let pixels = samples.chunks_exact(channels).map(|s| match *s {
        [gray] => [gray, gray, gray, 255],
        [gray, alpha] => [gray, gray, gray, alpha],
        [r, g, b] => [r, g, b, 255],
        _ => [s[0], s[1], s[2], s[3]],
    });
    let side = |side: usize| u32::try_from(side).map_err(|_| format!("a side has {side} pixels"));
    Ok(Picture {
        width: side(width)?,
        height: side(height)?,
        pixels: pixels.collect(),
    })
}

/// An error of a reader as text.
fn text(error: impl std::fmt::Debug + std::fmt::Display) -> String {
    error.to_string()
}

fn png(bytes: &[u8]) -> Result<Picture, String> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::EXPAND | Transformations::STRIP_16);
    let mut reader = decoder.read_info().map_err(text)?;
    let (width, height) = reader.info().size();
    check(width.into(), height.into())?;
    let mut buffer = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let frame = reader.next_frame(&mut buffer).map_err(text)?;
    let samples = &buffer[..frame.buffer_size()];
    let channels = match frame.color_type {
        ColorType::Grayscale => 1,
        ColorType::GrayscaleAlpha => 2,
        ColorType::Rgb => 3,
        ColorType::Rgba => 4,
        ColorType::Indexed => return Err("its palette was not read".into()),
    };
    picture(width as usize, height as usize, samples, channels)
}

fn jpeg(bytes: &[u8]) -> Result<Picture, String> {
    let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder.decode_headers().map_err(text)?;
    let info = decoder.info().ok_or("it has no header")?;
    check(info.width.into(), info.height.into())?;
    let samples = decoder.decode().map_err(text)?;
    picture(info.width.into(), info.height.into(), &samples, 3)
}

fn bmp(bytes: &[u8]) -> Result<Picture, String> {
    let words = |error: &dyn std::fmt::Debug| format!("{error:?}");
    let mut decoder = BmpDecoder::new(ZCursor::new(bytes));
    decoder.decode_headers().map_err(|error| words(&error))?;
    let (width, height) = decoder.dimensions().ok_or("it has no header")?;
    check(width as u64, height as u64)?;
    let channels = decoder.colorspace().ok_or("it has no header")?;
    let samples = decoder.decode().map_err(|error| words(&error))?;
    picture(width, height, &samples, channels.num_components())
}

fn gif(bytes: &[u8]) -> Result<Picture, String> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).map_err(text)?;
    let (width, height) = (usize::from(decoder.width()), usize::from(decoder.height()));
    check(width as u64, height as u64)?;
    let frame = decoder.read_next_frame().map_err(text)?;
    let frame = frame.ok_or("it has no picture")?;
    // The first frame may cover a part of the picture; the rest is transparent.
    let mut samples = vec![0; 4 * width * height];
    let (left, across) = (usize::from(frame.left), usize::from(frame.width));
    let rows = frame.buffer.chunks_exact(4 * across.max(1));
    for (at, row) in (usize::from(frame.top)..height).zip(rows) {
        let start = 4 * (at * width + left.min(width));
        let len = row.len().min(4 * (width - left.min(width)));
        samples[start..start + len].copy_from_slice(&row[..len]);
    }
    picture(width, height, &samples, 4)
}

fn webp(bytes: &[u8]) -> Result<Picture, String> {
    let mut decoder = image_webp::WebPDecoder::new(Cursor::new(bytes)).map_err(text)?;
    let (width, height) = decoder.dimensions();
    check(width.into(), height.into())?;
    let len = decoder.output_buffer_size().ok_or("it is too large")?;
    let mut samples = vec![0; len];
    decoder.read_image(&mut samples).map_err(text)?;
    let channels = if decoder.has_alpha() { 4 } else { 3 };
    picture(width as usize, height as usize, &samples, channels)
}

/// Whether a file may be a TGA. Because TGA has no signature at its start, this checks that the fields of its header
/// make sense.
fn is_tga(bytes: &[u8]) -> bool {
    let Some(&[_, has_table, kind, .., bits, flags]) = bytes.first_chunk::<18>() else {
        return false;
    };
    has_table <= 1
        && matches!(kind & !8, 1..=3)
        && matches!(bits, 8 | 15 | 16 | 24 | 32)
        && flags >> 6 == 0
}

fn tga(bytes: &[u8]) -> Result<Picture, String> {
    let file = RawTga::from_slice(bytes).map_err(|error| format!("{error:?}"))?;
    let size = file.size();
    check(size.width.into(), size.height.into())?;
    let alpha = bytes[17] & 0xf;
    let (width, height) = (size.width as usize, size.height as usize);
    let color = |raw: u32, bits: Bpp| -> [u8; 4] {
        let [b, g, r, a] = raw.to_le_bytes();
        // A channel of 5 bits, widened to 255 steps and rounded to nearest.
        let wide = |shift: u32| ((((raw >> shift) & 31) * 527 + 23) >> 6) as u8;
        match bits {
            Bpp::Bits32 if alpha > 0 => [r, g, b, a],
            Bpp::Bits24 | Bpp::Bits32 => [r, g, b, 255],
            _ => [wide(10), wide(5), wide(0), 255],
        }
    };
    let mut pixels = vec![[0, 0, 0, 255]; width * height];
    let mut count = 0;
    for pixel in file.pixels() {
        count += 1;
        // The reader counts from the top left corner.
        #[allow(clippy::cast_sign_loss)] // within the picture
        let at = pixel.position.y as usize * width + pixel.position.x as usize;
        let Some(place) = pixels.get_mut(at) else {
            continue;
        };
        *place = match (file.data_type(), file.color_map()) {
            (DataType::ColorMapped, Some(map)) => {
                let entry = map.get_raw(pixel.color as usize);
                color(
                    entry.ok_or("a color index leaves its table")?,
                    map.entry_bpp(),
                )
            }
            (DataType::BlackAndWhite, _) => {
                let gray = pixel.color as u8;
                [gray, gray, gray, 255]
            }
            _ => color(pixel.color, file.color_bpp()),
        };
    }
    if count < pixels.len() {
        return Err(format!("it ends after {count} of {} pixels", pixels.len()));
    }
    Ok(Picture {
        width: size.width,
        height: size.height,
        pixels,
    })
}
