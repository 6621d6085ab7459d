//! A net in an order of its own, which the text does not decide: steps by their labels, transitions by the steps around
//! them. What is searched for in this order is found whatever the order of declaration is.
//!
//! Shorter labels come first, so that step 2 stands before step 10 as an author would write them.

use grafc_model::chart::{Claims, Controls, GrafcetId, StepId, TransitionId};
use grafc_net::net::{Forced, Grafcet, Place, Steps, Transition};
use grafc_net::{Arcs, Net};
use index_vec::IndexVec;

/// What the search for components needs of a net, its ids in canonical order.
pub(crate) struct Canonical {
    /// Steps, transitions, and grafcets with their steps and orders; all other tables are empty.
    pub(crate) net: Net,
    pub(crate) arcs: Arcs,
    /// The ids in the net that it was made of.
    pub(crate) step: IndexVec<StepId, StepId>,
    pub(crate) transition: IndexVec<TransitionId, TransitionId>,
    /// The other way round.
    pub(crate) rank: IndexVec<StepId, StepId>,
    pub(crate) transition_rank: IndexVec<TransitionId, TransitionId>,
}

impl Canonical {
    /// Of a flat net.
    pub(crate) fn new(net: &Net) -> Canonical {
        let mut steps: Vec<StepId> = net.places.indices().collect();
        steps.sort_by(|a, b| {
            let key = |s: StepId| {
                let (place, grafcet) = (&net.places[s], &net.grafcets[net.places[s].grafcet]);
                (place.label.len(), place.label.as_str(), grafcet.name.as_str(), s)
            };
            key(*a).cmp(&key(*b))
        });
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
        let places = steps.iter().map(|s| bare_place(&net.places[*s], &rank)).collect();
        let transitions = transitions.into_iter().map(|(pre, post, t)| {
            let Transition { grafcet, within, condition, span, .. } = net.transitions[t];
            let within = within.map(|s| rank[s]);
            Transition { designation: None, comment: None, grafcet, pre, post, within, condition, span }
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
        let arcs = Arcs::of(&net, |_| true);
        Canonical { net, arcs, step: steps.into_iter().collect(), transition, rank, transition_rank }
    }
}

fn bare_place(place: &Place, rank: &IndexVec<StepId, StepId>) -> Place {
    Place { comment: None, within: place.within.map(|s| rank[s]), ..place.clone() }
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
