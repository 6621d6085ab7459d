//! The names of everything in a source and its header. What stands at the top of these is the chart's name, an underscore
//! and a word; constants are in capital letters.

use crate::keywords::Family;
use crate::namer::{MAX_LENGTH, Namer};
use crate::transliterate::identifier;
use ecow::{EcoString, eco_format};
use grafc_logic::scan::{Program, Role, StepId, TimerId, VarId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// All names.
pub struct CNames {
    /// The type of the chart: `Lamp`.
    pub chart: EcoString,
    /// The same before constants: `LAMP`.
    pub capitals: EcoString,
    /// Variables without what they are part of: `full`, not `chart->outputs.full`; constants whole.
    pub variables: IndexVec<VarId, EcoString>,
    /// The constants of steps, whole: `LAMP_X1`.
    pub steps: IndexVec<StepId, EcoString>,
    pub(super) timers: IndexVec<TimerId, EcoString>,
    /// The type of each state, and its constants by value.
    pub(super) states: Vec<StateNames>,
    /// Counts micro-steps where the program has no variable for that.
    pub(super) count: EcoString,
}

/// The names of a state.
pub(super) struct StateNames {
    /// The enum.
    pub ty: EcoString,
    /// What each value is called, the idle one first, then in order of declaration.
    pub constants: Vec<(i64, EcoString)>,
    by_value: FxHashMap<i64, usize>,
}

impl StateNames {
    /// What a value is called.
    pub fn constant(&self, value: i64) -> Option<&EcoString> {
        self.by_value.get(&value).map(|place| &self.constants[*place].1)
    }
}

impl CNames {
    /// Names by rank: what the chart declares, then what is ours.
    pub(super) fn new(program: &Program) -> Self {
        let chart = Namer::new(Family::C).name(&program.name);
        let capitals = chart.to_ascii_uppercase();
        let mut variables: IndexVec<VarId, EcoString> = program.variables.iter().map(|_| EcoString::new()).collect();
        let mut give = |namer: &mut Namer, wanted: &dyn Fn(Role) -> bool| {
            let ids: Vec<VarId> = program.variables.indices().filter(|v| wanted(program.variables[*v].role)).collect();
            let wishes = ids.iter().map(|v| program.variables[*v].name.clone());
            for (v, name) in ids.iter().zip(namer.names(wishes)) {
                variables[*v] = name;
            }
        };
        // Each group is a struct of its own.
        for role in [Role::Input, Role::Output, Role::Internal] {
            give(&mut Namer::new(Family::C), &|other| other == role);
        }
        let mut memory = Namer::new(Family::C);
        give(&mut memory, &|role| matches!(role, Role::Step | Role::State | Role::Memory));
        let timers = program.timers.iter().map(|timer| memory.name(&timer.name)).collect();
        let mut locals = Namer::new(Family::C);
        give(&mut locals, &|role| matches!(role, Role::Temporary | Role::Observed | Role::Flag(_)));
        let count = locals.name("micro_steps");
        let mut constants = Namer::new(Family::C);
        let mut whole = |wanted: &str| eco_format!("{capitals}_{}", constants.name(&wanted.to_ascii_uppercase()));
        let steps: IndexVec<StepId, EcoString> =
            program.steps.iter().map(|step| whole(&activity(&step.label))).collect();
        for (id, variable) in program.of_role(Role::Constant) {
            variables[id] = whole(&identifier(&variable.name, MAX_LENGTH));
        }
        let mut types = Namer::new(Family::C);
        let states = program.states.iter().map(|state| {
            let name = types.name(&program.variables[state.variable].name);
            let mut names: Vec<(i64, EcoString)> = Vec::with_capacity(state.values.len() + 1);
            names.extend(state.idle.map(|idle| (idle, whole(&eco_format!("{name}_none")))));
            names.extend(state.values.iter().map(|(s, value)| {
                let step = activity(&program.steps[*s].label);
                (*value, whole(&eco_format!("{name}_{step}")))
            }));
            let by_value = names.iter().enumerate().map(|(place, (value, _))| (*value, place)).collect();
            StateNames { ty: eco_format!("{chart}_{name}"), constants: names, by_value }
        });
        let states = states.collect();
        CNames { variables, timers, steps, states, count, chart, capitals }
    }
}

/// The standard's variable of a step's activity.
fn activity(label: &str) -> EcoString {
    identifier(&eco_format!("X{label}"), MAX_LENGTH)
}
