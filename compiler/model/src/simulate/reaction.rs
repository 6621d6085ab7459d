//! R9-R14: reactions.

use super::arithmetic::convert;
use super::plan::{Memory, Valued};
use super::pulses::{Occurred, Pulses};
use super::settle::{Conflict, Phase, settle};
use super::stored::allocate;
use super::{Simulator, State};
use crate::chart::{Event, Mode, Stored, Value, VariableId, VariableKind};
use crate::reaction::{Evolution, Flags, LivelockOutputs, Response, Stimulus};

/// What looks on, if somebody does.
type Observer<'o, 'a> = Option<&'o mut dyn FnMut(&Simulator<'a>)>;

impl<'a> Simulator<'a> {
    /// Reacts to inputs at an instant; the first call is the initial reaction.
    pub fn react(&mut self, stimulus: &Stimulus) -> Response {
        self.reaction(stimulus, None)
    }

    /// The same, shown from within: `observe` sees the simulator once it has started and after each micro-step.
    pub fn react_observed(&mut self, stimulus: &Stimulus, observe: &mut dyn FnMut(&Simulator<'a>)) -> Response {
        self.reaction(stimulus, Some(observe))
    }

    fn reaction(&mut self, stimulus: &Stimulus, mut observe: Observer<'_, 'a>) -> Response {
        let t = stimulus.t_ms;
        if stimulus.restart {
            self.restart(true);
        }
        let controls = self.chart.controls;
        if self.is_given(controls.clear_flags, &stimulus.inputs) {
            self.flags = Flags::default();
            if let Some(assertion) = controls.assertion {
                self.state.variables[assertion] = Value::Int(0);
            }
        }
        if self.is_given(controls.reset, &stimulus.inputs) {
            self.restart(controls.keeps_retained);
        }
        let inputs = self.set_inputs(&stimulus.inputs);
        // There is no input event at the initial reaction: what came before is taken to have been the same.
        let input_event = match &self.previous {
            Some(previous) => previous.iter().zip(&inputs).any(|(&old, &new)| old != new),
            None => {
                self.start(t);
                if let Some(observe) = &mut observe {
                    observe(self);
                }
                false
            }
        };
        self.previous = Some(inputs);
        for (id, _) in self.chart.variables.iter_enumerated().filter(|(_, variable)| variable.momentary) {
            self.state.variables[id] = Value::Bool(false);
        }
        let cut_off = match self.profile.evolution {
            Evolution::Stable => self.evolve(t, input_event, observe),
            // R14: exactly one micro-step a call.
            Evolution::Scan => {
                self.micro_step(t, true, input_event);
                if let Some(observe) = &mut observe {
                    observe(self);
                }
                false
            }
        };
        self.look_at_claims(t, cut_off);
        self.publish(t, cut_off)
    }

    /// Whether an input that acts on the chart as a whole is true.
    fn is_given(&self, control: Option<VariableId>, given: &[Value]) -> bool {
        let Some(control) = control else { return false };
        let inputs = self.chart.variables.iter_enumerated().filter(|(_, v)| v.kind == VariableKind::Input);
        let place = inputs.take_while(|(id, _)| *id != control).count();
        given.get(place).copied().unwrap_or(self.state.variables[control]) == Value::Bool(true)
    }

    /// R9: inputs are constant during the reaction. An input that is not given keeps its value.
    fn set_inputs(&mut self, given: &[Value]) -> Vec<Value> {
        let mut given = given.iter();
        let mut inputs = Vec::new();
        for (id, variable) in self.chart.variables.iter_enumerated() {
            if variable.kind == VariableKind::Input {
                if let Some(&value) = given.next() {
                    self.state.variables[id] = convert(variable.ty, value);
                }
                if !self.chart.controls.has(id) {
                    inputs.push(self.state.variables[id]);
                }
            }
        }
        inputs
    }

    /// R9: micro-steps until nothing changes, or until there have been too many; whether it was that.
    ///
    /// A state that comes again comes again and again, since inputs and time are fixed: where nobody looks, what is left
    /// of the bound after whole rounds is all that need be done.
    fn evolve(&mut self, t: i64, input_event: bool, mut observe: Observer<'_, 'a>) -> bool {
        let bound = self.profile.bound_for(self.chart.steps.len(), self.chart.transitions.len());
        // The state after the first micro-step, and that after a later one, which moves on in ever larger steps (Brent).
        let mut marks: [Option<(u32, State)>; 2] = [None, None];
        let (mut done, mut left) = (0, bound);
        loop {
            let changed = self.micro_step(t, done == 0, input_event && done == 0);
            if let Some(observe) = &mut observe {
                observe(self);
            }
            if !changed {
                return false;
            }
            (done, left) = (done + 1, left.saturating_sub(1));
            if left == 0 {
                self.flags.livelock = true;
                return true;
            }
            if observe.is_some() {
                continue;
            }
            let seen = marks.iter().flatten().find(|(_, state)| *state == self.state).map(|(at, _)| *at);
            match seen {
                Some(at) => {
                    left %= done - at;
                    marks = [None, None];
                    if left == 0 {
                        self.flags.livelock = true;
                        return true;
                    }
                }
                None if done == 1 => marks[0] = Some((done, self.state.clone())),
                None if done.is_power_of_two() && marks[0].is_some() => marks[1] = Some((done, self.state.clone())),
                None => {}
            }
        }
    }

    /// R10, up to the loop: the initial situation, and the actions on activation of its steps. These see the settled
    /// situation, initial values, no edge, and delays as in a first context; what delays remember and what edges
    /// compare with begins in the first micro-step.
    fn start(&mut self, t: i64) {
        let before = self.state.active.clone();
        let mut initial = self.commands.initial.clone();
        let (cleared, events) = (self.cleared.iter().map(|_| false).collect(), vec![false; self.chart.pulses.len()]);
        let occurred = Occurred { cleared: &cleared, events: &events };
        let State { saved, frozen, .. } = &mut self.state;
        let pulses = Pulses::new(self.chart, &self.commands, occurred, saved, frozen);
        let phase = Phase::Start(&self.commands.initial);
        let Conflict(conflict) = settle(self.chart, &self.orders, pulses, phase, &before, &mut initial);
        self.flags.force_conflict |= conflict;
        self.state.active = initial;
        self.begins = true;
        self.forget();
        for since in &mut self.state.since {
            *since = t;
        }
        if self.profile.initial_actions {
            let on_activation = |stored: &&Stored| match stored.event {
                Event::Activation(step) => self.state.active[step],
                Event::Event(..) | Event::Deactivation(_) | Event::Clearing(_) | Event::EachScan(..) => false,
            };
            let triggered: Vec<&Stored> = self.chart.stored.iter().filter(on_activation).collect();
            if let Some(seen) = &mut self.seen {
                seen.done = self.chart.stored.iter().map(|stored| on_activation(&stored)).collect();
            }
            let nodes = self.plan.before_first_context(self.chart, triggered.iter().map(|stored| stored.value));
            self.evaluate(&nodes, Memory::Fresh, t);
            let allocated = allocate(&triggered, &self.values, &mut self.state);
            self.flags.alloc_conflict |= allocated.conflict;
        }
        self.take_edges_as_seen(t);
    }

    /// `m := cur` of the first context, so that no edge is true in it.
    fn take_edges_as_seen(&mut self, t: i64) {
        // The context is evaluated on copies: its delays are updated, and its divisions count, in the micro-step.
        let mut first = self.clone();
        let nodes: Vec<Valued> = first.plan.context.clone();
        first.evaluate(&nodes, Memory::Update, t);
        for &(edge, operand) in &self.plan.edges {
            self.state.edges[edge] = first.values.holds(operand);
        }
    }

    /// R11, R14: outputs of the situation and the variables reached, with the delays of the latest context. After a
    /// stable reaction that is the latest context itself.
    fn publish(&mut self, t: i64, cut_off: bool) -> Response {
        let nodes = std::mem::take(&mut self.plan.outputs);
        self.evaluate(&nodes, Memory::Hold, t);
        self.plan.outputs = nodes;
        let outputs =
            self.chart.variables.iter_enumerated().filter(|(_, variable)| variable.kind == VariableKind::Output);
        let wire = |id, place: usize| match self.profile.livelock_outputs {
            LivelockOutputs::Hold if cut_off => self.shown.get(place).copied().unwrap_or(Value::Bool(false)),
            LivelockOutputs::Off if cut_off => Value::Bool(false),
            LivelockOutputs::Computed | LivelockOutputs::Hold | LivelockOutputs::Off => {
                Value::Bool(self.values.wire(id))
            }
        };
        let outputs = outputs.enumerate().map(|(place, (id, variable))| match variable.mode {
            Mode::Wire => wire(id, place),
            Mode::Given | Mode::Stored => self.state.variables[id],
        });
        let outputs: Vec<Value> = outputs.collect();
        self.shown = outputs;
        Response {
            outputs: self.shown.clone(),
            situation: self.state.active.iter_enumerated().filter(|(_, active)| **active).map(|(id, _)| id).collect(),
            flags: self.flags,
        }
    }
}
