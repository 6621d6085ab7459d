//! Where each declared variable is read and set first.

use crate::chart::VariableId;
use crate::resolve::Resolved;
use crate::symbols::{Entity, Role};
use grafc_diagnostics::Span;
use index_vec::{IndexVec, index_vec};

/// The first places in the text; none if there are none.
#[derive(Clone, Copy, Default)]
pub struct Usage {
    /// Where it is read, in a condition, a value, a delay, another declaration.
    pub read: Option<Span>,
    /// Where an action sets it.
    pub set: Option<Span>,
}

/// How each variable is used.
pub fn usage(resolved: &Resolved) -> IndexVec<VariableId, Usage> {
    let mut usage: IndexVec<VariableId, Usage> = index_vec![Usage::default(); resolved.chart.variables.len()];
    for found in &resolved.symbols.uses {
        let Entity::Variable(id) = found.entity else { continue };
        let place = match found.role {
            Role::Read => &mut usage[id].read,
            Role::Assigned => &mut usage[id].set,
            Role::Before | Role::After | Role::Forced | Role::Enclosing | Role::Expanded | Role::Allowed => continue,
        };
        let first = place.get_or_insert(found.span);
        *first = (*first).min(found.span);
    }
    usage
}
