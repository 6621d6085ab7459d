//! What gives saved memory back: the wires of the restored situation, and which steps exclude each other in it.

use crate::encode::heading::heading;
use crate::lower::cover::Cover;
use crate::lower::{Context, Lowering, Moment};
use crate::scan::{Exclusive, Heading, Restoring, Statement, VarId};
use grafc_model::chart::Mode;
use rustc_hash::FxHashSet;

/// Those wires that a call writes as well, each from the situation alone: one that follows a state in a call, too; then what
/// is `seen` of the situation; then what is `overriding` them after a call that was given up.
pub(crate) fn restoring(
    lowering: &mut Lowering,
    started: Option<VarId>,
    calls: [&[Statement]; 4],
    cover: Option<&Cover>,
    seen: Vec<Statement>,
    overriding: Option<Statement>,
) -> Restoring {
    let net = &*lowering.net.clone();
    let written = written(calls);
    let kept = std::mem::take(&mut lowering.kept_wires);
    let mut cx = Context::new(Moment::Restored);
    for v in net.variables.indices().filter(|v| net.variables[*v].mode == Mode::Wire) {
        if written.contains(&lowering.symbols.declared(v)) {
            cx.origin = lowering.wire_origin(v);
            lowering.wire(&mut cx, v);
        }
    }
    lowering.kept_wires = kept;
    let mut statements = Vec::new();
    heading(&mut statements, Heading::Outputs, cx.statements);
    statements.extend(seen);
    statements.extend(overriding);
    if let Some(started) = started.filter(|_| !statements.is_empty()) {
        // Before the first call nothing is active, whatever a state says.
        let when = lowering.symbols.read(&mut lowering.pool, started);
        statements = vec![Statement::when(when, statements)];
    }
    Restoring { statements, exclusive: cover.map(|cover| exclusive(lowering, cover)).unwrap_or_default() }
}

/// What calls write.
fn written(calls: [&[Statement]; 4]) -> FxHashSet<VarId> {
    let mut written = FxHashSet::default();
    let mut open = calls.to_vec();
    while let Some(statements) = open.pop() {
        for statement in statements {
            if let Statement::Assign { target, .. } = statement {
                written.insert(*target);
            }
            open.extend(statement.bodies());
        }
    }
    written
}

/// The sets of a cover whose steps have bits, without those that a pass has added.
fn exclusive(lowering: &Lowering, cover: &Cover) -> Vec<Exclusive> {
    let net = &lowering.net;
    let of_set = cover.sets.iter().map(|set| {
        let bits = set.steps.iter().copied().filter(|s| lowering.situation.bit(*s).is_some());
        let steps: Vec<_> = bits.filter(|s| !net.places[*s].auxiliary).collect();
        Exclusive { always: set.always_marked && steps.len() == set.steps.len(), steps }
    });
    let mut sets: Vec<Exclusive> = of_set.filter(|set| set.steps.len() > 1 || set.always).collect();
    sets.sort_by_key(|set| !set.always);
    sets
}
