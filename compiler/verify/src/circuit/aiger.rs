//! A circuit in AIGER 1.9 (ASCII, `aag`): the format of the hardware model checking competition, which abc and many engines
//! read.
//!
//! Inputs and latches come first and bear their names; what must never hold is a bad state, and what is assumed a constraint
//! on the inputs.

use super::build::Circuit;
use super::graph::{Literal, Node};
use std::fmt::Write;

/// The text.
pub fn aiger(circuit: &Circuit) -> String {
    let nodes = circuit.graph.nodes();
    // The format wants inputs, then latches, then conjunctions.
    let mut number = vec![0; nodes.len()];
    let given = circuit.inputs.iter().map(|input| input.literal).chain(circuit.latches.iter().map(|latch| latch.now));
    let mut last = 0;
    let mut name = |number: &mut Vec<u64>, node: usize| {
        last += 1;
        number[node] = last;
    };
    given.for_each(|literal| name(&mut number, literal.node()));
    let ands = || nodes.iter().enumerate().filter(|(_, node)| matches!(node, Node::And(..)));
    ands().for_each(|(node, _)| name(&mut number, node));
    let literal = |literal: Literal| 2 * number[literal.node()] + u64::from(literal.is_negated());

    let constraints = usize::from(circuit.assumed != Literal::TRUE);
    let (inputs, latches) = (circuit.inputs.len(), circuit.latches.len());
    let mut out = format!("aag {last} {inputs} {latches} 0 {} {} {constraints}\n", ands().count(), circuit.bad.len());
    let mut line = |words: std::fmt::Arguments| {
        // Writing into a text cannot fail.
        let _ = writeln!(out, "{words}");
    };
    circuit.inputs.iter().for_each(|input| line(format_args!("{}", literal(input.literal))));
    for latch in &circuit.latches {
        line(format_args!("{} {} {}", literal(latch.now), literal(latch.next), u8::from(latch.initial)));
    }
    circuit.bad.iter().for_each(|bad| line(format_args!("{}", literal(bad.literal))));
    if constraints > 0 {
        line(format_args!("{}", literal(circuit.assumed)));
    }
    for (node, kind) in ands() {
        if let Node::And(a, b) = kind {
            line(format_args!("{} {} {}", 2 * number[node], literal(*a), literal(*b)));
        }
    }
    let names = circuit.inputs.iter().map(|input| ('i', &input.name));
    for (place, (kind, name)) in names.enumerate() {
        line(format_args!("{kind}{place} {}", one_line(name)));
    }
    for (place, latch) in circuit.latches.iter().enumerate() {
        line(format_args!("l{place} {}", one_line(&latch.name)));
    }
    for (place, bad) in circuit.bad.iter().enumerate() {
        line(format_args!("b{place} {}", one_line(&bad.name)));
    }
    line(format_args!(
        "c\n{}: a clock is a micro-step of the chart; it rests where latch 0 holds",
        one_line(&circuit.name)
    ));
    out
}

/// A name without line ends, which end the line of a symbol.
fn one_line(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
