//! Writes pictures and animations in file formats.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use gif::{AnyExtension, Repeat};
use png::{BitDepth, ColorType};

use super::Result;
use crate::output;

/// The time between frames of an animation, in milliseconds.
pub const FRAME_MS: u64 = 40;
/// A mark in every picture that this program writes. A picture that gets a default name replaces only a file with this
/// mark.
const MARK: &str = "fixel simulator";

/// The format of a picture file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Png,
    Gif,
    /// Animated PNG.
    Apng,
}

impl Format {
    /// Returns the format that the extension of `path` names. Standard output has no extension, so the format is PNG,
    /// or GIF if there are several frames.
    ///
    /// # Errors
    ///
    /// The extension names no known format, or a format that cannot hold several frames.
    pub fn of(path: &Path, frames: u32) -> Result<Self> {
        let several = frames > 1;
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("png") if several => Err(format!(
                "{frames} frames make an animation: it needs --out FILE.gif or FILE.apng"
            )
            .into()),
            Some("png") => Ok(Self::Png),
            Some("gif") => Ok(Self::Gif),
            Some("apng") => Ok(Self::Apng),
            _ if output::is_stream(path) => Ok(if several { Self::Gif } else { Self::Png }),
            _ => Err(format!(
                "output {}: its name must end in .png, .gif or .apng (an animated PNG)",
                path.display()
            )
            .into()),
        }
    }
}

/// Chooses a name for a picture in the working directory: `stem`, or `stem`-picture if `stem` is an input, or a file
/// that this program did not write.
///
/// # Errors
///
/// Both names are taken.
pub fn free_name(stem: &Path, extension: &str, inputs: &[PathBuf]) -> Result<PathBuf> {
    for suffix in ["", "-picture"] {
        let mut name = stem.as_os_str().to_os_string();
        name.push(suffix);
        name.push(extension);
        let path = PathBuf::from(name);
        let is_free = path.symlink_metadata().is_err() || is_own(&path);
        if is_free && output::refuse_inputs(&path, inputs).is_ok() {
            return Ok(path);
        }
    }
    Err(format!(
        "{0}{extension} and {0}-picture{extension} are files that this program did not write: name the picture with \
         --out",
        stem.display()
    )
    .into())
}

/// Whether this program wrote the file.
fn is_own(path: &Path) -> bool {
    let mut start = Vec::new();
    let is_read = path.is_file()
        && File::open(path).is_ok_and(|file| file.take(256).read_to_end(&mut start).is_ok());
    is_read
        && start
            .windows(MARK.len())
            .any(|bytes| bytes == MARK.as_bytes())
}

/// Encodes the frames of a picture, or of an animation that repeats forever.
pub enum Encoder<'a> {
    Png(png::Writer<&'a mut Vec<u8>>),
    Gif(Box<gif::Encoder<&'a mut Vec<u8>>>, (u16, u16)),
}

impl<'a> Encoder<'a> {
    /// Writes the header for this number of frames.
    ///
    /// # Errors
    ///
    /// The encoder fails.
    pub fn new(
        format: Format,
        bytes: &'a mut Vec<u8>,
        (width, height): (u32, u32),
        frames: u32,
    ) -> Result<Self> {
        if format == Format::Gif {
            let size = (u16::try_from(width)?, u16::try_from(height)?);
            let mut gif = gif::Encoder::new(bytes, size.0, size.1, &[])?;
            // The mark is a comment, which viewers do not show.
            gif.write_raw_extension(AnyExtension(0xfe), &[MARK.as_bytes()])?;
            gif.set_repeat(Repeat::Infinite)?;
            return Ok(Self::Gif(Box::new(gif), size));
        }
        let mut png = png::Encoder::new(bytes, width, height);
        png.set_color(ColorType::Rgb);
        png.set_depth(BitDepth::Eight);
        png.add_text_chunk("Software".into(), MARK.into())?;
        if format == Format::Apng {
            png.set_animated(frames, 0)?;
            png.set_frame_delay(FRAME_MS as u16, 1000)?;
        }
        Ok(Self::Png(png.write_header()?))
    }

    /// Writes a frame.
    ///
    /// # Errors
    ///
    /// The encoder fails.
    pub fn frame(&mut self, pixels: &[Rgb888]) -> Result<()> {
        let pixels: Vec<u8> = pixels
            .iter()
            .flat_map(|color| [color.r(), color.g(), color.b()])
            .collect();
        match self {
            Self::Png(png) => png.write_image_data(&pixels)?,
            Self::Gif(gif, (width, height)) => {
                let mut frame = gif::Frame::from_rgb_speed(*width, *height, &pixels, 10);
                // The delay is in hundredths of a second.
                frame.delay = FRAME_MS as u16 / 10;
                gif.write_frame(&frame)?;
            }
        }
        Ok(())
    }

    /// Writes the end of the file.
    ///
    /// # Errors
    ///
    /// The encoder fails.
    pub fn finish(self) -> Result<()> {
        match self {
            Self::Png(png) => png.finish()?,
            Self::Gif(gif, _) => drop(gif.into_inner()?),
        }
        Ok(())
    }
}
