//! Causes of changes of the situation: clearings (R3, R4), enclosures and orders (R2, R5).
//!
//! Only what is *new* in a micro-step k > 1 needs a cause, and that is enough:
//!
//! - A step that a clearing activates in k was not activated by the same clearing in k - 1: had it been, only an order
//!   or an inactive enclosing step could have taken it away again, and neither lets the transition clear in k.
//! - A step that a clearing deactivates in k although the transition has cleared in k - 1 as well was kept active in
//!   k - 1 by another clearing that has stopped (rule 5). Such a transition is said to *go on*.
//! - A transition that clears in k and did not in k - 1 had a step before it activated in k - 1, or its condition has
//!   come true, or it is no longer frozen. That its enclosing step was activated tells nothing new unless it is a
//!   source transition, since the steps before it then were activated as well.
//! - An order with a set of steps changes its grafcet only when it comes into force or when the enclosing step of the
//!   grafcet is activated; while it is in force, the situation is that set already.

use super::PAIRS;
use super::causes::{Causes, Change, Way};
use super::conditions;
use super::stable::Stable;
use super::values::Occasion;
use crate::analysis::Analysis;
use grafc_model::chart::{ExprId, GrafcetId, StepId, TransitionId};
use grafc_net::net::Forced;
use grafc_net::{Arcs, Net};
use index_vec::IndexVec;
use std::borrow::Cow;

/// The arcs of those transitions that ever clear, and what is known of them.
pub(super) struct Ways<'a> {
    analysis: &'a Analysis,
    stable: &'a Stable,
    occasions: &'a IndexVec<ExprId, Occasion>,
    arcs: Cow<'a, Arcs>,
    goes_on: IndexVec<TransitionId, bool>,
}

impl<'a> Ways<'a> {
    pub(super) fn new(analysis: &'a Analysis, stable: &'a Stable, occasions: &'a IndexVec<ExprId, Occasion>) -> Self {
        let net = analysis.net();
        let clears = |t: TransitionId| !stable.never(t);
        let arcs = if net.transitions.indices().all(clears) {
            Cow::Borrowed(&analysis.arcs)
        } else {
            Cow::Owned(Arcs::of(net, clears))
        };
        let goes_on = net.transitions.iter().map(|_| false).collect();
        let mut ways = Ways { analysis, stable, occasions, arcs, goes_on };
        for t in net.transitions.indices() {
            ways.goes_on[t] = !stable.never(t) && !ways.by_edge(t);
        }
        for s in net.places.indices() {
            for t in ways.arcs.out_of_step(s) {
                ways.goes_on[*t] = ways.goes_on[*t] && ways.kept(s, *t);
            }
        }
        ways
    }

    /// Whether a transition that waits for no edge may clear in two micro-steps one after the other.
    pub(super) fn goes_on(&self, t: TransitionId) -> bool {
        self.goes_on[t]
    }

    /// Whether the transition clears only by an edge.
    fn by_edge(&self, t: TransitionId) -> bool {
        self.occasions[self.analysis.net.transitions[t].condition] != Occasion::Level
    }

    /// Whether the transition leads out of the step, even if also back to it; of a large one this is not asked.
    fn leads_out_of(&self, t: TransitionId, s: StepId) -> bool {
        self.analysis.net.transitions[t].pre.iter().take(PAIRS).any(|p| *p == s)
    }

    /// Whether `u` cannot clear after `t` in one reaction.
    fn excluded(&self, t: TransitionId, u: TransitionId) -> bool {
        self.stable.exclude(t, u)
            || self.stable.share_inputs(t, u) && {
                let Analysis { conditions, facts, .. } = self.analysis;
                let (pool, of) = (&conditions.lowering.pool, &conditions.of_transition);
                facts.exclude_later(pool, of[t], of[u], &|v| self.analysis.is_fixed(v))
            }
    }

    /// Whether another transition may keep `s` active while `t` leads out of it.
    fn kept(&self, s: StepId, t: TransitionId) -> bool {
        if self.analysis.components.covers(s) {
            return false;
        }
        let many = self.arcs.entering(s).len() > PAIRS;
        many || self.arcs.into_step(s).iter().chain(self.arcs.loops(s)).any(|u| *u != t && !self.excluded(*u, t))
    }
}

/// Adds the causes of all changes of the situation.
pub(super) fn add(net: &Net, ways: &Ways, causes: &mut Causes) {
    for t in net.transitions.indices().filter(|t| !ways.stable.never(*t)) {
        transition(ways, t, causes);
    }
    for s in net.places.indices() {
        step(ways, s, causes);
    }
    let mut sets: IndexVec<StepId, usize> = net.places.iter().map(|_| 0).collect();
    for order in net.grafcets.iter().flat_map(|g| &g.orders) {
        if let Forced::Steps(steps) = &order.forced {
            steps.iter().for_each(|s| sets[*s] += 1);
        }
    }
    for g in net.grafcets.indices() {
        orders(net, g, &sets, causes);
    }
    released(ways, &sets, causes);
}

fn transition(ways: &Ways, t: TransitionId, causes: &mut Causes) {
    let transition = &ways.analysis.net.transitions[t];
    let (grafcet, condition) = (transition.grafcet, transition.condition);
    let (clears, stops) = (Change::Clears(t), Change::Stops(t));
    causes.start(clears);
    // All these are active when it clears. Had one just been activated, that alone would be cause enough; see `step`.
    let before = |s: StepId| transition.encloser() == Some(s) || ways.leads_out_of(t, s);
    conditions::add(&ways.analysis.net, ways.occasions, (condition, Way::Up), &before, clears, causes);
    conditions::add(&ways.analysis.net, ways.occasions, (condition, Way::Down), &before, stops, causes);
    for s in &transition.pre {
        causes.next(Change::Deactivated(*s), stops);
    }
    if ways.by_edge(t) {
        return;
    }
    causes.next(Change::Thawed(grafcet), clears);
    for enclosing in transition.within.iter().filter(|_| transition.pre.is_empty()) {
        causes.next(Change::Activated(*enclosing), clears);
    }
}

fn step(ways: &Ways, s: StepId, causes: &mut Causes) {
    let net = &*ways.analysis.net;
    let place = &net.places[s];
    let (activated, placed, deactivated) = (Change::Activated(s), Change::Placed(s), Change::Deactivated(s));
    let (into, out_of, loops) = (ways.arcs.into_step(s), ways.arcs.out_of_step(s), ways.arcs.loops(s));
    for t in into {
        causes.at_once(Change::Clears(*t), activated);
    }
    if causes.places_steps() {
        causes.at_once(placed, activated);
    }
    for t in out_of {
        causes.at_once(Change::Clears(*t), deactivated);
    }
    if out_of.iter().any(|t| ways.goes_on(*t)) {
        for t in into.iter().chain(loops) {
            stops_to_keep(ways, *t, s, causes);
        }
    }
    for enclosing in &place.within {
        causes.at_once(Change::Deactivated(*enclosing), deactivated);
        if place.activated {
            causes.at_once(Change::Activated(*enclosing), placed);
        }
    }
    // What the activation makes possible; pair by pair where there are few, to leave out those that exclude each other.
    let after = out_of.len() + loops.len();
    let few = into.len().saturating_mul(after) <= PAIRS.saturating_mul(into.len() + after);
    for u in out_of.iter().chain(loops).filter(|u| !ways.by_edge(**u) && !ways.stable.needs_more(net, **u, s)) {
        if few {
            if causes.places_steps() {
                causes.next(placed, Change::Clears(*u));
            }
            for t in into.iter().filter(|t| !ways.excluded(**t, *u)) {
                causes.next(Change::Clears(*t), Change::Clears(*u));
            }
        } else {
            causes.next(activated, Change::Clears(*u));
        }
    }
}

/// What lets a transition stop to keep `s` active, while another one leads out of `s`: anything but that `s` has been
/// deactivated before.
fn stops_to_keep(ways: &Ways, t: TransitionId, s: StepId, causes: &mut Causes) {
    let transition = &ways.analysis.net.transitions[t];
    let deactivated = Change::Deactivated(s);
    if transition.pre.len() + transition.post.len() > PAIRS {
        causes.at_once(Change::Stops(t), deactivated);
        return;
    }
    conditions::add(
        &ways.analysis.net,
        ways.occasions,
        (transition.condition, Way::Down),
        &|x| x == s,
        deactivated,
        causes,
    );
    for other in transition.pre.iter().filter(|p| **p != s) {
        causes.next(Change::Deactivated(*other), deactivated);
    }
}

/// What orders on a grafcet do to its steps, and what freezes it. Of each step it is known how many sets hold it.
fn orders(net: &Net, g: GrafcetId, sets: &IndexVec<StepId, usize>, causes: &mut Causes) {
    let grafcet = &net.grafcets[g];
    if let Some(around) = grafcet.frozen_with {
        causes.at_once(Change::Frozen(around), Change::Frozen(g));
        causes.at_once(Change::Thawed(around), Change::Thawed(g));
        causes.at_once(Change::Released(around), Change::Thawed(g));
    }
    let mut all = 0;
    for (rank, order) in grafcet.orders.iter().enumerate() {
        causes.at_once(Change::Activated(order.step), Change::Frozen(g));
        causes.at_once(Change::Deactivated(order.step), Change::Overruled(g, rank + 1));
        causes.at_once(Change::Overruled(g, rank), Change::Overruled(g, rank + 1));
        let steps = match &order.forced {
            Forced::Current => {
                causes.at_once(Change::Deactivated(order.step), Change::Thawed(g));
                continue;
            }
            Forced::Steps(steps) => steps,
        };
        all += 1;
        causes.at_once(Change::Deactivated(order.step), Change::Released(g));
        let obeyed = Change::Obeyed(g, rank);
        causes.at_once(Change::Activated(order.step), obeyed);
        causes.at_once(Change::Overruled(g, rank), obeyed);
        for enclosing in net.within(g) {
            causes.at_once(Change::Activated(*enclosing), obeyed);
        }
        causes.at_once(obeyed, Change::Forced(g));
        for s in steps {
            causes.at_once(obeyed, Change::Placed(*s));
        }
    }
    // A step that every set holds is never forced to be inactive.
    for s in grafcet.steps.iter().filter(|s| sets[**s] < all) {
        causes.at_once(Change::Forced(g), Change::Deactivated(*s));
    }
}

/// What the end of an order makes possible.
///
/// Where an order has forced certain steps, these are the situation in which it ends: of the transitions of its grafcet
/// those are enabled whose steps before are among them. Of what is frozen otherwise nothing is known.
fn released(ways: &Ways, sets: &IndexVec<StepId, usize>, causes: &mut Causes) {
    for (t, transition) in ways.analysis.net.transitions.iter_enumerated() {
        if !ways.stable.never(t) && !ways.by_edge(t) && transition.pre.iter().all(|s| sets[*s] > 0) {
            causes.next(Change::Released(transition.grafcet), Change::Clears(t));
        }
    }
}
