//! Saves an animation as a WebP file.

use std::error::Error;
use std::fs;
use std::path::Path;

use embedded_graphics::geometry::OriginDimensions;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use webp::{AnimEncoder, AnimFrame, WebPConfig};

/// How much of the pictures a file keeps.
#[derive(Clone, Copy)]
pub enum Quality {
    /// Each pixel.
    Exact,
    /// What can be seen. The animation of the garden has 0.8 MB; with each pixel, it would have 3.8 MB.
    Visible,
}

/// Writes pictures of equal size to a file, with a number of pictures a second. The animation repeats forever.
pub fn save(
    path: &Path,
    pictures: &[SimulatorDisplay<Rgb565>],
    rate: u64,
    quality: Quality,
) -> Result<(), Box<dyn Error>> {
    let size = pictures.first().map(OriginDimensions::size);
    let size = size.ok_or("an animation needs a frame")?;
    let mut config = WebPConfig::new().map_err(|()| "libwebp has another version")?;
    match quality {
        Quality::Exact => (config.lossless, config.quality, config.method) = (1, 75., 4),
        Quality::Visible => {
            (config.use_sharp_yuv, config.quality) = (1, 75.);
            config.method = 6; // the slowest, for the smallest file
        }
    }
    let pixels = |picture: &SimulatorDisplay<Rgb565>| {
        let image = picture.to_rgb_output_image(&OutputSettings::default());
        image.as_image_buffer().to_vec() // red, green and blue of each pixel
    };
    let frames: Vec<Vec<u8>> = pictures.iter().map(pixels).collect();
    let mut encoder = AnimEncoder::new(size.width, size.height, &config);
    for (frame, number) in frames.iter().zip(0..) {
        let milliseconds = i32::try_from(number * 1000 / rate)?;
        encoder.add_frame(AnimFrame::from_rgb(
            frame,
            size.width,
            size.height,
            milliseconds,
        ));
    }
    let file = encoder
        .try_encode()
        .map_err(|error| format!("WebP: {error:?}"))?;
    Ok(fs::write(path, &*file)?)
}
