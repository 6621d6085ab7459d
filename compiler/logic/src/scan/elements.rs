//! The elements of the chart that statements come from, beside steps and variables.

use super::{
    ActionId, Heading, Held, OrderId, Origin, Program, Role, Statement, StepId, TimerId, Told, TransitionId, VarId,
    Variable,
};
use ecow::EcoString;
use grafc_diagnostics::Span;
use grafc_formula::{FormulaId, Pool, Value};
use grafc_model::chart::{GrafcetId, Note, VariableId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::ops::Range;

/// Transitions, actions and orders of the chart.
#[derive(Clone, Debug, Default)]
pub struct Elements {
    /// Transitions; those that a pass has added come last and are none of the chart.
    pub transitions: IndexVec<TransitionId, Transition>,
    /// Actions.
    pub actions: IndexVec<ActionId, Action>,
    /// Forcing orders.
    pub orders: IndexVec<OrderId, Order>,
    /// Grafcets.
    pub grafcets: IndexVec<GrafcetId, Grafcet>,
    /// The steps around transitions.
    around: Vec<StepId>,
    /// The grafcet of each step of the chart.
    grafcet_of: IndexVec<StepId, GrafcetId>,
    /// The steps that set each variable by continuous actions, if that was asked for.
    setters: FxHashMap<VariableId, Vec<StepId>>,
    /// Labels of steps that a pass has added, which come after those of the chart.
    added: Vec<EcoString>,
}

/// A partial grafcet.
#[derive(Clone, Debug)]
pub struct Grafcet {
    /// The name.
    pub name: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
}

impl Grafcet {
    /// How it is headed: `G1: the cycle`.
    pub fn title(&self) -> String {
        match &self.comment {
            Some(comment) => format!("{}: {comment}", self.name),
            None => self.name.to_string(),
        }
    }
}

/// A transition.
#[derive(Clone, Debug)]
pub struct Transition {
    /// The designation.
    pub designation: Option<Note>,
    /// The attached comment.
    pub comment: Option<Note>,
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
    /// When it is done.
    pub when: When,
    /// What it assigns.
    pub target: VariableId,
    /// The action in the chart.
    pub span: Span,
}

/// When an action is done.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum When {
    /// While its step is active.
    Active,
    /// On an event while its step is active.
    Event,
    /// On deactivation of its step.
    Deactivation,
    /// On clearing of its transition.
    Clearing,
    /// On activation of its step.
    Activation,
    /// Each scan, while its step is active.
    EachScan,
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
        let continuous = net.continuous.iter().map(|a| Action {
            of: Origin::Step(a.step),
            when: When::Active,
            target: a.target,
            span: a.span,
        });
        let stored = net.stored.iter().map(|a| {
            let (of, when) = match a.event {
                Event::Event(s, _) => (Origin::Step(s), When::Event),
                Event::Deactivation(s) => (Origin::Step(s), When::Deactivation),
                Event::Clearing(t) => (Origin::Transition(t), When::Clearing),
                Event::Activation(s) => (Origin::Step(s), When::Activation),
                Event::EachScan(s, _) => (Origin::Step(s), When::EachScan),
            };
            Action { of, when, target: a.target, span: a.span }
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
        let grafcets = net.grafcets.iter();
        elements.grafcets = grafcets.map(|g| Grafcet { name: g.name.clone(), comment: g.comment.clone() }).collect();
        elements.grafcet_of = net.places.iter().map(|place| place.grafcet).collect();
        elements.added = net.places.iter().filter(|place| place.auxiliary).map(|place| place.label.clone()).collect();
        elements
    }

    /// Adds a transition.
    pub fn transition(
        &mut self,
        designation: Option<Note>,
        comment: Option<Note>,
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

    /// Finds which steps set each variable.
    pub(crate) fn find_setters(&mut self, net: &Net) {
        for action in &net.continuous {
            let steps = self.setters.entry(action.target).or_default();
            if steps.last() != Some(&action.step) {
                steps.push(action.step);
            }
        }
    }

    /// Whether the chart has several grafcets, so that it is said of each part which one it is about.
    pub fn has_several_grafcets(&self) -> bool {
        self.grafcets.len() > 1
    }

    /// The grafcet of a step, if it is known.
    pub fn grafcet_of(&self, step: StepId) -> Option<GrafcetId> {
        self.grafcet_of.get(step).copied()
    }

    /// A word for a transition: its designation, or the first steps around it.
    pub(super) fn word<'l>(&self, transition: TransitionId, label: impl Fn(StepId) -> &'l str) -> EcoString {
        let Transition { designation, before, after, .. } = &self.transitions[transition];
        let steps = self.steps(before).iter().take(1).chain(self.steps(after).iter().take(1));
        let labels = || steps.map(|s| label(*s)).collect::<Vec<_>>().join("_").into();
        designation.as_ref().map_or_else(labels, |designation| designation.text().clone())
    }

    /// The steps before a transition, and those after it.
    pub fn around(&self, transition: TransitionId) -> (&[StepId], &[StepId]) {
        let Transition { before, after, .. } = &self.transitions[transition];
        (self.steps(before), self.steps(after))
    }

    fn steps(&self, range: &Range<u32>) -> &[StepId] {
        &self.around[range.start as usize..range.end as usize]
    }
}

/// Most transitions are written with so many bytes.
const USUAL: usize = 32;

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
            Role::Step | Role::State | Role::Flag(_) | Role::Memory | Role::Temporary | Role::Observed => Origin::Chart,
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
                Statement::Heading(_) | Statement::Case { .. } | Statement::If(_) => continue,
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
        let mut arrow = String::with_capacity(USUAL);
        for (range, sign) in [(before, " -> "), (after, "")] {
            for (place, s) in self.elements.steps(range).iter().enumerate() {
                arrow.push_str(if place > 0 { ", " } else { "" });
                arrow.push_str(self.label(*s));
            }
            arrow.push_str(sign);
        }
        let trimmed = arrow.trim();
        if trimmed.len() == arrow.len() { arrow } else { trimmed.to_owned() }
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

    /// When an action is done, in words.
    fn occasion(&self, action: &Action) -> String {
        let of = match action.of {
            Origin::Step(s) => self.label(s).to_owned(),
            Origin::Transition(t) => self.arrow(t),
            Origin::Chart
            | Origin::Action(_)
            | Origin::Actions(_)
            | Origin::Order(_)
            | Origin::Orders(_)
            | Origin::Declaration(_) => String::new(),
        };
        match action.when {
            When::Active => of,
            When::Event => format!("event in {of}"),
            When::Deactivation => format!("deactivation of {of}"),
            When::Clearing => format!("clearing of {of}"),
            When::Activation => format!("activation of {of}"),
            When::EachScan => format!("each scan in {of}"),
        }
    }

    /// The steps that set a variable, the first ones.
    fn steps_on(&self, variable: VariableId) -> String {
        const NAMED: usize = 6;
        let steps = self.elements.setters.get(&variable).map_or(&[][..], Vec::as_slice);
        let rest = steps.len().checked_sub(NAMED).filter(|rest| *rest > 0).map(|_| "…");
        steps.iter().take(NAMED).map(|s| self.label(*s)).chain(rest).collect::<Vec<_>>().join(", ")
    }

    /// The words of a heading.
    pub fn heading(&self, heading: Heading) -> Cow<'static, str> {
        let words = heading.text();
        match heading {
            Heading::Of(_, g) => format!("{words} in {}", self.elements.grafcets[g].title()).into(),
            Heading::FlagsAreLowered
            | Heading::StartsAnew
            | Heading::OutputsOnArcs
            | Heading::Conditions
            | Heading::MemoryOfEdges
            | Heading::TransitionsThatClear
            | Heading::Transitions
            | Heading::NextSituation
            | Heading::FrozenGrafcets
            | Heading::EnclosuresAndOrders
            | Heading::StoredActions
            | Heading::OutputsOfTheSteps
            | Heading::Situation
            | Heading::WhatTheClearingsBringAbout
            | Heading::TimersOfTheStepBefore
            | Heading::TimersOfTheActiveStep
            | Heading::Outputs
            | Heading::OutputsAfterLivelock
            | Heading::Assertions
            | Heading::WhatIsSeenOfTransitions
            | Heading::WhatIsSeenOfTheSituation
            | Heading::WhatIsSeenOfActions => words.into(),
        }
    }

    /// Whether anything is said beside a statement of where it comes from.
    pub fn says(&self, origin: Origin, told: Told) -> bool {
        match (told, origin) {
            (Told::Nothing, _) => false,
            (Told::Comment, Origin::Step(s)) => self.steps.get(s).is_some_and(|step| step.comment.is_some()),
            (Told::Name | Told::All | Told::Comment | Told::Steps | Told::Before(_), _) => true,
        }
    }

    /// What is said beside a statement of where it comes from.
    pub fn remark(&self, origin: Origin, told: Told) -> Option<String> {
        let (name, comment) = match (origin, told) {
            (_, Told::Nothing) => return None,
            (_, Told::Before(read)) => {
                let read = self.variables.get(VarId::from_usize(read.index()));
                return read.map(|v| format!("reads {} before that is written", v.name));
            }
            (Origin::Step(s), Told::Comment) => {
                return self.steps.get(s).and_then(|step| step.comment.as_ref()).map(ToString::to_string);
            }
            (Origin::Step(s), _) => {
                (format!("step {}", self.label(s)), self.steps.get(s).and_then(|step| step.comment.as_deref()))
            }
            (Origin::Action(a), Told::Name) => return self.elements.actions.get(a).map(|action| self.occasion(action)),
            (Origin::Action(a), Told::Steps) => {
                return self.elements.actions.get(a).map(|action| self.steps_on(action.target));
            }
            (Origin::Actions(v), Told::Steps) => return Some(self.steps_on(v)),
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
