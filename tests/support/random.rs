//! Random inputs. A test runs with many inputs, the same in each run. If an input fails, the test searches for a small
//! input that also fails.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::vec::Vec;
use std::{env, eprintln};

use rand::distr::uniform::SampleUniform;
use rand::rngs::SmallRng;
use rand::{Rng, RngCore, SeedableRng};

/// The value of `Random::length` with which a [`list`] can have every length in its range.
const WHOLE: usize = 32;

/// The generator of a test's inputs.
#[derive(Clone)]
pub struct Random {
    generator: SmallRng,
    /// The part of its range of lengths that a [`list`] uses, in units of 1/32 and from the lower end: 1 to [`WHOLE`].
    length: usize,
    has_made_lists: bool,
}

impl RngCore for Random {
    fn next_u32(&mut self) -> u32 {
        self.generator.next_u32()
    }

    fn next_u64(&mut self) -> u64 {
        self.generator.next_u64()
    }

    fn fill_bytes(&mut self, bytes: &mut [u8]) {
        self.generator.fill_bytes(bytes);
    }
}

/// The number of inputs for a test that takes seconds: an eighth of `all`. With the environment variable `FIXEL_ALL`,
/// which `.ci/nightly` sets, it is `all`.
#[allow(dead_code)] // the library's unit tests are quick
pub fn sampled(all: u32) -> u32 {
    if env::var_os("FIXEL_ALL").is_some() {
        all
    } else {
        all.div_ceil(8)
    }
}

/// Runs a test for `count` generators.
///
/// If the test panics, it runs again, first with short lists and then with longer ones, until it panics again. So the
/// input that is reported has few triangles. The last message names the seed of this input, and the length of its
/// lists. To run the test with this input again, set the environment variables `FIXEL_SEED` (the seed of the first
/// generator, by default 0) and `FIXEL_LENGTH` (the length of all lists, from 1 to 32). Another seed gives other
/// inputs.
pub fn cases(count: u32, mut test: impl FnMut(&mut Random)) {
    run(count, &mut test);
}

/// This function is not generic, so that it is compiled only once.
fn run(count: u32, test: &mut dyn FnMut(&mut Random)) {
    let variable = |name, without| {
        env::var(name).map_or(without, |text| text.parse().expect("a whole number"))
    };
    let (first, longest) = (
        variable("FIXEL_SEED", 0),
        variable("FIXEL_LENGTH", WHOLE as u64) as usize,
    );
    let seeds = (0..count).map(|case| u64::from(case).wrapping_add(first));
    let mut fails = |seed, length| {
        let mut random = Random {
            generator: SmallRng::seed_from_u64(seed),
            length,
            has_made_lists: false,
        };
        let result = catch_unwind(AssertUnwindSafe(|| test(&mut random)));
        (result.err(), random.has_made_lists)
    };
    for seed in seeds.clone() {
        let (Some(panic), has_made_lists) = fails(seed, longest) else {
            continue;
        };
        let shorter = if has_made_lists { 1..longest } else { 1..1 };
        for length in shorter {
            for seed in seeds.clone() {
                if let (Some(panic), _) = fails(seed, length) {
                    eprintln!("failed with FIXEL_SEED={seed} FIXEL_LENGTH={length}");
                    resume_unwind(panic);
                }
            }
        }
        eprintln!("failed with FIXEL_SEED={seed}");
        resume_unwind(panic);
    }
}

/// A number of any size. Each number of bits has the same probability.
pub fn number(random: &mut Random) -> i32 {
    random.random::<i32>() >> random.random_range(0..32)
}

/// Random numbers, one in each of these ranges.
pub fn within<T: SampleUniform + PartialOrd, const N: usize>(
    random: &mut Random,
    ranges: [Range<T>; N],
) -> [T; N] {
    ranges.map(|range| random.random_range(range))
}

/// A list of random items. The list's length is in the range `length`.
pub fn list<T>(
    random: &mut Random,
    length: Range<usize>,
    mut item: impl FnMut(&mut Random) -> T,
) -> Vec<T> {
    random.has_made_lists = true;
    let lengths = (length.len() * random.length).div_ceil(WHOLE);
    (0..random.random_range(length.start..length.start + lengths))
        .map(|_| item(random))
        .collect()
}
