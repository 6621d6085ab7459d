//! Checked chart to Petri net. Translates, decides nothing.

use crate::net::{Grafcet, MacroStep, Net, Place, Transition};
use grafc_model::chart::{Chart, MacroId, Node, StepId};
use index_vec::IndexVec;

/// The Petri net of a checked chart; macro-steps, enclosures and orders stand in side tables.
pub fn build(chart: &Chart) -> Net {
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
    let mut transitions = IndexVec::with_capacity(chart.transitions.len());
    for (id, t) in chart.transitions.iter_enumerated() {
        let mut places = |nodes: &[Node], table: fn(&mut MacroStep) -> &mut Vec<_>| -> Vec<StepId> {
            let mut steps = Vec::with_capacity(nodes.len());
            for node in nodes {
                match *node {
                    Node::Step(s) => steps.push(s),
                    Node::Macro(m) => table(&mut macro_steps[m]).push(id),
                }
            }
            steps
        };
        let pre = places(&t.pre, |m| &mut m.left_by);
        let post = places(&t.post, |m| &mut m.entered_by);
        transitions.push(Transition {
            designation: t.designation.clone(),
            comment: t.comment.clone(),
            grafcet: t.grafcet,
            pre,
            post,
            within: None,
            condition: t.condition,
            span: t.span,
        });
    }
    Net {
        name: chart.name.clone(),
        comment: chart.comment.clone(),
        variables: chart.variables.clone(),
        places: chart
            .steps
            .iter()
            .map(|s| Place {
                label: s.label.clone(),
                comment: s.comment.clone(),
                grafcet: s.grafcet,
                initial: s.initial,
                activated: s.activated,
                within: None,
                auxiliary: false,
                span: s.span,
            })
            .collect(),
        transitions,
        grafcets: chart
            .grafcets
            .iter()
            .map(|g| Grafcet {
                name: g.name.clone(),
                comment: g.comment.clone(),
                enclosing_step: g.enclosing_step,
                level: g.level,
                steps: g.steps.clone(),
                orders: Vec::new(),
                frozen_with: None,
                span: g.span,
            })
            .collect(),
        hierarchy: chart.hierarchy.clone(),
        controls: chart.controls,
        macro_steps,
        continuous: chart.continuous.clone(),
        stored: chart.stored.clone(),
        orders: chart.orders.clone(),
        conflict_at_start: false,
        exprs: chart.exprs.clone(),
        facts: Vec::new(),
    }
}
