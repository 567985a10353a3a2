//! The bits of rotations. The firmware checks the same checksum on every core.

use crate::examples::rotations::{CRC, entries};

#[test]
fn checksum_of_rotations() {
    let mut sum = crc32fast::Hasher::new();
    let mut count = 0;
    for entry in entries() {
        sum.update(&entry.to_le_bytes());
        count += 1;
    }
    let sum = sum.finalize();
    assert!(count > 14_000, "{count} entries");
    assert_eq!(sum, CRC, "{sum:#010x}");
}
