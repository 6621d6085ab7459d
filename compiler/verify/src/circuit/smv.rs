//! A circuit in SMV, the language of NuSMV and nuXmv.
//!
//! Names are numbers, since not all names of charts are names of SMV; a comment beside each says whose it is.

use super::build::{Circuit, one_line};
use super::graph::{Literal, Node};
use std::fmt::Write;

/// The text.
pub fn smv(circuit: &Circuit) -> String {
    let nodes = circuit.graph.nodes();
    let mut names: Vec<String> = (0..nodes.len()).map(|node| format!("n{node}")).collect();
    names[0] = "FALSE".to_string();
    for (place, input) in circuit.inputs.iter().enumerate() {
        names[input.literal.node()] = format!("i{place}");
    }
    for (place, latch) in circuit.latches.iter().enumerate() {
        names[latch.now.node()] = format!("l{place}");
    }
    let literal = |literal: Literal| {
        let name = &names[literal.node()];
        if literal.is_negated() { format!("!{name}") } else { name.clone() }
    };
    let mut out =
        format!("-- {}: a step is a micro-step of the chart; it rests where l0 holds\n", one_line(&circuit.name));
    let mut line = |words: std::fmt::Arguments| {
        // Writing into a text cannot fail.
        let _ = writeln!(out, "{words}");
    };
    line(format_args!("MODULE main"));
    if !circuit.inputs.is_empty() {
        line(format_args!("IVAR"));
    }
    for (place, input) in circuit.inputs.iter().enumerate() {
        line(format_args!("  i{place} : boolean; -- {}", one_line(&input.name)));
    }
    line(format_args!("VAR"));
    for (place, latch) in circuit.latches.iter().enumerate() {
        line(format_args!("  l{place} : boolean; -- {}", one_line(&latch.name)));
    }
    line(format_args!("DEFINE"));
    for (node, kind) in nodes.iter().enumerate() {
        if let Node::And(a, b) = kind {
            line(format_args!("  n{node} := {} & {};", literal(*a), literal(*b)));
        }
    }
    line(format_args!("ASSIGN"));
    for (place, latch) in circuit.latches.iter().enumerate() {
        let initial = if latch.initial { "TRUE" } else { "FALSE" };
        line(format_args!("  init(l{place}) := {initial};"));
        line(format_args!("  next(l{place}) := {};", literal(latch.next)));
    }
    // What is broken after a step hangs on the inputs of it, and an invariant may not: so it is kept.
    for (place, bad) in circuit.bad.iter().enumerate() {
        line(format_args!("VAR b{place} : boolean; -- {}", one_line(&bad.name)));
        line(format_args!("ASSIGN init(b{place}) := FALSE; next(b{place}) := {};", literal(bad.literal)));
    }
    if circuit.assumed != Literal::TRUE {
        line(format_args!("TRANS {}", literal(circuit.assumed)));
    }
    for (place, bad) in circuit.bad.iter().enumerate() {
        line(format_args!("INVARSPEC !b{place} -- {}", one_line(&bad.name)));
    }
    out
}
