//! Fuzz target: OBJ text made from arbitrary bytes.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzzed::obj::check(bytes));
