//! Where each variable lies: in the inputs, the outputs, the chart itself, or in a local variable.

use super::literals::literal;
use super::names::{RustNames, StateNames};
use ecow::{EcoString, eco_format};
use grafc_formula::{Formula, FormulaId, Type, Value};
use grafc_logic::scan::{Held, Origins, Program, Role, StepId, TimerId, VarId};
use rustc_hash::{FxHashMap, FxHashSet};

/// How the variables of one program are read and written.
pub(super) struct Places<'p> {
    program: &'p Program,
    names: &'p RustNames,
    /// Where variables come from, if somebody asks.
    pub origins: Option<Origins>,
    /// The state whose values each variable holds.
    state: FxHashMap<VarId, usize>,
    /// The steps whose bits lie in the packed situation.
    packed: FxHashMap<VarId, StepId>,
    /// Temporaries that functions pass on to each other.
    shared: FxHashSet<VarId>,
}

impl<'p> Places<'p> {
    /// Finds all places. Steps are packed where each has a bit; beside states, the few bits that are left stand alone.
    pub fn new(program: &'p Program, names: &'p RustNames) -> Self {
        let mut packed = FxHashMap::default();
        if program.states.is_empty() {
            packed.extend(program.steps.iter_enumerated().filter_map(|(s, step)| match step.held {
                Held::Bit(v) => Some((v, s)),
                Held::State(..) => None,
            }));
        }
        let state = program.state_of();
        Places { program, names, origins: None, state, packed, shared: FxHashSet::default() }
    }

    /// A variable as an operand. Of many variables these texts would be what takes most room, so none is kept.
    pub fn read(&self, id: VarId) -> EcoString {
        let name = &self.names.variables[id];
        match self.program.variables[id].role {
            Role::Input => eco_format!("inputs.{name}"),
            Role::Output => eco_format!("self.outputs.{name}"),
            Role::Internal => eco_format!("self.variables.{name}"),
            Role::Temporary if self.shared.contains(&id) => eco_format!("values.{name}"),
            Role::Constant | Role::Temporary | Role::Observed => name.clone(),
            Role::Flag(flag) => eco_format!("self.flags.{}", flag.name()),
            Role::Step => match self.packed.get(&id) {
                Some(step) => eco_format!("self.is_active({})", self.names.steps[*step]),
                None => eco_format!("self.{name}"),
            },
            Role::State | Role::Memory => eco_format!("self.{name}"),
        }
    }

    /// Temporaries that functions pass on to each other.
    pub fn share(&mut self, shared: &[VarId]) {
        self.shared.extend(shared);
    }

    /// The step whose bit in the packed situation a variable is.
    pub fn packed(&self, id: VarId) -> Option<StepId> {
        self.packed.get(&id).copied()
    }

    /// The state whose values a variable holds.
    pub fn state(&self, id: VarId) -> Option<&StateNames> {
        self.state.get(&id).map(|index| &self.names.states[*index])
    }

    /// A value of a state as a variant of its enum.
    pub fn variant(&self, id: VarId, value: i64) -> Option<EcoString> {
        self.state(id).map(|state| eco_format!("{}::{}", state.ty, state.variant(value)))
    }

    /// A value of the type that a variable has.
    pub fn value(&self, id: VarId, value: Value, ty: Type) -> EcoString {
        match value {
            Value::Int(n) => self.variant(id, n).unwrap_or_else(|| literal(value, ty)),
            Value::Bool(_) | Value::Real(_) | Value::Time(_) => literal(value, ty),
        }
    }

    /// The field of a timer.
    pub fn timer(&self, timer: TimerId) -> EcoString {
        eco_format!("self.{}", self.names.timers[timer])
    }

    /// How long a timer runs.
    pub fn preset(&self, timer: TimerId) -> EcoString {
        let preset = self.program.timers[timer].given_preset();
        match preset.constant {
            Some(constant) => self.read(constant),
            None => literal(Value::Time(preset.ms), Type::Time),
        }
    }

    /// The columns of an operand of an arithmetic operation, which is no operation itself.
    pub fn width_of_operand(&self, program: &Program, id: FormulaId) -> usize {
        match program.pool.get(id) {
            Formula::Variable(v) => self.read(*v).len(),
            Formula::Widen(a) => match program.pool.get(*a) {
                Formula::Variable(v) => self.read(*v).len() + "i32::from()".len(),
                _ => "i32::from()".len(),
            },
            Formula::TimerElapsed(t) => self.timer(*t).len() + ".elapsed()".len(),
            _ => 0,
        }
    }
}
