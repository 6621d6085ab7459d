//! Mutates charts and checks what must hold for every text.
//!
//! ```text
//! cargo run --release -p grafc-syntax --example fuzz -- --seconds 60 [--seed 7]
//! ```
//!
//! It needs no nightly compiler. A text that breaks a rule is written to `fuzz-failure.gct` in the directory for
//! temporary files, and the run ends with a panic that says which rule.

#![allow(clippy::print_stdout)]

#[path = "../tests/common/mod.rs"]
mod common;

use std::path::Path;
use std::time::{Duration, Instant};

/// Pieces of the language, and of what is not quite the language.
const WORDS: &[&str] = &[
    "chart",
    "input",
    "output",
    "var",
    "const",
    "grafcet",
    "expansion",
    "step",
    "transition",
    "initial",
    "activated",
    "enclosing",
    "macro",
    "if",
    "on",
    "on activation",
    "on deactivation",
    "on event",
    "force",
    "true",
    "false",
    "and",
    "·",
    "&",
    "or",
    "|",
    "xor",
    "not",
    "!",
    "¬",
    "rise",
    "↑",
    "fall",
    "↓",
    "mod",
    "+",
    "-",
    "*",
    "/",
    "=",
    "<>",
    "≠",
    "<",
    "<=",
    "≤",
    ">",
    ">=",
    "≥",
    ":=",
    ":",
    ",",
    "->",
    "→",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "{*}",
    "{INIT}",
    "{}",
    "a",
    "X1",
    "T1",
    "Größe",
    "клапан",
    "`on`",
    "`2s/X202`",
    "``",
    "`",
    "\"text\"",
    "\"say \"\"go\"\"\"",
    "\"",
    "1",
    "0",
    "42",
    "16#FF",
    "2#102",
    "8.5",
    "1.5e-3",
    "1_000",
    "1__0",
    "3s",
    "500ms",
    "1min30s",
    "0.5ms",
    "T#1m30s",
    "TIME#2h",
    "T#",
    "3x",
    "%IX0.0",
    "at %QX1.2",
    "at",
    ": bool",
    ": time := 3s",
    "// c\n",
    "(* c *)",
    "(* a (* b *) c *)",
    "(*",
    "*)",
    "\n",
    "\r\n",
    "\n\n\n",
    " ",
    "\u{FEFF}",
    "\u{200B}",
    "$",
    ";",
    "…",
    "activation",
    "event",
    "INIT",
    "3s/a/7s",
    "[C < 3]",
    "\n// c\n",
    "\n(* d\n e *)\n",
];

const SEEDS: &[&str] = &[
    include_str!("../tests/samples/every_construct.gct"),
    "transition 1 -> 2 : ↑(a + b) · not 3s/X1/5s xor [C + 1 <= -2 * (D mod 3)] or rise [a]",
    "grafcet X9/G4 \"e\" { initial activated step 1 { A if 3s/a  C := C + 1 on event ↓b  force G1{1, 2} } }",
    "expansion M3 { step E3 transition E3 -> S3 : 1 step S3 }",
    "var a \"x\", b : real := -8.5 at %MD0 const t : time := T#1d2h3m4s5ms",
    "",
];

fn main() {
    let mut seconds = 60;
    let mut seed = None;
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let value = arguments.next().and_then(|v| v.parse().ok());
        match (argument.as_str(), value) {
            ("--seconds", Some(value)) => seconds = value,
            ("--seed", Some(value)) => seed = Some(value),
            _ => {
                println!("usage: fuzz [--seconds N] [--seed N]");
                std::process::exit(2);
            }
        }
    }
    let seed = seed.unwrap_or_else(|| fastrand::u64(..));
    let mut random = fastrand::Rng::with_seed(seed);
    let mut seeds: Vec<String> = SEEDS.iter().map(|s| (*s).to_owned()).collect();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../testsuite"), &mut seeds);
    println!("seed {seed}, {} charts", seeds.len());

    let (mut runs, mut valid) = (0u64, 0u64);
    let end = Instant::now() + Duration::from_secs(seconds);
    let mut slowest = Duration::ZERO;
    while Instant::now() < end {
        let text = mutate(&mut random, &seeds);
        let start = Instant::now();
        let result = std::panic::catch_unwind(|| common::check(&text));
        slowest = slowest.max(start.elapsed());
        match result {
            Ok(sound) => valid += u64::from(sound),
            Err(panic) => {
                let path = std::env::temp_dir().join("fuzz-failure.gct");
                let written = std::fs::write(&path, &text);
                println!("after {runs} runs: {} ({written:?})", path.display());
                std::panic::resume_unwind(panic);
            }
        }
        runs += 1;
    }
    println!("{runs} runs, {valid} of them without faults, no finding; the slowest took {slowest:?}");
}

/// All charts below a folder.
fn collect(folder: &Path, seeds: &mut Vec<String>) {
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        let Ok(entries) = std::fs::read_dir(&folder) else { continue };
        for path in entries.flatten().map(|e| e.path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "gct") {
                seeds.extend(std::fs::read_to_string(&path));
            }
        }
    }
    seeds.sort();
}

fn mutate(random: &mut fastrand::Rng, seeds: &[String]) -> String {
    let pick = |random: &mut fastrand::Rng| seeds[random.usize(..seeds.len())].as_str();
    if random.u8(..) < 8 {
        let bytes: Vec<u8> = (0..random.usize(..200)).map(|_| random.u8(..)).collect();
        return String::from_utf8_lossy(&bytes).into_owned();
    }
    if random.u8(..) < 8 {
        let words = random.usize(..80);
        return (0..words).map(|_| WORDS[random.usize(..WORDS.len())]).collect::<Vec<_>>().join(" ");
    }
    let mut text = pick(random).to_owned();
    for _ in 0..random.usize(1..6) {
        let (from, to) = (place(random, &text), place(random, &text));
        let (from, to) = (from.min(to), from.max(to));
        let short = floor(&text, to.min(from + random.usize(..12)));
        match random.u8(..10) {
            0 => text.replace_range(from..short, ""),
            1 => text.replace_range(from..to, ""),
            2 => text.insert_str(from, WORDS[random.usize(..WORDS.len())]),
            3 => text.insert_str(blank(&text, from), &format!(" {} ", WORDS[random.usize(..WORDS.len())])),
            4 => text.replace_range(from..short, WORDS[random.usize(..WORDS.len())]),
            5 => {
                let piece = text[from..short].to_owned();
                text.insert_str(to, &piece);
            }
            6 => {
                let other = pick(random);
                let (a, b) = (place(random, other), place(random, other));
                text.insert_str(from, &other[a.min(b)..a.max(b)]);
            }
            7 => text.insert(from, char::from_u32(random.u32(..0x3000)).unwrap_or('\u{FFFD}')),
            // Comments and line ends between tokens keep a chart valid: this is what the formatter has to bear.
            _ => {
                const BETWEEN: [&str; 8] = [
                    " // c\n",
                    "\n// own\n",
                    " (* c *) ",
                    "\n(* own *)\n",
                    " (* two\n lines *) ",
                    "\n",
                    "\n\n\n",
                    "\r\n",
                ];
                text.insert_str(blank(&text, from), BETWEEN[random.usize(..BETWEEN.len())]);
            }
        }
        if text.len() > 20_000 {
            text.truncate(floor(&text, 20_000));
        }
    }
    text
}

/// A place between two characters.
fn place(random: &mut fastrand::Rng, text: &str) -> usize {
    floor(text, random.usize(..=text.len()))
}

fn floor(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// The next blank, where a word can stand alone.
fn blank(text: &str, from: usize) -> usize {
    text[from..].find([' ', '\n']).map_or(text.len(), |n| from + n)
}
