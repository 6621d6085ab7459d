//! What may not be meant, in words: one rule a file. What is warned of was found by the analysis; here it gets its code,
//! its places and its reasons.

mod allocation_conflict;
mod constant_condition;
mod counter_race;
mod dead_end;
mod entered_while_active;
mod non_exclusive_divergence;
mod orders_not_exclusive;
pub(crate) mod overlap;
mod ring_of_inputs;
mod step_never_active;
mod transition_never_clears;
mod wording;

use crate::analysis::Analysis;
use grafc_diagnostics::Diagnostics;

/// A rule.
type Rule = fn(&Analysis, &mut Diagnostics);

/// The rules, in order of their codes.
const WARNINGS: &[Rule] = &[
    non_exclusive_divergence::check,
    counter_race::check,
    orders_not_exclusive::check,
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
    diagnostics.sort_by_place();
    diagnostics
}
