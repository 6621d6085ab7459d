//! What may not be meant, in words: one rule a file. What is warned of was found by the analysis; here it gets its code,
//! its places and its reasons.

mod allocation_conflict;
mod assuming;
mod constant_condition;
mod counter_race;
mod dead_end;
mod entered_while_active;
mod non_exclusive_divergence;
mod orders_not_exclusive;
pub(crate) mod overlap;
mod pulses_at_once;
mod ring_of_inputs;
mod step_never_active;
mod transition_never_clears;
mod wording;

use crate::analysis::Analysis;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use rustc_hash::FxHashMap;

/// A rule.
type Rule = fn(&Analysis, &mut Diagnostics);

/// The rules, in order of their codes.
const WARNINGS: &[Rule] = &[
    non_exclusive_divergence::check,
    counter_race::check,
    orders_not_exclusive::check,
    pulses_at_once::check,
    allocation_conflict::check,
    step_never_active::check,
    transition_never_clears::check,
    dead_end::check,
    constant_condition::check,
    entered_while_active::check,
    ring_of_inputs::check,
];

/// What the rules say of a flat net, in order of place.
pub fn warn(analysis: &Analysis) -> Diagnostics {
    let mut diagnostics = Diagnostics::new();
    for rule in WARNINGS {
        rule(analysis, &mut diagnostics);
    }
    if let Some(assuming) = diagnostics.iter().any(is_about_inputs).then(|| assuming::analysis(analysis)).flatten() {
        let mut left = Diagnostics::new();
        for rule in WARNINGS {
            rule(&assuming, &mut left);
        }
        // Of what is found in both cases, the one in which all assumptions are kept is shown.
        let place = |warning: &Diagnostic| (warning.code, warning.primary.span);
        let left: FxHashMap<_, _> = left.iter().map(|warning| (place(warning), warning.clone())).collect();
        let all = std::mem::take(&mut diagnostics);
        for warning in &all {
            match left.get(&place(warning)) {
                Some(assuming) if is_about_inputs(warning) => diagnostics.push(assuming.clone()),
                None if is_about_inputs(warning) => {}
                Some(_) | None => diagnostics.push(warning.clone()),
            }
        }
    }
    diagnostics.sort_by_place();
    diagnostics
}

/// Whether assumptions on inputs can answer a warning.
fn is_about_inputs(warning: &Diagnostic) -> bool {
    matches!(warning.code, Code::W0409 | Code::W0411 | Code::W0412 | Code::W0424)
}
