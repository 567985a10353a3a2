//! UF2: the file that a Pico's drive takes. Its blocks of 512 bytes each carry 256 bytes and their address.

use std::ops::Range;

/// Where flash begins, and with it the firmware.
const FLASH: u32 = 0x1000_0000;
/// The bytes that are erased together. A Pico's boot loader wants to get all of them (RP2040-E14 in its data sheet).
const SECTOR: usize = 4096;
/// The bytes of a block.
const PAYLOAD: usize = 256;
const BLOCK: usize = 512;

const START: [u32; 2] = [0x0a32_4655, 0x9e5d_5157];
const END: u32 = 0x0ab1_6f30;
/// The family's number is in the block.
const HAS_FAMILY: u32 = 0x2000;
const RP2040: u32 = 0xe48b_ff56;

/// A UF2 of the firmware, from the start of flash on, and the words of a model.
#[must_use]
pub fn uf2(firmware: &[u8], model: &[u32]) -> Vec<u8> {
    let model: Vec<u8> = model.iter().flat_map(|word| word.to_le_bytes()).collect();
    let mut pages: Vec<(u32, [u8; PAYLOAD])> = Vec::new();
    for (start, bytes) in [(FLASH, firmware), (crate::ADDRESS, &model)] {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(SECTOR), 0xff);
        let pages_of = bytes.as_chunks().0.iter().copied();
        pages.extend((start..).step_by(PAYLOAD).zip(pages_of));
    }
    let count = u32::try_from(pages.len()).unwrap_or(u32::MAX);
    let blocks = (0..).zip(&pages).flat_map(|(number, (address, page))| {
        let [first, second] = START;
        let head = [
            first, second, HAS_FAMILY, *address, 256, number, count, RP2040,
        ];
        let mut block: Vec<u8> = head.iter().flat_map(|word| word.to_le_bytes()).collect();
        block.extend(page);
        block.resize(BLOCK - 4, 0);
        block.extend(END.to_le_bytes());
        block
    });
    blocks.collect()
}

/// The bytes that a UF2 has at addresses; 0xff where it has none, as erased flash.
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
