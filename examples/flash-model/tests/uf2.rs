//! A UF2 holds a firmware and a model for the board that the firmware is for.

use flash_model::{ADDRESS, Board, board, region, uf2};

/// Words that stand for a model: a UF2 takes any words.
const MODEL: [u32; 1500] = {
    let mut words = [0; 1500];
    let mut at = 0;
    while at < words.len() {
        words[at] = 0x0101_0101 * (at as u32 % 251);
        at += 1;
    }
    words
};

/// An ELF file with these bytes in two segments.
fn elf(address: u32, bytes: &[u8]) -> Vec<u8> {
    let mut file = b"\x7fELF\x01\x01\x01".to_vec();
    file.resize(16, 0);
    let mut put = |words: &[u32]| file.extend(words.iter().flat_map(|word| word.to_le_bytes()));
    // An Arm program. Its header has 52 bytes, and two more of 32 bytes each follow.
    put(&[
        0x0028_0002,
        1,
        address,
        52,
        0,
        0,
        0x0020_0034,
        0x0028_0002,
        0,
    ]);
    let (all, half) = (bytes.len() as u32, bytes.len() as u32 / 2);
    for (from, to) in [(0, half), (half, all)] {
        // Load, from the file's bytes, for RAM, in flash.
        put(&[
            1,
            116 + from,
            0x2000_0000 + from,
            address + from,
            to - from,
            to - from,
            4,
            1,
        ]);
    }
    file.extend(bytes);
    file
}

#[test]
fn firmware_must_lie_below_the_model() {
    let wrong = |firmware: &[u8], message: &str| {
        let error = uf2(firmware, &MODEL).unwrap_err();
        assert!(error.contains(message), "{error}");
    };
    assert!(uf2(&elf(0x1003_fff8, &[0; 8]), &MODEL).is_ok());
    wrong(
        &elf(0x1003_fff8, &[0; 10]),
        "firmware: 5 bytes at 0x1003fffd are outside its flash",
    );
    wrong(
        &elf(0x0fff_fff0, &[0; 8]),
        "4 bytes at 0xffffff0 are outside",
    );
    wrong(b"no firmware", "firmware: ");
}

#[test]
fn a_uf2_holds_firmware_and_model() {
    let firmware: Vec<u8> = (0..10_000_u32)
        .map(|at| (at * 7).to_le_bytes()[0])
        .collect();
    let file = uf2(&elf(0x1000_0000, &firmware), &MODEL).unwrap();
    let (blocks, rest) = file.as_chunks::<512>();
    assert!(rest.is_empty());
    let sectors = |bytes: usize| bytes.div_ceil(4096) * 16;
    assert_eq!(
        blocks.len(),
        sectors(firmware.len()) + sectors(4 * MODEL.len())
    );
    for (number, block) in blocks.iter().enumerate() {
        let word = |at: usize| u32::from_le_bytes(block[4 * at..][..4].try_into().unwrap());
        assert_eq!(
            [word(0), word(1), word(127)],
            [0x0a32_4655, 0x9e5d_5157, 0x0ab1_6f30]
        );
        assert_eq!([word(2), word(4), word(7)], [0x2000, 256, 0xe48b_ff56]);
        assert_eq!([word(5) as usize, word(6) as usize], [number, blocks.len()]);
        assert_eq!(word(3) % 256, 0);
    }
    assert!(region(&file, 0x1000_0000..0x1000_2710) == firmware);
    let bytes: Vec<u8> = MODEL.iter().flat_map(|word| word.to_le_bytes()).collect();
    assert!(region(&file, ADDRESS..ADDRESS + 4 * 1500) == bytes);
    // All other flash stays erased.
    let rest = region(&file, 0x1000_2710..ADDRESS);
    assert!(rest.iter().all(|&byte| byte == 0xff));
    // The model in a UF2 can be replaced.
    let other = [1, 2, 3];
    assert!(uf2(&file, &other) == uf2(&elf(0x1000_0000, &firmware), &other));
    let model = &file[512 * sectors(firmware.len())..];
    assert_eq!(uf2(model, &[]), Err("firmware: the UF2 has none".into()));
}

#[test]
fn a_uf2_is_for_the_chip_that_starts_its_firmware() {
    // The chip looks for the block in the first 4 KiB. Its second word says which processors the program is for.
    let block = |image_type: u32| [0xffff_ded3, image_type, 0x1ff, 0, 0xab12_3579];
    let arm = 0x1021_0142;
    for (at, image_type, wanted, family) in [
        (0x114, arm, Board::Pico2, 0xe48b_ff59_u32),
        (4088, arm, Board::Pico2, 0xe48b_ff59),
        (4092, arm, Board::Pico, 0xe48b_ff56),
        (0x114, 0x1001_0142, Board::Pico, 0xe48b_ff56),
    ] {
        let mut firmware = vec![0; 8192];
        let bytes: Vec<u8> = block(image_type)
            .iter()
            .flat_map(|word| word.to_le_bytes())
            .collect();
        firmware[at..at + bytes.len()].copy_from_slice(&bytes);
        let firmware = elf(0x1000_0000, &firmware);
        assert_eq!(board(&firmware).unwrap(), wanted, "{at} {image_type:#x}");
        let file = uf2(&firmware, &MODEL).unwrap();
        for block in file.as_chunks::<512>().0 {
            assert_eq!(block[28..32], family.to_le_bytes(), "{at} {image_type:#x}");
        }
    }
}
