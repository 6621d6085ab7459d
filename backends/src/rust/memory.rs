//! What a chart remembers from scan to scan: its fields, and the packed situation.

use super::places::Places;
use grafc_logic::scan::{Program, Role, VarId};

/// The bits of a word of the packed situation.
pub(super) const WORD: usize = 32;

/// How many words hold the packed situation; none where steps are held otherwise.
pub(super) fn words(program: &Program) -> usize {
    if program.states.is_empty() { program.steps.len().div_ceil(WORD) } else { 0 }
}

/// The fields that are not packed, in groups.
pub(super) fn fields(program: &Program, places: &Places) -> Vec<(&'static str, Vec<VarId>)> {
    let all = |wanted: fn(Role) -> bool| -> Vec<VarId> {
        let ids = program.variables.iter_enumerated().filter(|(_, v)| wanted(v.role)).map(|(id, _)| id);
        ids.filter(|id| places.packed(*id).is_none()).collect()
    };
    vec![
        ("which step is active", all(|role| role == Role::State)),
        ("steps", all(|role| role == Role::Step)),
        ("memory from scan to scan", all(|role| role == Role::Memory)),
    ]
}
