//! No text makes the parser panic, overflow the stack or take more than linear time.

mod common;

use common::check;
use grafc_diagnostics::FileId;
use std::time::{Duration, Instant};

/// Parses, formats, clones and drops, on a thread whose stack no recursion over the text would fit in. (Without
/// optimisation the generated lexer alone takes half of it, in a single frame.)
fn survives(text: String, sound: bool) {
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(move || {
        let (chart, diagnostics) = grafc_syntax::parse(FileId::new(0), &text);
        assert_eq!(!diagnostics.has_errors(), sound, "{:?}", diagnostics.iter().next());
        drop(chart.clone());
        if sound {
            let formatted = grafc_syntax::format(&text, &chart);
            let (again, _) = grafc_syntax::parse(FileId::new(0), &formatted);
            assert!(grafc_syntax::same(&chart, &again));
        }
    });
    thread.expect("a thread can be made").join().expect("no panic");
}

#[test]
fn depth_does_not_matter() {
    for depth in [10_000, 200_000] {
        let open = |o: &str| o.repeat(depth);
        survives(format!("transition 1 -> 2 : {}a{}", open("("), open(")")), true);
        survives(format!("transition 1 -> 2 : {}a", open("not ")), true);
        survives(format!("transition 1 -> 2 : {}a{}", open("↑("), open(")")), true);
        survives(format!("transition 1 -> 2 : [{}a{}]", open("["), open("]")), true);
        survives(format!("transition 1 -> 2 : {}a{}", open("3s/("), open(")")), true);
        survives(format!("var v : int := {}1", open("-")), true);
        survives(format!("transition 1 -> 2 : {}", open("(")), false);
        survives(format!("transition 1 -> 2 : a{}", open(")")), false);
        survives(format!("transition 1 -> 2 : {}", open("not ")), false);
        survives(format!("step 1 {}", open("{")), false);
        survives(open("}"), false);
        survives(open("grafcet G {"), false);
        survives(open("expansion M { step 1 ") + &open("}"), false);
        survives(open("(*"), false);
        survives(open("(*") + &open("*)"), true);
    }
}

#[test]
fn length_does_not_matter() {
    let n = 100_000;
    survives(format!("transition 1 -> 2 : a{}", " or a".repeat(n)), true);
    survives(format!("transition 1 -> 2 : a{}", " and a".repeat(n)), true);
    survives(format!("var v : int := 1{}", " + 1".repeat(n)), true);
    survives(format!("transition 1{} -> 2 : a", ", 1".repeat(n)), true);
    survives(format!("step 1 {{{}}}", " A".repeat(n)), true);
    survives("step 1 { A } ".repeat(n), true);
    survives(format!("transition 1 -> 2 : a {} or b", "(* c *)".repeat(n)), true);
    survives(format!("transition 1 -> 2 : a {} or b", "// c\n".repeat(n)), true);
    survives(format!("step 1 {{ {} A }}", "// c\n".repeat(n)), true);
    survives("initial ".repeat(n), false);
    survives("step 1 { C := 1 } ".repeat(n), false);
    survives(format!("step 1 {{ {} }}", "C := 1 ".repeat(n)), false);
}

#[test]
fn nested_expansions_have_a_limit() {
    let nested = |n: usize| "expansion M { ".repeat(n) + &"} ".repeat(n);
    assert!(check(&nested(64)));
    assert_eq!(common::faults(&nested(65)), ["E0107 1:909 blocks are nested deeper than 64 levels"]);
}

#[test]
fn one_long_token() {
    survives(format!("step {}", "a".repeat(10 << 20)), true);
    let n = 1 << 20;
    survives("a".repeat(n), false);
    survives(format!("step {}", "1".repeat(n)), true);
    survives(format!("var v : int := {}", "1".repeat(n)), false);
    survives(format!("var v : real := 0.{}", "1".repeat(n)), true);
    survives(format!("var v : time := 0.{}s", "1".repeat(n)), false);
    survives(format!("var v : time := {}", "1s".repeat(n / 2)), false);
    survives(format!("step 1 \"{}", "a".repeat(n)), false);
    survives(format!("step 1 \"{}\"", "\"\"".repeat(n / 2)), true);
    survives(format!("step `{}", "a".repeat(n)), false);
    survives("$".repeat(n), false);
    survives("€".repeat(n / 3), false);
    survives("\"".repeat(n), false);
    survives("`".repeat(n), false);
    survives("%".repeat(n), false);
    survives("/".repeat(n), true);
    survives(" ".repeat(n), true);
    survives(format!("(*{}", "a".repeat(n)), false);
}

/// Twice the text may take twice the time, with much room for a busy machine, but not four times.
#[test]
fn time_is_linear() {
    for (open, piece, close) in [
        ("", "step 1 { A if b and c }\n", ""),
        ("", "step 1 { A if b and }\n", ""),
        ("transition 1 -> 2 : a", " or a", ""),
        ("transition 1 -> 2 : ", "(", ""),
        ("", "(* ", ""),
        ("", "\"a\n", ""),
        ("", "`a\n", ""),
        ("", "1e+", ""),
        ("", "T#", ""),
        ("", "grafcet G { ", ""),
        ("", "$", ""),
        ("", "$ ", ""),
        ("step 1 { ", "// c\n", "A }"),
    ] {
        let time = |n: usize| {
            let text = format!("{open}{}{close}", piece.repeat(n));
            let one = || {
                let start = Instant::now();
                let (chart, diagnostics) = grafc_syntax::parse(FileId::new(0), &text);
                if !diagnostics.has_errors() {
                    grafc_syntax::format(&text, &chart);
                }
                start.elapsed()
            };
            (0..3).map(|_| one()).min().unwrap_or_default()
        };
        let (short, long) = (time(5_000), time(40_000));
        let bound = short * 8 * 4 + Duration::from_millis(50);
        assert!(long < bound, "{open}{piece}…: 5000 took {short:?}, 40000 took {long:?}");
    }
}

#[test]
fn random_token_soups() {
    const WORDS: &[&str] = &[
        "chart",
        "input",
        "var",
        "grafcet",
        "expansion",
        "step",
        "transition",
        "initial",
        "macro",
        "if",
        "on",
        "force",
        "and",
        "+",
        "not",
        "↑",
        "-",
        "*",
        "/",
        "=",
        ":=",
        ":",
        ",",
        "->",
        "(",
        ")",
        "[",
        "]",
        "{",
        "}",
        "a",
        "G1",
        "`on`",
        "\"t\"",
        "1",
        "16#FF",
        "8.5",
        "3s",
        "T#1s",
        "%IX0.0",
        "at",
        "bool",
        "// c\n",
        "(* c *)",
        "(*",
        "\"",
        "`",
        "$",
        "3x",
        "\n",
    ];
    let mut random = fastrand::Rng::with_seed(60848);
    let mut sound = 0;
    for _ in 0..20_000 {
        let words = random.usize(..30);
        let text: Vec<&str> = (0..words).map(|_| WORDS[random.usize(..WORDS.len())]).collect();
        sound += u32::from(check(&text.join(" ")));
    }
    assert!(sound > 100, "some soups are charts: {sound}");
}

#[test]
fn random_noise() {
    let mut random = fastrand::Rng::with_seed(61131);
    for _ in 0..2_000 {
        let bytes: Vec<u8> = (0..random.usize(..300)).map(|_| random.u8(..)).collect();
        check(&String::from_utf8_lossy(&bytes));
        let characters: String = (0..100).map(|_| char::from_u32(random.u32(..0x2300)).unwrap_or('\u{FFFD}')).collect();
        check(&characters);
    }
    let noise: String = (0..1 << 20).map(|_| char::from(random.u8(..))).collect();
    check(&noise);
}
