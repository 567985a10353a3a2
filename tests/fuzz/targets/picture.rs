//! The target for libFuzzer, which cargo-fuzz builds: a picture file of arbitrary bytes.
#![cfg_attr(fuzzing, no_main)]

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz::import::picture(bytes));

#[cfg(not(fuzzing))]
fn main() {
    println!("this program is for cargo-fuzz: .ci/fuzz");
}
