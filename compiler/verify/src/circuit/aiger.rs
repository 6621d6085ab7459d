//! A circuit in AIGER 1.9 (binary, `aig`): the format of the hardware model checking competition, which abc and many engines
//! read.
//!
//! Inputs and latches come first and bear their names; what must never hold is a bad state, and what is assumed a constraint
//! on the inputs.

use super::build::{Circuit, one_line};
use super::graph::{Literal, Node};

/// The file.
pub fn aiger(circuit: &Circuit) -> Vec<u8> {
    let nodes = circuit.graph.nodes();
    // The format wants inputs, then latches, then conjunctions, operands before what they are operands of.
    let mut number: Vec<u64> = vec![0; nodes.len()];
    let inputs = circuit.inputs.iter().map(|input| input.literal.node());
    let latches = circuit.latches.iter().map(|latch| latch.now.node());
    let ands = nodes.iter().enumerate().filter(|(_, node)| matches!(node, Node::And(..))).map(|(node, _)| node);
    for (place, node) in inputs.chain(latches).chain(ands).enumerate() {
        number[node] = place as u64 + 1;
    }
    let literal = |literal: Literal| 2 * number[literal.node()] + u64::from(literal.is_negated());

    let ands = nodes.iter().filter(|node| matches!(node, Node::And(..))).count();
    let (inputs, latches, bad) = (circuit.inputs.len(), circuit.latches.len(), circuit.bad.len());
    let constraints = usize::from(circuit.assumed != Literal::TRUE);
    let last = inputs + latches + ands;
    let mut out = format!("aig {last} {inputs} {latches} 0 {ands} {bad} {constraints}\n").into_bytes();
    let mut line = |text: String| out.extend(text.into_bytes().into_iter().chain([b'\n']));
    for latch in &circuit.latches {
        line(format!("{} {}", literal(latch.next), u8::from(latch.initial)));
    }
    circuit.bad.iter().for_each(|bad| line(literal(bad.literal).to_string()));
    if constraints > 0 {
        line(literal(circuit.assumed).to_string());
    }
    for (node, kind) in nodes.iter().enumerate() {
        if let Node::And(a, b) = kind {
            let (own, a, b) = (2 * number[node], literal(*a), literal(*b));
            push(&mut out, own - a.max(b));
            push(&mut out, a.max(b) - a.min(b));
        }
    }
    let mut line = |text: String| out.extend(text.into_bytes().into_iter().chain([b'\n']));
    let mut symbol = |kind: char, place: usize, name: &str| line(format!("{kind}{place} {}", one_line(name)));
    circuit.inputs.iter().enumerate().for_each(|(place, input)| symbol('i', place, &input.name));
    circuit.latches.iter().enumerate().for_each(|(place, latch)| symbol('l', place, &latch.name));
    circuit.bad.iter().enumerate().for_each(|(place, bad)| symbol('b', place, &bad.name));
    line(format!("c\n{}: a clock is a micro-step of the chart; it rests where latch 0 holds", one_line(&circuit.name)));
    out
}

/// A number, seven bits a byte, the lowest first.
fn push(out: &mut Vec<u8>, mut number: u64) {
    while number >= 0x80 {
        out.push(number as u8 | 0x80);
        number >>= 7;
    }
    out.push(number as u8);
}
