//! What has been proved of a net, for people.

use crate::analysis::components::{self, Reason};
use crate::analysis::transients::{self, Known, Transients};
use crate::lower::{Context, Lowering, Moment};
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;

/// What is known of a flat net.
#[derive(Clone, Debug)]
pub struct Report {
    /// How many micro-steps a reaction can need.
    pub transients: Transients,
    /// The steps that share a state with none, and why.
    pub bits: Vec<(StepId, String)>,
}

/// Analyses a flat net.
pub fn analyse(net: &Net) -> Report {
    let mut lowering = Lowering::new(net, None);
    let mut cx = Context::new(Moment::MicroStep);
    let conditions: IndexVec<TransitionId, _> =
        net.transitions.iter().map(|t| lowering.expr(&mut cx, t.condition)).collect();
    let analysed = components::analyse(net, &lowering.pool, &lowering.edges, &conditions);
    let transients = transients::analyse(net, &Known::new(&lowering, &conditions, &analysed.components));
    let bits = analysed.reasons.iter().map(|(s, reason)| (*s, because(net, *reason))).collect();
    Report { transients, bits }
}

/// Of more steps on one side of a transition, only the first ones are named.
const STEPS_NAMED: usize = 6;

/// A transition as the chart draws it: `1, 2 -> 3`. A long list of steps is cut short: many transitions may have the same
/// thousands of steps on one side.
pub fn arrow(net: &Net, t: TransitionId) -> String {
    let labels = |steps: &[StepId]| {
        let named = steps.iter().take(STEPS_NAMED).map(|s| net.places[*s].label.as_str());
        let rest = steps.len().checked_sub(STEPS_NAMED).filter(|rest| *rest > 0).map(|rest| format!("… ({rest} more)"));
        named.map(str::to_owned).chain(rest).collect::<Vec<_>>().join(", ")
    };
    format!("{} -> {}", labels(&net.transitions[t].pre), labels(&net.transitions[t].post)).trim().to_owned()
}

fn because(net: &Net, reason: Reason) -> String {
    let t = |t: TransitionId| arrow(net, t);
    let s = |s: StepId| net.places[s].label.as_str();
    match reason {
        Reason::Together(a, b) => format!("`{}` and `{}` may clear together", t(a), t(b)),
        Reason::Many(count) => format!("{count} transitions leave it, too many to compare"),
        Reason::Source(a) => format!("the source transition `{}` leads to it", t(a)),
        Reason::From(a) => format!("`{}` leads to it from steps that are bits", t(a)),
        Reason::Origin(a) => format!("`{}` leads to it from steps that it cannot share a state with", t(a)),
        Reason::Before(a, x, y) => format!("it would go with {} and {}, both before `{}`", s(x), s(y), t(a)),
        Reason::After(a, x, y) => format!("it would go with {} and {}, both after `{}`", s(x), s(y), t(a)),
        Reason::Initial(x, y) => format!("it would go with {} and {}, both initial", s(x), s(y)),
        Reason::Links(x, y) => format!("it would go with {} and {}, both with an activation link", s(x), s(y)),
        Reason::Forced(x, y) => format!("it would go with {} and {}, which one order forces together", s(x), s(y)),
        Reason::GivenUp => "the search for a state to share was given up".to_owned(),
    }
}
