//! Charts of any size, to measure with: regular, but with a condition and an action everywhere.
//!
//! [`SHAPES`] names them. What a shape takes as its size is the number of steps, of parallel branches, of grafcets or of
//! operands;
//! every shape gives a chart without errors from size 2 on.

mod plain;

use std::fmt::Write as _;

const HEAD: &str = "\
input a, b, c, d : bool
output w0, w1, w2, w3, w4, w5, w6, w7 : bool
output n : int

";

/// How deep enclosures are nested in [`deep`].
const DEPTH: usize = 16;

/// How many steps stand before the branches of [`spine`].
const SPINE: usize = 1_000;

/// A family of charts.
pub struct ScalingShape {
    /// Its name.
    pub name: &'static str,
    /// What a chart of size N is.
    pub meaning: &'static str,
    /// The text of the chart of a size.
    pub write: fn(usize) -> String,
}

/// All families.
pub const SHAPES: [ScalingShape; 11] = [
    ScalingShape {
        name: "rings",
        meaning: "parallel grafcets, each a ring of ten steps; N steps in all",
        write: rings,
    },
    ScalingShape { name: "ring", meaning: "one ring of N steps", write: ring },
    ScalingShape { name: "deep", meaning: "enclosures nested 16 deep, side by side; N steps in all", write: deep },
    ScalingShape {
        name: "wide",
        meaning: "a ring of enclosing steps, an enclosure in each; N steps in all",
        write: wide,
    },
    ScalingShape { name: "parallel", meaning: "a step before N parallel branches of two steps", write: parallel },
    ScalingShape {
        name: "spine",
        meaning: "1,000 steps in a row before N parallel branches of two steps",
        write: spine,
    },
    ScalingShape { name: "forced", meaning: "N grafcets, each forced by a step of one ring of N steps", write: forced },
    ScalingShape {
        name: "branches",
        meaning: "a step before N parallel branches of two steps, without stored actions",
        write: plain::branches,
    },
    ScalingShape { name: "pairs", meaning: "N grafcets of two steps, without stored actions", write: plain::pairs },
    ScalingShape {
        name: "joined",
        meaning: "one transition from N steps to N others, and one from each of these back",
        write: plain::joined,
    },
    ScalingShape {
        name: "priorities",
        meaning: "transitions beside each other, each with the negated conditions of those before it; N operands in all",
        write: plain::priorities,
    },
];

fn rings(steps: usize) -> String {
    let mut out = head("Rings", steps);
    for first in (0..steps).step_by(10) {
        write_ring(&mut out, &format!("G{first}"), first, 10.min(steps - first), |step| initially(step == first));
    }
    out
}

fn ring(steps: usize) -> String {
    let mut out = head("Ring", steps);
    write_ring(&mut out, "G1", 0, steps, |step| initially(step == 0));
    out
}

/// Each level is an enclosing step and a step beside it. Only the outermost grafcet of a column starts by itself, and its
/// enclosing step then starts all levels at once.
fn deep(steps: usize) -> String {
    let mut out = head("Deep", steps);
    for start in (0..steps).step_by(2 * DEPTH) {
        let end = steps.min(start + 2 * DEPTH);
        let mut first = start;
        while first < end {
            // A step left over stays with the innermost level.
            let innermost = end - first < 4;
            let count = if innermost { end - first } else { 2 };
            let name = if first == start { format!("G{first}") } else { format!("X{}/G{first}", first - 2) };
            let at_top = first == start;
            write_ring(&mut out, &name, first, count, |step| match (at_top, step == first && !innermost) {
                (true, _) if step + 1 == first + count => "initial step",
                (true, true) => "enclosing step",
                (true, false) => "step",
                (false, true) => "activated enclosing step",
                (false, false) => activated(step == first),
            });
            first += count;
        }
    }
    out
}

fn wide(steps: usize) -> String {
    let enclosing = steps / 2;
    let mut out = head("Wide", steps);
    write_ring(
        &mut out,
        "G1",
        0,
        enclosing,
        |step| if step == 0 { "initial enclosing step" } else { "enclosing step" },
    );
    for step in 0..enclosing {
        let first = enclosing + step;
        // The step left over is the last one's.
        let count = if step + 1 == enclosing { steps - first } else { 1 };
        write_ring(&mut out, &format!("X{step}/E{step}"), first, count, |inner| match (step, inner == first) {
            (0, true) => "initial activated step",
            (_, first) => activated(first),
        });
    }
    out
}

fn parallel(branches: usize) -> String {
    branching("Parallel", 1, branches)
}

fn spine(branches: usize) -> String {
    branching("Spine", SPINE, branches)
}

/// Steps in a row, then parallel branches of two steps, then the first step again.
fn branching(name: &str, row: usize, branches: usize) -> String {
    let mut out = head(name, branches);
    out.push_str("grafcet G1 {\n");
    for step in 0..row + 2 * branches {
        write_step(&mut out, step, initially(step == 0));
    }
    for step in 1..row {
        write_transition(&mut out, &(step - 1).to_string(), &step.to_string(), step - 1);
    }
    let list = |first: usize| {
        let steps: Vec<String> = (first..first + branches).map(|step| step.to_string()).collect();
        steps.join(", ")
    };
    let (begin, end) = (row, row + branches);
    write_transition(&mut out, &(row - 1).to_string(), &list(begin), row - 1);
    for branch in 0..branches {
        write_transition(&mut out, &(begin + branch).to_string(), &(end + branch).to_string(), begin + branch);
    }
    write_transition(&mut out, &list(end), "0", end);
    out.push_str("}\n");
    out
}

/// The four kinds of orders in turn.
fn forced(grafcets: usize) -> String {
    let mut out = head("Forced", grafcets);
    out.push_str("grafcet Master {\n");
    for step in 0..grafcets {
        let situation = match step % 4 {
            0 => "*".to_owned(),
            1 => (grafcets + 2 * step + 1).to_string(),
            2 => String::new(),
            _ => "INIT".to_owned(),
        };
        let _ = writeln!(out, "  {} {step} {{ force F{step}{{{situation}}} }}", initially(step == 0));
    }
    write_arcs(&mut out, 0, grafcets);
    out.push_str("}\n\n");
    for step in 0..grafcets {
        let first = grafcets + 2 * step;
        write_ring(&mut out, &format!("F{step}"), first, 2, |inner| initially(inner == first));
    }
    out
}

fn head(name: &str, size: usize) -> String {
    format!("chart {name}_{size}\n\n{HEAD}")
}

fn initially(initial: bool) -> &'static str {
    if initial { "initial step" } else { "step" }
}

fn activated(linked: bool) -> &'static str {
    if linked { "activated step" } else { "step" }
}

/// A grafcet that is one ring; a single step stands alone.
fn write_ring(out: &mut String, name: &str, first: usize, count: usize, kind: impl Fn(usize) -> &'static str) {
    let _ = writeln!(out, "grafcet {name} {{");
    for step in first..first + count {
        write_step(out, step, kind(step));
    }
    if count > 1 {
        write_arcs(out, first, count);
    }
    out.push_str("}\n\n");
}

fn write_arcs(out: &mut String, first: usize, count: usize) {
    for step in first..first + count {
        let next = if step + 1 == first + count { first } else { step + 1 };
        write_transition(out, &step.to_string(), &next.to_string(), step);
    }
}

fn write_step(out: &mut String, step: usize, kind: &str) {
    let action = match step % 5 {
        0 => "n := n + 1 on activation".to_owned(),
        1 => format!("w{} if b", step % 8),
        _ => format!("w{}", step % 8),
    };
    let _ = writeln!(out, "  {kind} {step} {{ {action} }}");
}

fn write_transition(out: &mut String, from: &str, to: &str, step: usize) {
    let condition = match step % 4 {
        0 => "↑a".to_owned(),
        1 => "b and not c".to_owned(),
        2 => format!("2s/X{step}"),
        _ => "c or d".to_owned(),
    };
    let _ = writeln!(out, "  transition {from} -> {to} : {condition}");
}

#[cfg(test)]
mod tests {
    use super::*;
    use grafc_diagnostics::FileId;
    use grafc_model::chart::Chart;

    fn chart(shape: &ScalingShape, size: usize) -> Chart {
        let text = (shape.write)(size);
        let (ast, diagnostics) = grafc_syntax::parse(FileId::default(), &text);
        assert!(!diagnostics.has_errors(), "{} {size}: {diagnostics:#?}\n{text}", shape.name);
        let (chart, diagnostics) = grafc_model::check(&ast, "scaling");
        assert!(!diagnostics.has_errors(), "{} {size}: {diagnostics:#?}\n{text}", shape.name);
        chart.expect("a chart without errors")
    }

    #[test]
    fn all_shapes_are_charts_of_the_size_asked_for() {
        for shape in &SHAPES {
            for size in [2, 3, 4, 5, 9, 32, 33, 34, 35, 64, 100, 130] {
                let steps = match shape.name {
                    "rings" | "ring" | "deep" | "wide" => size,
                    "parallel" => 1 + 2 * size,
                    "spine" => SPINE + 2 * size,
                    "forced" => 3 * size,
                    "branches" => 1 + 2 * size,
                    "pairs" | "joined" => 2 * size,
                    "priorities" => 1 + exits(size),
                    name => panic!("{name} has no expected number of steps"),
                };
                assert_eq!(chart(shape, size).steps.len(), steps, "{} {size}", shape.name);
            }
        }
    }

    /// The most exits e with e (e + 1) / 2 operands at most.
    fn exits(operands: usize) -> usize {
        let (mut exits, mut left) = (0, operands);
        while left > exits {
            exits += 1;
            left -= exits;
        }
        exits
    }

    #[test]
    fn enclosures_are_as_deep_and_as_wide_as_said() {
        let deep = (SHAPES[2].write)(64);
        assert_eq!(deep.matches("grafcet X").count(), 30, "two columns, 15 enclosures in each");
        assert!(deep.contains("grafcet X28/G30 {"), "the sixteenth level:\n{deep}");
        assert!(!deep.contains("grafcet X30/"), "no seventeenth:\n{deep}");
        assert_eq!((SHAPES[3].write)(64).matches("grafcet X").count(), 32);
    }
}
