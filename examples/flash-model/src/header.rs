//! The header, and the lists behind it.

use core::ops::Range;

use bytemuck::{AnyBitPattern, NoUninit, Pod, Zeroable};

use crate::Problem;

/// Where the model starts in a board's address space: behind 256 KiB for the firmware. examples/boards/build.rs keeps
/// the firmware below.
pub const ADDRESS: u32 = 0x1004_0000;

/// The first word: "fixm".
pub(crate) const MAGIC: u32 = u32::from_le_bytes(*b"fixm");
/// The version of the format.
pub(crate) const VERSION: u32 = 2;
/// The words at the start that the checksum leaves out.
const UNCHECKED: usize = 4;
/// A part's texture if it has none.
pub(crate) const NO_TEXTURE: u32 = u32::MAX;

/// The first face, the one after the last, 0xRRGGBB, and the index of a texture or 0xFFFFFFFF.
pub type PartRecord = [u32; 4];
/// Width, height and the index of the first texel.
pub type TextureRecord = [u32; 3];

/// The first words of a model.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct Header {
    /// "fixm".
    pub magic: u32,
    /// The version of the format.
    pub version: u32,
    /// The length of header and lists in bytes.
    pub length: u32,
    /// The CRC-32 of everything behind this word.
    pub checksum: u32,
    /// A [`Panel`].
    pub panel: u32,
    /// The fraction bits of positions.
    pub fraction: u32,
    /// The least u and v, and the greatest, in units of 2^-20.
    pub uv_corners: [[i32; 2]; 2],
    /// Elements of the lists.
    pub positions: u32,
    /// Elements.
    pub faces: u32,
    /// Elements.
    pub normals: u32,
    /// Elements.
    pub normal_faces: u32,
    /// Elements.
    pub uvs: u32,
    /// Elements.
    pub uv_faces: u32,
    /// Elements.
    pub colors: u32,
    /// Elements.
    pub color_faces: u32,
    /// Elements.
    pub parts: u32,
    /// Elements.
    pub textures: u32,
    /// Elements.
    pub texels: u32,
}

/// The words of a header.
pub(crate) const HEADER: usize = size_of::<Header>() / 4;

/// A board that the firmware runs on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Board {
    /// A Raspberry Pi Pico, with an RP2040 and 2 MiB of flash.
    Pico,
    /// A Raspberry Pi Pico 2, with an RP2350 and 4 MiB of flash.
    Pico2,
}

impl Board {
    /// Where the model lies in the address space: up to the end of flash.
    #[must_use]
    pub const fn flash(self) -> Range<u32> {
        match self {
            Self::Pico => ADDRESS..0x1020_0000,
            Self::Pico2 => ADDRESS..0x1040_0000,
        }
    }

    /// How many words the flash for the model has.
    #[must_use]
    pub const fn words(self) -> usize {
        let Range { start, end } = self.flash();
        (end - start) as usize / 4
    }
}

/// A panel that the firmware knows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Panel {
    /// 240x240 pixels.
    #[default]
    St7789 = 0,
    /// 320x240 pixels.
    Ili9341 = 1,
}

impl Panel {
    /// The panel of a number.
    #[must_use]
    pub const fn of(number: u32) -> Option<Self> {
        match number {
            0 => Some(Self::St7789),
            1 => Some(Self::Ili9341),
            _ => None,
        }
    }

    /// The panel that is wanted, even if the rest is damaged; the ST7789 if that is unknown.
    #[must_use]
    pub fn wanted(words: &[u32]) -> Self {
        let header = words.first_chunk::<HEADER>();
        header
            .map(bytemuck::must_cast_ref::<_, Header>)
            .filter(|header| header.magic == MAGIC && header.version == VERSION)
            .and_then(|header| Self::of(header.panel))
            .unwrap_or_default()
    }

    /// Its columns and rows.
    #[must_use]
    pub const fn size(self) -> (u32, u32) {
        match self {
            Self::St7789 => (240, 240),
            Self::Ili9341 => (320, 240),
        }
    }
}

/// The header, and the words of the lists, whose checksum is right.
pub(crate) fn read(words: &[u32]) -> Result<(&Header, &[u32]), Problem> {
    let (header, _) = words
        .split_first_chunk::<HEADER>()
        .ok_or(Problem::Missing)?;
    let header: &Header = bytemuck::must_cast_ref(header);
    if header.magic != MAGIC {
        return Err(Problem::Missing);
    }
    if header.version != VERSION {
        return Err(Problem::Version(header.version));
    }
    let length = header.length as usize / 4;
    let is_whole = header.length.is_multiple_of(4) && length >= HEADER;
    let words = words.get(..length).filter(|_| is_whole);
    let words = words.ok_or(Problem::Length(header.length))?;
    let (is, wanted) = (checksum(words), header.checksum);
    if is != wanted {
        return Err(Problem::Checksum { is, wanted });
    }
    Ok((header, &words[HEADER..]))
}

/// The CRC-32 that the header of these words should have.
pub(crate) fn checksum(words: &[u32]) -> u32 {
    crc32fast::hash(bytemuck::must_cast_slice(&words[UNCHECKED..]))
}

/// The lists that were not read yet.
pub(crate) struct Lists<'a>(pub &'a [u32]);

impl<'a> Lists<'a> {
    /// The next list.
    pub fn arrays<T: NoUninit + AnyBitPattern, const N: usize>(
        &mut self,
        count: u32,
    ) -> Result<&'a [[T; N]], Problem> {
        let bytes = (count as usize).checked_mul(size_of::<[T; N]>());
        let words = bytes.ok_or(Problem::Lists)?.div_ceil(4);
        let (list, rest) = self.0.split_at_checked(words).ok_or(Problem::Lists)?;
        self.0 = rest;
        let (arrays, _) = bytemuck::cast_slice(list).as_chunks();
        arrays.get(..count as usize).ok_or(Problem::Lists)
    }

    /// The next list of triples.
    pub fn triples<T: NoUninit + AnyBitPattern>(
        &mut self,
        count: u32,
    ) -> Result<&'a [[T; 3]], Problem> {
        self.arrays(count)
    }

    /// Nothing must follow.
    pub fn end(self) -> Result<(), Problem> {
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(Problem::Lists)
        }
    }
}
