//! Writes and reads UF2, the format of files that are copied onto the USB drive of a Pico or a Pico 2. A file consists
//! of blocks of 512 bytes. Each block carries 256 bytes of data, and their address in flash.

use std::ops::Range;

use elf::abi::PT_LOAD;
use elf::endian::LittleEndian;
use elf::{ElfBytes, ParseError};

use crate::Board;

/// The address of the first byte of flash, which is the first byte of the firmware.
const FLASH: u32 = 0x1000_0000;
/// The address of the model.
const MODEL: u32 = crate::ADDRESS;
/// The number of bytes of flash that are erased together. A Pico's boot loader needs data for all of these bytes
/// (RP2040-E14 in its data sheet).
const SECTOR: usize = 4096;
/// The number of bytes of data that a block carries.
const PAYLOAD: usize = 256;
const BLOCK: usize = 512;

const START: [u32; 2] = [0x0a32_4655, 0x9e5d_5157];
const END: u32 = 0x0ab1_6f30;
/// The flag that says that a block has the number of a family of chips.
const HAS_FAMILY: u32 = 0x2000;

/// An RP2350 starts a program only if it finds these words in the first 4 KiB of flash: the first word begins a block,
/// and the second word, the block's first item, says that the program is for the chip's Arm cores in the secure state.
const RP2350_BLOCK: [u32; 2] = [0xffff_ded3, 0x1021_0142];

impl Board {
    /// The number of the board's family of chips in a UF2 file. The board's drive refuses files with another number.
    ///
    /// If the flash of an RP2350 is divided by a partition table, its boot loader also needs a block of the family
    /// "absolute" (RP2350-E10 in its data sheet). A new Pico 2 has no such table.
    const fn family(self) -> u32 {
        match self {
            Self::Pico => 0xe48b_ff56,
            Self::Pico2 => 0xe48b_ff59,
        }
    }

    /// Returns the board of a program. `image` is what the program puts into flash.
    fn of(image: &[u8]) -> Self {
        let start = &image[..image.len().min(4096)];
        let words: Vec<u32> = start
            .as_chunks()
            .0
            .iter()
            .copied()
            .map(u32::from_le_bytes)
            .collect();
        let is_rp2350 = words.windows(2).any(|words| words == RP2350_BLOCK);
        if is_rp2350 { Self::Pico2 } else { Self::Pico }
    }
}

/// Returns the board of the firmware, which is an ELF file or a UF2 file.
///
/// # Errors
///
/// As for [`uf2`].
pub fn board(firmware: &[u8]) -> Result<Board, String> {
    Ok(Board::of(&image(firmware, MODEL)?))
}

/// Makes a UF2 file from the firmware and the words of a model. The firmware is an ELF file or a UF2 file. If that UF2
/// file contains a model, it is left out. Without a model, all of a Pico's flash is the firmware's.
///
/// # Errors
///
/// The firmware is neither an ELF file nor a UF2 file, or does not lie in flash below the model.
pub fn uf2(firmware: &[u8], model: &[u32]) -> Result<Vec<u8>, String> {
    let end = if model.is_empty() {
        Board::Pico.flash().end
    } else {
        MODEL
    };
    let firmware = image(firmware, end)?;
    let family = Board::of(&firmware).family();
    let model: Vec<u8> = model.iter().flat_map(|word| word.to_le_bytes()).collect();
    let mut pages: Vec<(u32, [u8; PAYLOAD])> = Vec::new();
    for (start, bytes) in [(FLASH, firmware), (MODEL, model)] {
        let mut bytes = bytes;
        bytes.resize(bytes.len().next_multiple_of(SECTOR), 0xff);
        let pages_of = bytes.as_chunks().0.iter().copied();
        pages.extend((start..).step_by(PAYLOAD).zip(pages_of));
    }
    let count = u32::try_from(pages.len()).unwrap_or(u32::MAX);
    let blocks = (0..).zip(&pages).flat_map(|(number, (address, page))| {
        let [first, second] = START;
        let head = [
            first, second, HAS_FAMILY, *address, 256, number, count, family,
        ];
        let mut block: Vec<u8> = head.iter().flat_map(|word| word.to_le_bytes()).collect();
        block.extend(page);
        block.resize(BLOCK - 4, 0);
        block.extend(END.to_le_bytes());
        block
    });
    Ok(blocks.collect())
}

/// Returns the bytes that an ELF file, or a UF2 file below the model, puts into flash below `end`, beginning with the
/// first byte of flash.
fn image(file: &[u8], end_of_flash: u32) -> Result<Vec<u8>, String> {
    if file.starts_with(&START[0].to_le_bytes()) {
        let mut image = region(file, FLASH..MODEL);
        let last = image.iter().rposition(|&byte| byte != 0xff);
        image.truncate(last.ok_or("firmware: the UF2 has none")? + 1);
        return Ok(image);
    }
    let say = |problem: ParseError| format!("firmware: {problem}");
    let file = ElfBytes::<LittleEndian>::minimal_parse(file).map_err(say)?;
    let mut image = Vec::new();
    let segments = file.segments().ok_or("firmware: it has no segments")?;
    for segment in segments
        .iter()
        .filter(|segment| segment.p_type == PT_LOAD && segment.p_filesz > 0)
    {
        let bytes = file.segment_data(&segment).map_err(say)?;
        let start = segment.p_paddr.checked_sub(FLASH.into());
        let end = start.and_then(|start| start.checked_add(segment.p_filesz));
        let room = u64::from(end_of_flash - FLASH);
        let (Some(start), Some(end)) = (start, end.filter(|&end| end <= room)) else {
            let address = segment.p_paddr;
            return Err(format!(
                "firmware: {} bytes at {address:#x} are outside its flash",
                bytes.len()
            ));
        };
        // Both numbers are at most 2 MiB, so they fit into a `usize`.
        let [start, end] = [start, end].map(|at| usize::try_from(at).unwrap_or(0));
        image.resize(image.len().max(end), 0xff);
        image[start..end].copy_from_slice(bytes);
    }
    Ok(image)
}

/// Returns the bytes that a UF2 file has for these addresses. Where the file has none, the byte is 0xff, as in erased
/// flash.
#[must_use]
pub fn region(uf2: &[u8], addresses: Range<u32>) -> Vec<u8> {
    let mut bytes = vec![0xff; addresses.len()];
    for block in uf2.as_chunks::<BLOCK>().0 {
        let word = |at: usize| {
            let word = block[at..].first_chunk().copied();
            word.map_or(0, u32::from_le_bytes)
        };
        for (address, &byte) in (word(12)..).zip(&block[32..32 + PAYLOAD]) {
            let at = address.checked_sub(addresses.start);
            if let Some(to) = at.and_then(|at| bytes.get_mut(at as usize)) {
                *to = byte;
            }
        }
    }
    bytes
}
