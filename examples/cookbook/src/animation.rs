//! An animation as a GIF: one palette for all frames, and for each frame only the pixels that have changed.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use color_quant::NeuQuant;
use embedded_graphics::geometry::{OriginDimensions, Point};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics_simulator::SimulatorDisplay;
use gif::{DisposalMethod, Encoder, Frame, Repeat};

/// Time between frames, in hundredths of a second.
const DELAY: u16 = 10;
/// Colors of the palette. The index after them leaves a pixel as it is.
const COLORS: usize = 63;
const UNCHANGED: u8 = COLORS as u8;
/// Two colors look the same if the squares of their differences in red, green and blue add up to no more.
const TOLERANCE: i32 = 350;

type Pixel = [u8; 4];

/// Writes pictures of one size to a file; after the last one, the first one follows.
pub fn save(path: &Path, pictures: &[SimulatorDisplay<Rgb565>]) -> Result<(), Box<dyn Error>> {
    let frames: Vec<Vec<Pixel>> = pictures.iter().map(pixels).collect();
    let samples = frames.iter().flatten().step_by(7);
    let quantizer = NeuQuant::new(5, COLORS, &samples.flatten().copied().collect::<Vec<_>>());
    let mut palette = quantizer.color_map_rgb();
    palette.resize(3 * (COLORS + 1), 0);

    let size = pictures.first().map(OriginDimensions::size);
    let size = size.ok_or("an animation needs a frame")?;
    let [width, height] = [size.width, size.height].map(|side| side as u16);
    let file = BufWriter::new(File::create(path)?);
    let mut encoder = Encoder::new(file, width, height, &palette)?;
    encoder.set_repeat(Repeat::Infinite)?;
    let mut shown = vec![None; usize::from(width) * usize::from(height)];
    for frame in &frames {
        let indices: Vec<u8> = (shown.iter_mut().zip(frame))
            .map(|(shown, pixel)| match *shown {
                Some(old) if look_same(old, *pixel) => UNCHANGED,
                _ => {
                    *shown = Some(*pixel);
                    quantizer.index_of(pixel) as u8
                }
            })
            .collect();
        let frame = Frame::from_indexed_pixels(width, height, indices, Some(UNCHANGED));
        encoder.write_frame(&Frame {
            delay: DELAY,
            dispose: DisposalMethod::Keep,
            ..frame
        })?;
    }
    Ok(())
}

fn look_same(a: Pixel, b: Pixel) -> bool {
    let square = |(a, b): (&u8, &u8)| (i32::from(*a) - i32::from(*b)).pow(2);
    a.iter().zip(&b).map(square).sum::<i32>() <= TOLERANCE
}

/// Red, green, blue and opacity of all pixels.
fn pixels(picture: &SimulatorDisplay<Rgb565>) -> Vec<Pixel> {
    let size = picture.size();
    let row = |y| (0..size.width.cast_signed()).map(move |x| Point::new(x, y));
    (0..size.height.cast_signed())
        .flat_map(row)
        .map(|at| Rgb888::from(picture.get_pixel(at)))
        .map(|color| [color.r(), color.g(), color.b(), 255])
        .collect()
}
