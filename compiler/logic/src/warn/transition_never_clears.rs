//! W0415: a transition that is never cleared, though each step before it may be active.
//!
//! A transition is cleared only while all steps before it are active and its condition holds (IEC 60848, 4.5.3). Where
//! the steps are never active all at once, or the condition never holds while they are, that is proved.
//!
//! Warned of: `transition 2, 3 -> 1 : a`, where steps 2 and 3 are alternatives
//! Not warned of: the same after `transition 1 -> 2, 3 : b`

use super::wording;
use crate::analysis::Analysis;
use crate::analysis::liveness::possible::Why;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};

/// One warning per transition; where the condition is constant, W0417 says so.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    for (t, why) in &analysis.liveness().never.transitions {
        let transition = &net.transitions[*t];
        let label = |step: grafc_model::chart::StepId| &net.places[step].label;
        let diagnostic = Diagnostic::new(Code::W0415, transition.span, "this transition is never cleared");
        let condition = net.exprs[transition.condition].span;
        diagnostics.push(match why {
            Why::Constant => continue,
            Why::Apart(a, b) => {
                let diagnostic = match [a, b].map(|step| transition.pre.contains(step)) {
                    [true, true] => diagnostic,
                    [..] => diagnostic.also(condition, "it asks for a step that is not active then"),
                };
                diagnostic
                    .also(net.places[*a].span, format!("never active together with step `{}`", label(*b)))
                    .also(net.places[*b].span, format!("never active together with step `{}`", label(*a)))
                    .note("IEC 60848, 4.5.3: a transition is enabled only while all steps before it are active")
                    .help("lead into both steps at once (`1 -> 2, 3`), or use two transitions instead of the join")
            }
            Why::Condition => diagnostic
                .also(condition, "this never holds while the steps before the transition are active")
                .help("correct the condition, or leave the transition out"),
            Why::AtOnce => diagnostic
                .note(format!("{} are never active all at once", wording::steps(net, &transition.pre)))
                .note("IEC 60848, 4.5.3: a transition is enabled only while all steps before it are active")
                .help(
                    "take out of the join the step whose token is used up before, or lead into the others another way",
                ),
        });
    }
}
