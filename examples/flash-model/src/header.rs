//! The header of a model, and the lists that follow the header.

use core::ops::Range;

use bytemuck::{AnyBitPattern, NoUninit, Pod, Zeroable};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};

use crate::{Module, Problem};

/// The address of the model's first byte, 256 KiB after the first byte of flash. The firmware ends below this address:
/// examples/boards/build.rs tells the linker where the model begins.
pub const ADDRESS: u32 = 0x1004_0000;

/// The first word: "fixm".
pub(crate) const MAGIC: u32 = u32::from_le_bytes(*b"fixm");
/// The version of the format.
pub(crate) const VERSION: u32 = 4;
/// The number of words at the start of a model that the checksum leaves out. The last of these words is the checksum.
const UNCHECKED: usize = 4;
/// In place of a texture's index, this number says that a part has no texture.
pub(crate) const NO_TEXTURE: u32 = u32::MAX;

/// The bit of a part's finish that says that its faces are seen from behind, too.
pub(crate) const TWO_SIDED: u32 = 1;
/// The bit of a part's finish that says that its surface has its own colors in every light.
pub(crate) const UNLIT: u32 = 2;
/// The bit of a part's finish that says that texels with the color [`HOLE`] are holes.
pub(crate) const HOLES: u32 = 4;

/// The color of the texels that are holes, in textures that have holes.
pub const HOLE: Rgb565 = Rgb565::MAGENTA;

/// A part of a model: its first face, the face after its last, its color as 0xRRGGBB, the index of its texture, or
/// 0xFFFFFFFF if it has no texture, the light that it sends out as 0xRRGGBB, and the bits of its finish: 1 for faces
/// that are seen from behind, 2 for a surface without light, 4 for a texture with holes.
pub type PartRecord = [u32; 6];
/// A texture: its width and height in texels, and the index of its first texel.
pub type TextureRecord = [u32; 3];

/// The first words of a model.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct Header {
    /// "fixm".
    pub magic: u32,
    /// The version of the format.
    pub version: u32,
    /// The length of the whole model, that is, of the header and the lists, in bytes.
    pub length: u32,
    /// The CRC-32 of all words of the model after this word.
    pub checksum: u32,
    /// The module that shows the model.
    pub module: Module,
    /// The number of fraction bits of a position's coordinates.
    pub fraction: u32,
    /// The least u and the least v of the model, then the greatest u and the greatest v, in units of 2^-20.
    pub uv_corners: [[i32; 2]; 2],
    /// The number of positions.
    pub positions: u32,
    /// The number of faces.
    pub faces: u32,
    /// The number of normals.
    pub normals: u32,
    /// The number of faces of normals.
    pub normal_faces: u32,
    /// The number of texture coordinates.
    pub uvs: u32,
    /// The number of faces of texture coordinates.
    pub uv_faces: u32,
    /// The number of colors.
    pub colors: u32,
    /// The number of faces of colors.
    pub color_faces: u32,
    /// The number of parts.
    pub parts: u32,
    /// The number of textures.
    pub textures: u32,
    /// The number of texels of all textures.
    pub texels: u32,
}

/// The number of words of a header.
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
    /// The addresses of the model's flash: from the end of the firmware's 256 KiB to the end of flash.
    #[must_use]
    pub const fn flash(self) -> Range<u32> {
        match self {
            Self::Pico => ADDRESS..0x1020_0000,
            Self::Pico2 => ADDRESS..0x1040_0000,
        }
    }

    /// The number of words of 32 bits that fit into the model's flash.
    #[must_use]
    pub const fn words(self) -> usize {
        let Range { start, end } = self.flash();
        (end - start) as usize / 4
    }
}

impl Module {
    /// Returns the module that the model's header names, even if the rest of the model is damaged. If the words do not
    /// begin with a header, or no program can use the module, returns the ST7789.
    #[must_use]
    pub fn wanted(words: &[u32]) -> Self {
        let header = words.first_chunk::<HEADER>();
        header
            .map(bytemuck::must_cast_ref::<_, Header>)
            .filter(|header| header.magic == MAGIC && header.version == VERSION)
            .map(|header| header.module)
            .filter(|module| module.check().is_ok())
            .unwrap_or_default()
    }
}

/// Checks the first word, the version, the length and the checksum of a model. Returns its header, and the words of its
/// lists.
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

/// Computes the checksum that belongs into the header of these words.
pub(crate) fn checksum(words: &[u32]) -> u32 {
    crc32fast::hash(bytemuck::must_cast_slice(&words[UNCHECKED..]))
}

/// The words of the lists that have not been read yet.
pub(crate) struct Lists<'a>(pub &'a [u32]);

impl<'a> Lists<'a> {
    /// Reads the next list, which has `count` elements.
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

    /// Reads the next list, which has `count` triples.
    pub fn triples<T: NoUninit + AnyBitPattern>(
        &mut self,
        count: u32,
    ) -> Result<&'a [[T; 3]], Problem> {
        self.arrays(count)
    }

    /// Checks that no words follow the last list.
    pub fn end(self) -> Result<(), Problem> {
        if self.0.is_empty() {
            Ok(())
        } else {
            Err(Problem::Lists)
        }
    }
}
