//! Graphs and automata for programs; their form is described in docs/automata.md.

use grafc_automata::{Automaton, Kind, System};
use serde_json::{Value, json};

/// One object in one line.
pub(super) fn system(system: &System) -> String {
    let graphs = system.graphs.iter().map(|graph| {
        let vertices = graph.vertices.iter().map(|vertex| {
            json!({ "label": vertex.label, "initial": vertex.initial, "actions": vertex.actions })
        });
        let arcs = graph.arcs.iter().map(|arc| {
            let states = arc.states.iter().map(|(other, vertex)| {
                json!({ "graph": other, "vertex": vertex })
            });
            let states = states.collect::<Vec<Value>>();
            json!({ "from": arc.from, "to": arc.to, "when": arc.when, "states": states, "more": arc.more, "actions": arc.actions })
        });
        let (vertices, arcs): (Vec<Value>, Vec<Value>) = (vertices.collect(), arcs.collect());
        json!({ "name": graph.name, "vertices": vertices, "arcs": arcs, "notes": graph.notes })
    });
    let graphs: Vec<Value> = graphs.collect();
    one_line(&json!({ "version": 1, "chart": system.name, "graphs": graphs, "orders": system.orders }))
}

/// One object in one line.
pub(super) fn automaton(automaton: &Automaton) -> String {
    let kind = match automaton.kind {
        Kind::Moore => "moore",
        Kind::Mealy => "mealy",
        Kind::Extended => "extended",
        Kind::Minimal => "minimal",
    };
    let vertices = automaton.vertices.iter().map(|vertex| {
        let outputs = vertex.outputs.iter().map(|(name, when)| json!({ "name": name, "when": when }));
        json!({ "name": vertex.name, "outputs": outputs.collect::<Vec<Value>>() })
    });
    let arcs = automaton
        .arcs
        .iter()
        .map(|arc| json!({ "from": arc.from, "to": arc.to, "when": arc.when, "outputs": arc.outputs }));
    let (vertices, arcs): (Vec<Value>, Vec<Value>) = (vertices.collect(), arcs.collect());
    let machine = &automaton.machine;
    one_line(&json!({
        "version": 1,
        "chart": machine.name,
        "kind": kind,
        "inputs": machine.inputs,
        "outputs": machine.outputs,
        "initial": machine.initial,
        "vertices": vertices,
        "arcs": arcs,
        "states_of_the_chart": automaton.before,
        "pairs_of_the_product": automaton.pairs,
    }))
}

fn one_line(value: &Value) -> String {
    value.to_string() + "\n"
}
