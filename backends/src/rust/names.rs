//! The names of everything in one file of Rust, each in the case that Rust has for its kind.

use crate::keywords::Family;
use crate::namer::{MAX_LENGTH, Namer};
use crate::transliterate::identifier;
use ecow::{EcoString, eco_format};
use grafc_logic::scan::{Program, Role, StepId, TimerId, VarId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// All names. Values are unique in the whole file, and so are types, variants of `Step` and constants: readers search for
/// them.
pub struct RustNames {
    /// Variables without what they are part of: `full`, not `inputs.full`.
    pub variables: IndexVec<VarId, EcoString>,
    /// The chart's type.
    pub chart: EcoString,
    /// The variants of `Step`.
    pub steps: IndexVec<StepId, EcoString>,
    pub(super) timers: IndexVec<TimerId, EcoString>,
    /// The type of each state, and its variants by value.
    pub(super) states: Vec<StateNames>,
}

/// The names of a state.
pub(super) struct StateNames {
    /// The enum.
    pub ty: EcoString,
    /// What each value is called, the idle one first, then in order of declaration.
    pub variants: Vec<(i64, EcoString)>,
    by_value: FxHashMap<i64, usize>,
}

impl StateNames {
    /// At which place of the variants a value is.
    pub fn place(&self, value: i64) -> usize {
        self.by_value.get(&value).copied().unwrap_or_default()
    }

    /// What a value is called.
    pub fn variant(&self, value: i64) -> &str {
        self.by_value.get(&value).map_or("", |place| &self.variants[*place].1)
    }
}

impl RustNames {
    /// Names by rank: what the chart declares, then what is ours.
    pub(super) fn new(program: &Program) -> Self {
        let mut values = Namer::new(Family::RustValues);
        let mut types = Namer::new(Family::RustTypes);
        let chart = types.name(&camel(&program.name));
        let mut variables: IndexVec<VarId, EcoString> = program.variables.iter().map(|_| EcoString::new()).collect();
        let mut give = |namer: &mut Namer, case: fn(&str) -> EcoString, wanted: &dyn Fn(Role) -> bool| {
            let ids: Vec<VarId> = program.variables.indices().filter(|v| wanted(program.variables[*v].role)).collect();
            let wishes = ids.iter().map(|v| case(&program.variables[*v].name));
            for (v, name) in ids.iter().zip(namer.names(wishes)) {
                variables[*v] = name;
            }
        };
        give(&mut types, screaming, &|role| role == Role::Constant);
        give(&mut values, snake, &|role| matches!(role, Role::Input | Role::Output | Role::Internal));
        give(&mut values, snake, &|role| {
            matches!(role, Role::Step | Role::State | Role::Flag(_) | Role::Memory | Role::Temporary)
        });
        let timers = program.timers.iter().map(|timer| values.name(&snake(&timer.name))).collect();
        let wishes = program.steps.iter().map(|step| variant(&step.label));
        let steps: IndexVec<StepId, EcoString> = types.names(wishes).into();
        let states = program.states.iter().map(|state| {
            let ty = types.name(&camel(&program.variables[state.variable].name));
            // Always written with their type, so what they are called elsewhere does not matter.
            let mut own = Namer::new(Family::RustTypes);
            let given = own.names(state.values.iter().map(|(s, _)| steps[*s].clone()));
            let mut variants: Vec<(i64, EcoString)> = state.values.iter().map(|(_, n)| *n).zip(given).collect();
            if let Some(idle) = state.idle {
                variants.insert(0, (idle, "None".into()));
            }
            let by_value = variants.iter().enumerate().map(|(place, (value, _))| (*value, place)).collect();
            StateNames { ty, variants, by_value }
        });
        let states = states.collect();
        RustNames { variables, timers, chart, steps, states }
    }
}

/// A name for a module.
pub(super) fn module(wanted: &str) -> EcoString {
    Namer::new(Family::RustValues).name(&snake(wanted))
}

/// `weighA` and `Weigh_A` to `weigh_a`: a name of a field, a variable or a function.
fn snake(name: &str) -> EcoString {
    let name = identifier(name, MAX_LENGTH);
    let mut out = EcoString::new();
    let mut before_is_small = false;
    for c in name.chars() {
        if c.is_ascii_uppercase() && before_is_small {
            out.push('_');
        }
        before_is_small = c.is_ascii_lowercase();
        out.push(c.to_ascii_lowercase());
    }
    out
}

/// A name of a constant.
fn screaming(name: &str) -> EcoString {
    snake(name).to_ascii_uppercase()
}

/// `weigh_mix_b4` to `WeighMixB4`, `at_G1_1` to `AtG1_1`: a name of a type. Between digits the underscore stays.
fn camel(name: &str) -> EcoString {
    let name = identifier(name, MAX_LENGTH);
    let mut out = EcoString::new();
    for word in name.split('_').filter(|word| !word.is_empty()) {
        let digits_meet = out.ends_with(|c: char| c.is_ascii_digit()) && word.starts_with(|c: char| c.is_ascii_digit());
        if digits_meet {
            out.push('_');
        }
        let mut letters = word.chars();
        out.extend(letters.next().map(|c| c.to_ascii_uppercase()));
        out.push_str(letters.as_str());
    }
    out
}

/// A step as a variant: `X` before a number, as in the standard's variable of its activity.
fn variant(label: &str) -> EcoString {
    if label.starts_with(|c: char| c.is_ascii_digit()) { camel(&eco_format!("X{label}")) } else { camel(label) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cases() {
        for (name, small, large) in [
            ("CS", "cs", "CS"),
            ("TM_down", "tm_down", "TMDown"),
            ("startButton", "start_button", "StartButton"),
            ("at_G1_1", "at_g1_1", "AtG1_1"),
            ("weigh_mix_b4", "weigh_mix_b4", "WeighMixB4"),
            ("X1", "x1", "X1"),
        ] {
            assert_eq!(snake(name), small);
            assert_eq!(camel(name), large);
        }
        assert_eq!(screaming("mixTime"), "MIX_TIME");
        assert_eq!(variant("20"), "X20");
        assert_eq!(variant("Fill"), "Fill");
    }
}
