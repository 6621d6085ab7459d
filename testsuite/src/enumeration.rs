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
            let mut seen: Vec<(State, Vec<usize>)> = Vec::new();
            let stimulus = Stimulus { t_ms: 0, restart: false, inputs: given };
            let mut look = |simulator: &Simulator| {
                let cleared = simulator.cleared().iter_enumerated().filter(|(_, cleared)| **cleared);
                seen.push((simulator.state().clone(), cleared.map(|(t, _)| t.index()).collect()));
            };
            everywhere.sights.react_observed(chart, &mut simulator, &stimulus, at.is_none(), &mut look);
            if simulator.flags().livelock {
                found.livelocks.entry((from.clone(), ring(&seen))).or_default().insert(vector);
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
        found.deadlocks = (0..states.len())
            .filter(|s| is_dead(*s, &successors, &situations))
            .map(|s| situations[s].clone())
            .collect();
    }
    everywhere.stuck = !found.deadlocks.is_empty();
    let leads_home = |s: usize| reached(s, &successors).iter().any(|s| found.initial.contains(&situations[*s]));
    everywhere.homeless = !(0..states.len()).all(leads_home);
    Some((found, everywhere))
}

fn situation(active: &Activity) -> Situation {
    active.iter_enumerated().filter(|(_, active)| **active).map(|(s, _)| s.index()).collect()
}

/// What was cleared from a state to the same one again; if none comes again, in all micro-steps.
fn ring(seen: &[(State, Vec<usize>)]) -> Vec<usize> {
    let again = (0..seen.len()).find_map(|end| {
        let begin = seen[..end].iter().position(|(state, _)| *state == seen[end].0)?;
        Some(begin + 1..end + 1)
    });
    let round = again.map_or(seen, |again| &seen[again]);
    let cleared: BTreeSet<usize> = round.iter().flat_map(|(_, cleared)| cleared).copied().collect();
    cleared.into_iter().collect()
}

/// Whether every state that can be reached has the same situation.
fn is_dead(state: usize, successors: &[BTreeSet<usize>], situations: &[Situation]) -> bool {
    reached(state, successors).iter().all(|s| situations[*s] == situations[state])
}

/// What can be reached from a state, itself among it.
fn reached(state: usize, successors: &[BTreeSet<usize>]) -> BTreeSet<usize> {
    let mut met = BTreeSet::from([state]);
    let mut open = vec![state];
    while let Some(at) = open.pop() {
        open.extend(successors[at].iter().filter(|next| met.insert(**next)));
    }
    met
}
