//! E0315: a forced situation names steps of the forced grafcet.
//!
//! A situation of a grafcet is a set of its own steps (IEC 60848, 7.3 and symbol 37). Those of its expansions are its own, those
//! of its enclosures are not.
//!
//! Wrong: `grafcet G1 { initial step 1 { force G2{30} } }`, where `30` belongs to `G3`
//! Right: `grafcet G1 { initial step 1 { force G2{20} } }`, where `20` belongs to `G2`

use crate::chart::Node;
use crate::resolve::Resolved;
use crate::resolve::scope::Label;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_syntax::ast;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    for action in resolved.parts.steps.iter().flat_map(|part| &part.ast.actions) {
        if let ast::ActionKind::Force { grafcet, situation: ast::Situation::Steps(names) } = &action.kind {
            check_order(resolved, grafcet, names, diagnostics);
        }
    }
}

fn check_order(resolved: &Resolved, grafcet: &ast::Name, names: &[ast::Name], diagnostics: &mut Diagnostics) {
    let Some(Label::Grafcet(forced)) = resolved.scope.label(&grafcet.text) else { return };
    if resolved.scope.is_ambiguous(&grafcet.text) {
        return;
    }
    for name in names.iter().filter(|name| !resolved.scope.is_ambiguous(&name.text)) {
        let Some(Node::Step(id)) = resolved.scope.node(&name.text) else { continue };
        let step = &resolved.chart.steps[id];
        if step.grafcet != forced && !resolved.parts.is_stray(step.grafcet) {
            let owner = &resolved.chart.grafcets[step.grafcet].name;
            let message = format!("step `{}` belongs to `{owner}`, not to `{}`", name.text, grafcet.text);
            diagnostics.push(
                Diagnostic::new(Code::E0315, name.span, message)
                    .also(step.span, "the step is here")
                    .note("IEC 60848, symbol 37: a situation names steps of the forced grafcet")
                    .help(format!("leave out `{}`, or force `{owner}` by an order of its own", name.text)),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn a_step_of_another_grafcet() {
        breaks(
            "E0315",
            "grafcet G1 { initial step 1 { force G2{20, 30} } } grafcet G2 { step 20 } grafcet G3 { initial step 30 }",
        );
    }

    #[test]
    fn a_step_of_an_expansion() {
        passes(
            "grafcet G1 { initial step 1 { force G2{E3} } }
             grafcet G2 { initial step 20 macro step M3 expansion M3 { step E3 step S3 } }",
        );
    }
}
