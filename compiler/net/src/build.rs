//! Checked chart to Petri net. Translates, decides nothing.

use crate::net::{Grafcet, MacroStep, Net, Place, Steps, Transition};
use grafc_model::chart::{Chart, MacroId, Node, Nodes, Tables};
use index_vec::IndexVec;

/// The Petri net of a checked chart; macro-steps, enclosures and orders stand in side tables.
pub fn build(chart: &Chart) -> Net {
    into_net(chart.clone())
}

/// The same, of a chart that nobody asks any more: what the net has of it changes hands.
pub fn into_net(chart: Chart) -> Net {
    let mut macro_steps: IndexVec<MacroId, MacroStep> = chart
        .macro_steps
        .iter_enumerated()
        .map(|(id, m)| MacroStep {
            label: m.label.clone(),
            entry: chart.entry(id),
            exit: chart.exit(id),
            places: Vec::new(),
            inner: Vec::new(),
            entered_by: Vec::new(),
            left_by: Vec::new(),
        })
        .collect();
    for (id, step) in chart.steps.iter_enumerated() {
        if let Some(m) = step.expansion_of {
            macro_steps[m].places.push(id);
        }
    }
    for (id, inner) in chart.macro_steps.iter_enumerated() {
        if let Some(m) = inner.expansion_of {
            macro_steps[m].inner.push(id);
        }
    }
    let chart: Tables = chart.into();
    let mut transitions = IndexVec::with_capacity(chart.transitions.len());
    for (id, t) in chart.transitions.into_iter_enumerated() {
        let mut places = |nodes: Nodes, table: fn(&mut MacroStep) -> &mut Vec<_>| {
            let mut steps = Steps::with_capacity(nodes.len());
            for node in nodes {
                match node {
                    Node::Step(s) => steps.push(s),
                    Node::Macro(m) => table(&mut macro_steps[m]).push(id),
                }
            }
            steps
        };
        let pre = places(t.pre, |m| &mut m.left_by);
        let post = places(t.post, |m| &mut m.entered_by);
        transitions.push(Transition {
            designation: t.designation,
            comment: t.comment,
            grafcet: t.grafcet,
            pre,
            post,
            within: Steps::new(),
            condition: t.condition,
            auxiliary: false,
            span: t.span,
        });
    }
    Net {
        name: chart.name,
        comment: chart.comment,
        options: chart.options,
        variables: chart.variables,
        places: chart
            .steps
            .into_iter()
            .map(|s| Place {
                label: s.label,
                comment: s.comment,
                grafcet: s.grafcet,
                initial: s.initial,
                activated: s.activated,
                within: Steps::new(),
                started: s.initial,
                saved: false,
                auxiliary: false,
                span: s.span,
            })
            .collect(),
        transitions,
        grafcets: chart
            .grafcets
            .into_iter()
            .map(|g| Grafcet {
                name: g.name,
                comment: g.comment,
                enclosing_step: g.enclosing_step,
                child: g.child,
                starts_frozen: false,
                level: g.level,
                steps: g.steps,
                orders: Vec::new(),
                frozen_with: None,
                span: g.span,
            })
            .collect(),
        hierarchy: chart.hierarchy,
        controls: chart.controls,
        macro_steps,
        continuous: chart.continuous,
        stored: chart.stored,
        orders: chart.orders,
        pulses: chart.pulses,
        runs: chart.runs,
        conflict_at_start: false,
        exprs: chart.exprs,
        claims: chart.claims,
        facts: Vec::new(),
    }
}
