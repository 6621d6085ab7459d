//! Outputs on arcs of automata in a chart that evolves to stability: each reaction begins with them false, and those that it
//! takes make theirs true.

use super::heading::heading;
use crate::lower::Lowering;
use crate::scan::{Heading, Origin, Statement};

/// Once a call, before the evolution.
pub(crate) fn statements(lowering: &mut Lowering) -> Vec<Statement> {
    let no = lowering.pool.truth(false);
    let net = lowering.net.clone();
    let momentary = net.variables.iter_enumerated().filter(|(_, variable)| variable.momentary);
    let over = momentary.map(|(v, _)| Statement::assign(Origin::Declaration(v), lowering.symbols.declared(v), no));
    let mut out = Vec::new();
    heading(&mut out, Heading::OutputsOnArcs, over.collect());
    out
}
