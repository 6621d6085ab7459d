//! E0304: a transition links steps.
//!
//! Steps and transitions alternate (IEC 60848, 4.4). A source transition has no step before it (6.3.3), a sink transition none
//! after it (6.3.4); one with neither changes nothing.
//!
//! Wrong: `transition -> : a`
//! Right: `transition -> 1 : a`

use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    for transition in resolved.parts.transitions.iter().map(|part| part.ast) {
        if transition.from.is_empty() && transition.to.is_empty() {
            diagnostics.push(
                Diagnostic::new(Code::E0304, transition.span, "the transition has no step before and none after it")
                    .note("IEC 60848, 4.4: steps and transitions alternate")
                    .help("name the steps before and after it: `transition … -> … : …`"),
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn neither_side() {
        breaks("E0304", "input a : bool initial step 1 transition -> : a");
    }

    #[test]
    fn one_side_is_enough() {
        passes("input a : bool initial step 1 transition -> 1 : ↑a transition 1 -> : ↑a");
    }
}
