//! Which grafcets are children, or enclosed in one however deep: nothing of them is active at the start (R15).

use crate::chart::{GrafcetId, Tables};
use index_vec::IndexVec;

/// For each grafcet, whether it is a child, or enclosed by a step of one, however deep. What encloses each other in a circle
/// (E0313) is in none.
pub fn below(chart: &Tables) -> IndexVec<GrafcetId, bool> {
    let mut below: IndexVec<GrafcetId, bool> = chart.grafcets.iter().map(|grafcet| grafcet.child).collect();
    let mut inside: IndexVec<GrafcetId, Vec<GrafcetId>> = chart.grafcets.iter().map(|_| Vec::new()).collect();
    for (id, grafcet) in chart.grafcets.iter_enumerated() {
        if let Some(step) = grafcet.enclosing_step.and_then(|step| chart.steps.get(step)) {
            inside[step.grafcet].push(id);
        }
    }
    let mut open: Vec<GrafcetId> = below.iter_enumerated().filter(|(_, child)| **child).map(|(id, _)| id).collect();
    while let Some(around) = open.pop() {
        for &id in &inside[around] {
            if !std::mem::replace(&mut below[id], true) {
                open.push(id);
            }
        }
    }
    below
}
