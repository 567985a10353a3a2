//! Random inputs: a test runs for many of them, the same ones each time.

use std::ops::Range;
use std::vec::Vec;
use std::{env, eprintln};

use rand::distr::uniform::{SampleRange, SampleUniform};
use rand::{Rng, SeedableRng};

/// The generator of the inputs.
pub type Random = rand::rngs::SmallRng;

/// Runs a test for `count` generators. If it panics, a message names the generator's seed.
///
/// The environment variable `FIXEL_SEED` is the seed of the first generator, 0 without it: another one gives other
/// inputs, and the one that a message names repeats that failure at once.
pub fn cases(count: u64, mut test: impl FnMut(&mut Random)) {
    run(count, &mut test);
}

/// Not generic, so that it is compiled once.
fn run(count: u64, test: &mut dyn FnMut(&mut Random)) {
    let first = env::var("FIXEL_SEED").map_or(0, |seed| seed.parse().expect("FIXEL_SEED is a u64"));
    for seed in (0..count).map(|case| case.wrapping_add(first)) {
        let _named = Named(seed);
        test(&mut Random::seed_from_u64(seed));
    }
}

/// Names a seed while a panic unwinds.
struct Named(u64);

impl Drop for Named {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("failed with FIXEL_SEED={}", self.0);
        }
    }
}

/// A number of any size: each count of bits has the same chance.
pub fn number(random: &mut Random) -> i32 {
    random.random::<i32>() >> random.random_range(0..32)
}

/// A number in each of these ranges.
pub fn within<T: SampleUniform + PartialOrd, const N: usize>(
    random: &mut Random,
    ranges: [Range<T>; N],
) -> [T; N] {
    ranges.map(|range| random.random_range(range))
}

/// A list of random items, whose length is in a range.
pub fn list<T>(
    random: &mut Random,
    length: impl SampleRange<usize>,
    mut item: impl FnMut(&mut Random) -> T,
) -> Vec<T> {
    (0..random.random_range(length))
        .map(|_| item(random))
        .collect()
}
