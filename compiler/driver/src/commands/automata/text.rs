//! Graphs and automata for people.

use super::diagram::{stands, with_outputs};
use grafc_automata::{Automaton, Kind, System};
use std::fmt::Write as _;

/// Graph by graph, each with its vertices and what leads on.
pub(super) fn system(system: &System) -> String {
    let (graphs, vertices) = (system.graphs.len(), system.graphs.iter().map(|graph| graph.vertices.len()).sum());
    let mut out = format!("{}: {}, {}\n", system.name, counted(graphs, "graph"), vertices_counted(vertices));
    for order in &system.orders {
        let _ = writeln!(out, "   {order}");
    }
    for graph in &system.graphs {
        let _ = write!(out, "\n{}\n", graph.name);
        for note in &graph.notes {
            let _ = writeln!(out, "   {note}");
        }
        let leaving = leaving(graph.vertices.len(), &graph.arcs, |arc| arc.from);
        for (vertex, arcs) in graph.vertices.iter().zip(leaving) {
            let _ = writeln!(out, "{}", line(&vertex.label, &vertex.actions, vertex.initial));
            for arc in arcs {
                let label = with_outputs(system.label(arc), &arc.actions);
                let _ = writeln!(out, "   {label} -> {}", graph.vertices[arc.to].label);
            }
        }
    }
    out
}

/// An automaton, and how many states it has beside the chart.
pub(super) fn automaton(automaton: &Automaton) -> String {
    let machine = &automaton.machine;
    let kind = match automaton.kind {
        Kind::Moore => "Moore automaton",
        Kind::Mealy => "Mealy automaton",
        Kind::Extended => "extended automaton",
        Kind::Minimal => "smallest Mealy automaton",
    };
    let (loops, arcs) = machine.count();
    let mut out = format!(
        "{}: {kind}, {}, {}, {}\n",
        machine.name,
        vertices_counted(automaton.vertices.len()),
        counted(loops, "loop"),
        counted(arcs, "arc")
    );
    let (before, pairs) = (counted(automaton.before, "state"), counted(automaton.pairs, "pair"));
    let _ = writeln!(out, "The chart has {before}; both do the same, in {pairs} of their product.\n");
    let leaving = leaving(automaton.vertices.len(), &automaton.arcs, |arc| arc.from);
    for (place, (vertex, arcs)) in automaton.vertices.iter().zip(leaving).enumerate() {
        let outputs: Vec<String> = vertex.outputs.iter().map(stands).collect();
        let _ = writeln!(out, "{}", line(&vertex.name, &outputs, place == machine.initial));
        for arc in arcs {
            let label = with_outputs(arc.when.clone(), &arc.outputs);
            let _ = writeln!(out, "   {label} -> {}", automaton.vertices[arc.to].name);
        }
    }
    out
}

/// The arcs that leave each vertex.
fn leaving<A>(vertices: usize, arcs: &[A], from: impl Fn(&A) -> usize) -> Vec<Vec<&A>> {
    let mut leaving: Vec<Vec<&A>> = vec![Vec::new(); vertices];
    arcs.iter().for_each(|arc| leaving[from(arc)].push(arc));
    leaving
}

fn line(name: &str, outputs: &[String], initial: bool) -> String {
    let outputs = if outputs.is_empty() { String::new() } else { format!("  {{ {} }}", outputs.join("  ")) };
    format!("{name}{outputs}{}", if initial { "  initial" } else { "" })
}

fn counted(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

fn vertices_counted(count: usize) -> String {
    if count == 1 { "1 vertex".to_owned() } else { format!("{count} vertices") }
}
