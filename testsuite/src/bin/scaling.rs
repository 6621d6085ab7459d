//! Writes a chart of a given shape and size to standard output, to measure how long it takes to compile.
//!
//! ```text
//! cargo build --release
//! for n in 1000 10000 100000; do
//!   cargo run --release -q -p grafc-testsuite --bin scaling -- rings $n > /tmp/rings_$n.gct
//!   time target/release/grafc /tmp/rings_$n.gct --target st -o /tmp/rings_$n.st
//! done
//! ```
//!
//! Without arguments it lists the shapes.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use grafc_testsuite::scaling::SHAPES;
use std::process::ExitCode;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [name, size] = words.as_slice() else { return usage() };
    let shape = SHAPES.iter().find(|shape| shape.name == name);
    let size = size.parse::<usize>().ok().filter(|n| *n >= 2);
    let (Some(shape), Some(size)) = (shape, size) else { return usage() };
    print!("{}", (shape.write)(size));
    ExitCode::SUCCESS
}

fn usage() -> ExitCode {
    eprintln!("usage: scaling SHAPE N, with N from 2 on");
    for shape in &SHAPES {
        eprintln!("  {:8}  {}", shape.name, shape.meaning);
    }
    ExitCode::from(2)
}
