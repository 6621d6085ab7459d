//! Charts without stored actions and without times, which the encodings may write in place; and transitions with many
//! steps on both sides, or many transitions beside each other.

use std::fmt::Write as _;

/// A step before N parallel branches of two steps.
pub(super) fn branches(count: usize) -> String {
    let mut out = head("Branches", count, "a, b, c");
    out.push_str("grafcet G1 {\n  initial step s\n");
    for branch in 0..count {
        let _ = writeln!(out, "  step p{branch} {{ w{} }}\n  step q{branch}", branch % 4);
    }
    let _ = writeln!(out, "  transition s -> {} : a", list("p", count));
    for branch in 0..count {
        let _ = writeln!(out, "  transition p{branch} -> q{branch} : b");
    }
    let _ = writeln!(out, "  transition {} -> s : c\n}}", list("q", count));
    out
}

/// N grafcets of two steps.
pub(super) fn pairs(count: usize) -> String {
    let mut out = head("Pairs", count, "a, b");
    for pair in 0..count {
        let (first, second) = (2 * pair, 2 * pair + 1);
        let _ = writeln!(out, "grafcet G{pair} {{\n  initial step {first} {{ w{} }}\n  step {second}", pair % 4);
        let _ = writeln!(out, "  transition {first} -> {second} : a\n  transition {second} -> {first} : b\n}}");
    }
    out
}

/// One transition from N steps to N others, and one from each of these back.
pub(super) fn joined(count: usize) -> String {
    let mut out = head("Joined", count, "a, b");
    out.push_str("grafcet G1 {\n");
    for step in 0..count {
        let _ = writeln!(out, "  initial step p{step}\n  step q{step} {{ w{} }}", step % 4);
    }
    let _ = writeln!(out, "  transition {} -> {} : a", list("p", count), list("q", count));
    for step in 0..count {
        let _ = writeln!(out, "  transition q{step} -> p{step} : b");
    }
    out.push_str("}\n");
    out
}

/// Transitions beside each other, each with the negated conditions of all before it; N operands in all.
pub(super) fn priorities(operands: usize) -> String {
    let exits = (1..).take_while(|exits| exits * (exits + 1) / 2 <= operands).count();
    let inputs = list("c", exits);
    let mut out = head("Priorities", operands, &format!("a, {inputs}"));
    out.push_str("grafcet G1 {\n  initial step s\n");
    for exit in 0..exits {
        let _ = writeln!(out, "  step p{exit} {{ w{} }}", exit % 4);
        let before: String = (0..exit).map(|before| format!("not c{before} and ")).collect();
        let _ = writeln!(out, "  transition s -> p{exit} : {before}c{exit}\n  transition p{exit} -> s : a");
    }
    out.push_str("}\n");
    out
}

fn head(name: &str, size: usize, inputs: &str) -> String {
    format!("chart {name}_{size}\n\ninput {inputs} : bool\noutput w0, w1, w2, w3 : bool\n\n")
}

fn list(name: &str, count: usize) -> String {
    let all: Vec<String> = (0..count).map(|index| format!("{name}{index}")).collect();
    all.join(", ")
}
