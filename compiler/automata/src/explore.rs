//! From a scan program to the machine that it is: from the state before the first call on, each state is called once, with
//! all inputs at a time.

use crate::call::{Beyond, Caller, of_role};
use crate::machine::{Machine, Set, State, apart};
use crate::refine::{classes, quotient};
use grafc_logic::scan::{Program, Role, VarId};
use grafc_model::chart::Value;
use indexmap::IndexSet;
use rustc_hash::FxBuildHasher;
use std::collections::BTreeMap;

/// The machine of a program, if it has no more than so many states. States in which the same steps are active, and from which
/// on all is the same, are one.
///
/// # Errors
/// It counts, measures time, or has more states.
pub fn explore(program: &Program, most: usize) -> Result<Machine, Beyond> {
    let mut caller = Caller::new(program)?;
    let kept: Vec<VarId> =
        program.variables.iter_enumerated().filter(|(_, variable)| variable.role.is_kept()).map(|(id, _)| id).collect();
    let outputs = of_role(program, Role::Output);
    let is_true = |variable: &VarId| program.variables[*variable].initial() == Value::Bool(true);
    let mut found: IndexSet<Vec<bool>, FxBuildHasher> = IndexSet::default();
    found.insert(kept.iter().map(is_true).collect());
    let (mut states, mut at): (Vec<State>, usize) = (Vec::new(), 0);
    let mut settled = Vec::new();
    while let Some(state) = found.get_index(at) {
        caller.call(&kept, state)?;
        if at == 0 {
            let begun = caller.begun.iter().enumerate();
            settled = begun.filter(|(_, active)| active.is_true()).map(|(step, _)| step).collect();
        }
        let mut arcs: BTreeMap<usize, Set> = BTreeMap::new();
        for (when, values) in apart(&caller.alphabet.all, kept.iter().map(|variable| caller.value(*variable))) {
            let to = found.insert_full(values).0;
            if found.len() > most {
                return Err(Beyond::States(most));
            }
            let so_far = arcs.entry(to).or_insert_with(|| caller.alphabet.none.clone());
            *so_far = so_far.or(&when);
        }
        let arcs = arcs.into_iter().map(|(to, when)| (when, to)).collect();
        let outputs = outputs.iter().map(|output| caller.value(*output).clone()).collect();
        states.push(State { name: String::new(), arcs, outputs });
        at += 1;
    }
    let named = |variables: &[VarId]| variables.iter().map(|v| program.variables[*v].name.to_string()).collect();
    let inputs = named(&of_role(program, Role::Input));
    let mut machine = Machine { name: program.name.clone(), inputs, outputs: named(&outputs), initial: 0, states };
    let situations = begun(&machine, situations(program, &kept, &found), settled);
    for (state, steps) in machine.states.iter_mut().zip(&situations) {
        state.name = name(program, steps);
    }
    let mut different: IndexSet<&[usize], FxBuildHasher> = IndexSet::default();
    let at_first: Vec<usize> = situations.iter().map(|steps| different.insert_full(steps).0).collect();
    Ok(numbered(quotient(&machine, &classes(&machine, &at_first))))
}

/// The active steps of each state; before the first call none is.
fn situations(program: &Program, kept: &[VarId], found: &IndexSet<Vec<bool>, FxBuildHasher>) -> Vec<Vec<usize>> {
    let steps = program.steps.iter().map(|step| match step.held {
        grafc_logic::scan::Held::Bit(variable) => kept.iter().position(|v| *v == variable),
        grafc_logic::scan::Held::State(..) => None,
    });
    let places: Vec<Option<usize>> = steps.collect();
    let active = |state: &Vec<bool>| {
        let steps = places.iter().enumerate().filter(|(_, place)| place.is_some_and(|place| state[place]));
        steps.map(|(step, _)| step).collect()
    };
    found.iter().map(active).collect()
}

fn name(program: &Program, steps: &[usize]) -> String {
    let labels = steps.iter().map(|step| program.steps[grafc_logic::scan::StepId::from_usize(*step)].label.as_str());
    labels.collect::<Vec<_>>().join(" ")
}

/// What tells states apart at first: their steps. Before the first call no step is active yet: where the same is done in the
/// situation at the start, the steps of that stand for it, else those of any state that does the same.
fn begun(machine: &Machine, mut situations: Vec<Vec<usize>>, settled: Vec<usize>) -> Vec<Vec<usize>> {
    let everywhere = classes(machine, &vec![0; machine.states.len()]);
    let same = |state: &usize| everywhere[*state] == everywhere[machine.initial];
    let mut twins = (1..machine.states.len()).filter(same).collect::<Vec<_>>();
    twins.sort_by_key(|state| situations[*state] != settled);
    if let Some(twin) = twins.first() {
        situations[machine.initial] = situations[*twin].clone();
    }
    situations
}

/// Gives states of one name numbers; that before the first call, where it is one of its own, is `start`.
fn numbered(mut machine: Machine) -> Machine {
    let mut count: BTreeMap<String, usize> = BTreeMap::new();
    machine.states.iter().for_each(|state| *count.entry(state.name.clone()).or_default() += 1);
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for (place, state) in machine.states.iter_mut().enumerate() {
        if state.name.is_empty() {
            state.name = if place == machine.initial { "start".to_owned() } else { "none".to_owned() };
        }
        let number = seen.entry(state.name.clone()).or_default();
        *number += 1;
        if count.get(&state.name).is_some_and(|count| *count > 1) {
            state.name = format!("{}'{number}", state.name);
        }
    }
    machine
}
