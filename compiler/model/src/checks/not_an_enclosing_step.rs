//! E0318: what encloses a grafcet is declared as an enclosing step.
//!
//! A step that encloses is drawn with a symbol of its own (IEC 60848, table 10, symbols 4 and 5), so that a reader of its grafcet
//! sees that there is more inside. A macro-step has an expansion instead.
//!
//! Wrong: `step 9`, `grafcet X9/G4 { … }`
//! Right: `enclosing step 9`, `grafcet X9/G4 { … }`

use crate::chart::Node;
use crate::fixes::mark;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    for grafcet in resolved.parts.grafcets.iter().filter_map(|part| part.ast) {
        let Some(name) = grafcet.path.last() else { continue };
        let Some(label) = name.text.strip_prefix('X').filter(|label| !resolved.scope.is_ambiguous(label)) else {
            continue;
        };
        let message = format!("`{}` is enclosed by `{label}`, which is not an enclosing step", grafcet.name.text);
        let diagnostic = Diagnostic::new(Code::E0318, name.span, message);
        match resolved.scope.node(label) {
            Some(Node::Step(id)) if !chart.steps[id].enclosing => diagnostics.push(
                diagnostic
                    .also(chart.steps[id].span, "declared here")
                    .note("IEC 60848, table 10, symbol 4: an enclosing step has a symbol of its own")
                    .help(format!("declare it as `enclosing step {label}`"))
                    .fix(mark(resolved.parts.step(Node::Step(id)).ast, "enclosing")),
            ),
            Some(Node::Macro(id)) => diagnostics.push(
                diagnostic
                    .also(chart.macro_steps[id].span, "a macro-step")
                    .note("a macro-step stands for its expansion; steps of the expansion may enclose grafcets"),
            ),
            Some(Node::Step(_)) | None => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn a_plain_step() {
        breaks("E0318", "grafcet G1 { initial step 1 step 9 } grafcet X9/G4 { activated step 40 }");
    }

    #[test]
    fn a_macro_step() {
        breaks(
            "E0318",
            "grafcet G1 { initial step 1 macro step M9 expansion M9 { step E9 step S9 } }
             grafcet XM9/G4 { activated step 40 }",
        );
    }

    #[test]
    fn an_enclosing_step() {
        passes("grafcet G1 { initial step 1 enclosing step 9 } grafcet X9/G4 { activated step 40 }");
    }
}
