//! Which steps share a variable: given to the lowering, which holds the situation accordingly.

use grafc_model::chart::{GrafcetId, StepId};
use grafc_net::Net;
use grafc_net::net::Forced;
use index_vec::IndexVec;

/// A partition of steps into sets that exclude each other; what is in none stays a bit.
#[derive(Clone, Debug)]
pub(crate) struct Cover {
    /// By their first step.
    pub(crate) sets: Vec<CoverSet>,
    /// The set that holds a step.
    pub(crate) of_step: IndexVec<StepId, Option<usize>>,
}

/// Steps of one component.
#[derive(Clone, Debug)]
pub(crate) struct CoverSet {
    /// In order of declaration.
    pub(crate) steps: Vec<StepId>,
    /// Whether exactly one of them is active, always.
    pub(crate) always_marked: bool,
}

impl Cover {
    /// With a set of its own for each further step that is alone in holding a token.
    pub(crate) fn with_lone(&self, is_alone: impl Fn(StepId) -> bool) -> Cover {
        let mut cover = self.clone();
        for s in self.of_step.indices().filter(|s| self.of_step[*s].is_none() && is_alone(*s)) {
            cover.of_step[s] = Some(cover.sets.len());
            cover.sets.push(CoverSet { steps: vec![s], always_marked: false });
        }
        cover
    }

    /// The same without sets that are better held by bits: those of one step and, in a small chart whose transitions do not
    /// write states at once, short ones beside others whose steps have no comment, since their bits share a line.
    pub(crate) fn worth_a_number(&self, net: &Net, short_text: bool) -> Cover {
        let alone = self.sets.first().is_some_and(|set| set.steps.len() == net.places.len());
        let frees_short_ones = short_text && !alone;
        let short = |set: &CoverSet| {
            frees_short_ones && set.steps.len() < FEW && set.steps.iter().all(|s| net.places[*s].comment.is_none())
        };
        let worth = |set: &&CoverSet| set.steps.len() > 1 && !short(set);
        let sets: Vec<CoverSet> = self.sets.iter().filter(worth).cloned().collect();
        let mut of_step: IndexVec<StepId, Option<usize>> = self.of_step.iter().map(|_| None).collect();
        for (index, set) in sets.iter().enumerate() {
            set.steps.iter().for_each(|s| of_step[*s] = Some(index));
        }
        Cover { sets, of_step }
    }

    /// Whether nothing has to wait: without enclosures, forced situations and stored actions, and with a set for every
    /// step, a transition moves its states and switches their outputs itself.
    pub(crate) fn moves_in_place(&self, net: &Net) -> bool {
        let enclosed = net.places.iter().any(|place| !place.within.is_empty());
        let covered = self.of_step.iter().all(Option::is_some) && self.sets.iter().any(|set| set.steps.len() > 1);
        covered
            && !enclosed
            && !net.has_commands()
            && net.stored.is_empty()
            && net.grafcets.indices().all(|g| !is_forced(net, g))
    }
}

/// A set of fewer steps takes less lines without arms.
pub(crate) const FEW: usize = 5;

/// In a chart of fewer steps, what does not have to be done costs less than to find that out.
const SMALL: usize = 20;

/// Whether a chart is small.
pub(crate) fn is_small(net: &Net) -> bool {
    net.places.len() < SMALL
}

/// Whether an order sets the situation of a grafcet.
pub(crate) fn is_forced(net: &Net, g: GrafcetId) -> bool {
    net.grafcets[g].orders.iter().any(|order| matches!(order.forced, Forced::Steps(_)))
}
