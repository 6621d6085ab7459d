//! A net in an order of its own, which the text does not decide: steps by their labels, transitions by the steps around
//! them. What is searched for in this order is found whatever the order of declaration is.
//!
//! Shorter labels come first, so that step 2 stands before step 10 as an author would write them.

use grafc_model::chart::{Claims, Controls, GrafcetId, StepId, TransitionId};
use grafc_net::net::{Forced, Grafcet, Place, Steps, Transition};
use grafc_net::{Arcs, Net};
use index_vec::IndexVec;
use std::borrow::Cow;

/// What the search for components needs of a net, its ids in canonical order.
pub(crate) struct Canonical<'a> {
    /// Of its tables only steps, transitions, and grafcets with their steps and orders are meant.
    pub(crate) net: Cow<'a, Net>,
    pub(crate) arcs: Cow<'a, Arcs>,
    /// The ids in the net that it was made of.
    pub(crate) step: IndexVec<StepId, StepId>,
    pub(crate) transition: IndexVec<TransitionId, TransitionId>,
    /// The other way round.
    pub(crate) rank: IndexVec<StepId, StepId>,
    pub(crate) transition_rank: IndexVec<TransitionId, TransitionId>,
}

impl<'a> Canonical<'a> {
    /// Of a flat net and its arcs. Most charts are written in this order: then it is the net itself.
    pub(crate) fn new(net: &'a Net, arcs: &'a Arcs) -> Canonical<'a> {
        let mut steps: Vec<StepId> = net.places.indices().collect();
        steps.sort_by(|a, b| {
            let key = |s: StepId| {
                let (place, grafcet) = (&net.places[s], &net.grafcets[net.places[s].grafcet]);
                (place.label.len(), place.label.as_str(), grafcet.name.as_str(), s)
            };
            key(*a).cmp(&key(*b))
        });
        if steps.is_sorted() && is_sorted(net) {
            return Canonical {
                net: Cow::Borrowed(net),
                arcs: Cow::Borrowed(arcs),
                step: steps.iter().copied().collect(),
                transition: net.transitions.indices().collect(),
                rank: steps.into_iter().collect(),
                transition_rank: net.transitions.indices().collect(),
            };
        }
        let mut rank: IndexVec<StepId, StepId> = net.places.indices().collect();
        for (number, s) in steps.iter().enumerate() {
            rank[*s] = StepId::from_usize(number);
        }
        let ranked = |steps: &[StepId]| {
            let mut ranked: Vec<StepId> = steps.iter().map(|s| rank[*s]).collect();
            ranked.sort_unstable();
            ranked
        };
        let side = |steps: &[StepId]| {
            let mut side: Steps = steps.iter().map(|s| rank[*s]).collect();
            side.sort_unstable();
            side
        };
        let mut transitions: Vec<(Steps, Steps, TransitionId)> =
            net.transitions.iter_enumerated().map(|(id, t)| (side(&t.pre), side(&t.post), id)).collect();
        transitions.sort_unstable();
        let mut transition_rank: IndexVec<TransitionId, TransitionId> = net.transitions.indices().collect();
        for (number, (.., t)) in transitions.iter().enumerate() {
            transition_rank[*t] = TransitionId::from_usize(number);
        }
        let transition = transitions.iter().map(|(.., t)| *t).collect();
        let places = steps.iter().map(|s| bare_place(&net.places[*s], &side)).collect();
        let transitions = transitions.into_iter().map(|(pre, post, t)| {
            let Transition { grafcet, ref within, condition, auxiliary, span, .. } = net.transitions[t];
            let within = side(within);
            Transition { designation: None, comment: None, grafcet, pre, post, within, condition, auxiliary, span }
        });
        let grafcets: IndexVec<GrafcetId, Grafcet> = net.grafcets.iter().map(|g| bare_grafcet(g, &ranked)).collect();
        let net = Net {
            name: net.name.clone(),
            comment: None,
            options: net.options.clone(),
            variables: IndexVec::new(),
            places,
            transitions: transitions.collect(),
            grafcets,
            hierarchy: Vec::new(),
            macro_steps: IndexVec::new(),
            continuous: Vec::new(),
            stored: Vec::new(),
            orders: Vec::new(),
            pulses: Vec::new(),
            runs: Vec::new(),
            conflict_at_start: net.conflict_at_start,
            exprs: IndexVec::new(),
            claims: Claims::default(),
            controls: Controls::default(),
            facts: net.facts.clone(),
        };
        let arcs = Cow::Owned(Arcs::of(&net, |_| true));
        Canonical { net: Cow::Owned(net), arcs, step: steps.into_iter().collect(), transition, rank, transition_rank }
    }
}

/// Whether the lists of steps and the transitions stand in the order of the steps.
fn is_sorted(net: &Net) -> bool {
    let sides = || net.transitions.iter().map(|t| (t.pre.as_slice(), t.post.as_slice()));
    let forced = net.grafcets.iter().flat_map(|g| &g.orders).filter_map(|order| match &order.forced {
        Forced::Steps(steps) => Some(steps),
        Forced::Current => None,
    });
    sides().is_sorted()
        && sides().all(|(pre, post)| pre.is_sorted() && post.is_sorted())
        && net.grafcets.iter().map(|g| &g.steps).chain(forced).all(|steps| steps.is_sorted())
}

fn bare_place(place: &Place, ranked: &impl Fn(&[StepId]) -> Steps) -> Place {
    Place { comment: None, within: ranked(&place.within), ..place.clone() }
}

fn bare_grafcet(grafcet: &Grafcet, ranked: &impl Fn(&[StepId]) -> Vec<StepId>) -> Grafcet {
    let mut bare = Grafcet { comment: None, steps: ranked(&grafcet.steps), ..grafcet.clone() };
    for order in &mut bare.orders {
        if let Forced::Steps(steps) = &mut order.forced {
            *steps = ranked(steps);
        }
    }
    bare
}
