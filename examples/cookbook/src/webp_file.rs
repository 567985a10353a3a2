//! Saves an animation as a WebP file.

use std::error::Error;
use std::fs;
use std::path::Path;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use webp::{AnimEncoder, AnimFrame, WebPConfig};

/// How much of the pictures a file keeps.
#[derive(Clone, Copy)]
pub enum Quality {
    /// Each pixel.
    Exact,
    /// What can be seen, twice as large: the animation of the garden would be several times as large with each pixel.
    Visible,
}

/// Writes pictures of equal size to a file, with a number of pictures a second. The animation repeats forever.
pub fn save(
    path: &Path,
    pictures: &[SimulatorDisplay<Rgb565>],
    rate: u64,
    quality: Quality,
) -> Result<(), Box<dyn Error>> {
    let mut config = WebPConfig::new().map_err(|()| "libwebp has another version")?;
    let scale = match quality {
        Quality::Exact => {
            (config.lossless, config.quality, config.method) = (1, 75., 4);
            1
        }
        Quality::Visible => {
            (config.use_sharp_yuv, config.quality) = (1, 12.);
            config.method = 6; // the slowest, for the smallest file
            2
        }
    };
    let settings = OutputSettingsBuilder::new().scale(scale).build();
    let images = pictures
        .iter()
        .map(|picture| picture.to_rgb_output_image(&settings));
    let images: Vec<_> = images.collect();
    let (width, height) = (images.first().ok_or("an animation needs a frame")?)
        .as_image_buffer()
        .dimensions();
    let mut encoder = AnimEncoder::new(width, height, &config);
    // Red, green and blue of each pixel.
    let frames: Vec<_> = images
        .iter()
        .map(|image| image.as_image_buffer().to_vec())
        .collect();
    for (frame, number) in frames.iter().zip(0..) {
        let milliseconds = i32::try_from(number * 1000 / rate)?;
        encoder.add_frame(AnimFrame::from_rgb(frame, width, height, milliseconds));
    }
    let file = encoder
        .try_encode()
        .map_err(|error| format!("WebP: {error:?}"))?;
    Ok(fs::write(path, &*file)?)
}
