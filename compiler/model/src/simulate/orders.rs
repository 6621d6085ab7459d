//! R2: the forcing orders in force in a situation, and what they freeze.

use super::Activity;
use crate::chart::{Chart, GrafcetId, Situation, StepId};
use index_vec::IndexVec;

/// The orders of each grafcet by precedence: level of the forcing step's grafcet, then declaration.
#[derive(Clone, Debug)]
pub(super) struct Orders {
    by_grafcet: IndexVec<GrafcetId, Vec<Rank>>,
}

/// One order.
#[derive(Clone, Debug)]
struct Rank {
    step: StepId,
    forced: Forced,
}

/// What an order asks for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Forced {
    /// Exactly these steps, in order of declaration; `{}` and `{INIT}` are such sets too.
    Steps(Vec<StepId>),
    /// `{*}`: the current situation.
    Current,
}

/// The order in force on a grafcet.
#[derive(Clone, Copy, Debug)]
pub(super) struct InForce<'a> {
    /// What it asks for.
    pub forced: &'a Forced,
    /// Whether an order of lower precedence asks for something else.
    pub conflict: bool,
}

impl Orders {
    pub fn new(chart: &Chart) -> Self {
        let mut ranked: IndexVec<GrafcetId, Vec<(u32, Rank)>> = chart.grafcets.iter().map(|_| Vec::new()).collect();
        for order in &chart.orders {
            let level = chart.grafcets[chart.steps[order.step].grafcet].level;
            let forced = match &order.situation {
                Situation::Steps(steps) => {
                    let mut steps = steps.clone();
                    steps.sort_unstable();
                    steps.dedup();
                    Forced::Steps(steps)
                }
                Situation::Current => Forced::Current,
                Situation::Initial => {
                    let steps = &chart.grafcets[order.grafcet].steps;
                    let mut initial: Vec<StepId> =
                        steps.iter().copied().filter(|&step| chart.steps[step].initial).collect();
                    initial.sort_unstable();
                    Forced::Steps(initial)
                }
            };
            ranked[order.grafcet].push((level, Rank { step: order.step, forced }));
        }
        for orders in &mut ranked {
            // Stable: orders of one level stay in order of declaration.
            orders.sort_by_key(|&(level, _)| level);
        }
        let strip = |orders: Vec<(u32, Rank)>| orders.into_iter().map(|(_, rank)| rank).collect();
        Orders { by_grafcet: ranked.into_iter().map(strip).collect() }
    }

    /// The order in force on a grafcet in a situation.
    pub fn in_force(&self, grafcet: GrafcetId, active: &Activity) -> Option<InForce<'_>> {
        let mut candidates = self.by_grafcet[grafcet].iter().filter(|order| active[order.step]);
        let first = candidates.next()?;
        let conflict = candidates.any(|other| other.forced != first.forced);
        Some(InForce { forced: &first.forced, conflict })
    }

    /// For each grafcet whether it is frozen: by an order on it, or because its enclosing step's grafcet is.
    pub fn frozen(&self, chart: &Chart, active: &Activity) -> IndexVec<GrafcetId, bool> {
        let mut frozen: IndexVec<GrafcetId, bool> = chart.grafcets.iter().map(|_| false).collect();
        if chart.orders.is_empty() {
            return frozen;
        }
        for &grafcet in &chart.hierarchy {
            frozen[grafcet] = self.in_force(grafcet, active).is_some()
                || chart.grafcets[grafcet].enclosing_step.is_some_and(|step| frozen[chart.steps[step].grafcet]);
        }
        frozen
    }
}
