//! An interpreter of nets: what a net means at any stage, from as built to flat.
//!
//! It reads a net as [`grafc_net::net`] says: a construct that a pass has not removed yet as the chart has it, one that
//! is gone as what it left behind. So it says of each pass by itself whether it keeps the meaning, before any code is
//! made of the net. Plain and slow, and nothing in it is taken from the stages after the net; the rules are those of
//! the semantics (R1-R14; X1-X6 in `expressions`).
//!
//! The flag DIV0 is left out: passes have no say in it.

mod expressions;
mod pulses;

pub use expressions::same;
use expressions::{Context, Expressions, Memory, Reading, convert};
use grafc_model::chart::{
    Event, GrafcetId, Mode, Situation, StepId, TransitionId, Value, Variable, VariableId, VariableKind,
};
use grafc_model::reaction::{Evolution, Flags, LivelockOutputs, Profile, Response, Stimulus};
use grafc_net::net::{Fact, Forced, Net};
use index_vec::IndexVec;
use pulses::Pulses;

type Active = IndexVec<StepId, bool>;

/// A net that is being run.
pub struct NetSteps<'a> {
    net: &'a Net,
    profile: Profile,
    expressions: Expressions<'a>,
    /// Arcs, those of macro-steps included.
    pre: IndexVec<TransitionId, Vec<StepId>>,
    post: IndexVec<TransitionId, Vec<StepId>>,
    /// Orders on each grafcet, the one that wins first.
    orders: IndexVec<GrafcetId, Vec<(StepId, Forced)>>,
    active: Active,
    variables: IndexVec<VariableId, Value>,
    memory: Memory,
    /// The inputs of the reaction before.
    previous: Option<Vec<Value>>,
    flags: Flags,
    /// The outputs of the reaction before.
    shown: Vec<Value>,
}

impl<'a> NetSteps<'a> {
    /// A net before its initial reaction.
    pub fn new(net: &'a Net, profile: Profile) -> Self {
        let mut pre: IndexVec<_, Vec<StepId>> = net.transitions.iter().map(|t| t.pre.to_vec()).collect();
        let mut post: IndexVec<_, Vec<StepId>> = net.transitions.iter().map(|t| t.post.to_vec()).collect();
        for m in &net.macro_steps {
            m.left_by.iter().for_each(|t| pre[*t].push(m.exit));
            m.entered_by.iter().for_each(|t| post[*t].push(m.entry));
        }
        NetSteps {
            net,
            profile: net.options.over(profile),
            expressions: Expressions::new(net),
            pre,
            post,
            orders: net.grafcets.indices().map(|g| orders(net, g)).collect(),
            active: net.places.iter().map(|_| false).collect(),
            variables: net.variables.iter().map(|v| v.initial()).collect(),
            memory: Memory::new(net),
            previous: None,
            flags: Flags::default(),
            shown: Vec::new(),
        }
    }

    /// Whether each place is active.
    pub fn situation(&self) -> &Active {
        &self.active
    }

    /// Values of inputs, constants and stored variables; what stands for others means nothing.
    pub fn variables(&self) -> &IndexVec<VariableId, Value> {
        &self.variables
    }

    /// The flags raised so far; never DIV0.
    pub fn flags(&self) -> Flags {
        self.flags
    }

    /// Reacts to inputs at an instant (R9-R14). `observe` sees it once it has started and after each micro-step.
    pub fn react(&mut self, stimulus: &Stimulus, observe: &mut dyn FnMut(&NetSteps)) -> Response {
        let t = stimulus.t_ms;
        if stimulus.restart {
            self.restart(true);
        }
        let inputs: Vec<VariableId> =
            self.net.variables.indices().filter(|v| self.net.variables[*v].kind == VariableKind::Input).collect();
        let controls = self.net.controls;
        let asks = |control: Option<VariableId>| {
            let mut given = inputs.iter().zip(&stimulus.inputs);
            given.any(|(v, value)| Some(*v) == control && *value == Value::Bool(true))
        };
        if asks(controls.clear_flags) {
            self.flags = Flags::default();
        }
        if asks(controls.reset) {
            self.restart(controls.keeps_retained);
        }
        for (v, value) in inputs.iter().zip(&stimulus.inputs) {
            self.variables[*v] = convert(self.net.variables[*v].ty, *value);
        }
        let of_chart = inputs.iter().filter(|v| !controls.has(**v));
        let now: Vec<Value> = of_chart.map(|v| self.variables[*v]).collect();
        let mut event = false;
        match self.previous.replace(now.clone()) {
            Some(before) => event = before.iter().zip(&now).any(|(a, b)| !same(*a, *b)),
            None => {
                self.start(t);
                observe(self);
            }
        }
        for (v, _) in self.net.variables.iter_enumerated().filter(|(_, variable)| variable.momentary) {
            self.variables[v] = Value::Bool(false);
        }
        let bound = self.profile.bound_for(self.net.places.len(), self.net.transitions.len());
        let mut done = 0;
        loop {
            let changed = self.micro_step(t, event && done == 0);
            observe(self);
            done += 1;
            match self.profile.evolution {
                Evolution::Stable if changed && done < bound => {}
                Evolution::Stable => {
                    self.flags.livelock |= changed;
                    return self.publish(t, changed);
                }
                Evolution::Scan => return self.publish(t, false),
            }
        }
    }

    /// R10, after a restart or a reset: as at first, perhaps with what is retained.
    fn restart(&mut self, keeps_retained: bool) {
        let kept = std::mem::take(&mut self.variables);
        *self = NetSteps::new(self.net, self.profile);
        if !keeps_retained {
            return;
        }
        for (v, variable) in self.net.variables.iter_enumerated().filter(|(_, variable)| variable.retain) {
            self.variables[v] = if variable.mode == Mode::Stored { kept[v] } else { variable.initial() };
        }
    }

    /// R10. The delays of this context are forgotten again, and no edge is true in the first one.
    fn start(&mut self, t: i64) {
        let marked: Active = self.net.places.iter().map(|place| place.initial).collect();
        if self.has(Fact::SettledStart) {
            self.active = marked;
            self.memory.saved = self.net.places.iter().map(|place| place.saved).collect();
            self.memory.frozen = self.net.grafcets.iter().map(|grafcet| grafcet.starts_frozen).collect();
            self.flags.force_conflict = self.net.conflict_at_start;
        } else {
            let none: Active = marked.iter().map(|_| false).collect();
            let below = pulses::below_children(self.net);
            let marked: Active =
                marked.iter_enumerated().map(|(s, m)| *m && !below[self.net.places[s].grafcet]).collect();
            self.active = self.settle(&none, marked, Phase::Start(&below));
        }
        self.net.places.indices().for_each(|s| self.memory.activated(s, t));
        if self.profile.initial_actions {
            let cx = self.read(Reading::Levels, t);
            let on_activation = |e: Event| matches!(e, Event::Activation(s) if self.active[s]);
            let triggered: Vec<usize> =
                (0..self.net.stored.len()).filter(|i| on_activation(self.net.stored[*i].event)).collect();
            self.allocate(&triggered, &cx);
        }
        let cx = self.read(Reading::Context, t);
        self.memory.keep_edges(&cx);
    }

    /// R1-R8; says whether something changed.
    fn micro_step(&mut self, t: i64, input_event: bool) -> bool {
        let net = self.net;
        let cx = self.read(Reading::Context, t);
        let cleared: IndexVec<TransitionId, bool> = net.transitions.indices().map(|t| self.clears(t, &cx)).collect();
        let cleared_ones = || cleared.iter_enumerated().filter(|(_, c)| **c).map(|(t, _)| t);
        let mut next = self.active.clone();
        cleared_ones().flat_map(|t| &self.pre[t]).for_each(|s| next[*s] = false);
        cleared_ones().flat_map(|t| &self.post[t]).for_each(|s| next[*s] = true);
        let before = self.active.clone();
        // What is read until the end of the micro-step is read of the state before it.
        let levels = self.read(Reading::Levels, t);
        let memory = self.memory.clone();
        let given = |event| match event {
            Event::Event(s, e) => before[s] && cx.holds(e) && (input_event || !levels.holds(e)),
            Event::Clearing(t) => cleared[t],
            Event::Deactivation(_) | Event::Activation(_) | Event::EachScan(..) => false,
        };
        let given: Vec<bool> = net.pulses.iter().map(|pulse| given(pulse.event)).collect();
        let next = self.settle(&before, next, Phase::Evolution(&given));

        // R7, by kinds: E, D, T, A; and apart from them S.
        let mut triggered: Vec<(u8, usize)> = Vec::new();
        let mut each_scan = Vec::new();
        for (i, action) in net.stored.iter().enumerate() {
            let (kind, happened) = match action.event {
                Event::Event(s, e) => (0, before[s] && cx.holds(e) && (input_event || !levels.holds(e))),
                Event::Deactivation(s) => (1, before[s] && !next[s]),
                Event::Clearing(t) => (2, cleared[t]),
                Event::Activation(s) => (3, next[s] && !before[s]),
                Event::EachScan(s, e) => {
                    if next[s] && e.is_none_or(|e| cx.holds(e)) {
                        each_scan.push(i);
                    }
                    continue;
                }
            };
            if happened {
                triggered.push((kind, i));
            }
        }
        triggered.sort_unstable();
        let triggered: Vec<usize> = triggered.into_iter().map(|(_, i)| i).collect();
        let mut stored = self.allocate(&triggered, &cx);
        if !each_scan.is_empty() {
            let after = self.expressions.read_again(&self.active, &self.variables, &memory, t, &cx);
            stored |= self.allocate(&each_scan, &after);
        }

        let moved = before != next;
        for s in net.places.indices().filter(|s| next[*s] && !before[*s]) {
            self.memory.activated(s, t);
        }
        self.active = next;
        let edge = self.memory.keep_edges(&cx);
        self.memory.keep_delays(&cx);
        moved || stored || edge || memory.saved != self.memory.saved || memory.frozen != self.memory.frozen
    }

    /// R3
    fn clears(&self, id: TransitionId, cx: &Context) -> bool {
        let transition = &self.net.transitions[id];
        let within = self.around(&transition.within, transition.grafcet);
        self.pre[id].iter().all(|s| self.active[*s])
            && (within.is_empty() || within.iter().any(|e| self.active[*e]))
            && !self.frozen(transition.grafcet)
            && !self.memory.frozen[transition.grafcet]
            && (!self.net.grafcets[transition.grafcet].child
                || !self.pre[id].is_empty()
                || self.net.grafcets[transition.grafcet].steps.iter().any(|s| self.active[*s]))
            && cx.holds(transition.condition)
    }

    /// The steps that something of a grafcet is within, before and after enclosures are flattened.
    fn around<'n>(&'n self, within: &'n [StepId], g: GrafcetId) -> &'n [StepId] {
        self.net.grafcets[g].enclosing_step.as_ref().map_or(within, std::slice::from_ref)
    }

    /// R2: whether a grafcet is frozen in the old situation.
    fn frozen(&self, grafcet: GrafcetId) -> bool {
        let net = self.net;
        let mut looked_at = Some(grafcet);
        while let Some(g) = looked_at {
            if self.orders[g].iter().any(|(step, _)| self.active[*step]) {
                return true;
            }
            looked_at = if self.has(Fact::ClosedFreezing) {
                net.grafcets[g].frozen_with
            } else {
                net.grafcets[g].enclosing_step.map(|e| net.places[e].grafcet)
            };
        }
        false
    }

    /// R5, place by place.
    fn settle(&mut self, before: &Active, mut next: Active, phase: Phase) -> Active {
        let net = self.net;
        let none = vec![false; net.pulses.len()];
        let (given, start) = match phase {
            Phase::Start(below) => (&none[..], Some(below)),
            Phase::Evolution(given) => (given, None),
        };
        let mut pulses = Pulses::new(net, given);
        for g in &net.hierarchy {
            let grafcet = &net.grafcets[*g];
            let within = self.around(net.within(*g), *g);
            let is_start =
                |e: &StepId| start.is_some_and(|below| net.places[*e].initial && !below[net.places[*e].grafcet]);
            let begins = !within.iter().any(|e| before[*e] || is_start(e));
            let is_empty = !within.is_empty() && !within.iter().any(|e| next[*e]);
            for s in grafcet.steps.iter().filter(|_| !within.is_empty()) {
                next[*s] = !is_empty && (next[*s] || begins && net.places[*s].activated);
            }
            if is_empty {
                pulses.forget(*g, &mut self.memory);
                continue;
            }
            self.flags.force_conflict |= pulses.act(*g, before, &mut next, &mut self.memory);
            let in_force: Vec<&Forced> =
                self.orders[*g].iter().filter(|(step, _)| next[*step]).map(|(_, forced)| forced).collect();
            let Some(first) = in_force.first() else { continue };
            self.flags.force_conflict |= in_force.iter().any(|other| other != first);
            match first {
                Forced::Steps(steps) => {
                    grafcet.steps.iter().for_each(|s| next[*s] = steps.contains(s));
                    pulses.forget(*g, &mut self.memory);
                }
                Forced::Current => {}
            }
        }
        next
    }

    /// R7: assigns from the values of the context, the last one wins; says whether a variable changed.
    fn allocate(&mut self, triggered: &[usize], cx: &Context) -> bool {
        let old = self.variables.clone();
        let mut given: IndexVec<VariableId, Option<Value>> = old.iter().map(|_| None).collect();
        for action in triggered.iter().map(|i| &self.net.stored[*i]) {
            let value = cx.value(action.value);
            self.flags.alloc_conflict |= given[action.target].is_some_and(|earlier| !same(earlier, value));
            given[action.target] = Some(value);
        }
        for (v, value) in given.iter_enumerated() {
            self.variables[v] = value.unwrap_or(old[v]);
        }
        self.variables.iter().zip(&old).any(|(a, b)| !same(*a, *b))
    }

    /// R11, R14: with the delays of the latest context.
    fn publish(&mut self, t: i64, cut_off: bool) -> Response {
        let cx = self.read(Reading::After, t);
        let net = self.net;
        let before = std::mem::take(&mut self.shown).into_iter().map(Some).chain(std::iter::repeat(None));
        let instead = if cut_off { self.profile.livelock_outputs } else { LivelockOutputs::Computed };
        let output = |((v, variable), before): ((VariableId, &Variable), Option<Value>)| match variable.mode {
            Mode::Wire => match instead {
                LivelockOutputs::Computed => Value::Bool(cx.wire(v)),
                LivelockOutputs::Hold => before.unwrap_or(Value::Bool(false)),
                LivelockOutputs::Off => Value::Bool(false),
            },
            Mode::Given | Mode::Stored => self.variables[v],
        };
        let outputs = net.variables.iter_enumerated().filter(|(_, v)| v.kind == VariableKind::Output);
        let outputs: Vec<Value> = outputs.zip(before).map(output).collect();
        self.shown.clone_from(&outputs);
        let steps = net.places.iter_enumerated().filter(|(s, place)| self.active[*s] && !place.auxiliary);
        Response { outputs, situation: steps.map(|(s, _)| s).collect(), flags: self.flags }
    }

    fn read(&self, reading: Reading, t: i64) -> Context {
        self.expressions.read(&self.active, &self.variables, &self.memory, reading, t)
    }

    fn has(&self, fact: Fact) -> bool {
        self.net.facts.contains(&fact)
    }
}

/// When a situation is settled.
enum Phase<'a> {
    /// At the start, with the grafcets that are children or enclosed in one.
    Start(&'a IndexVec<GrafcetId, bool>),
    /// In a micro-step, with what pulse orders wait for.
    Evolution(&'a [bool]),
}

/// R2: the orders on a grafcet, ranked already or not.
fn orders(net: &Net, grafcet: GrafcetId) -> Vec<(StepId, Forced)> {
    if net.facts.contains(&Fact::RankedOrders) {
        return net.grafcets[grafcet].orders.iter().map(|order| (order.step, order.forced.clone())).collect();
    }
    let mut found: Vec<(u32, usize)> = Vec::new();
    for (i, order) in net.orders.iter().enumerate().filter(|(_, order)| order.grafcet == grafcet) {
        found.push((net.grafcets[net.places[order.step].grafcet].level, i));
    }
    found.sort_unstable();
    let forced = |situation: &Situation| match situation {
        Situation::Current => Forced::Current,
        Situation::Steps(steps) => Forced::Steps(steps.clone()),
        Situation::Initial => {
            let steps = net.grafcets[grafcet].steps.iter().copied();
            Forced::Steps(steps.filter(|s| net.places[*s].initial).collect())
        }
    };
    found.into_iter().map(|(_, i)| (net.orders[i].step, forced(&net.orders[i].situation))).collect()
}
