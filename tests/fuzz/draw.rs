//! Fuzz target: draw calls made from arbitrary bytes.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzzed::draw::check(bytes));
