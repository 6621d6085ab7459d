//! The elements of the chart that statements come from, beside steps and variables.

use super::{Held, Origin, Program, Role, Statement, StepId, TimerId, Told, TransitionId, VarId, Variable};
use ecow::EcoString;
use grafc_diagnostics::Span;
use grafc_formula::{FormulaId, Pool, Value};
use grafc_model::chart::{GrafcetId, VariableId};
use grafc_net::Net;
use index_vec::{IndexVec, define_index_type};
use rustc_hash::FxHashMap;
use std::ops::Range;

define_index_type! {
    /// An action of the chart: the continuous ones, then the stored ones, each in order of declaration.
    pub struct ActionId = u32;
    DISPLAY_FORMAT = "a{}";
    DEBUG_FORMAT = "a{}";
}

define_index_type! {
    /// A forcing order: those on one grafcet after those on another, the one that wins first.
    pub struct OrderId = u32;
    DISPLAY_FORMAT = "o{}";
    DEBUG_FORMAT = "o{}";
}

/// Transitions, actions and orders of the chart.
#[derive(Clone, Debug, Default)]
pub struct Elements {
    /// Transitions; those that a pass has added come last and are none of the chart.
    pub transitions: IndexVec<TransitionId, Transition>,
    /// Actions.
    pub actions: IndexVec<ActionId, Action>,
    /// Forcing orders.
    pub orders: IndexVec<OrderId, Order>,
    /// The steps around transitions.
    around: Vec<StepId>,
    /// Labels of steps that a pass has added, which come after those of the chart.
    added: Vec<EcoString>,
}

/// A transition.
#[derive(Clone, Debug)]
pub struct Transition {
    /// The designation.
    pub designation: Option<EcoString>,
    /// The attached comment.
    pub comment: Option<EcoString>,
    /// The item in the chart.
    pub span: Span,
    before: Range<u32>,
    after: Range<u32>,
}

/// An action.
#[derive(Clone, Copy, Debug)]
pub struct Action {
    /// The step or the transition that it belongs to.
    pub of: Origin,
    /// What it assigns.
    pub target: VariableId,
    /// The action in the chart.
    pub span: Span,
}

/// A forcing order.
#[derive(Clone, Debug)]
pub struct Order {
    /// The step that it belongs to.
    pub step: StepId,
    /// The grafcet that it forces.
    pub grafcet: GrafcetId,
    /// The name of that.
    pub name: EcoString,
    /// The order in the chart.
    pub span: Span,
}

impl Elements {
    /// The elements of a net.
    pub(crate) fn of(net: &Net) -> Self {
        use grafc_model::chart::Event;
        let mut elements = Elements::default();
        elements.transitions.reserve(net.transitions.len());
        for t in &net.transitions {
            elements.transition(t.designation.clone(), t.comment.clone(), t.span, &t.pre, &t.post);
        }
        let continuous =
            net.continuous.iter().map(|a| Action { of: Origin::Step(a.step), target: a.target, span: a.span });
        let stored = net.stored.iter().map(|a| {
            let of = match a.event {
                Event::Event(s, _) | Event::Deactivation(s) | Event::Activation(s) => Origin::Step(s),
                Event::Clearing(t) => Origin::Transition(t),
            };
            Action { of, target: a.target, span: a.span }
        });
        elements.actions = continuous.chain(stored).collect();
        for (grafcet, of) in net.grafcets.iter_enumerated() {
            let orders = of.orders.iter();
            elements.orders.extend(orders.map(|o| Order {
                step: o.step,
                grafcet,
                name: of.name.clone(),
                span: o.span,
            }));
        }
        elements.added = net.places.iter().filter(|place| place.auxiliary).map(|place| place.label.clone()).collect();
        elements
    }

    /// Adds a transition.
    pub fn transition(
        &mut self,
        designation: Option<EcoString>,
        comment: Option<EcoString>,
        span: Span,
        before: &[StepId],
        after: &[StepId],
    ) -> TransitionId {
        let mut range = |steps: &[StepId]| {
            let start = self.around.len() as u32;
            self.around.extend_from_slice(steps);
            start..self.around.len() as u32
        };
        let (before, after) = (range(before), range(after));
        self.transitions.push(Transition { designation, comment, span, before, after })
    }

    fn steps(&self, range: &Range<u32>) -> &[StepId] {
        &self.around[range.start as usize..range.end as usize]
    }
}

/// Where the variables and timers of a program come from.
#[derive(Clone, Debug)]
pub struct Origins {
    /// Variables.
    pub variables: IndexVec<VarId, Origin>,
    /// Timers.
    pub timers: IndexVec<TimerId, Origin>,
    /// The state that each variable takes its values from.
    states: FxHashMap<VarId, usize>,
    /// The step that a value of a state stands for.
    steps: FxHashMap<(usize, i64), StepId>,
}

impl Origins {
    /// What an assignment is about, whatever it comes from: the step that it writes, or the variable.
    pub fn written(&self, pool: &Pool, target: VarId, value: FormulaId) -> Origin {
        let Some(state) = self.states.get(&target) else { return self.variables[target] };
        match pool.as_constant(value) {
            Some(Value::Int(n)) => self.steps.get(&(*state, n)).map_or(Origin::Chart, |s| Origin::Step(*s)),
            _ => Origin::Chart,
        }
    }
}

impl Program {
    /// Where variables and timers come from: those of the chart from their declaration or step, others from what writes
    /// them first.
    pub fn origins(&self) -> Origins {
        let declared = |(id, variable): (VarId, &Variable)| match variable.role {
            Role::Input | Role::Output | Role::Internal | Role::Constant => Origin::declaration(id),
            Role::Step | Role::State | Role::Flag(_) | Role::Memory | Role::Temporary => Origin::Chart,
        };
        let mut variables: IndexVec<VarId, Origin> = self.variables.iter_enumerated().map(declared).collect();
        let mut timers: IndexVec<TimerId, Origin> = self.timers.iter().map(|_| Origin::Chart).collect();
        for (s, step) in self.steps.iter_enumerated() {
            if let Held::Bit(v) = step.held {
                variables[v] = Origin::Step(s);
            }
        }
        // A state, a flag and the mark of the first call belong to the chart as a whole, whatever writes them.
        let shared = |v: VarId| matches!(self.variables[v].role, Role::State | Role::Flag(_));
        let states = self.state_of();
        for statement in self.statements() {
            let (written, origin) = match statement {
                Statement::Assign { target, origin, .. } => (*target, *origin),
                Statement::Divide(division) => (division.target, division.origin),
                Statement::CallTimer { timer, origin, .. } => {
                    timers[*timer] = timers[*timer].or(*origin);
                    continue;
                }
                Statement::Heading(_) | Statement::Case { .. } | Statement::If { .. } => continue,
            };
            if !shared(written) && !states.contains_key(&written) {
                variables[written] = variables[written].or(origin);
            }
        }
        if let Some(repeat) = self.repeat {
            variables[repeat.again] = Origin::Chart;
        }
        let values = self.states.iter().enumerate();
        let steps =
            values.flat_map(|(place, state)| state.values.iter().map(move |(s, n)| ((place, *n), *s))).collect();
        Origins { variables, timers, states, steps }
    }

    /// Whether the chart has a transition, not a pass of ours: those that pass a step of ours on are no part of it.
    pub fn is_of_chart(&self, transition: TransitionId) -> bool {
        transition.index() + self.elements.added.len() < self.elements.transitions.len()
    }

    /// The label of a step.
    pub fn label(&self, step: StepId) -> &str {
        let added = || step.index().checked_sub(self.steps.len()).and_then(|place| self.elements.added.get(place));
        self.steps.get(step).map(|step| &step.label).or_else(added).map_or("", EcoString::as_str)
    }

    /// A transition as the chart writes it: `5, 8 -> 9`.
    pub fn arrow(&self, transition: TransitionId) -> String {
        let Transition { before, after, .. } = &self.elements.transitions[transition];
        let labels = |range: &Range<u32>| {
            self.elements.steps(range).iter().map(|s| self.label(*s)).collect::<Vec<_>>().join(", ")
        };
        format!("{} -> {}", labels(before), labels(after)).trim().to_owned()
    }

    /// Whether there is what a statement says that it comes from.
    pub fn has(&self, origin: Origin) -> bool {
        let elements = &self.elements;
        match origin {
            Origin::Chart => true,
            Origin::Step(s) => s.index() < self.steps.len() + elements.added.len(),
            Origin::Transition(t) => t < elements.transitions.len_idx(),
            Origin::Action(a) => a < elements.actions.len_idx(),
            Origin::Order(o) => o < elements.orders.len_idx(),
            Origin::Actions(v) | Origin::Declaration(v) => v.index() < self.variables.len(),
            // Freezing reaches grafcets on which no order acts.
            Origin::Orders(_) => true,
        }
    }

    /// What is said beside a statement of where it comes from.
    pub fn remark(&self, origin: Origin, told: Told) -> Option<String> {
        let (name, comment) = match (origin, told) {
            (_, Told::Nothing) => return None,
            (Origin::Step(s), _) => {
                (format!("step {}", self.label(s)), self.steps.get(s).and_then(|step| step.comment.as_deref()))
            }
            (Origin::Transition(t), _) => (self.arrow(t), self.elements.transitions[t].comment.as_deref()),
            (
                Origin::Chart
                | Origin::Action(_)
                | Origin::Actions(_)
                | Origin::Order(_)
                | Origin::Orders(_)
                | Origin::Declaration(_),
                _,
            ) => return None,
        };
        Some(match comment.filter(|_| told == Told::All) {
            Some(comment) => format!("{name}: {comment}"),
            None => name,
        })
    }
}
