//! W0414: a step that is never active.
//!
//! Nothing activates it: no transition leads to it, it is not initial, no link and no order places it (IEC 60848, 4.5,
//! 6.3.1, 7.3, 7.4); or what leads to it waits for the step itself. What follows from that is not told again.
//!
//! Warned of: `step 4  transition 4 -> 1 : a`, and nothing leads to step 4
//! Not warned of: the same with `transition 2 -> 4 : b`

use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// One warning per cause.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    for idle in &analysis.liveness().never.steps {
        let place = &net.places[idle.step];
        let macro_step = net.macro_steps.iter().find(|m| m.entry == idle.step && m.places.len() > 1);
        let mut what = format!("step `{}`", place.label);
        if let Some(m) = macro_step {
            what = format!("macro-step `{}`", m.label);
        }
        let message = format!("{what} is never active");
        let mut diagnostic = Diagnostic::new(Code::W0414, place.span, message);
        for t in &idle.needed_by {
            diagnostic = diagnostic.also(net.transitions[*t].span, "so this is never cleared");
        }
        let note = match idle.is_entered {
            true => "what leads to it waits for it: a circle that nothing enters",
            false => "no transition leads to it, it is not initial, and no link or order places it",
        };
        diagnostic = diagnostic.note(note);
        if idle.others > 0 {
            let steps = if idle.others == 1 { "one other step is" } else { "other steps are" };
            let count = if idle.others == 1 { String::new() } else { format!("{} ", idle.others) };
            diagnostic = diagnostic.note(format!("because of that, {count}{steps} never active either"));
        }
        diagnostics.push(diagnostic.help("add a transition that leads to it, or leave the step out"));
    }
}
