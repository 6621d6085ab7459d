//! What has been found out about a net, in words.

use crate::analysis::Analysis;
use crate::analysis::components::Reason;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;

/// The sets of steps of which at most one is ever active, so that one state can hold which: each step is in at most one.
/// Short ones `switch` may hold as bits all the same, where that makes a shorter text.
pub fn sets(analysis: &Analysis) -> impl Iterator<Item = &[StepId]> + '_ {
    analysis.cover.sets.iter().map(|set| set.steps.as_slice())
}

/// The steps that share a state with none, and why.
pub fn bits(analysis: &Analysis) -> impl Iterator<Item = (StepId, String)> + '_ {
    analysis.reasons.iter().map(|(s, reason)| (*s, because(analysis.net(), *reason)))
}

/// How it was found which steps exclude each other.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Method {
    /// One token goes through all steps that transitions connect: none is ever active together with another.
    OneToken,
    /// All situations that these steps can come to were found, so that nothing is left to be proved.
    AllSituations,
    /// Tokens were followed as far as that led: what was not found may be so all the same.
    Search,
}

/// Of how many steps of the chart each method has told.
pub fn exclusion(analysis: &Analysis) -> impl Iterator<Item = (Method, usize)> + '_ {
    let own = analysis.net.places.iter_enumerated().filter(|(_, place)| !place.auxiliary);
    let methods: Vec<Method> = own
        .map(|(s, _)| match analysis.reachable.part(s) {
            Some(_) => Method::AllSituations,
            None if analysis.one_token.contains(&s) => Method::OneToken,
            None => Method::Search,
        })
        .collect();
    let count = move |method| methods.iter().filter(|m| **m == method).count();
    [Method::OneToken, Method::AllSituations, Method::Search].into_iter().map(move |method| (method, count(method)))
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
        Reason::Entered(a) => format!("`{}` may clear while it is active", t(a)),
        Reason::From(a) => format!("`{}` leads to it from steps that are bits", t(a)),
        Reason::Origin(a) => format!("`{}` leads to it from steps that it cannot share a state with", t(a)),
        Reason::Before(a, x, y) => format!("its state would also hold {} and {}, both before `{}`", s(x), s(y), t(a)),
        Reason::After(a, x, y) => format!("its state would also hold {} and {}, both after `{}`", s(x), s(y), t(a)),
        Reason::Initial(x, y) => format!("its state would also hold {} and {}, both initial", s(x), s(y)),
        Reason::Links(x, y) => format!("its state would also hold {} and {}, both with an activation link", s(x), s(y)),
        Reason::Forced(x, y) => {
            format!("its state would also hold {} and {}, which one order forces together", s(x), s(y))
        }
        Reason::Commanded => "pulse orders act on its grafcet".to_owned(),
        Reason::GivenUp => "the search for a state to share was given up".to_owned(),
    }
}
