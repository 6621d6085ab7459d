//! Sets of steps of which at most one is active at any time.
//!
//! A set of steps of one grafcet is such a *component* if
//! 1. at most one of its steps is initial, once the start is settled;
//! 2. every transition that leads into the set has exactly one step of the set before it and one after it, and every
//!    transition that leads out of the set or within it has exactly one before and at most one after it;
//! 3. where several transitions leave a step of the set, their conditions exclude each other;
//! 4. if the grafcet is within a step, at most one step of the set has an activation link;
//! 5. each situation that an order forces on the grafcet holds at most one step of the set.
//!
//! Proof, by induction over micro-steps. The start puts at most one token into the set by 1. If no step of the set is
//! active, then by 2 no transition that leads into it clears (R3), and none comes. If one is, then by 3 at most one
//! transition after it clears, by 2 no other transition around the set does, and that one moves the token or takes it
//! away (R4). Then R5: an enclosure that is emptied harms nothing. One that starts was empty, since its enclosing step
//! was inactive, and nothing in it has cleared: by 4 the links bring at most one token. An order leaves what it finds
//! or makes the situation the forced one, and then 5 holds.
//!
//! What pulse orders (R15) make of a grafcet is not looked into: of those on which they act no step is in a component. What
//! such a grafcet encloses is as any enclosure: its enclosing step is activated and deactivated in other ways, but it is.
//!
//! What follows is used to keep formulas short: where nothing but clearings acts on a step, the step that the token
//! comes to was inactive, and a clearing that does not lead back changes the situation. What does not follow: that the
//! token moves along transitions. A link and an order bring one from nowhere, and an order also from any step to any
//! step that it forces.
//!
//! Two transitions that are only alternatives to each other count as one for 3: they lead from the same steps to the same
//! steps. And conditions need not exclude each other where steps before the transitions do, which lie in a component that
//! has been found already: what is proved of that one is proved without this one.
//!
//! The search is greedy and its work is bounded by the size of the net: what it does not find stays unproved, and the
//! formulas stay longer. It goes by labels, not by the order of the text (see `canonical`).
//!
//! Where all situations of a part are known (see `reachable`) a set may hold any steps of which no two are ever active
//! together, and only the following has to be said of each of them:
//! - no source transition leads to it, and no other one clears while the step is active, unless it leaves it;
//! - of the transitions that leave it at most one clears in a micro-step, or alternatives to it.
//!
//! Then what was said of components holds of such a set as well. A clearing brings a token into the set only where the
//! set is empty or loses the token by the same clearing: if another step of the set stayed active, or were left by another
//! clearing, the first clearing alone would make two steps of the set active, which is among the situations looked at.

mod cover;
mod exact;
mod family;
mod reason;
mod search;
#[cfg(test)]
mod tests;

pub(crate) use reason::Reason;

use super::Conditions;
use super::canonical::Canonical;
use super::reachable::Reachable;
use super::reachable::known::Known;
use super::reachable::parts::{self, Part};
use super::rivals::Rivals;
use crate::lower::cover::{Cover, CoverSet};
use cover::Arranged;
use grafc_formula::exclusion::EdgeFacts;
use grafc_model::chart::{GrafcetId, StepId, TransitionId};
use grafc_net::net::{Forced, Grafcet};
use grafc_net::{Arcs, Net};
use index_vec::IndexVec;
use rustc_hash::FxHashSet;
use search::Search;
use smallvec::SmallVec;

/// No more components than this are remembered for one step.
const REMEMBERED: usize = 8;

/// Components are written out for the steps that they share with others until this many steps for each step of the net
/// have been looked at.
const WRITTEN: usize = 32;

/// How often the search begins again because components show that more transitions exclude each other.
const ROUNDS: usize = 3;

/// Of more steps before a transition not each is compared with those before another.
const LOOKED_AT: usize = 8;

/// The components that were found.
#[derive(Clone)]
pub(crate) struct Components {
    of_step: IndexVec<StepId, SmallVec<[usize; 2]>>,
}

impl Components {
    /// No component at all.
    pub(crate) fn none(net: &Net) -> Self {
        Components { of_step: net.places.iter().map(|_| SmallVec::new()).collect() }
    }

    /// Components that hold a step, by number; not all of them if there are many.
    pub(crate) fn of(&self, step: StepId) -> &[usize] {
        &self.of_step[step]
    }

    /// Whether a step lies in a component.
    pub(crate) fn covers(&self, step: StepId) -> bool {
        !self.of_step[step].is_empty()
    }

    /// Whether some component holds both steps.
    pub(crate) fn share(&self, a: StepId, b: StepId) -> bool {
        self.of(a).iter().any(|component| self.of(b).contains(component))
    }
}

/// What has been found.
pub(crate) struct FoundComponents {
    pub(crate) components: Components,
    pub(crate) cover: Cover,
    /// Why each step that the cover leaves out stays a bit.
    pub(crate) reasons: Vec<(StepId, Reason)>,
    pub(crate) reachable: Reachable,
    pub(crate) rivals: Rivals,
    /// Steps of parts that one component holds as a whole: there is nothing more to be found of these.
    pub(crate) one_token: FxHashSet<StepId>,
}

/// A set of the cover, and the other steps of its component, as far as they are written out.
struct Written {
    set: CoverSet,
    others: Vec<StepId>,
}

/// Finds components that cover as many steps as possible.
pub(crate) fn find(
    net: &Net,
    arcs: &Arcs,
    facts: &EdgeFacts,
    conditions: &Conditions,
    commanded: &IndexVec<GrafcetId, bool>,
    situations: &[Known],
) -> FoundComponents {
    let canonical = Canonical::new(net, arcs);
    let rivals = Rivals::new(net, arcs, conditions, facts);
    let parts = parts::parts(&canonical);
    let to_write = WRITTEN * net.places.len();
    let mut apart = FxHashSet::default();
    let mut arranged = search(&canonical, &rivals, commanded, &apart);
    let one_token = |part: &Part, arranged: &Arranged| {
        let set = part.steps.first().and_then(|s| arranged.cover.of_step[*s]);
        set.is_some_and(|set| arranged.cover.sets[set].steps.len() == part.steps.len())
    };
    let is_commanded = |part: &Part| part.steps.first().is_some_and(|s| commanded[canonical.net.places[*s].grafcet]);
    let wanted = |part: &Part| !one_token(part, &arranged) && !is_commanded(part);
    let reachable = Reachable::find(&canonical, &parts, conditions, facts, &rivals, situations, wanted);
    for _ in 0..ROUNDS {
        let unknown = |t: TransitionId| net.transitions[t].pre.first().is_none_or(|s| reachable.part(*s).is_none());
        let is_open = |(a, b): &(TransitionId, TransitionId)| unknown(*a) && !apart.contains(&(*a, *b));
        let open: Vec<_> = rivals.pairs().filter(is_open).collect();
        if open.is_empty() {
            break;
        }
        let known = components(net, written(&canonical, &arranged, to_write)).0;
        let found: Vec<_> = open.into_iter().filter(|(a, b)| known_apart(&canonical, &known, *a, *b)).collect();
        if found.is_empty() {
            break;
        }
        apart.extend(found);
        arranged = search(&canonical, &rivals, commanded, &apart);
    }
    let whole = parts.iter().filter(|part| one_token(part, &arranged)).flat_map(|part| &part.steps);
    let one_token = whole.map(|s| canonical.step[*s]).collect();
    let mut reasons: Vec<(StepId, Reason)> = Vec::with_capacity(arranged.reasons.len());
    for (s, reason) in &arranged.reasons {
        reasons.push((canonical.step[*s], reason.named(|s| canonical.step[s], |t| canonical.transition[t])));
    }
    let mut all = written(&canonical, &arranged, to_write);
    exact::refine(net, arcs, &rivals, &reachable, &mut all, &mut reasons);
    reasons.sort_unstable_by_key(|(s, _)| *s);
    let (components, cover) = components(net, all);
    FoundComponents { components, cover, reasons, reachable, rivals, one_token }
}

/// What the search finds, by canonical ids. Of rivals that are known to be `apart` at most one clears.
fn search(
    canonical: &Canonical,
    rivals: &Rivals,
    commanded: &IndexVec<GrafcetId, bool>,
    apart: &FxHashSet<(TransitionId, TransitionId)>,
) -> Arranged {
    let (net, arcs) = (&*canonical.net, &*canonical.arcs);
    let around = Surroundings::new(net, arcs);
    let undecided = net.places.indices().map(|s| {
        let leaving = arcs.leaving(s);
        if commanded[net.places[s].grafcet] {
            return Some(Reason::Commanded);
        }
        if rivals.many(canonical.step[s]) {
            return Some(Reason::Many(leaving.len()));
        }
        leaving.iter().find_map(|t| {
            let a = canonical.transition[*t];
            let together = |b: &TransitionId| {
                let rank = canonical.transition_rank[*b];
                let shares = net.transitions[rank].pre.binary_search(&s).is_ok();
                (shares && !apart.contains(&(a.min(*b), a.max(*b)))).then_some(rank)
            };
            let first = rivals.of(a).iter().filter_map(together).min();
            first.map(|b| Reason::Together(*t.min(&b), *t.max(&b)))
        })
    });
    let undecided = undecided.collect();
    let mut search = Search::new(net, &around, undecided);
    search.run();
    cover::arrange(net, &around, search)
}

/// Whether steps before two transitions lie in one component.
fn known_apart(canonical: &Canonical, known: &Components, a: TransitionId, b: TransitionId) -> bool {
    let before = |t: TransitionId| {
        let pre = &canonical.net.transitions[canonical.transition_rank[t]].pre;
        pre.iter().take(LOOKED_AT).map(|s| canonical.step[*s])
    };
    before(a).any(|x| before(b).any(|y| x != y && known.share(x, y)))
}

/// The sets of an arrangement by the ids of the net, in canonical order; their components as far as there is `work` left.
fn written(canonical: &Canonical, arranged: &Arranged, mut work: usize) -> Vec<Written> {
    let mut all = Vec::with_capacity(arranged.cover.sets.len());
    for (number, set) in arranged.cover.sets.iter().enumerate() {
        let mut steps: Vec<StepId> = set.steps.iter().map(|s| canonical.step[*s]).collect();
        steps.sort_unstable();
        let mut others = Vec::new();
        arranged.rest(number, &mut work, |s| others.push(canonical.step[s]));
        all.push(Written { set: CoverSet { steps, always_marked: set.always_marked }, others });
    }
    all
}

/// Components and cover of these sets; the sets of the cover in the order of the text.
fn components(net: &Net, all: Vec<Written>) -> (Components, Cover) {
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_unstable_by_key(|index| all[*index].set.steps.first().copied());
    let mut number = vec![0; all.len()];
    for (place, index) in order.iter().enumerate() {
        number[*index] = place;
    }
    let mut components = Components::none(net);
    let mut of_step: IndexVec<StepId, Option<usize>> = net.places.iter().map(|_| None).collect();
    for (index, written) in all.iter().enumerate() {
        for s in &written.set.steps {
            components.of_step[*s].push(number[index]);
            of_step[*s] = Some(number[index]);
        }
    }
    for (index, written) in all.iter().enumerate() {
        for s in &written.others {
            let list = &mut components.of_step[*s];
            if list.len() < REMEMBERED {
                list.push(number[index]);
            }
        }
    }
    let mut sets: Vec<Option<CoverSet>> = all.into_iter().map(|written| Some(written.set)).collect();
    let sets = order.into_iter().filter_map(|index| sets[index].take()).collect();
    (components, Cover { sets, of_step })
}

/// What lies around each step.
struct Surroundings<'a> {
    arcs: &'a Arcs,
    /// The orders that force a step, numbered through the net.
    forced_by: IndexVec<StepId, Vec<usize>>,
    /// How many orders there are that force a set of steps.
    orders: usize,
}

impl<'a> Surroundings<'a> {
    fn new(net: &Net, arcs: &'a Arcs) -> Self {
        let forced_by = net.places.iter().map(|_| Vec::new()).collect();
        let mut around = Surroundings { arcs, forced_by, orders: 0 };
        for grafcet in &net.grafcets {
            for steps in forced(grafcet) {
                steps.iter().for_each(|s| around.forced_by[*s].push(around.orders));
                around.orders += 1;
            }
        }
        around
    }

    fn entering(&self, s: StepId) -> &'a [TransitionId] {
        self.arcs.entering(s)
    }

    fn leaving(&self, s: StepId) -> &'a [TransitionId] {
        self.arcs.leaving(s)
    }
}

/// The sets of steps that orders force on a grafcet.
fn forced(grafcet: &Grafcet) -> impl Iterator<Item = &[StepId]> {
    grafcet.orders.iter().filter_map(|order| match &order.forced {
        Forced::Steps(steps) => Some(steps.as_slice()),
        Forced::Current => None,
    })
}
