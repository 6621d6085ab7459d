//! E0319: only steps of an enclosure have an activation link.
//!
//! The link says that a step becomes active with the enclosing step (IEC 60848, table 10, symbol 41); without one it says
//! nothing.
//!
//! Wrong: `grafcet G1 { activated step 1 }`
//! Right: `grafcet G1 { initial step 1 }`, or `grafcet X9/G1 { activated step 1 }`

use crate::chart::Node;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix};
use grafc_syntax::ast::StepMark;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    for (id, step) in resolved.chart.steps.iter_enumerated().filter(|(_, step)| step.activated) {
        let grafcet = &resolved.parts.grafcets[step.grafcet];
        let is_enclosed = grafcet.ast.is_some_and(|grafcet| !grafcet.path.is_empty());
        if !is_enclosed && !resolved.parts.is_stray(step.grafcet) {
            let owner = &resolved.chart.grafcets[step.grafcet].name;
            let message = format!("step `{}` is `activated`, but no step encloses `{owner}`", step.label);
            let diagnostic = Diagnostic::new(Code::E0319, step.span, message).note(
                "IEC 60848, table 10, symbol 41: a step with an activation link becomes active with the enclosing step",
            );
            let written = resolved.parts.step(Node::Step(id)).ast;
            let fix = match step.initial {
                true => Fix::certain("leave out `activated`"),
                false => Fix::maybe("write `initial`"),
            };
            let fix = written.word(StepMark::Activated).map(|word| match step.initial {
                true => fix.delete(word),
                false => fix.replace(word, "initial"),
            });
            let mut diagnostic = match step.initial {
                true => diagnostic.help("leave out `activated`"),
                false => diagnostic.help("a step that is active at the start is `initial`"),
            };
            diagnostic.fixes.extend(fix);
            diagnostics.push(diagnostic);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn at_the_top() {
        breaks("E0319", "initial activated step 1");
        breaks("E0319", "grafcet G1 { initial step 1 activated step 2 }");
    }

    #[test]
    fn in_an_enclosure() {
        passes("grafcet G1 { initial step 1 enclosing step 9 } grafcet X9/G4 { activated step 40 }");
    }
}
