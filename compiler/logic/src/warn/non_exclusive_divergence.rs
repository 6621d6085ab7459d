//! W0409: two transitions after one step that may be cleared together.
//!
//! A selection is exclusive only if its conditions are (IEC 60848, 6.2.3): where two hold at once, both transitions are
//! cleared (4.5.5, rule 4), and the sequences after them run in parallel.
//!
//! Warned of: `transition 1 -> 2 : a`, `transition 1 -> 3 : b`
//! Not warned of: `transition 1 -> 2 : a`, `transition 1 -> 3 : b and not a`; nor of two transitions between the same steps,
//! of which it does not matter whether one or both are cleared

use super::wording;
use crate::analysis::Analysis;
use crate::analysis::together::clearings::Clashes;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use rustc_hash::FxHashMap;

/// More transitions after one step are not shown.
const SHOWN: usize = 4;

/// One warning per step.
pub(super) fn check(analysis: &Analysis, diagnostics: &mut Diagnostics) {
    let net = analysis.net();
    let exit_of: FxHashMap<StepId, &str> = net.macro_steps.iter().map(|m| (m.exit, m.label.as_str())).collect();
    for clashes in &analysis.together().clearings {
        let label = &net.places[clashes.step].label;
        let drawn = match exit_of.get(&clashes.step) {
            Some(macro_step) => format!("step `{label}` (exit of `{macro_step}`)"),
            None => format!("step `{label}`"),
        };
        // One that is never cleared is told of by itself (W0415).
        let never = &analysis.liveness().never.clears;
        let mut clashes = clashes.clone();
        clashes.pairs.retain(|pair| !never[pair.first] && !never[pair.second]);
        if let Some(warning) = report(net, &clashes, &drawn) {
            diagnostics.push(warning);
        }
    }
}

fn report(net: &Net, clashes: &Clashes, drawn: &str) -> Option<Diagnostic> {
    let span = |t: TransitionId| net.transitions[t].span;
    let pair = clashes.pairs.first()?;
    let message = format!("this transition and another after {drawn} may be cleared at once");
    let mut diagnostic =
        Diagnostic::new(Code::W0409, span(pair.second), message).also(span(pair.first), "cleared together with it");
    let mut shown = vec![pair.first, pair.second];
    for t in clashes.pairs.iter().flat_map(|pair| [pair.first, pair.second]) {
        if shown.len() < SHOWN && !shown.contains(&t) {
            shown.push(t);
            diagnostic = diagnostic.also(span(t), "this may be cleared with one of them, too");
        }
    }
    diagnostic = diagnostic.also(net.places[clashes.step].span, format!("all come after {drawn}"));
    match pair.case.as_ref().and_then(|case| wording::case(net, case)).as_deref() {
        Some("") => diagnostic = diagnostic.note("their conditions hold in any case"),
        Some(case) => diagnostic = diagnostic.note(format!("their conditions both hold if {case}")),
        None => {}
    }
    Some(
        diagnostic
            .note("IEC 60848, 6.2.3: a selection is exclusive only if its conditions are; else both sequences start"),
    )
}
