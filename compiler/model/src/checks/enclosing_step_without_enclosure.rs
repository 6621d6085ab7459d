//! E0320: an enclosing step encloses something.
//!
//! Its symbol promises at least one enclosure (IEC 60848, 7.4 and table 10, symbol 4).
//!
//! Wrong: `enclosing step 9` alone
//! Right: `enclosing step 9` and `grafcet X9/G4 { … }`

use crate::chart::{Node, StepId};
use crate::fixes::without_mark;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix};
use grafc_syntax::ast::StepMark;
use index_vec::{IndexVec, index_vec};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let mut encloses: IndexVec<StepId, bool> = index_vec![false; chart.steps.len()];
    for (id, grafcet) in chart.grafcets.iter_enumerated() {
        match grafcet.enclosing_step {
            Some(step) => encloses[step] = true,
            // An enclosing step that is not known, and reported as such, may be any of them.
            None if resolved.parts.grafcets[id].ast.is_some_and(|grafcet| !grafcet.path.is_empty()) => return,
            None => {}
        }
    }
    for (id, step) in chart.steps.iter_enumerated() {
        if step.enclosing && !encloses[id] && !resolved.scope.is_ambiguous(&step.label) {
            let fix = Fix::maybe(format!("declare it as `step {}`", step.label));
            diagnostics.push(
                Diagnostic::new(Code::E0320, step.span, format!("no grafcet is enclosed by step `{}`", step.label))
                    .note("IEC 60848, table 10, symbol 4: an enclosing step has at least one enclosure")
                    .help(format!("add `grafcet X{}/… {{ … }}`, or declare it as `step {}`", step.label, step.label))
                    .fix(without_mark(fix, resolved.parts.step(Node::Step(id)).ast, StepMark::Enclosing)),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn nothing_enclosed() {
        breaks("E0320", "initial step 1 enclosing step 9");
    }

    #[test]
    fn something_enclosed() {
        passes("grafcet G1 { initial step 1 enclosing step 9 } grafcet X9/G4 { activated step 40 }");
    }
}
