//! Directed links and synchronisations: what stands before and behind each transition.
//!
//! AGRAFE draws a synchronisation as a node of its own between steps and a transition (IEC 60848, symbol 9); the text
//! names its steps at the transition. Where several transitions follow one synchronisation, each names them all.

use crate::agrafe::model::{Model, NodeId, NodeKind};
use crate::{changed, doubtful, lost};
use grafc_diagnostics::{Diagnostics, Span};
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashSet;

/// The steps around a transition.
#[derive(Clone, Default)]
pub struct Steps {
    pub before: Vec<NodeId>,
    pub behind: Vec<NodeId>,
}

/// The kinds of node as arcs see them.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Step,
    Transition,
    Synchronization,
}

fn end(kind: &NodeKind) -> End {
    match kind {
        NodeKind::Step | NodeKind::Enclosing(_) | NodeKind::Entry | NodeKind::Exit | NodeKind::Macro(_) => End::Step,
        NodeKind::Transition(_) => End::Transition,
        NodeKind::Synchronization => End::Synchronization,
    }
}

/// What joins a node with the next ones.
#[derive(Clone, Default)]
struct Joined {
    from: Vec<NodeId>,
    to: Vec<NodeId>,
}

/// The steps around each transition; none if they were more than `limit`.
pub fn follow(model: &Model, limit: usize, diagnostics: &mut Diagnostics) -> Option<IndexVec<NodeId, Steps>> {
    let joined = joined(model, diagnostics);
    for (id, node) in model.nodes.iter_enumerated() {
        if let NodeKind::Synchronization = node.kind {
            check_synchronization(model, node.span, &joined[id], diagnostics);
        }
    }
    let mut around: IndexVec<NodeId, Steps> = index_vec![Steps::default(); model.nodes.len()];
    let mut ends = 0;
    for (id, node) in model.nodes.iter_enumerated() {
        let NodeKind::Transition(_) = node.kind else { continue };
        let Steps { before, behind } = &mut around[id];
        let sides = [(&joined[id].from, before, "follows"), (&joined[id].to, behind, "leads to")];
        for (side, (direct, steps, verb)) in sides.into_iter().enumerate() {
            for &node in direct {
                let known = steps.len();
                if let End::Step = end(&model.nodes[node].kind) {
                    steps.push(node);
                } else {
                    let through = if side == 0 { &joined[node].from } else { &joined[node].to };
                    steps.extend(through.iter().filter(|&&step| end(&model.nodes[step].kind) == End::Step));
                }
                ends += steps.len() - known;
                if ends > limit {
                    return None;
                }
            }
            let direct_steps = direct.iter().filter(|&&node| end(&model.nodes[node].kind) == End::Step).count();
            if direct_steps > 1 {
                let message = format!("the transition {} {verb} several steps without a synchronisation", node.id);
                diagnostics
                    .push(doubtful(node.span, message).note("it is taken as if there were one (IEC 60848, symbol 9)"));
            }
            let mut seen = FxHashSet::default();
            steps.retain(|step| seen.insert(*step));
        }
        if around[id].before.is_empty() && around[id].behind.is_empty() {
            diagnostics.push(lost(
                node.span,
                format!("the transition {} is lost, because no step is connected to it", node.id),
            ));
        }
    }
    Some(around)
}

/// What is joined to each node, in the order of the arcs.
fn joined(model: &Model, diagnostics: &mut Diagnostics) -> IndexVec<NodeId, Joined> {
    let mut joined: IndexVec<NodeId, Joined> = index_vec![Joined::default(); model.nodes.len()];
    let mut seen = FxHashSet::default();
    for arc in &model.arcs {
        let (source, target) = (end(&model.nodes[arc.source].kind), end(&model.nodes[arc.target].kind));
        if source == target {
            let what = match source {
                End::Step => "two steps",
                End::Transition => "two transitions",
                End::Synchronization => "two synchronisations",
            };
            diagnostics.push(
                lost(arc.span, format!("an arc between {what} is lost"))
                    .note("steps and transitions alternate (IEC 60848, 4.4)"),
            );
        } else if !seen.insert((arc.source, arc.target)) {
            diagnostics.push(changed(arc.span, "an arc that is there twice is written once"));
        } else {
            joined[arc.source].to.push(arc.target);
            joined[arc.target].from.push(arc.source);
        }
    }
    joined
}

/// A synchronisation joins steps with transitions, on both sides; else its arcs lead nowhere.
fn check_synchronization(model: &Model, span: Span, joined: &Joined, diagnostics: &mut Diagnostics) {
    let has = |nodes: &[NodeId], kind: End| nodes.iter().any(|&node| end(&model.nodes[node].kind) == kind);
    let steps = has(&joined.from, End::Step) == has(&joined.to, End::Transition);
    let transitions = has(&joined.from, End::Transition) == has(&joined.to, End::Step);
    if !(steps && transitions) || joined.from.is_empty() && joined.to.is_empty() {
        diagnostics.push(
            lost(span, "arcs of a synchronisation are lost, because they do not connect steps with transitions")
                .note("steps and transitions alternate (IEC 60848, 4.4)"),
        );
    }
}
