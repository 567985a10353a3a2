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
const DELAY: u16 = 10;
/// Colors of the palette. The index after them leaves a pixel as it is.
const COLORS: usize = 63;
const UNCHANGED: u8 = COLORS as u8;
/// Two colors look the same if the squares of their differences in red, green and blue add up to no more.
const TOLERANCE: i32 = 350;

type Pixel = [u8; 4];

/// Writes pictures of one size to a file; after the last one, the first one follows.
pub fn save(path: &str, pictures: &[SimulatorDisplay<Rgb565>]) -> Result<(), Box<dyn Error>> {
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
        encoder.write_lzw_pre_encoded_frame(&Frame {
            delay: DELAY,
            dispose: DisposalMethod::Keep,
            transparent: Some(UNCHANGED),
            width,
            height,
            buffer: compressed(frame, &mut shown, &quantizer, &palette).into(),
            ..Frame::default()
        })?;
    }
    Ok(())
}

/// A dictionary of sequences of indices, each with a number: LZW, the compression of the format.
///
/// The encoder writes numbers. After each it adds a sequence: the one that it has written and the index after it.
struct Dictionary {
    /// The indices that continue each sequence, and the numbers of the longer sequences.
    sequences: Vec<Vec<(u8, usize)>>,
    /// Bits of a number, and those that are not yet in a byte.
    size: u32,
    bits: (u32, u32),
    bytes: Vec<u8>,
}

impl Dictionary {
    /// Bits of an index.
    const INDEX_BITS: u8 = COLORS.ilog2() as u8 + 1;
    /// The numbers that empty the dictionary and that end a frame; sequences of several indices follow.
    const CLEAR: usize = COLORS + 1;
    const END: usize = COLORS + 2;

    fn new() -> Self {
        let mut new = Self {
            sequences: Vec::new(),
            size: 0,
            bits: (0, 0),
            bytes: vec![Self::INDEX_BITS],
        };
        new.clear();
        new.write(Self::CLEAR);
        new
    }

    fn clear(&mut self) {
        self.sequences = vec![Vec::new(); Self::END + 1];
        self.size = u32::from(Self::INDEX_BITS) + 1;
    }

    /// Writes the number of a sequence, the lowest bit first.
    fn write(&mut self, number: usize) {
        let (bits, count) = &mut self.bits;
        *bits |= (number as u32) << *count;
        *count += self.size;
        while *count >= 8 {
            self.bytes.push(*bits as u8);
            (*bits, *count) = (*bits >> 8, *count - 8);
        }
    }

    /// Writes a sequence that `index` does not continue, and adds the one that it would be.
    fn add(&mut self, sequence: usize, index: u8) {
        self.write(sequence);
        let number = self.sequences.len();
        if number == 4096 {
            self.write(Self::CLEAR);
            self.clear();
            return;
        }
        self.size += u32::from(number == 1 << self.size);
        self.sequences[sequence].push((index, number));
        self.sequences.push(Vec::new());
    }

    /// Writes the last sequence and the end.
    fn finish(mut self, sequence: usize) -> Vec<u8> {
        self.write(sequence);
        self.size += u32::from(self.sequences.len() == 1 << self.size);
        self.write(Self::END);
        self.bytes.push(self.bits.0 as u8);
        self.bytes
    }
}

/// A frame, compressed, and what is shown then.
fn compressed(
    frame: &[Pixel],
    shown: &mut [Option<u8>],
    quantizer: &NeuQuant,
    palette: &[u8],
) -> Vec<u8> {
    let difference = |index: u8, pixel: &Pixel| -> i32 {
        let color = &palette[3 * usize::from(index)..];
        let square = |(a, b): (&u8, &u8)| (i32::from(*a) - i32::from(*b)).pow(2);
        color.iter().zip(&pixel[..3]).map(square).sum()
    };
    let mut dictionary = Dictionary::new();
    let mut current = None;
    for (shown, pixel) in shown.iter_mut().zip(frame) {
        let old = *shown;
        let color = |index| if index == UNCHANGED { old } else { Some(index) };
        // The longer a sequence is that the dictionary has, the better.
        let longer = current
            .and_then(|at: usize| dictionary.sequences.get(at))
            .into_iter()
            .flatten()
            .filter_map(|&(index, longer)| Some((difference(color(index)?, pixel), index, longer)))
            .filter(|&(difference, ..)| difference <= TOLERANCE)
            .min();
        let index = if let Some((_, index, longer)) = longer {
            current = Some(longer);
            index
        } else {
            let is_old = old.is_some_and(|old| difference(old, pixel) <= TOLERANCE);
            let index = if is_old {
                UNCHANGED
            } else {
                quantizer.index_of(pixel) as u8
            };
            if let Some(sequence) = current {
                dictionary.add(sequence, index);
            }
            current = Some(usize::from(index));
            index
        };
        *shown = color(index);
    }
    dictionary.finish(current.unwrap_or_default())
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
