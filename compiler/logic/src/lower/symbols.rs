//! The variables of the program that is being made.

use crate::scan::{Flag, Role, VarId, Variable};
use ecow::EcoString;
use grafc_formula::number::zero;
use grafc_formula::{FormulaId, Pool, Type};
use grafc_model::chart::Note;
use grafc_model::chart::VariableId;
use grafc_net::Net;
use grafc_net::net::Place;
use index_vec::IndexVec;
use std::collections::BTreeMap;

/// So many variables of ours more are usual, and of many variables such a part.
const FEW: usize = 16;
const PART: usize = 64;

/// The table of variables: the chart's first, in its order, then ours as they are needed.
#[derive(Clone)]
pub(crate) struct Symbols {
    pub(crate) table: IndexVec<VarId, Variable>,
    declared: IndexVec<VariableId, VarId>,
    flags: BTreeMap<Flag, VarId>,
}

impl Symbols {
    /// The chart's own variables.
    pub(crate) fn new(net: &Net) -> Self {
        // Beside the chart's own a bit a step and, mostly, a value a transition.
        let size = net.variables.len() + net.places.len() + net.transitions.len();
        let mut table = IndexVec::with_capacity(size + size / PART + FEW);
        let declared = net
            .variables
            .iter()
            .map(|v| {
                let mut declared = Variable::declared(v);
                // What the chart assigns gets its initial value in `first`: not every compiler keeps the initial
                // values of a function block's variables. What is retained has it in both places: a controller that
                // gets a new version of the program gives it to what is new.
                if declared.role.is_kept() && !v.retain {
                    declared.set_initial(zero(v.ty));
                }
                table.push(declared)
            })
            .collect();
        Symbols { table, declared, flags: BTreeMap::new() }
    }

    /// The variable that was declared in the chart.
    pub(crate) fn declared(&self, id: VariableId) -> VarId {
        self.declared[id]
    }

    /// A new variable of ours.
    pub(crate) fn fresh(&mut self, role: Role, name: impl Into<EcoString>, ty: Type, comment: Option<Note>) -> VarId {
        self.table.push(Variable { comment, ..Variable::new(role, name, ty) })
    }

    /// A new variable for the activity of a place.
    pub(crate) fn bit(&mut self, place: &Place) -> VarId {
        self.table.push(Variable::of_step(place))
    }

    /// The variable of a flag, which exists from its first use on.
    pub(crate) fn flag(&mut self, flag: Flag) -> VarId {
        if let Some(known) = self.flags.get(&flag) {
            return *known;
        }
        let (name, comment) = match flag {
            Flag::Livelock => ("LIVELOCK", "no stable situation within the bound"),
            Flag::AllocConflict => ("ALLOC_CONFLICT", "stored actions disagreed on a value"),
            Flag::ForceConflict => ("FORCE_CONFLICT", "forcing orders disagreed on a situation"),
            Flag::Div0 => ("DIV0", "something was divided by zero"),
        };
        let variable = self.fresh(Role::Flag(flag), name, Type::Bool, Some(comment.into()));
        self.flags.insert(flag, variable);
        variable
    }

    /// The formula that reads a variable.
    pub(crate) fn read(&self, pool: &mut Pool, variable: VarId) -> FormulaId {
        pool.variable(variable, self.table[variable].ty)
    }
}
