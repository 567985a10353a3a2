//! Saves an animation as a WebP file. The file keeps all colors of the pictures. The losses of its compression are
//! invisible.

use std::error::Error;
use std::fs;
use std::path::Path;

use embedded_graphics::geometry::OriginDimensions;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use webp::{AnimEncoder, AnimFrame, WebPConfig};

/// The number of pictures per second.
const RATE: u32 = 15;
/// The quality, at most 100. At 75, the animation of the garden has 0.8 MB; without losses, it would have 3.8 MB.
const QUALITY: f32 = 75.;

/// Writes pictures of equal size to a file. The animation repeats forever.
pub fn save(path: &Path, pictures: &[SimulatorDisplay<Rgb565>]) -> Result<(), Box<dyn Error>> {
    let size = pictures.first().map(OriginDimensions::size);
    let size = size.ok_or("an animation needs a frame")?;
    let mut config = WebPConfig::new().map_err(|()| "libwebp has another version")?;
    config.quality = QUALITY;
    config.method = 6; // the slowest, for the smallest file
    config.use_sharp_yuv = 1;
    let pixels = |picture: &SimulatorDisplay<Rgb565>| {
        let image = picture.to_rgb_output_image(&OutputSettings::default());
        image.as_image_buffer().to_vec() // red, green and blue of each pixel
    };
    let frames: Vec<Vec<u8>> = pictures.iter().map(pixels).collect();
    let mut encoder = AnimEncoder::new(size.width, size.height, &config);
    for (frame, number) in frames.iter().zip(0_u32..) {
        let milliseconds = (number * 1000 / RATE).cast_signed();
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
