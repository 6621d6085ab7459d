//! E0310: an enclosure has an activation link.
//!
//! When the enclosing step becomes active, the steps that have a link do (IEC 60848, table 10, symbol 41); without one
//! the enclosure would stay empty. This holds even where the enclosing step is active from the start and never becomes
//! so again: a link there costs a word, and does not break when a transition is added.
//!
//! Wrong: `enclosing step 2`, `grafcet X2/G2 { step 20 }`
//! Right: `enclosing step 2`, `grafcet X2/G2 { activated step 20 }`

use crate::chart::Node;
use crate::fixes::mark;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for grafcet in &chart.grafcets {
        let Some(enclosing) = grafcet.enclosing_step.map(|id| &chart.steps[id]) else { continue };
        if !grafcet.steps.iter().any(|&id| chart.steps[id].activated) {
            let message = format!(
                "no step of `{}` is activated with step `{}`, which encloses it",
                grafcet.name, enclosing.label
            );
            let first = grafcet.steps.first().map(|&id| resolved.parts.step(Node::Step(id)).ast);
            let mut diagnostic = Diagnostic::new(Code::E0310, grafcet.span, message)
                .also(enclosing.span, "the enclosing step is here")
                .note("IEC 60848, table 10, symbol 41: activation links say which enclosed steps become active with it")
                .help("mark the steps that begin the enclosure as `activated`");
            diagnostic.fixes.extend(first.map(|step| mark(step, "activated")));
            diagnostics.push(diagnostic);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn no_link() {
        breaks("E0310", "grafcet G1 { initial step 1 enclosing step 2 } grafcet X2/G2 { step 20 }");
        breaks("E0310", "grafcet G1 { initial step 1 enclosing step 2 } grafcet X2/G2 { }");
        breaks("E0310", "grafcet G1 { initial enclosing step 2 } grafcet X2/G2 { initial step 20 }");
    }

    #[test]
    fn a_link() {
        passes("grafcet G1 { initial step 1 enclosing step 2 } grafcet X2/G2 { activated step 20 step 21 }");
    }

    #[test]
    fn a_link_in_an_expansion() {
        passes(
            "grafcet G1 { initial step 1 enclosing step 2 }
             grafcet X2/G2 { macro step M3 expansion M3 { activated step E3 step S3 } }",
        );
    }
}
