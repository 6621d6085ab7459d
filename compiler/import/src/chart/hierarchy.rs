//! Which step encloses which grafcet, and which macro-step has which expansion.
//!
//! AGRAFE says an enclosure twice, at the step and at the grafcet, and nothing keeps the two alike. An expansion stands
//! among the partial grafcets and only its macro-step knows it.

use crate::agrafe::model::{GrafcetId, GrafcetKind, Model, NodeId, NodeKind};
use crate::{changed, doubtful, lost};
use grafc_diagnostics::Diagnostics;
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashSet;

/// What stands within what.
pub struct Hierarchy {
    /// The step that encloses a grafcet.
    pub encloser: IndexVec<GrafcetId, Option<NodeId>>,
    /// The macro-step that a grafcet expands.
    pub expanded: IndexVec<GrafcetId, Option<NodeId>>,
    /// Steps that enclose something.
    pub enclosing: FxHashSet<NodeId>,
}

impl Hierarchy {
    /// Whether a grafcet is written: the chart itself only if it has steps of its own.
    pub fn is_block(&self, model: &Model, grafcet: GrafcetId) -> bool {
        match model.grafcets[grafcet].kind {
            GrafcetKind::Chart => !model.grafcets[grafcet].nodes.is_empty(),
            GrafcetKind::Partial | GrafcetKind::Expansion => true,
        }
    }
}

/// Finds the hierarchy.
pub fn find(model: &Model, diagnostics: &mut Diagnostics) -> Hierarchy {
    let mut encloser: IndexVec<GrafcetId, Option<NodeId>> =
        model.grafcets.iter().map(|grafcet| grafcet.enclosing_step).collect();
    let mut expanded = index_vec![None; model.grafcets.len()];
    let mut listed = FxHashSet::default();
    for (id, node) in model.nodes.iter_enumerated() {
        match &node.kind {
            NodeKind::Enclosing(grafcets) => {
                for &grafcet in grafcets {
                    listed.insert((id, grafcet));
                    match encloser[grafcet] {
                        Some(other) if other == id => {}
                        Some(_) => diagnostics.push(
                            doubtful(
                                node.span,
                                format!("the step {} encloses a grafcet that another encloses", node.id),
                            )
                            .also(model.grafcets[grafcet].span, "the grafcet itself says which one")
                            .note("a grafcet is enclosed by one step"),
                        ),
                        None => {
                            let message = format!("only the step {} says that it encloses a grafcet", node.id);
                            diagnostics
                                .push(doubtful(node.span, message).also(model.grafcets[grafcet].span, "this one"));
                            encloser[grafcet] = Some(id);
                        }
                    }
                }
            }
            NodeKind::Macro(Some(expansion)) => {
                if expanded[*expansion].is_some() {
                    let message = format!("the macro-step {} has the expansion of another", node.id);
                    diagnostics
                        .push(doubtful(node.span, message).note("an expansion is written once, for the first of them"));
                } else {
                    expanded[*expansion] = Some(id);
                }
            }
            NodeKind::Step
            | NodeKind::Entry
            | NodeKind::Exit
            | NodeKind::Macro(None)
            | NodeKind::Transition(_)
            | NodeKind::Synchronization => {}
        }
    }
    for (id, grafcet) in model.grafcets.iter_enumerated() {
        if let Some(step) = grafcet.enclosing_step
            && !listed.contains(&(step, id))
        {
            let message = format!("only the grafcet says that the step {} encloses it", model.nodes[step].id);
            diagnostics.push(doubtful(grafcet.span, message).also(model.nodes[step].span, "this step"));
        }
    }
    let enclosing: FxHashSet<NodeId> = encloser.iter().flatten().copied().collect();
    for (id, node) in model.nodes.iter_enumerated() {
        if matches!(node.kind, NodeKind::Enclosing(_)) && !enclosing.contains(&id) {
            diagnostics.push(changed(
                node.span,
                format!("the enclosing step {} encloses nothing and is a plain step", node.id),
            ));
        }
        if node.activation_link && is_unenclosed(model, &encloser, node.grafcet) {
            diagnostics.push(
                lost(node.span, format!("the activation link of the step {} is lost", node.id))
                    .note("only steps of an enclosure have one (IEC 60848, symbol 41)"),
            );
        }
    }
    Hierarchy { encloser, expanded, enclosing }
}

/// Whether an activation link means nothing in a grafcet.
pub fn is_unenclosed(model: &Model, encloser: &IndexVec<GrafcetId, Option<NodeId>>, grafcet: GrafcetId) -> bool {
    match model.grafcets[grafcet].kind {
        GrafcetKind::Chart | GrafcetKind::Partial => encloser[grafcet].is_none(),
        GrafcetKind::Expansion => false,
    }
}
