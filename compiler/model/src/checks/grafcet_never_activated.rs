//! E0312: something can become active in every grafcet at the top.
//!
//! Steps become active by the initial situation (IEC 60848, 4.5.1), by a source transition (6.3.3), or because the grafcet is
//! forced to a situation that is not empty (7.3). An enclosure has its links, and rules of its own.
//!
//! Wrong: `grafcet G2 { step 20 step 21 transition 20 -> 21 : a }`
//! Right: `grafcet G2 { initial step 20 step 21 transition 20 -> 21 : a }`

use crate::chart::{GrafcetId, Node};
use crate::fixes::mark;
use crate::resolve::Resolved;
use crate::resolve::scope::Label;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_syntax::ast;
use index_vec::{IndexVec, index_vec};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    if chart.steps.is_empty() {
        return; // E0321, or macro-steps without steps: E0306
    }
    let mut activated: IndexVec<GrafcetId, bool> = index_vec![false; chart.grafcets.len()];
    for step in chart.steps.iter().filter(|step| step.initial) {
        activated[step.grafcet] = true;
    }
    for (id, part) in resolved.parts.transitions.iter_enumerated() {
        if part.ast.from.is_empty() {
            activated[chart.transitions[id].grafcet] = true;
        }
    }
    for action in resolved.parts.steps.iter().flat_map(|part| &part.ast.actions) {
        if let ast::ActionKind::Force { grafcet, situation: ast::Situation::Steps(names) } = &action.kind
            && let Some(Label::Grafcet(id)) = resolved.scope.label(&grafcet.text)
        {
            activated[id] |= !names.is_empty();
        }
    }
    // A macro-step cannot be initial (E0306), but it shows what is meant.
    for part in resolved.parts.steps.iter().filter(|part| part.ast.is_initial()) {
        if let Node::Macro(id) = part.node {
            activated[chart.macro_steps[id].grafcet] = true;
        }
    }
    for (id, grafcet) in chart.grafcets.iter_enumerated() {
        let is_enclosed = resolved.parts.grafcets[id].ast.is_some_and(|grafcet| !grafcet.path.is_empty());
        let is_sure = !resolved.parts.is_stray(id) && !resolved.scope.is_ambiguous(&grafcet.name);
        // Of a child W0427 tells.
        if !activated[id] && !is_enclosed && is_sure && !grafcet.child {
            let what = if grafcet.steps.is_empty() { "has no steps" } else { "can never have an active step" };
            let first = grafcet.steps.first().map(|&id| resolved.parts.step(Node::Step(id)).ast);
            let mut diagnostic =
                Diagnostic::new(Code::E0312, grafcet.span, format!("the grafcet `{}` {what}", grafcet.name))
                    .note("it has no initial step, no source transition, and is not forced to a situation with steps")
                    .help("mark the steps that are active at the start as `initial`");
            diagnostic.fixes.extend(first.map(|step| mark(step, "initial")));
            diagnostics.push(diagnostic);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn nothing_activates_it() {
        breaks(
            "E0312",
            "input a : bool grafcet G1 { initial step 1 } grafcet G2 { step 20 step 21 transition 20 -> 21 : a }",
        );
        breaks("E0312", "grafcet G1 { initial step 1 } grafcet G2 { }");
        breaks("E0312", "step 1");
    }

    #[test]
    fn forced_to_nothing_is_not_activated() {
        breaks("E0312", "grafcet G1 { initial step 1 { force G2{} } } grafcet G2 { step 20 }");
        breaks("E0312", "grafcet G1 { initial step 1 { force G2{INIT} } } grafcet G2 { step 20 }");
        breaks("E0312", "grafcet G1 { initial step 1 { force G2{*} } } grafcet G2 { step 20 }");
    }

    #[test]
    fn a_source_transition_or_an_order_is_enough() {
        passes("input a : bool step 1 transition -> 1 : ↑a");
        passes("grafcet G1 { initial step 1 { force G2{20} } } grafcet G2 { step 20 }");
    }
}
