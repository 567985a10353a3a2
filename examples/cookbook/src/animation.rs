//! An animation as a GIF: one palette for all frames, and of each frame only what has changed.
//!
//! Among colors that look the same, it takes the one that compresses best.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

use color_quant::NeuQuant;
use embedded_graphics::geometry::{OriginDimensions, Point};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_graphics_simulator::SimulatorDisplay;
use gif::{DisposalMethod, Encoder, Frame, Repeat};

/// Time between frames, in hundredths of a second.
const DELAY: u16 = 9;
/// Colors of the palette. The index after them leaves a pixel as it is.
const COLORS: usize = 127;
const UNCHANGED: u8 = 127;
/// Two colors look the same if the squares of their differences in red, green and blue add up to no more.
const TOLERANCE: i32 = 220;

type Pixel = [u8; 4];

/// Writes pictures of one size to a file; after the last one, the first one follows.
pub fn save(path: &str, pictures: &[SimulatorDisplay<Rgb565>]) -> Result<(), Box<dyn Error>> {
    let frames: Vec<Vec<Pixel>> = pictures.iter().map(pixels).collect();
    let samples = frames.iter().flatten().step_by(7);
    let quantizer = NeuQuant::new(1, COLORS, &samples.flatten().copied().collect::<Vec<_>>());
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
        encoder.write_frame(&Frame {
            delay: DELAY,
            dispose: DisposalMethod::Keep,
            transparent: Some(UNCHANGED),
            width,
            height,
            buffer: indices(frame, &mut shown, &quantizer, &palette).into(),
            ..Frame::default()
        })?;
    }
    Ok(())
}

/// The indices that a frame is written with, and what is shown then.
///
/// The format compresses (LZW) by a dictionary of sequences of indices, which grows by one when a sequence is not in it.
/// So the longer a sequence that is in it can be continued, the fewer bits there are.
fn indices(
    frame: &[Pixel],
    shown: &mut [Option<u8>],
    quantizer: &NeuQuant,
    palette: &[u8],
) -> Vec<u8> {
    /// Sequences by their numbers: the indices that continue each, and the numbers of the longer sequences.
    fn start() -> Vec<Vec<(u8, usize)>> {
        vec![Vec::new(); COLORS + 1]
    }
    let mut sequences = start();
    let mut current = None;
    let difference = |index: u8, pixel: &Pixel| -> i32 {
        let color = &palette[3 * usize::from(index)..];
        let square = |(a, b): (&u8, &u8)| (i32::from(*a) - i32::from(*b)).pow(2);
        color.iter().zip(&pixel[..3]).map(square).sum()
    };
    let mut indices = Vec::with_capacity(frame.len());
    for (shown, pixel) in shown.iter_mut().zip(frame) {
        let old = *shown;
        let color = |index| if index == UNCHANGED { old } else { Some(index) };
        let continued = current
            .and_then(|at: usize| sequences.get(at))
            .into_iter()
            .flatten()
            .filter_map(|&(index, longer)| {
                let difference = difference(color(index)?, pixel);
                (difference <= TOLERANCE).then_some((difference, index, longer))
            })
            .min();
        let index = if let Some((_, index, longer)) = continued {
            current = Some(longer);
            index
        } else {
            let is_old = old.is_some_and(|old| difference(old, pixel) <= TOLERANCE);
            let index = if is_old {
                UNCHANGED
            } else {
                quantizer.index_of(pixel) as u8
            };
            if let Some(at) = current {
                let longer = sequences.len();
                sequences[at].push((index, longer));
                sequences.push(Vec::new());
                // Two numbers are for other purposes. A full dictionary is emptied.
                if longer + 2 >= 4095 {
                    sequences = start();
                }
            }
            current = Some(usize::from(index));
            index
        };
        *shown = color(index);
        indices.push(index);
    }
    indices
}

/// Red, green, blue and opacity of all pixels.
fn pixels(picture: &SimulatorDisplay<Rgb565>) -> Vec<Pixel> {
    let size = picture.size();
    let row = |y| (0..size.width as i32).map(move |x| Point::new(x, y));
    (0..size.height as i32)
        .flat_map(row)
        .map(|at| Rgb888::from(picture.get_pixel(at)))
        .map(|color| [color.r(), color.g(), color.b(), 255])
        .collect()
}
