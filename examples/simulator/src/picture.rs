//! Pictures that are read. The crate `image` would read more formats, but takes longer to compile than this library.

use std::io::Cursor;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use png::{ColorType, Decoder, Transformations};
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

/// Most pixels of a picture that is read: 16,384 x 16,384.
const MOST: u64 = 1 << 28;

/// Colors, row by row from the top.
#[derive(Debug)]
pub struct Picture {
    pub width: u32,
    pub height: u32,
    pub colors: Vec<Rgb888>,
}

impl Picture {
    /// Reads a PNG or JPEG, whatever its name.
    ///
    /// # Errors
    ///
    /// It is neither, or damaged, or too large.
    pub fn decode(bytes: &[u8]) -> Result<Self, String> {
        let picture = if bytes.starts_with(b"\x89PNG") {
            png(bytes)
        } else if bytes.starts_with(&[0xff, 0xd8]) {
            jpeg(bytes)
        } else {
            Err("it is neither a PNG nor a JPEG".into())
        }?;
        let pixels = u64::from(picture.width) * u64::from(picture.height);
        if pixels == 0 || picture.colors.len() as u64 != pixels {
            return Err("its size does not fit its pixels".into());
        }
        Ok(picture)
    }

    /// Returns the picture in another size. Each color is the mean of those around its place, weighted by a triangle
    /// of twice the distance of pixels, in the coarser of the two sizes.
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

/// For each of `to` pixels in a row: which of `from` pixels it is the mean of, with their shares.
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

fn grays(samples: &[u8], each: usize) -> Vec<Rgb888> {
    let gray = |sample: &[u8]| Rgb888::new(sample[0], sample[0], sample[0]);
    samples.chunks_exact(each).map(gray).collect()
}

fn colors(samples: &[u8], each: usize) -> Vec<Rgb888> {
    let color = |sample: &[u8]| Rgb888::new(sample[0], sample[1], sample[2]);
    samples.chunks_exact(each).map(color).collect()
}
