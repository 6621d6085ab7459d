//! What is ours is called so that it collides with nothing; what the chart declares keeps its name.

use crate::keywords::Family;
use crate::namer::Namer;
use ecow::{EcoString, eco_format};
use grafc_logic::scan::{Program, Role, TimerId, VarId};
use index_vec::IndexVec;
use rustc_hash::FxHashSet;

/// All names.
pub(super) struct Names {
    /// The class.
    pub class: EcoString,
    /// Variables: those of the chart as it has them; what is kept of ours as a property of the memory.
    pub variables: IndexVec<VarId, EcoString>,
    /// Variables of ours as local ones.
    pub locals: IndexVec<VarId, EcoString>,
    /// Timers, as properties.
    pub timers: IndexVec<TimerId, EcoString>,
}

impl Names {
    /// Gives them.
    pub fn new(program: &Program) -> Names {
        let mut namer = Namer::new(Family::JavaScript);
        let class = namer.name(&program.name);
        let (mut ours, mut timers) = (Properties::default(), Properties::default());
        let mut variables = IndexVec::with_capacity(program.variables.len());
        let mut locals = IndexVec::with_capacity(program.variables.len());
        for variable in &program.variables {
            let is_ours = match variable.role {
                Role::Input | Role::Output | Role::Internal | Role::Constant | Role::Flag(_) => false,
                Role::Step | Role::State | Role::Memory | Role::Temporary | Role::Observed => true,
            };
            variables.push(if is_ours { ours.name(&variable.name) } else { variable.name.clone() });
            let local = if variable.role == Role::Temporary { namer.name(&variable.name) } else { EcoString::new() };
            locals.push(local);
        }
        let timers = program.timers.iter().map(|timer| timers.name(&timer.name)).collect();
        Names { class, variables, locals, timers }
    }
}

/// Names of the properties of one object: any text, each once.
#[derive(Default)]
struct Properties {
    taken: FxHashSet<EcoString>,
    next: rustc_hash::FxHashMap<EcoString, u32>,
}

impl Properties {
    fn name(&mut self, wanted: &str) -> EcoString {
        let wanted = EcoString::from(wanted);
        if self.taken.insert(wanted.clone()) {
            return wanted;
        }
        let number = self.next.entry(wanted.clone()).or_insert(1);
        loop {
            let name = eco_format!("{wanted}_{number}");
            *number += 1;
            if self.taken.insert(name.clone()) {
                return name;
            }
        }
    }
}
