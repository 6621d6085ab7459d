//! See `grafc_testsuite::fuzzing::pipeline`.

#![no_main]

libfuzzer_sys::fuzz_target!(|text: &str| grafc_testsuite::fuzzing::pipeline(text));
