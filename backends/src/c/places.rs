//! Where each variable lies: in a struct of the chart's, or in a local variable.

use super::literals::literal;
use super::names::{CNames, StateNames};
use crate::temporaries::{PARTS, Uses, temporaries};
use ecow::{EcoString, eco_format};
use grafc_formula::{Type, Value};
use grafc_logic::scan::{Origins, Preset, Program, Role, TimerId, VarId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// How the variables of one program are read and written.
pub(super) struct Places<'p> {
    pub program: &'p Program,
    pub names: &'p CNames,
    /// Where variables come from, if somebody asks.
    pub origins: Option<Origins>,
    read: IndexVec<VarId, EcoString>,
    /// The state whose values each variable holds.
    state: FxHashMap<VarId, usize>,
    temporaries: FxHashMap<VarId, Uses>,
}

/// The part that gives memory back, which is a function of its own.
pub(super) const RESTORING: usize = PARTS - 1;

impl<'p> Places<'p> {
    /// The places as a scan sees them, which is given inputs; or as what gives memory back does, which has those that the
    /// chart keeps.
    pub fn new(program: &'p Program, names: &'p CNames, restoring: bool) -> Self {
        let inputs = if restoring { "chart->kept." } else { "inputs->" };
        let read = program.variables.iter_enumerated().map(|(id, variable)| {
            let name = &names.variables[id];
            match variable.role {
                Role::Input => eco_format!("{inputs}{name}"),
                Role::Output => eco_format!("chart->outputs.{name}"),
                Role::Internal => eco_format!("chart->variables.{name}"),
                Role::Flag(flag) => eco_format!("chart->flags.{}", flag.name()),
                Role::Step | Role::State | Role::Memory => eco_format!("chart->{name}"),
                Role::Constant | Role::Temporary | Role::Observed => name.clone(),
            }
        });
        let read = read.collect();
        Places { program, names, origins: None, read, state: program.state_of(), temporaries: temporaries(program) }
    }

    /// A variable as an operand.
    pub fn read(&self, id: VarId) -> &EcoString {
        &self.read[id]
    }

    /// The field of a timer.
    pub fn timer(&self, timer: TimerId) -> EcoString {
        eco_format!("chart->{}", self.names.timers[timer])
    }

    /// How long a delay takes.
    pub fn preset(&self, preset: Preset) -> EcoString {
        match preset.constant {
            Some(constant) => self.read[constant].clone(),
            None => literal(Value::Time(preset.ms), Type::Time),
        }
    }

    /// The state whose values a variable holds.
    pub fn state(&self, id: VarId) -> Option<&StateNames> {
        self.state.get(&id).map(|state| &self.names.states[*state])
    }

    /// The type of a variable.
    pub fn type_name(&self, id: VarId) -> &str {
        match self.state(id) {
            Some(state) => &state.ty,
            None => super::literals::type_name(self.program.variables[id].ty),
        }
    }

    /// A constant as the value of a variable, of a state by its name.
    pub fn value(&self, id: VarId, value: Value) -> EcoString {
        let named = match (self.state(id), value) {
            (Some(state), Value::Int(n)) => {
                state.constant(n).cloned().or_else(|| Some(eco_format!("({}){n}", state.ty)))
            }
            _ => None,
        };
        named.unwrap_or_else(|| literal(value, self.program.variables[id].ty))
    }

    /// Whether a temporary is written once in one part and used nowhere else: it is declared where that is done.
    pub fn is_constant(&self, id: VarId) -> bool {
        // After the micro-steps it is asked whether another would be needed.
        let is_asked = self.program.repeat.is_some_and(|repeat| repeat.again == id);
        !is_asked && self.temporaries.get(&id).is_some_and(|uses| uses.is_constant() && !uses.crosses())
    }

    /// The local variables of the scan, or of what gives memory back, that are declared at its head, in order.
    pub fn declared(&self, restoring: bool) -> Vec<VarId> {
        let is_used = |uses: &Uses| {
            if restoring { uses.parts[RESTORING] } else { uses.parts[..RESTORING].contains(&true) }
        };
        let is = |(v, uses): &(&VarId, &Uses)| is_used(uses) && !self.is_constant(**v);
        let mut declared: Vec<VarId> = self.temporaries.iter().filter(is).map(|(v, _)| *v).collect();
        declared.sort_unstable();
        declared
    }
}
