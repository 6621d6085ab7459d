//! Any text is parsed: spans lie in it, and formatting what has no errors keeps its meaning.

#![no_main]

#[path = "../../../compiler/syntax/tests/common/mod.rs"]
mod common;

libfuzzer_sys::fuzz_target!(|text: &str| {
    common::check(text);
});
