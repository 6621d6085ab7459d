//! Charts of any size, to measure with: regular, but with a condition and an action everywhere.

use std::fmt::Write as _;

const HEAD: &str = "\
input a, b, c, d : bool
output w0, w1, w2, w3, w4, w5, w6, w7 : bool
output n : int

";

/// Parallel grafcets, each a ring of ten steps; `steps` in all.
pub fn rings(steps: usize) -> String {
    let mut out = format!("chart Rings_{steps}\n\n{HEAD}");
    for first in (0..steps).step_by(10) {
        let count = 10.min(steps - first);
        let _ = writeln!(out, "grafcet G{first} {{");
        write_ring(&mut out, first, count);
        out.push_str("}\n\n");
    }
    out
}

/// One ring of `steps` steps.
pub fn ring(steps: usize) -> String {
    let mut out = format!("chart Ring_{steps}\n\n{HEAD}grafcet G1 {{\n");
    write_ring(&mut out, 0, steps);
    out.push_str("}\n");
    out
}

fn write_ring(out: &mut String, first: usize, count: usize) {
    for step in first..first + count {
        let initial = if step == first { "initial " } else { "" };
        let action = match step % 5 {
            0 => "n := n + 1 on activation".to_string(),
            1 => format!("w{} if b", step % 8),
            _ => format!("w{}", step % 8),
        };
        let _ = writeln!(out, "  {initial}step {step} {{ {action} }}");
    }
    for step in first..first + count {
        let next = if step + 1 == first + count { first } else { step + 1 };
        let condition = match step % 4 {
            0 => "↑a".to_string(),
            1 => "b and not c".to_string(),
            2 => format!("2s/X{step}"),
            _ => "c or d".to_string(),
        };
        let _ = writeln!(out, "  transition {step} -> {next} : {condition}");
    }
}
