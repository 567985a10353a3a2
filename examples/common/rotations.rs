//! Rotations of every kind. Their bits must be the same on every core.

use fixel::prelude::*;

/// The checksum of [`entries`]: the CRC-32 of all entries, each with its low byte first.
pub const CRC: u32 = 0xcc2e_e873;

/// The number of rotations of each kind.
const COUNT: u32 = 400;

/// A vector of this length, in units of 2^-16, shows every bit of a rotation matrix.
const LONG: i32 = 1 << 30;

/// The entries of many rotation matrices, column by column, in units of 2^-30.
pub fn entries() -> impl Iterator<Item = i32> {
    let mut state = 1_u64;
    // The linear congruential generator of Knuth's MMIX. Small numbers are as frequent as large ones.
    let mut random = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 32) as i32 >> (state >> 27 & 31)
    };
    (0..COUNT)
        .flat_map(move |_| {
            let parts = [(); 4].map(|()| random());
            let [x, y, z, turn] = parts;
            let [a, b, c] = [turn, x, y].map(|bits| Angle::from_bits(bits.cast_unsigned()));
            let turned = Transform::from_euler(a, b, c);
            [
                Some(turned),
                Some(turned.renormalized()),
                // An axis or a quaternion of length zero makes no rotation.
                Transform::rotate(Vec3::from_bits([x, y, z]), a).ok(),
                Transform::from_quaternion(parts.map(Scalar::from_bits)).ok(),
            ]
        })
        .flatten()
        .flat_map(|rotation| {
            [[LONG, 0, 0], [0, LONG, 0], [0, 0, LONG]]
                .map(|axis| rotation.direction(Vec3::from_bits(axis)).to_bits())
        })
        .flatten()
}
