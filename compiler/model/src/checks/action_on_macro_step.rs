//! E0307: a macro-step has no actions.
//!
//! It stands for the steps of its expansion and has no state of its own (IEC 60848, table 10, symbol 42): actions belong to
//! those steps, or depend on the activity `XM3`.
//!
//! Wrong: `macro step M3 { V }`
//! Right: `expansion M3 { step E3 { V } … }`

use crate::chart::Node;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    for part in resolved.parts.steps.iter().filter(|part| matches!(part.node, Node::Macro(_))) {
        if let Some(action) = part.ast.actions.first() {
            let label = &part.ast.label;
            diagnostics.push(
                Diagnostic::new(Code::E0307, action.span, format!("the macro-step `{}` has an action", label.text))
                    .note("IEC 60848, table 10, symbol 42: a macro-step stands for its expansion")
                    .help("put the action on steps of the expansion"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn on_the_macro_step() {
        breaks("E0307", "output V : bool initial step 1 macro step M3 { V } expansion M3 { step E3 step S3 }");
    }

    #[test]
    fn in_the_expansion() {
        passes("output V : bool initial step 1 macro step M3 expansion M3 { step E3 { V } step S3 }");
    }
}
