//! E0316: a forced situation names no macro-step.
//!
//! A macro-step stands for the steps of its expansion, and a situation says which of those are active (IEC 60848, 7.3 and
//! symbol 42).
//!
//! Wrong: `force G2{M3}`
//! Right: `force G2{E3}`

use crate::chart::Node;
use crate::fixes::name_instead;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_syntax::ast;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    for action in resolved.parts.steps.iter().flat_map(|part| &part.ast.actions) {
        let ast::ActionKind::Force { situation: ast::Situation::Steps(names), .. } = &action.kind else { continue };
        for name in names {
            if let Some(Node::Macro(id)) = resolved.scope.node(&name.text) {
                let diagnostic = Diagnostic::new(
                    Code::E0316,
                    name.span,
                    format!("the macro-step `{}` cannot be in a forced situation", name.text),
                )
                .also(resolved.chart.macro_steps[id].span, "the macro-step is here")
                .note("IEC 60848, symbol 42: a macro-step is active while a step of its expansion is");
                diagnostics.push(match name.text.strip_prefix('M') {
                    Some(rest) => {
                        let diagnostic = diagnostic.help(format!("name a step of its expansion, such as `E{rest}`"));
                        match resolved.chart.macro_steps[id].entry {
                            Some(entry) => diagnostic.fix(name_instead(name.span, &resolved.chart.steps[entry].label)),
                            None => diagnostic,
                        }
                    }
                    None => diagnostic,
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    const FORCED: &str = "grafcet G2 { initial step 20 macro step M3 expansion M3 { step E3 step S3 } }";

    #[test]
    fn a_macro_step() {
        breaks("E0316", &format!("grafcet G1 {{ initial step 1 {{ force G2{{M3}} }} }} {FORCED}"));
    }

    #[test]
    fn a_step_of_its_expansion() {
        passes(&format!("grafcet G1 {{ initial step 1 {{ force G2{{S3}} }} }} {FORCED}"));
    }
}
