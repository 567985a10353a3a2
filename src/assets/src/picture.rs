//! Reads pictures: PNG, JPEG, BMP, TGA, GIF and WebP.
//!
//! Each format has a reader of its own. The crate `image` reads all of these formats, but brings color management, too,
//! which takes longer to compile than all of these readers together.

mod bmp;
mod tga;

use std::collections::HashMap;
use std::io::Cursor;

use png::{ColorType, Decoder, Transformations};
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;
use zune_jpeg::errors::DecodeErrors;

use crate::material::times;
use crate::{Alpha, sniff};

/// The largest number of pixels that a picture may have: 16,384 x 16,384.
const MOST: u64 = 1 << 28;

/// Any file may have this many pixels: 256 x 256. Decoding them takes milliseconds.
const FEW: u64 = 1 << 16;

const CAN_BE_READ: &str = "PNG, JPEG, BMP, TGA, GIF and WebP can be read";

/// A picture: its pixels, row by row from the top, as red, green, blue and alpha.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The number of columns, at least 1.
    pub width: u32,
    /// The number of rows, at least 1.
    pub height: u32,
    /// The colors of all pixels: width times height.
    pub pixels: Vec<[u8; 4]>,
    /// The file's table of colors, if it has one.
    pub table: Option<Table>,
}

/// A table of colors, and the pixels as indices into it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// For each pixel, the index of its color.
    pub indices: Vec<u8>,
    /// At most 256 colors: red, green, blue and alpha.
    pub colors: Vec<[u8; 4]>,
}

impl Picture {
    /// Reads a picture. The format is found from the bytes, not from a name.
    ///
    /// # Errors
    ///
    /// The format is unknown, or the picture is damaged or too large.
    pub fn decode(bytes: &[u8]) -> Result<Self, String> {
        let picture = if bytes.starts_with(b"\x89PNG") {
            png(bytes)
        } else if bytes.starts_with(&[0xff, 0xd8]) {
            jpeg(bytes)
        } else if bytes.starts_with(b"BM") {
            bmp::read(bytes)
        } else if bytes.starts_with(b"GIF8") {
            gif(bytes)
        } else if bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
            webp(bytes)
        } else if tga::is(bytes) {
            tga::read(bytes)
        } else {
            Err(sniff::refusal(bytes, CAN_BE_READ)
                .unwrap_or_else(|| "it is not a PNG, JPEG, BMP, TGA, GIF or WebP".into()))
        }?;
        let pixels = u64::from(picture.width) * u64::from(picture.height);
        if pixels == 0 || picture.pixels.len() as u64 != pixels {
            return Err("its size does not match its number of pixels".into());
        }
        Ok(picture)
    }

    /// Multiplies all colors by `tint`.
    pub(crate) fn tint(&mut self, tint: [u8; 3]) {
        if tint != [255; 3] {
            for [r, g, b, _] in &mut self.pixels {
                [*r, *g, *b] = times([*r, *g, *b], tint);
            }
        }
    }

    /// Adds the light of another picture, multiplied by `light`. The picture gets the size of the one with more pixels:
    /// a short file could make a picture of both pictures' longer sides too large.
    pub(crate) fn add(&mut self, glow: &Self, light: [f64; 3]) {
        let is_larger = glow.pixels.len() > self.pixels.len();
        let of = if is_larger { glow } else { &*self };
        let (width, height) = (of.width, of.height);
        *self = self.resampled(width, height);
        for (pixel, glow) in self
            .pixels
            .iter_mut()
            .zip(glow.resampled(width, height).pixels)
        {
            for (channel, (glow, light)) in pixel.iter_mut().zip(glow.into_iter().zip(light)) {
                let sum = f64::from(*channel) + f64::from(glow) * light;
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
                (*channel = sum.round() as u8);
            }
        }
    }

    /// Replaces each alpha by the opacity that `alpha` says it means. If no pixel is visible then, makes all opaque,
    /// and returns true.
    pub fn cut(&mut self, alpha: Alpha) -> bool {
        for [.., a] in &mut self.pixels {
            *a = match alpha {
                Alpha::Ignored => 255,
                Alpha::Cut(least) if *a >= least => 255,
                Alpha::Cut(_) => 0,
                Alpha::Blended => *a,
            };
        }
        let is_hidden = self.pixels.iter().all(|pixel| pixel[3] == 0);
        if is_hidden {
            self.pixels = shown(std::mem::take(&mut self.pixels));
        }
        is_hidden
    }

    /// Whether any pixel is not opaque.
    #[must_use]
    pub fn has_alpha(&self) -> bool {
        self.pixels.iter().any(|pixel| pixel[3] < 255)
    }

    /// Returns the pixels as indices, and the colors; `None` if there are more than 256 colors. If the file has a table
    /// that agrees with the pixels, the colors are this table. Otherwise, the colors are in the order in which they
    /// first occur.
    #[must_use]
    pub fn palette(&self) -> Option<(Vec<u8>, Vec<[u8; 4]>)> {
        if let Some(Table { indices, colors }) = &self.table {
            let from_table = indices.iter().map(|&at| colors.get(usize::from(at)));
            if from_table.eq(self.pixels.iter().map(Some)) {
                return Some((indices.clone(), colors.clone()));
            }
        }
        let mut colors = Vec::new();
        let mut places = HashMap::new();
        let index = |&pixel: &[u8; 4]| {
            let place = places.entry(pixel).or_insert_with(|| {
                colors.push(pixel);
                u8::try_from(colors.len() - 1).ok()
            });
            *place
        };
        let indices: Option<Vec<u8>> = self.pixels.iter().map(index).collect();
        Some((indices?, colors))
    }

    /// Returns the picture in another size. Along a side that shrinks, each new pixel is the mean of the old pixels
    /// that it covers. Along a side that grows, colors are interpolated. In both cases, colors are weighted by alpha,
    /// so the colors of invisible pixels have no weight.
    #[must_use]
    pub fn resampled(&self, width: u32, height: u32) -> Self {
        if (width, height) == (self.width, self.height) {
            return self.clone();
        }
        let (columns, rows) = (weights(self.width, width), weights(self.height, height));
        let stride = self.width.max(1) as usize;
        let mean = |row: &[(usize, f32)], at: &dyn Fn(usize) -> [f32; 4]| {
            row.iter().fold([0.0; 4], |sum, &(from, weight)| {
                let color = at(from);
                [0, 1, 2, 3].map(|channel| sum[channel] + color[channel] * weight)
            })
        };
        let mut wide = Vec::with_capacity(columns.len() * self.height as usize);
        for row in self.pixels.chunks_exact(stride) {
            let at = |x: usize| {
                let [r, g, b, alpha] = row[x].map(f32::from);
                let weight = alpha / 255.0;
                [r * weight, g * weight, b * weight, alpha]
            };
            wide.extend(columns.iter().map(|column| mean(column, &at)));
        }
        let mut pixels = Vec::with_capacity(columns.len() * rows.len());
        for row in &rows {
            for x in 0..columns.len() {
                let [r, g, b, alpha] = mean(row, &|y: usize| wide[y * columns.len() + x]);
                // The sum of the weights has a rounding error, which must not change the mean of opaque colors.
                let weight = match alpha {
                    254.99.. => 1.0,
                    0.5.. => alpha / 255.0,
                    _ => f32::INFINITY,
                };
                #[allow(clippy::cast_sign_loss)] // a mean of bytes, and the cast saturates
                let byte = |value: f32| (value + 0.5) as u8;
                let [r, g, b] = [r, g, b].map(|sum| byte(sum / weight));
                pixels.push([r, g, b, byte(alpha)]);
            }
        }
        Self {
            width,
            height,
            pixels,
            table: None,
        }
    }
}

/// A row of `from` pixels becomes a row of `to` pixels. Returns, for each new pixel, the old pixels that contribute to
/// it, and their weights. If the row shrinks, the old pixels are all that the new pixel covers at least in part. If the
/// row grows, they are the nearest two.
#[allow(clippy::cast_precision_loss, clippy::cast_sign_loss)] // below 2^24, and clamped to 0
fn weights(from: u32, to: u32) -> Vec<Vec<(usize, f32)>> {
    let ratio = from as f32 / to as f32;
    let width = ratio.max(1.0);
    let one = |at: u32| {
        let start = (at as f32 + 0.5) * ratio - width / 2.0;
        let (first, end) = (start.floor().max(0.0) as u32, (start + width).ceil() as u32);
        let covered = |pixel: u32| {
            let pixel = pixel as f32;
            ((pixel + 1.0).min(start + width) - pixel.max(start)).max(0.0)
        };
        let sum: f32 = (first..end.min(from)).map(covered).sum();
        (first..end.min(from))
            .map(|pixel| (pixel as usize, covered(pixel) / sum))
            .collect()
    };
    (0..to).map(one).collect()
}

/// Refuses pictures without pixels, and pictures that are too large: for any file ([`MOST`]), or for a file of this
/// size, because a short file must not claim much memory and time: at most 16 pixels a byte, or 4096 x 4096 pixels. So
/// this must come before the first loop over the pixels.
/// `most` is the largest number of pixels that the format can store in the file's bytes. Pictures of up to [`FEW`] pixels
/// are read even if they have more.
fn check(bytes: &[u8], most: u64, width: u64, height: u64) -> Result<(), String> {
    let bounded = (16 * bytes.len() as u64).max(1 << 24);
    let most = most.min(bounded).clamp(FEW, MOST);
    if (1..=most).contains(&(width * height)) {
        return Ok(());
    }
    let len = bytes.len();
    Err(format!(
        "it is {width}x{height} pixels: 1 to {most} can be read from a file of {len} bytes"
    ))
}

/// A picture from samples of `count` channels: gray, gray and alpha, RGB or RGBA.
fn picture(width: usize, height: usize, samples: &[u8], count: usize) -> Result<Picture, String> {
    let pixels = samples.chunks_exact(count).map(|s| match *s {
        [gray] => [gray, gray, gray, 255],
        [gray, alpha] => [gray, gray, gray, alpha],
        [r, g, b] => [r, g, b, 255],
        _ => [s[0], s[1], s[2], s[3]],
    });
    colored(width, height, pixels.collect())
}

/// A picture without a table.
fn colored(width: usize, height: usize, pixels: Vec<[u8; 4]>) -> Result<Picture, String> {
    let side = |side: usize| u32::try_from(side).map_err(|_| format!("a side has {side} pixels"));
    Ok(Picture {
        width: side(width)?,
        height: side(height)?,
        pixels,
        table: None,
    })
}

/// A picture with pixels that are indices of a table.
fn indexed(
    width: usize,
    height: usize,
    indices: Vec<u8>,
    colors: Vec<[u8; 4]>,
) -> Result<Picture, String> {
    let color = |&at: &u8| colors.get(usize::from(at)).copied();
    let pixels: Option<_> = indices.iter().map(color).collect();
    let pixels = pixels.ok_or("a color index is not in its table")?;
    let mut picture = colored(width, height, pixels)?;
    picture.table = Some(Table { indices, colors });
    Ok(picture)
}

/// The indices of the pixels of a row. An index has 1, 2, 4 or 8 bits. The first index in a byte is in the byte's
/// highest bits.
fn unpacked(row: &[u8], bits: usize, width: usize) -> impl Iterator<Item = u8> {
    let mask = u8::MAX >> (8 - bits);
    (0..width).map(move |x| row[x * bits / 8] >> (8 - bits - x * bits % 8) & mask)
}

/// The color of a pixel, from the bits that the masks of red, green, blue and alpha select. If the mask of alpha is 0,
/// alpha is 255.
fn masked(raw: &[u8], masks: [u32; 4]) -> [u8; 4] {
    let high_first = raw.iter().rev();
    let bits = high_first.fold(0, |bits, &byte| bits << 8 | u32::from(byte));
    let mut color = masks.map(|mask| {
        let shift = mask.trailing_zeros() % 32;
        let (value, most) = ((bits & mask) >> shift, (mask >> shift).max(1));
        // The result is at most 255, because the value is at most `most`.
        ((u64::from(value) * 255 + u64::from(most) / 2) / u64::from(most)) as u8
    });
    if masks[3] == 0 {
        color[3] = 255;
    }
    color
}

/// Makes all pixels opaque if all are invisible, because some programs write 0 to an alpha channel that they do not
/// use.
fn shown(mut pixels: Vec<[u8; 4]>) -> Vec<[u8; 4]> {
    if pixels.iter().all(|pixel| pixel[3] == 0) {
        for pixel in &mut pixels {
            pixel[3] = 255;
        }
    }
    pixels
}

/// Reverses the order of rows, the order of the pixels in each row, or both.
fn turned<T>(mut list: Vec<T>, width: usize, vertically: bool, horizontally: bool) -> Vec<T> {
    if vertically {
        list.reverse();
    }
    if vertically != horizontally {
        list.chunks_mut(width.max(1)).for_each(<[T]>::reverse);
    }
    list
}

/// The message of a reader's error.
fn text(error: impl std::fmt::Display) -> String {
    let text = error.to_string();
    text.replace("IO Error: failed to fill whole buffer", "it ends too early")
}

fn png(bytes: &[u8]) -> Result<Picture, String> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    let is_indexed = decoder.read_header_info().map_err(text)?.color_type == ColorType::Indexed;
    decoder.set_transformations(if is_indexed {
        Transformations::IDENTITY
    } else {
        Transformations::EXPAND | Transformations::STRIP_16
    });
    let mut reader = decoder.read_info().map_err(text)?;
    let (width, height) = reader.info().size();
    // Deflate stores at most 258 bytes in 2 bits: a match takes a bit for its length and a bit for its distance.
    let bits = bytes.len() as u64 * 4 * 258 * 8;
    let most = bits / reader.info().bits_per_pixel() as u64;
    check(bytes, most, width.into(), height.into())?;
    let (width, height) = (width as usize, height as usize);
    let mut buffer = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let frame = reader.next_frame(&mut buffer).map_err(text)?;
    let samples = &buffer[..frame.buffer_size()];
    let channels = match frame.color_type {
        ColorType::Grayscale => 1,
        ColorType::GrayscaleAlpha => 2,
        ColorType::Rgb => 3,
        ColorType::Rgba => 4,
        ColorType::Indexed => {
            let info = reader.info();
            let colors = info.palette.as_deref().ok_or("it has no table of colors")?;
            let alphas = info.trns.as_deref().unwrap_or_default().iter();
            let alphas = alphas.copied().chain(std::iter::repeat(255));
            let colors = colors.chunks_exact(3).zip(alphas);
            let rows = samples.chunks_exact(frame.line_size);
            let bits = frame.bit_depth as usize;
            let indices = rows.flat_map(|row| unpacked(row, bits, width)).collect();
            let colors = colors.map(|(rgb, alpha)| [rgb[0], rgb[1], rgb[2], alpha]);
            return indexed(width, height, indices, colors.collect());
        }
    };
    picture(width, height, samples, channels)
}

fn jpeg(bytes: &[u8]) -> Result<Picture, String> {
    // Without this check, the decoder would fill the missing part of a short file with gray.
    if !bytes.windows(2).any(|marker| marker == [0xff, 0xd9]) {
        return Err("it ends before its end marker".into());
    }
    let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    check_planes(bytes)?;
    decoder.decode_headers().map_err(jpeg_text)?;
    let turn = decoder.exif().map_or(1, |exif| orientation(exif));
    let info = decoder.info().ok_or("it has no header")?;
    // A block takes at least 1 bit, in a progressive file without details. It covers 8x8 pixels, or up to 32x32 pixels
    // if its component has fewer samples. But at least one component has all columns, and at least one has all rows. If
    // these are two components, each has 4 blocks per 32x32 pixels. So 8 bits hold at most 32x32 pixels.
    let most = bytes.len() as u64 * 32 * 32;
    check(bytes, most, info.width.into(), info.height.into())?;
    let samples = decoder.decode().map_err(jpeg_text)?;
    let picture = picture(info.width.into(), info.height.into(), &samples, 3)?;
    Ok(oriented(picture, turn))
}

/// Refuses colors that the JPEG decoder would place wrongly without an error: those of reduced planes that a baseline
/// file stores one after another, and planes with more columns than the first.
fn check_planes(bytes: &[u8]) -> Result<(), String> {
    let (mut at, mut frame) = (2, (0, &[][..]));
    while let Some(&[0xff, marker, high, low]) = bytes.get(at..).and_then(<[u8]>::first_chunk) {
        let end = at + 2 + usize::from(u16::from_be_bytes([high, low]));
        let data = bytes.get(at + 4..end).unwrap_or_default();
        match (marker, data) {
            (0xc0..=0xc2, _) => frame = (marker, data.get(6..).unwrap_or_default()),
            (0xda, [count, ..]) => {
                let (kind, planes) = frame;
                let samples: Vec<u8> = planes.chunks_exact(3).map(|plane| plane[1]).collect();
                let first = samples.first().copied().unwrap_or(0);
                let is_alike = samples.iter().all(|&other| other == first);
                let is_apart = kind < 0xc2 && usize::from(*count) < samples.len();
                let is_finer = samples.iter().any(|&other| other >> 4 > first >> 4);
                if (is_apart && !is_alike) || is_finer {
                    return Err("its colors are stored in an unusual order: save it again".into());
                }
                break;
            }
            _ => {}
        }
        // Bytes of 0xff can come before a marker.
        at = if marker == 0xff { at + 1 } else { end };
    }
    Ok(())
}

/// The message of the JPEG decoder's error, whose own text has quotation marks and names of types.
fn jpeg_text(error: DecodeErrors) -> String {
    match error {
        DecodeErrors::Format(text) => text,
        DecodeErrors::FormatStatic(text) => text.into(),
        DecodeErrors::IoErrors(_) => "it ends too early".into(),
        other => other.to_string(),
    }
}

/// The orientation that Exif data states, from 1 to 8; 1 if they state none.
fn orientation(exif: &[u8]) -> u8 {
    // The entry of the orientation, without its value: a number of 16 bits, the low or the high byte first.
    let entries = [
        (b"\x12\x01\x03\0\x01\0\0\0", 8),
        (b"\x01\x12\0\x03\0\0\0\x01", 9),
    ];
    let mut found = entries.iter().filter_map(|&(entry, value)| {
        let start = exif.windows(8).position(|bytes| bytes == entry)?;
        exif.get(start + value).copied()
    });
    let value = found.next().filter(|value| (1..=8).contains(value));
    value.unwrap_or(1)
}

/// A picture upright, from its Exif orientation: the sides where its first row and its first column are.
fn oriented(mut picture: Picture, orientation: u8) -> Picture {
    let (width, height) = (picture.width as usize, picture.height as usize);
    if orientation > 4 {
        let place = |at: usize| at % height * width + at / height;
        picture.pixels = (0..width * height)
            .map(|at| picture.pixels[place(at)])
            .collect();
        (picture.width, picture.height) = (picture.height, picture.width);
    }
    let (up, left) = (
        matches!(orientation, 3 | 4 | 7 | 8),
        matches!(orientation, 2 | 3 | 6 | 7),
    );
    picture.pixels = turned(picture.pixels, picture.width as usize, up, left);
    picture
}

fn gif(bytes: &[u8]) -> Result<Picture, String> {
    let mut options = gif::DecodeOptions::new();
    options.set_memory_limit(gif::MemoryLimit::Unlimited);
    let mut decoder = options.read_info(bytes).map_err(text)?;
    let (width, height) = (usize::from(decoder.width()), usize::from(decoder.height()));
    // A code of LZW has at most 12 bits, and stands for at most 4096 pixels. Shorter codes stand for fewer pixels a bit.
    let most = bytes.len() as u64 * 4096 * 8 / 12;
    check(bytes, most, width as u64, height as u64)?;
    let frame = decoder.next_frame_info().map_err(text)?;
    let frame = frame.ok_or("it has no picture")?;
    check(bytes, most, frame.width.into(), frame.height.into())?;
    let frame = frame.clone();
    let mut indices = vec![0; decoder.buffer_size()];
    decoder.read_into_buffer(&mut indices).map_err(text)?;
    let colors = frame.palette.as_deref().or(decoder.global_palette());
    let mut colors: Vec<[u8; 4]> = colors
        .ok_or("it has no table of colors")?
        .chunks_exact(3)
        .map(|rgb| [rgb[0], rgb[1], rgb[2], 255])
        .collect();
    let clear = frame.transparent.map(usize::from);
    if let Some(color) = clear.and_then(|at| colors.get_mut(at)) {
        color[3] = 0;
    }
    let (left, top) = (usize::from(frame.left), usize::from(frame.top));
    let (across, down) = (usize::from(frame.width), usize::from(frame.height));
    let frame = indexed(across, down, indices, colors)?;
    if (left, top, across, down) == (0, 0, width, height) {
        return Ok(frame);
    }
    // The first frame can cover only a part of the picture. The rest stays transparent.
    let mut pixels = vec![[0; 4]; width * height];
    let rows = pixels.chunks_exact_mut(width).skip(top);
    for (to, from) in rows.zip(frame.pixels.chunks_exact(across.max(1))) {
        let to = &mut to[left.min(width)..];
        let len = to.len().min(across);
        to[..len].copy_from_slice(&from[..len]);
    }
    colored(width, height, pixels)
}

fn webp(bytes: &[u8]) -> Result<Picture, String> {
    let mut decoder = image_webp::WebPDecoder::new(Cursor::new(bytes)).map_err(text)?;
    let (width, height) = decoder.dimensions();
    let len = bytes.len() as u64;
    let most = if decoder.is_lossy() {
        // 16x16 pixels take at least 1.67 bits: the first decision about how they are predicted takes at least
        // log2(256/145) bits, and the first decision about how their colors are predicted log2(256/142) bits.
        len * (16 * 16 * 8 * 100) / 167
    } else {
        // Areas of one color take no bits at all, so a picture of any size can have 34 bytes. Other areas of two colors
        // take at least 11 bits per 8 * 4096 pixels: a match with the longest length.
        (len * (8 * 8 * 4096) / 11).max(4096 * 4096)
    };
    check(bytes, most, width.into(), height.into())?;
    let len = decoder.output_buffer_size().ok_or("it is too large")?;
    let mut samples = vec![0; len];
    decoder.read_image(&mut samples).map_err(text)?;
    let channels = if decoder.has_alpha() { 4 } else { 3 };
    picture(width as usize, height as usize, &samples, channels)
}
