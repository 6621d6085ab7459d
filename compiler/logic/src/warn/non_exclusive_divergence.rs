//! W0409: two transitions after one step that may be cleared together.
//!
//! A selection is exclusive only if its conditions are (IEC 60848, 6.2.3): where two hold at once, both transitions are
//! cleared (4.5.5, rule 4), and the sequences after them run in parallel.
//!
//! Warned of: `transition 1 -> 2 : a`, `transition 1 -> 3 : b`
//! Not warned of: `transition 1 -> 2 : a`, `transition 1 -> 3 : b and not a`; nor of two transitions between the same steps,
//! of which it does not matter whether one or both are cleared

use super::known::Known;
use super::witness::{self, Found};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// A transition is compared with this many that follow it after the same step.
const NEAR: usize = 16;

/// More transitions after one step are not shown.
const SHOWN: usize = 4;

/// More steps before a transition are not looked at.
const LOOKED_AT: usize = 8;

/// Two transitions that may be cleared together, and the case in which they are, if it can be said.
type Clash = (TransitionId, TransitionId, Option<String>);

/// Applies the rule: one warning a step.
pub(super) fn check(known: &mut Known, diagnostics: &mut Diagnostics) {
    let net = known.net;
    let mut leaving: IndexVec<StepId, Vec<TransitionId>> = net.places.iter().map(|_| Vec::new()).collect();
    for (t, transition) in net.transitions.iter_enumerated() {
        transition.pre.iter().for_each(|s| leaving[*s].push(t));
    }
    let exit_of: FxHashMap<StepId, &str> = net.macro_steps.iter().map(|m| (m.exit, m.label.as_str())).collect();
    // Pairs that share several steps are looked at once.
    let mut seen = FxHashSet::default();
    for (step, after) in leaving.iter_enumerated() {
        let mut clashes: Vec<Clash> = Vec::new();
        for (i, &a) in after.iter().enumerate() {
            for &b in after[i + 1..].iter().take(NEAR) {
                if clashes.len() < SHOWN
                    && seen.insert((a, b))
                    && let Some(case) = clash(known, a, b)
                {
                    clashes.push((a, b, case));
                }
            }
        }
        if !clashes.is_empty() {
            let label = &net.places[step].label;
            let drawn = match exit_of.get(&step) {
                Some(macro_step) => format!("step `{label}` (exit of `{macro_step}`)"),
                None => format!("step `{label}`"),
            };
            diagnostics.push(report(net, step, &drawn, &clashes));
        }
    }
}

/// Whether both may be cleared in one micro-step, and if so, in which case.
fn clash(known: &mut Known, a: TransitionId, b: TransitionId) -> Option<Option<String>> {
    let net = known.net;
    let (first, second) = (&net.transitions[a], &net.transitions[b]);
    let same_steps = || sorted(&first.pre) == sorted(&second.pre) && sorted(&first.post) == sorted(&second.post);
    if known.exclude(known.conditions[a], known.conditions[b]) || same_steps() {
        return None;
    }
    let (before_a, before_b) =
        (&first.pre[..first.pre.len().min(LOOKED_AT)], &second.pre[..second.pre.len().min(LOOKED_AT)]);
    if before_a.iter().any(|a| before_b.iter().any(|b| known.never_together(*a, *b))) {
        return None;
    }
    let active: Vec<StepId> = before_a.iter().chain(before_b).copied().collect();
    match witness::search(known, &[first.condition, second.condition], &active) {
        Found::Case(case) => Some(case),
        Found::Impossible => None,
        Found::Unknown => Some(None),
    }
}

fn sorted(steps: &[StepId]) -> Vec<StepId> {
    let mut steps = steps.to_vec();
    steps.sort_unstable();
    steps
}

fn report(net: &Net, step: StepId, drawn: &str, clashes: &[Clash]) -> Diagnostic {
    let span = |t: TransitionId| net.transitions[t].span;
    let (first, second, case) = &clashes[0];
    let message = format!("this transition and another after {drawn} may be cleared at once");
    let mut diagnostic =
        Diagnostic::new(Code::W0409, span(*second), message).also(span(*first), "cleared together with it");
    let mut shown = vec![*first, *second];
    for t in clashes.iter().flat_map(|(a, b, _)| [*a, *b]) {
        if shown.len() < SHOWN && !shown.contains(&t) {
            shown.push(t);
            diagnostic = diagnostic.also(span(t), "this may be cleared with one of them, too");
        }
    }
    diagnostic = diagnostic.also(net.places[step].span, format!("all come after {drawn}"));
    match case.as_deref() {
        Some("") => diagnostic = diagnostic.note("their conditions hold in any case"),
        Some(case) => diagnostic = diagnostic.note(format!("their conditions both hold if {case}")),
        None => {}
    }
    diagnostic.note("IEC 60848, 6.2.3: a selection is exclusive only if its conditions are; else both sequences start")
}
