//! The target for libFuzzer, which cargo-fuzz builds: draw calls made from arbitrary bytes.
#![cfg_attr(fuzzing, no_main)]

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz::draw::check(bytes));

#[cfg(not(fuzzing))]
fn main() {
    println!("this program is for cargo-fuzz: .ci/fuzz");
}
