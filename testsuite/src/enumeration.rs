//! All situations that a chart can come to, found by trying every input in every state of the reference simulator: what
//! `grafc graph` and `grafc verify` are held against. Plain and slow; for charts with Boolean inputs, without delays and durations.

use crate::sights::Sights;
use grafc_model::chart::{Chart, ExprKind, Type, Value, VariableKind};
use grafc_model::reaction::{Profile, Stimulus};
use grafc_model::simulate::{Activity, Simulator, State};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The places of the active steps.
pub type Situation = Vec<usize>;

/// What was found; a vector of inputs is a number, the first input its lowest bit.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Enumerated {
    /// Those after the initial reaction.
    pub initial: BTreeSet<Situation>,
    /// All of them.
    pub situations: BTreeSet<Situation>,
    /// From one to another, with all vectors that some state reacts to so.
    pub edges: BTreeMap<(Situation, Situation), BTreeSet<u32>>,
    /// Those that have a state from which no other situation can be reached.
    pub deadlocks: BTreeSet<Situation>,
    /// From a situation, or at the start, with the transitions that are cleared again and again.
    pub livelocks: BTreeMap<(Option<Situation>, Vec<usize>), BTreeSet<u32>>,
}

/// What holds of all of it.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Everywhere {
    /// What was seen in micro-steps.
    pub sights: Sights,
    /// Some state has no way to another situation.
    pub stuck: bool,
    /// Some state has no way to an initial situation.
    pub homeless: bool,
}

/// Whether a chart is of the kind that can be enumerated, with at most so many inputs.
pub fn is_plain(chart: &Chart, most_inputs: usize) -> bool {
    let inputs: Vec<_> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
    let timed = |kind: &ExprKind| matches!(kind, ExprKind::Delay { .. } | ExprKind::StepTime(_));
    inputs.len() <= most_inputs
        && inputs.iter().all(|input| input.ty == Type::Bool)
        && !chart.exprs.iter().any(|expr| timed(&expr.kind))
}

/// Tries everything; none if there are more states than this.
pub fn enumerate(chart: &Chart, profile: Profile, most: usize) -> Option<(Enumerated, Everywhere)> {
    let inputs = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).count();
    let vectors = 0..1u32 << inputs;
    let mut found = Enumerated::default();
    let mut everywhere = Everywhere::default();
    // Time stands still, so that states which differ in nothing but it are one.
    let mut states: Vec<Simulator> = Vec::new();
    let mut known: HashMap<(Situation, u32), Vec<usize>> = HashMap::new();
    let mut successors: Vec<BTreeSet<usize>> = Vec::new();
    let mut at: Option<usize> = None;
    loop {
        let from = at.map(|at| situation(states[at].state().situation()));
        for vector in vectors.clone() {
            let mut simulator = at.map_or_else(|| Simulator::new(chart, profile), |at| states[at].clone());
            let given = (0..inputs).map(|bit| Value::Bool(vector >> bit & 1 == 1)).collect();
            let stimulus = Stimulus { t_ms: 0, restart: false, inputs: given };
            let before = simulator.clone();
            everywhere.sights.react(chart, &mut simulator, &stimulus, at.is_none());
            if simulator.flags().livelock {
                let ring = ring(before, &stimulus);
                found.livelocks.entry((from.clone(), ring)).or_default().insert(vector);
                continue;
            }
            let to = situation(simulator.state().situation());
            // States differ in what is stored as well.
            let alike = known.entry((to.clone(), vector)).or_default();
            let next = match alike.iter().find(|state| states[**state].state() == simulator.state()) {
                Some(state) => *state,
                None => {
                    alike.push(states.len());
                    states.push(simulator);
                    successors.push(BTreeSet::new());
                    states.len() - 1
                }
            };
            found.situations.insert(to.clone());
            match (&from, at) {
                (Some(from), Some(at)) => {
                    successors[at].insert(next);
                    if *from != to {
                        found.edges.entry((from.clone(), to)).or_default().insert(vector);
                    }
                }
                (None, _) | (_, None) => {
                    found.initial.insert(to);
                }
            }
        }
        if states.len() > most {
            return None;
        }
        let next = at.map_or(0, |at| at + 1);
        if next >= states.len() {
            break;
        }
        at = Some(next);
    }
    let situations: Vec<Situation> = states.iter().map(|state| situation(state.state().situation())).collect();
    if !chart.transitions.is_empty() {
        let leaves = |s: usize| successors[s].iter().any(|next| situations[*next] != situations[s]);
        let ways_out = leading_to(leaves, &successors);
        found.deadlocks = (0..states.len()).filter(|s| !ways_out[*s]).map(|s| situations[s].clone()).collect();
    }
    everywhere.stuck = !found.deadlocks.is_empty();
    everywhere.homeless = leading_to(|s| found.initial.contains(&situations[s]), &successors).contains(&false);
    Some((found, everywhere))
}

fn situation(active: &Activity) -> Situation {
    active.iter_enumerated().filter(|(_, active)| **active).map(|(s, _)| s.index()).collect()
}

/// What is cleared, in a reaction that does not end, from a state to the same one again; if none comes again, in all
/// micro-steps.
fn ring(mut simulator: Simulator, stimulus: &Stimulus) -> Vec<usize> {
    let mut seen: Vec<(State, Vec<usize>)> = Vec::new();
    simulator.react_observed(stimulus, &mut |simulator| {
        let cleared = simulator.cleared().iter_enumerated().filter(|(_, cleared)| **cleared);
        seen.push((simulator.state().clone(), cleared.map(|(t, _)| t.index()).collect()));
    });
    let again = (0..seen.len()).find_map(|end| {
        let begin = seen[..end].iter().position(|(state, _)| *state == seen[end].0)?;
        Some(begin + 1..end + 1)
    });
    let round = again.map_or(&seen[..], |again| &seen[again]);
    let cleared: BTreeSet<usize> = round.iter().flat_map(|(_, cleared)| cleared).copied().collect();
    cleared.into_iter().collect()
}

/// From which states a goal can be reached; from a goal itself it can.
fn leading_to(is_goal: impl Fn(usize) -> bool, successors: &[BTreeSet<usize>]) -> Vec<bool> {
    let mut predecessors = vec![Vec::new(); successors.len()];
    for (state, successors) in successors.iter().enumerate() {
        successors.iter().for_each(|next| predecessors[*next].push(state));
    }
    let mut leads: Vec<bool> = (0..successors.len()).map(is_goal).collect();
    let mut open: Vec<usize> = (0..successors.len()).filter(|state| leads[*state]).collect();
    while let Some(at) = open.pop() {
        for before in &predecessors[at] {
            if !std::mem::replace(&mut leads[*before], true) {
                open.push(*before);
            }
        }
    }
    leads
}
