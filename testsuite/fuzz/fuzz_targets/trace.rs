//! See `grafc_testsuite::fuzzing::trace`.

#![no_main]

libfuzzer_sys::fuzz_target!(|text: &str| grafc_testsuite::fuzzing::trace(text));
