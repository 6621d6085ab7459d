//! The rules of `docs/semantics.md` that a run exercises, each by what can be seen of it.
//!
//! The simulator is watched micro-step by micro-step; what it shows is the situation, the variables, and which
//! transitions it cleared. The expected situation before rule R5 is worked out here from the arcs.

use super::pulses::{self, Evolved, Remembered};
use grafc_model::chart::{
    Chart, Event, ExprKind, GrafcetId, MacroId, Mode, Node, Order, Situation, Step, StepId, TransitionId, Value,
    VariableId, VariableKind,
};
use grafc_model::reaction::{Evolution, Profile, Response, Stimulus};
use grafc_model::simulate::{Activity, Simulator};
use index_vec::IndexVec;
use std::collections::BTreeSet;

/// All of them.
pub fn all() -> impl Iterator<Item = &'static str> {
    PLAIN.iter().copied().chain(pulses::ALL)
}

/// Those of what every chart may have.
const PLAIN: &[&str] = &[
    "R1 a condition holds in a later micro-step only",
    "R2 an order in force: steps",
    "R2 an order in force: none",
    "R2 an order in force: INIT",
    "R2 an order in force: *",
    "R2 two orders, one wins",
    "R2 frozen with what encloses it",
    "R3 a transition is cleared",
    "R3 several are cleared together",
    "R3 an enabled transition is frozen",
    "R3 a source transition is in an inactive enclosure",
    "R4 a step is left and entered at once",
    "R5 an enclosure is emptied",
    "R5 activation links are followed",
    "R5 an order changes the situation",
    "R6 activated by a clearing",
    "R6 activated by a link",
    "R6 activated by an order",
    "R6 deactivated by a clearing",
    "R6 deactivated with an enclosure",
    "R6 deactivated by an order",
    "R7 action on event",
    "R7 action on deactivation",
    "R7 action on clearing",
    "R7 action on activation",
    "R8 changed by the situation",
    "R8 changed by a variable alone",
    "R8 changed by an edge alone",
    "R9 stable at once",
    "R9 stable after one evolution",
    "R9 stable after several evolutions",
    "R9 not stable within the bound",
    "R10 actions of initial steps are done",
    "R10 actions of initial steps are left out",
    "R10 an order acts at the start",
    "R10 an enclosure starts without its links",
    "R10 a restart keeps what is retained",
    "R10 a restart begins anew with the rest",
    "R11 a continuous output changes",
    "R11 a stored output changes",
    "R12 time alone changes something",
    "R12 nothing happens without a change",
    "R13 inputs change without time",
    "R13 a delay ends to the millisecond",
    "R13 a delay ends as inputs change",
    "R14 one micro-step a call",
    "R14 the next call goes on",
    "R15 action each scan",
];

/// Those of a run.
pub fn of(chart: &Chart, profile: Profile, stimuli: &[Stimulus]) -> BTreeSet<&'static str> {
    let mut watch = Watch::new(chart, profile);
    let mut simulator = Simulator::new(chart, profile);
    let mut before: Option<(&Stimulus, Response)> = None;
    for stimulus in stimuli {
        watch.begin(stimulus, before.as_ref().map(|(stimulus, _)| *stimulus));
        let response = simulator.react_observed(stimulus, &mut |simulator| watch.micro_step(simulator));
        watch.end(stimulus, &response, before.as_ref().map(|(stimulus, response)| (*stimulus, response)));
        before = Some((stimulus, response));
    }
    watch.seen
}

struct Watch<'a> {
    chart: &'a Chart,
    profile: Profile,
    pre: IndexVec<TransitionId, Vec<StepId>>,
    post: IndexVec<TransitionId, Vec<StepId>>,
    seen: BTreeSet<&'static str>,
    now: i64,
    started: bool,
    /// Micro-steps of this reaction.
    micro_steps: usize,
    /// Whether a micro-step of this reaction changed the situation.
    moved: bool,
    /// Whether the latest micro-step changed neither the situation nor a variable.
    quiet: bool,
    active: Activity,
    /// `saved` and `fr` of R15.
    saved: (Activity, IndexVec<GrafcetId, bool>),
    variables: IndexVec<VariableId, Value>,
    since: IndexVec<StepId, i64>,
}

impl<'a> Watch<'a> {
    fn new(chart: &'a Chart, profile: Profile) -> Self {
        let steps = |nodes: &[Node], of_macro: fn(&Chart, MacroId) -> StepId| {
            let step = |node: &Node| match node {
                Node::Step(step) => *step,
                Node::Macro(id) => of_macro(chart, *id),
            };
            nodes.iter().map(step).collect::<Vec<StepId>>()
        };
        Watch {
            chart,
            profile: chart.options.over(profile),
            pre: chart.transitions.iter().map(|t| steps(&t.pre, Chart::exit)).collect(),
            post: chart.transitions.iter().map(|t| steps(&t.post, Chart::entry)).collect(),
            seen: BTreeSet::new(),
            now: 0,
            started: false,
            micro_steps: 0,
            moved: false,
            quiet: false,
            active: chart.steps.iter().map(|_| false).collect(),
            saved: (chart.steps.iter().map(|_| false).collect(), chart.grafcets.iter().map(|_| false).collect()),
            variables: chart.variables.iter().map(|v| v.initial()).collect(),
            since: chart.steps.iter().map(|_| 0).collect(),
        }
    }

    fn see(&mut self, holds: bool, what: &'static str) {
        if holds {
            self.seen.insert(what);
        }
    }

    /// The variables that actions can change.
    fn stored(&self) -> impl Iterator<Item = VariableId> + use<'a> {
        let variables = &self.chart.variables;
        variables.indices().filter(|v| variables[*v].mode == Mode::Stored)
    }

    fn begin(&mut self, stimulus: &Stimulus, before: Option<&Stimulus>) {
        self.now = stimulus.t_ms;
        (self.micro_steps, self.moved, self.quiet) = (0, false, false);
        let Some(before) = before else { return };
        if stimulus.restart {
            let initial = |v: VariableId| self.chart.variables[v].initial();
            let changed = |retain: bool| {
                let of_these = |v: &VariableId| self.chart.variables[*v].retain == retain;
                self.stored().filter(of_these).any(|v| self.variables[v] != initial(v))
            };
            let (kept, lost) = (changed(true), changed(false));
            self.see(kept, "R10 a restart keeps what is retained");
            self.see(lost, "R10 a restart begins anew with the rest");
            self.started = false;
            self.active.iter_mut().for_each(|active| *active = false);
            self.saved.0.iter_mut().for_each(|saved| *saved = false);
            self.saved.1.iter_mut().for_each(|frozen| *frozen = false);
            return;
        }
        let changed = before.inputs != stimulus.inputs;
        self.see(changed && before.t_ms == stimulus.t_ms, "R13 inputs change without time");
        for expr in &self.chart.exprs {
            let ExprKind::Delay { on, operand, .. } = &expr.kind else { continue };
            let ExprKind::StepActive(step) = self.chart.exprs[*operand].kind else { continue };
            if on.ms > 0 && self.active[step] && self.since[step] + on.ms == self.now && before.t_ms < self.now {
                self.see(true, "R13 a delay ends to the millisecond");
                self.see(changed, "R13 a delay ends as inputs change");
            }
        }
    }

    fn micro_step(&mut self, simulator: &Simulator) {
        let (active, variables) = (simulator.state().situation().clone(), simulator.state().variables().clone());
        let (saved, frozen) = simulator.state().saved();
        let saved = (saved.clone(), frozen.clone());
        if self.started {
            self.evolution(&active, &saved, &variables, simulator.cleared());
            self.micro_steps += 1;
        } else {
            self.start(&active, &saved.1, &variables);
            self.started = true;
        }
        for (step, since) in self.since.iter_mut_enumerated() {
            if active[step] && !self.active[step] {
                *since = self.now;
            }
        }
        (self.active, self.saved, self.variables) = (active, saved, variables);
    }

    fn start(
        &mut self,
        active: &Activity,
        frozen: &IndexVec<GrafcetId, bool>,
        variables: &IndexVec<VariableId, Value>,
    ) {
        let chart = self.chart;
        let is_forced = |g: GrafcetId| chart.orders.iter().any(|order| order.grafcet == g && active[order.step]);
        let is_other = |(s, a): (&Step, &bool)| s.initial != *a && is_forced(s.grafcet);
        self.see(chart.steps.iter().zip(active).any(is_other), "R10 an order acts at the start");
        let is_started = |(s, a): (&Step, &bool)| *a && chart.grafcets[s.grafcet].child && !is_forced(s.grafcet);
        let commands = chart.steps.iter().zip(active).any(is_started) || frozen.iter().any(|frozen| *frozen);
        self.see(commands, "R15 pulses act at the start");
        let without_links = |g: &GrafcetId| {
            let grafcet = &chart.grafcets[*g];
            grafcet.enclosing_step.is_some_and(|e| chart.steps[e].initial)
                && grafcet.steps.iter().any(|s| chart.steps[*s].activated && !chart.steps[*s].initial && !active[*s])
        };
        self.see(chart.grafcets.indices().any(|g| without_links(&g)), "R10 an enclosure starts without its links");
        let has_action = chart.stored.iter().any(|a| matches!(a.event, Event::Activation(s) if active[s]));
        let done = self.stored().any(|v| !chart.variables[v].retain && variables[v] != chart.variables[v].initial());
        self.see(done, "R10 actions of initial steps are done");
        self.see(has_action && !self.profile.initial_actions, "R10 actions of initial steps are left out");
    }

    fn evolution(
        &mut self,
        after: &Activity,
        saved: &(Activity, IndexVec<GrafcetId, bool>),
        variables: &IndexVec<VariableId, Value>,
        cleared: &IndexVec<TransitionId, bool>,
    ) {
        let chart = self.chart;
        let before = self.active.clone();
        self.see(self.quiet, "R8 changed by an edge alone");
        let count = cleared.iter().filter(|c| **c).count();
        self.see(count > 0, "R3 a transition is cleared");
        self.see(count > 1, "R3 several are cleared together");
        self.see(count > 0 && self.micro_steps > 0, "R1 a condition holds in a later micro-step only");
        // R4: the situation before orders and enclosures have their say.
        let mut left: Activity = before.iter().map(|_| false).collect();
        let mut entered = left.clone();
        for (id, _) in cleared.iter_enumerated().filter(|(_, cleared)| **cleared) {
            self.pre[id].iter().for_each(|s| left[*s] = true);
            self.post[id].iter().for_each(|s| entered[*s] = true);
        }
        self.see(chart.steps.indices().any(|s| left[s] && entered[s]), "R4 a step is left and entered at once");
        self.frozen(&before);
        for grafcet in chart.grafcets.indices() {
            self.settled(grafcet, &before, after, &left, &entered);
        }
        let remembered = |active: &Activity, (saved, frozen): &(Activity, IndexVec<GrafcetId, bool>)| Remembered {
            active: active.clone(),
            saved: saved.clone(),
            frozen: frozen.clone(),
        };
        let (earlier, later) = (remembered(&before, &self.saved), remembered(after, saved));
        let evolved = Evolved { chart, before: &earlier, after: &later, cleared, entered: &entered };
        self.seen.extend(chart.grafcets.indices().flat_map(|g| evolved.of(g)));
        self.actions(&before, after, cleared, variables);
        let moved = before != *after;
        let allocated = self.stored().any(|v| self.variables[v] != variables[v]);
        self.see(moved, "R8 changed by the situation");
        self.see(allocated && !moved, "R8 changed by a variable alone");
        self.moved |= moved;
        self.quiet = !moved && !allocated;
    }

    /// R2 and R3 in the situation before a micro-step.
    fn frozen(&mut self, before: &Activity) {
        let chart = self.chart;
        let mut frozen: IndexVec<GrafcetId, bool> = chart.grafcets.iter().map(|_| false).collect();
        for &g in &chart.hierarchy {
            let orders: Vec<&Order> = chart.orders.iter().filter(|o| o.grafcet == g && before[o.step]).collect();
            let with = chart.grafcets[g].enclosing_step.is_some_and(|e| before[e] && frozen[chart.steps[e].grafcet]);
            frozen[g] = !orders.is_empty() || with;
            self.see(orders.is_empty() && with, "R2 frozen with what encloses it");
            self.see(orders.iter().any(|o| o.situation != orders[0].situation), "R2 two orders, one wins");
            if let [order] = orders[..] {
                self.see(
                    true,
                    match &order.situation {
                        Situation::Steps(steps) if steps.is_empty() => "R2 an order in force: none",
                        Situation::Steps(_) => "R2 an order in force: steps",
                        Situation::Current => "R2 an order in force: *",
                        Situation::Initial => "R2 an order in force: INIT",
                    },
                );
            }
        }
        for (id, transition) in chart.transitions.iter_enumerated() {
            let enabled = !self.pre[id].is_empty() && self.pre[id].iter().all(|s| before[*s]);
            self.see(enabled && frozen[transition.grafcet], "R3 an enabled transition is frozen");
            let inactive = chart.grafcets[transition.grafcet].enclosing_step.is_some_and(|e| !before[e]);
            self.see(self.pre[id].is_empty() && inactive, "R3 a source transition is in an inactive enclosure");
        }
    }

    /// R5 and R6 in one grafcet.
    fn settled(&mut self, g: GrafcetId, before: &Activity, after: &Activity, left: &Activity, entered: &Activity) {
        let chart = self.chart;
        let encloser = chart.grafcets[g].enclosing_step;
        let emptied = encloser.is_some_and(|e| before[e] && !after[e]);
        let opened = encloser.is_some_and(|e| !before[e] && after[e]);
        let ordered = chart.orders.iter().any(|o| o.grafcet == g && after[o.step]);
        for &s in &chart.grafcets[g].steps {
            let evolved = entered[s] || before[s] && !left[s];
            let link = opened && !ordered && chart.steps[s].activated;
            self.see(emptied && before[s], "R5 an enclosure is emptied");
            self.see(link && after[s] && !evolved, "R5 activation links are followed");
            self.see(ordered && evolved != after[s], "R5 an order changes the situation");
            match (before[s], after[s]) {
                (false, true) if evolved => self.see(true, "R6 activated by a clearing"),
                (false, true) if link => self.see(true, "R6 activated by a link"),
                (false, true) => self.see(ordered, "R6 activated by an order"),
                (true, false) if !evolved => self.see(true, "R6 deactivated by a clearing"),
                (true, false) if emptied => self.see(true, "R6 deactivated with an enclosure"),
                (true, false) => self.see(ordered, "R6 deactivated by an order"),
                (true, true) | (false, false) => {}
            }
        }
    }

    /// R7: the kinds of action that were done. One on event is one that nothing else explains.
    fn actions(
        &mut self,
        before: &Activity,
        after: &Activity,
        cleared: &IndexVec<TransitionId, bool>,
        variables: &IndexVec<VariableId, Value>,
    ) {
        let chart = self.chart;
        let mut explained: IndexVec<VariableId, bool> = variables.iter().map(|_| false).collect();
        for action in &chart.stored {
            let (done, what) = match action.event {
                Event::Event(..) => continue,
                Event::Deactivation(s) => (before[s] && !after[s], "R7 action on deactivation"),
                Event::Clearing(t) => (cleared[t], "R7 action on clearing"),
                Event::Activation(s) => (!before[s] && after[s], "R7 action on activation"),
                // With a condition it is one that nothing else explains.
                Event::EachScan(_, Some(_)) => continue,
                Event::EachScan(s, None) => (after[s], "R15 action each scan"),
            };
            self.see(done, what);
            explained[action.target] |= done;
        }
        let by_event = self.stored().any(|v| !explained[v] && variables[v] != self.variables[v]);
        self.see(by_event, "R7 action on event");
    }

    fn end(&mut self, stimulus: &Stimulus, response: &Response, before: Option<(&Stimulus, &Response)>) {
        let same_inputs = before.is_some_and(|(before, _)| before.inputs == stimulus.inputs);
        match self.profile.evolution {
            Evolution::Scan => {
                self.see(self.moved, "R14 one micro-step a call");
                let still = before.is_some_and(|(before, _)| before.t_ms == stimulus.t_ms);
                self.see(same_inputs && still && self.moved, "R14 the next call goes on");
            }
            Evolution::Stable => {
                let raised = response.flags.livelock && before.is_none_or(|(_, response)| !response.flags.livelock);
                self.see(raised, "R9 not stable within the bound");
                self.see(self.micro_steps == 1 && self.quiet, "R9 stable at once");
                self.see(self.micro_steps == 2 && self.moved, "R9 stable after one evolution");
                self.see(self.micro_steps > 2 && self.moved, "R9 stable after several evolutions");
                let Some((_, earlier)) = before else { return };
                let same = earlier.situation == response.situation && earlier.outputs == response.outputs;
                self.see(same_inputs && !same, "R12 time alone changes something");
                self.see(same_inputs && same && self.micro_steps == 1, "R12 nothing happens without a change");
            }
        }
        let Some((_, earlier)) = before else { return };
        let outputs = self.chart.variables.iter().filter(|v| v.kind == VariableKind::Output);
        let pairs: Vec<(Mode, bool)> = outputs
            .zip(earlier.outputs.iter().zip(&response.outputs))
            .map(|(variable, (a, b))| (variable.mode, a != b))
            .collect();
        self.see(pairs.contains(&(Mode::Wire, true)), "R11 a continuous output changes");
        self.see(pairs.contains(&(Mode::Stored, true)), "R11 a stored output changes");
    }
}
