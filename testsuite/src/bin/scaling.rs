//! Writes a chart of a given size to standard output, to measure how long it takes to compile.
//!
//! ```text
//! cargo build --release
//! for n in 1000 10000 100000; do
//!   cargo run --release -q -p grafc-testsuite --bin scaling -- rings $n > /tmp/rings_$n.gct
//!   time target/release/grafc /tmp/rings_$n.gct --target st -o /tmp/rings_$n.st
//! done
//! ```
//!
//! `rings N`: parallel grafcets of ten steps each, N steps in all. `ring N`: one ring of N steps.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use grafc_testsuite::random::scaling::{ring, rings};
use std::process::ExitCode;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let size = words.get(1).and_then(|n| n.parse::<usize>().ok()).filter(|n| *n >= 2);
    match (words.first().map(String::as_str), size) {
        (Some("rings"), Some(steps)) => print!("{}", rings(steps)),
        (Some("ring"), Some(steps)) => print!("{}", ring(steps)),
        (_, _) => {
            eprintln!("usage: scaling rings|ring STEPS");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}
