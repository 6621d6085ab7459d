//! The reference simulator: the rules of the semantics, literally, one group of rules a file.
//!
//! | rules | file |
//! | --- | --- |
//! | M1 macro-steps | `flat` |
//! | X1-X6 expressions | `plan` (what is evaluated when), `context`, `delay`, `arithmetic` |
//! | R2 orders in force | `orders` |
//! | R5 settling | `settle` |
//! | R7 stored actions | `stored` |
//! | R15 pulse orders | `pulses` |
//! | R1, R3, R4, R6, R8 micro-step | `micro_step` |
//! | R9-R14 reactions | `reaction` |
//! | R12 when time alone changes something | `events` |
//!
//! `run` calls a chart over a whole trace, `probe` looks at more than its outputs, `claims` at what is claimed of it.
//!
//! It is the oracle of the compiler's tests: plain before fast, and sharing no code with the lowering of charts. It
//! neither panics nor recurses, whatever the chart.

mod arithmetic;
mod claims;
mod condition;
mod context;
mod delay;
mod events;
mod flat;
mod micro_step;
mod orders;
mod plan;
mod probe;
mod pulses;
mod reaction;
mod run;
mod seen;
mod settle;
mod stored;
#[cfg(test)]
mod tests;

use crate::chart::{Chart, ExprId, GrafcetId, Mode, StepId, TransitionId, Value, Variable, VariableId};
use crate::reaction::{Flags, Profile};
use claims::Watched;
use context::Values;
use delay::Delay;
use flat::Flat;
use index_vec::IndexVec;
use orders::Orders;
use plan::Plan;
pub use probe::Probe;
use pulses::Commands;
pub use run::{Call, Calls, MOST_CALLS, Observer, Onlooker, Run};
pub use seen::Seen;

/// Whether each step is active.
pub type Activity = IndexVec<StepId, bool>;

/// The state of A2: nothing else survives from one micro-step to the next.
#[derive(Clone, PartialEq, Debug)]
pub struct State {
    /// `X`: the situation.
    active: Activity,
    /// `V` and `I`: stored variables, inputs, and what never changes; entries of wires are not read.
    variables: IndexVec<VariableId, Value>,
    /// `τ`: when each step was last activated.
    since: IndexVec<StepId, i64>,
    /// `D`: the memory of each delay; other entries are not read.
    delays: IndexVec<ExprId, Delay>,
    /// `m`: the operand of each edge in the context before; other entries are not read.
    edges: IndexVec<ExprId, bool>,
    /// `saved`: the steps that were active when their grafcet was frozen by a pulse order (R15).
    saved: Activity,
    /// `fr`: the grafcets that are frozen so.
    frozen: IndexVec<GrafcetId, bool>,
}

/// A chart that is being run.
#[derive(Clone, Debug)]
pub struct Simulator<'a> {
    chart: &'a Chart,
    profile: Profile,
    flat: Flat,
    orders: Orders,
    commands: Commands,
    plan: Plan,
    state: State,
    /// The inputs of the reaction before; none before the first.
    previous: Option<Vec<Value>>,
    flags: Flags,
    /// The outputs of the latest reaction; none before the first.
    shown: Vec<Value>,
    /// The transitions that the latest micro-step cleared.
    cleared: IndexVec<TransitionId, bool>,
    /// What is seen of the latest micro-step, if somebody looks on.
    seen: Option<Box<Seen>>,
    /// Whether the next micro-step is the first one after the start, whose actions are seen with it.
    begins: bool,
    /// What is known of claims, if somebody looks at them.
    watched: Option<Box<Watched>>,
    /// Values of the latest context; those that a context reads it has written before.
    values: Values,
    /// The same with all edges replaced by 0.
    level_values: Values,
}

impl State {
    /// That before the initial reaction.
    fn new(chart: &Chart) -> Self {
        State {
            active: chart.steps.iter().map(|_| false).collect(),
            variables: chart.variables.iter().map(|variable| variable.initial()).collect(),
            since: chart.steps.iter().map(|_| 0).collect(),
            delays: chart.exprs.iter().map(|_| Delay::default()).collect(),
            edges: chart.exprs.iter().map(|_| false).collect(),
            saved: chart.steps.iter().map(|_| false).collect(),
            frozen: chart.grafcets.iter().map(|_| false).collect(),
        }
    }

    /// The steps that were active when pulse orders froze their grafcets, and the grafcets that are frozen so (R15).
    pub fn saved(&self) -> (&Activity, &IndexVec<GrafcetId, bool>) {
        (&self.saved, &self.frozen)
    }

    /// The active steps.
    pub fn situation(&self) -> &Activity {
        &self.active
    }

    /// The values of inputs, constants and stored variables; what stands for others means nothing.
    pub fn variables(&self) -> &IndexVec<VariableId, Value> {
        &self.variables
    }
}

impl<'a> Simulator<'a> {
    /// A chart before its initial reaction.
    ///
    /// What its heading chooses goes before what the profile says.
    pub fn new(chart: &'a Chart, profile: Profile) -> Self {
        let mut simulator = Simulator {
            chart,
            profile: chart.options.over(profile),
            flat: Flat::new(chart),
            orders: Orders::new(chart),
            commands: Commands::new(chart),
            plan: Plan::new(chart),
            state: State::new(chart),
            previous: None,
            flags: Flags::default(),
            shown: Vec::new(),
            cleared: chart.transitions.iter().map(|_| false).collect(),
            seen: None,
            begins: false,
            watched: None,
            values: Values::new(chart),
            level_values: Values::new(chart),
        };
        if chart.controls.assertion.is_some() {
            simulator.watch_claims();
        }
        simulator
    }

    /// R10, after a restart of the controller or a reset: what is retained may keep its value, and all the rest is as
    /// before the initial reaction, which comes next.
    fn restart(&mut self, keeps_retained: bool) {
        let before = std::mem::replace(&mut self.state, State::new(self.chart));
        let kept = |variable: &Variable| variable.retain && keeps_retained;
        for (id, variable) in self.chart.variables.iter_enumerated().filter(|(_, variable)| kept(variable)) {
            if variable.mode != Mode::Wire {
                self.state.variables[id] = before.variables[id];
            }
        }
        self.previous = None;
        self.flags = Flags::default();
        self.shown.clear();
        if let Some(watched) = &mut self.watched {
            watched.forget();
        }
    }

    /// The state after the latest reaction, or the latest micro-step of one that is observed.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Whether the latest micro-step cleared each transition.
    pub fn cleared(&self) -> &IndexVec<TransitionId, bool> {
        &self.cleared
    }

    /// The flags raised so far.
    pub fn flags(&self) -> Flags {
        self.flags
    }
}
