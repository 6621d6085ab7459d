//! What the reactions of a chart need, from the start on: every pair of inputs at the same instant and a second later,
//! from each situation and each value of the variables, as far as patience lasts.

use grafc_model::chart::{Chart, Value};
use grafc_model::reaction::{Evolution, Flags, Profile, Stimulus};
use grafc_model::simulate::{Simulator, State};
use std::collections::{BTreeMap, VecDeque};

/// More micro-steps are not waited for.
pub const ENDLESS: u32 = 40;

/// What was needed.
pub struct Needs {
    /// The most micro-steps of a reaction.
    pub most: u32,
    /// Whether never more than the first micro-step did something to the state or the flags.
    pub single: bool,
    /// The same without the memory of edges and delays.
    pub single_but_delays: bool,
}

/// Runs a chart over the Boolean inputs `a` and `b`; so many reactions at most.
pub fn explore(chart: &Chart, initial_actions: bool, patience: usize) -> Needs {
    let mut needs = Needs { most: 1, single: true, single_but_delays: true };
    let profile = Profile { bound: Some(ENDLESS), initial_actions, evolution: Evolution::Stable, ..Profile::default() };
    let mut open = VecDeque::from([(Simulator::new(chart, profile), None)]);
    let mut met: BTreeMap<String, u32> = BTreeMap::new();
    let mut reactions = 0;
    while let Some((before, since)) = open.pop_front() {
        for (a, b, wait) in stimuli(since.is_none()) {
            reactions += 1;
            if reactions > patience {
                return needs;
            }
            let mut simulator = before.clone();
            let t_ms = since.unwrap_or(0) + wait;
            let stimulus = Stimulus { t_ms, restart: false, inputs: vec![Value::Bool(a), Value::Bool(b)] };
            let micro_steps = needs.reaction(&mut simulator, &stimulus, since.is_none());
            if micro_steps < ENDLESS {
                let reached = simulator.state();
                // Twice, since memories that are not looked at may differ.
                let times = met.entry(format!("{:?}{:?}", reached.situation(), reached.variables())).or_default();
                *times += 1;
                if *times <= 2 {
                    open.push_back((simulator, Some(t_ms)));
                }
            }
        }
    }
    needs
}

/// Both inputs and how long they took to come; at the start nothing has been before.
fn stimuli(start: bool) -> impl Iterator<Item = (bool, bool, i64)> {
    let waits = if start { [0].as_slice() } else { &[0, 1000] };
    waits.iter().flat_map(|wait| [false, true].map(|a| [false, true].map(|b| (a, b, *wait)))).flatten()
}

impl Needs {
    /// Runs one reaction and takes in what it needed; says how many micro-steps it was.
    fn reaction(&mut self, simulator: &mut Simulator, stimulus: &Stimulus, start: bool) -> u32 {
        let mut seen: Vec<(State, Flags)> = Vec::new();
        simulator.react_observed(stimulus, &mut |s| seen.push((s.state().clone(), s.flags())));
        // What is seen first in the initial reaction is the situation before any micro-step.
        let micro_steps = &seen[usize::from(start)..];
        if let (Some((one, flags)), Some((all, all_flags))) = (micro_steps.first(), micro_steps.last()) {
            let variables = |state: &State| format!("{:?}", state.variables());
            self.single &= flags == all_flags && format!("{one:?}") == format!("{all:?}");
            self.single_but_delays &=
                flags == all_flags && one.situation() == all.situation() && variables(one) == variables(all);
        }
        let count = micro_steps.len() as u32;
        self.most = self.most.max(count);
        count
    }
}
