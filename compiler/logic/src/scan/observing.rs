//! What a program shows of its last micro-step, for a target that lets somebody look on: which transitions were enabled and
//! which cleared (R3), and on demand what else is to be seen of a chart that runs.
//!
//! All of it stands in variables of the role `Observed`, which the program writes and never reads for anything else: a
//! target chooses how to show them.

use super::{GrafcetId, Origin, Preset, StepId, TimerId, TransitionId, VarId};

/// How much of its micro-steps a program shows.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub enum Observed {
    /// Nothing, as generated code on a controller.
    #[default]
    Nothing,
    /// Which transitions were enabled, and which cleared, if somebody asks.
    Transitions,
    /// And conditions, frozen grafcets, forced steps, actions, orders, internal wires and delays, at all times.
    All,
}

/// The variables that show it.
#[derive(Clone, Debug, Default)]
pub struct Observing {
    /// How much it is.
    pub observed: Observed,
    /// What is shown of transitions is written only while this is true, which the program itself never writes; none where it
    /// always is.
    pub wanted: Option<VarId>,
    /// The transitions of the chart, in order of declaration.
    pub transitions: Vec<SeenTransition>,
    /// For each grafcet that can be frozen, whether it is, in the situation reached (R2).
    pub frozen: Vec<(GrafcetId, VarId)>,
    /// For each step that an order can force or hold, whether it is active because one in force does so.
    pub forced: Vec<(StepId, VarId)>,
    /// For each order, by its place among the orders as the chart writes them, whether it is in force in the situation
    /// reached.
    pub orders: Vec<(usize, VarId)>,
    /// For each action, by its place among the actions as the chart writes them, whether it acts: a continuous one assigns
    /// in the outputs that are published, a stored one was done in the last micro-step or, in the first, at the start.
    pub actions: Vec<(usize, VarId)>,
    /// Delays, and the durations of steps that conditions compare with a time.
    pub delays: Vec<SeenDelay>,
}

/// What is seen of a transition in a micro-step.
#[derive(Clone, Copy, Debug)]
pub struct SeenTransition {
    /// The transition.
    pub transition: TransitionId,
    /// Whether all steps before it were active and what encloses it was, and nothing froze it.
    pub enabled: VarId,
    /// Whether it was enabled and its condition true, so that it cleared.
    pub cleared: VarId,
    /// Whether its condition was true, if all is shown.
    pub satisfied: Option<VarId>,
}

/// A delay, as it is seen.
#[derive(Clone, Debug)]
pub struct SeenDelay {
    /// What it is part of; of several actions on a variable the first.
    pub origin: Origin,
    /// If that is an action, its place among the actions as the chart writes them.
    pub action: Option<usize>,
    /// It, as a chart shows it.
    pub text: String,
    /// What measures it.
    pub timer: TimerId,
    /// When it is over.
    pub total: Preset,
    /// Of an off-delay, whether it holds what it delays; else the timer runs without meaning.
    pub held: Option<VarId>,
}

impl Observing {
    /// All variables that it names.
    pub(crate) fn each_variable(&mut self, mut visit: impl FnMut(&mut VarId)) {
        let Observing { observed: _, wanted, transitions, frozen, forced, orders, actions, delays } = self;
        wanted.iter_mut().for_each(&mut visit);
        for seen in transitions {
            [&mut seen.enabled, &mut seen.cleared].into_iter().chain(&mut seen.satisfied).for_each(&mut visit);
        }
        frozen.iter_mut().for_each(|(_, v)| visit(v));
        forced.iter_mut().for_each(|(_, v)| visit(v));
        orders.iter_mut().chain(actions).for_each(|(_, v)| visit(v));
        for delay in delays {
            delay.held.iter_mut().chain(&mut delay.total.constant).for_each(&mut visit);
        }
    }
}
