//! W0418: a step that may be entered while it is active.
//!
//! A step is active or not; a second token is lost in it (IEC 60848, 4.5: activity is a Boolean variable), with its
//! action on activation and its restart of the time. That is seldom meant: most often a branch jumps over its join.
//! Told with a way that leads there, on which inputs and time alone decide.
//!
//! Warned of: `1 -> 2, 3 : a`, `3 -> 5 : b`, `2, 4 -> 5 : c`, `5 -> 1 : d`: round again while step 2 is active
//! Not warned of: a source transition, which holds its steps active (6.3.3)

use super::wording;
use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// One warning per step.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    for found in &analysis.liveness().situations.reentries {
        let place = &net.places[found.step];
        let message = format!("step `{}` may be entered while it is active", place.label);
        let situation = wording::steps(net, &found.situation);
        let verb = if found.situation.len() == 1 { "is" } else { "are" };
        let mut diagnostic = Diagnostic::new(Code::W0418, net.transitions[found.by].span, message)
            .here(format!("when {situation} {verb} active"))
            .also(place.span, "it stays active, and its actions on activation are not done again");
        if !found.way.is_empty() {
            diagnostic = diagnostic.note(format!("the way there: {}", wording::way(net, &found.way)));
        }
        diagnostics
            .push(diagnostic.help("join the branches before one of them begins again, or let the condition wait"));
    }
}
