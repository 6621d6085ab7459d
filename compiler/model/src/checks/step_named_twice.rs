//! E0303: a transition or a forced situation names each step once.
//!
//! Steps before and after a transition are sets, and so is a forced situation (IEC 60848, 4.5.4 and symbol 37): a step named
//! twice says nothing more, and is most likely a slip.
//!
//! Wrong: `transition 1 -> 2, 2 : a`
//! Right: `transition 1 -> 2, 3 : a`

use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_syntax::ast;
use rustc_hash::FxHashMap;

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    for part in &resolved.parts.transitions {
        check_names(&part.ast.from, "precedes the transition", diagnostics);
        check_names(&part.ast.to, "succeeds the transition", diagnostics);
    }
    for action in resolved.parts.steps.iter().flat_map(|part| &part.ast.actions) {
        if let ast::ActionKind::Force { situation: ast::Situation::Steps(names), .. } = &action.kind {
            check_names(names, "is in the forced situation", diagnostics);
        }
    }
}

fn check_names(names: &[ast::Name], role: &str, diagnostics: &mut Diagnostics) {
    if names.len() < 2 {
        return;
    }
    let mut seen = FxHashMap::default();
    for name in names {
        let first = *seen.entry(name.text.as_str()).or_insert(name.span);
        if first != name.span {
            let message = format!("step `{}` {role} twice", name.text);
            diagnostics.push(
                Diagnostic::new(Code::E0303, name.span, message)
                    .also(first, "named here already")
                    .help(format!("leave out the second `{}`", name.text)),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn a_step_named_twice_on_one_side() {
        breaks("E0303", "input a : bool initial step 1 step 2 transition 1 -> 2, 2 : a");
        breaks("E0303", "input a : bool initial step 1 step 2 transition 1, 1 -> 2 : a");
    }

    #[test]
    fn a_step_named_twice_in_a_forced_situation() {
        breaks("E0303", "grafcet G1 { initial step 1 { force G2{2, 2} } } grafcet G2 { step 2 }");
    }

    #[test]
    fn a_step_on_both_sides_is_a_self_loop() {
        passes("input a : bool initial step 1 transition 1 -> 1 : a");
    }
}
