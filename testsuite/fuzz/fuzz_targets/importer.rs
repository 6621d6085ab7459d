//! See `grafc_testsuite::fuzzing::importer`.

#![no_main]

libfuzzer_sys::fuzz_target!(|text: &str| grafc_testsuite::fuzzing::importer(text));
