//! Output files, which are complete or do not exist.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::time::Duration;

use image::codecs::gif::{GifEncoder, Repeat};
use image::codecs::png::PngEncoder;
use image::{Delay, DynamicImage, ExtendedColorType, Frame, ImageEncoder, RgbImage};

use super::Result;

/// Time between frames of an animation, in milliseconds.
pub const FRAME_MS: u64 = 40;

/// The kind of picture that a file name asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Png,
    Gif,
}

impl Format {
    /// Returns the format that the ending of `path` stands for.
    ///
    /// # Errors
    ///
    /// The ending is neither .png nor .gif.
    pub fn of(path: &Path) -> Result<Self> {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("png") => Ok(Self::Png),
            Some("gif") => Ok(Self::Gif),
            _ => Err(format!(
                "output {}: its name must end in .png or .gif",
                path.display()
            )
            .into()),
        }
    }
}

/// A file under a temporary name in the same directory. [`finish`](Self::finish) gives it its own name; without
/// `finish` it is removed.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    partial: PathBuf,
    file: Option<BufWriter<File>>,
}

impl Output {
    /// Opens a file for `path`.
    ///
    /// # Errors
    ///
    /// The file cannot be created.
    pub fn create(path: &Path) -> Result<Self> {
        let refuse = |problem: String| format!("cannot write {}: {problem}", path.display());
        if path.is_dir() {
            return Err(refuse("it is a directory".into()).into());
        }
        let name = path
            .file_name()
            .ok_or_else(|| refuse("it is not a file name".into()))?
            .to_string_lossy();
        let partial = path.with_file_name(format!(".{name}.{}.partial", process::id()));
        let file = File::create(&partial).map_err(|error| refuse(error.to_string()))?;
        Ok(Self {
            path: path.into(),
            partial,
            file: Some(BufWriter::new(file)),
        })
    }

    /// Gives the file its name.
    ///
    /// # Errors
    ///
    /// The file cannot be written or renamed.
    pub fn finish(mut self) -> Result<()> {
        let refuse =
            |error: std::io::Error| format!("cannot write {}: {error}", self.path.display());
        if let Some(mut file) = self.file.take() {
            file.flush().map_err(refuse)?;
        }
        fs::rename(&self.partial, &self.path).map_err(refuse)?;
        Ok(())
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match &mut self.file {
            Some(file) => file.write(bytes),
            None => Ok(0),
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.as_mut().map_or(Ok(()), Write::flush)
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        drop(self.file.take());
        // After `finish`, no file has that name.
        let _ = fs::remove_file(&self.partial);
    }
}

/// Writes `picture` as PNG.
///
/// # Errors
///
/// It cannot be written; then there is no file.
pub fn png(picture: &RgbImage, mut output: Output) -> Result<()> {
    let (width, height) = picture.dimensions();
    PngEncoder::new(&mut output).write_image(picture, width, height, ExtendedColorType::Rgb8)?;
    output.finish()
}

/// Returns an encoder of an animation that plays forever.
///
/// # Errors
///
/// The file cannot be written.
pub fn gif(output: &mut Output) -> Result<GifEncoder<&mut Output>> {
    let mut gif = GifEncoder::new_with_speed(output, 10);
    gif.set_repeat(Repeat::Infinite)?;
    Ok(gif)
}

/// `picture` as one frame of an animation.
pub fn frame(picture: &RgbImage) -> Frame {
    let picture = DynamicImage::ImageRgb8(picture.clone()).into_rgba8();
    let delay = Delay::from_saturating_duration(Duration::from_millis(FRAME_MS));
    Frame::from_parts(picture, 0, 0, delay)
}
