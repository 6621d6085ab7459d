//! Which transitions are enabled, and which clear (R3).

use crate::encode::clearings::left_to_clear;
use crate::encode::settle;
use crate::encode::task::Task;
use crate::lower::Lowering;
use crate::scan::{Heading, Observed, Observing, Origin, Role, SeenTransition, Statement, Told, VarId};
use ecow::eco_format;
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{StepId, TransitionId};
use index_vec::IndexVec;

/// Under a guard where somebody has to ask for it.
pub(super) fn statements(
    lowering: &mut Lowering,
    task: &Task,
    conditions: &IndexVec<TransitionId, FormulaId>,
    observed: Observed,
    observing: &mut Observing,
) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let (frozen, mut body) = settle::frozen(lowering);
    let active: IndexVec<StepId, FormulaId> = if task.encoding.overlaps() {
        without_followers(lowering, task, &mut body)
    } else {
        net.places.indices().map(|s| lowering.active(s)).collect()
    };
    let auxiliary = net.places.iter().filter(|place| place.auxiliary).count();
    // Those that a pass has added come last, one for each place of its own.
    for (t, transition) in net.transitions.iter_enumerated().take(net.transitions.len() - auxiliary) {
        let around = (!transition.within.is_empty())
            .then(|| lowering.pool.or(transition.within.iter().map(|e| active[*e]).collect::<Vec<_>>()));
        let around = around.into_iter().chain(transition.pre.iter().map(|s| active[*s]));
        let free = frozen[transition.grafcet].map(|frozen| lowering.pool.not(frozen));
        let left = left_to_clear(lowering, t);
        let value = lowering.pool.and(around.chain(free).chain(left));
        let enabled = set(lowering, "enabled", t, value, Told::All, &mut body);
        let is_enabled = lowering.symbols.read(&mut lowering.pool, enabled);
        let (satisfied, condition) = match observed {
            Observed::All => {
                let satisfied = set(lowering, "satisfied", t, conditions[t], Told::Nothing, &mut body);
                (Some(satisfied), lowering.symbols.read(&mut lowering.pool, satisfied))
            }
            Observed::Nothing | Observed::Transitions => (None, conditions[t]),
        };
        let value = lowering.pool.and([is_enabled, condition]);
        let cleared = set(lowering, "cleared", t, value, Told::Nothing, &mut body);
        observing.transitions.push(SeenTransition { transition: t, enabled, cleared, satisfied });
    }
    if body.is_empty() {
        return body;
    }
    body.insert(0, Statement::Heading(Heading::WhatIsSeenOfTransitions));
    if observed == Observed::All {
        return body;
    }
    let about = "whether somebody looks at the transitions";
    let wanted = lowering.symbols.fresh(Role::Observed, "observed", Type::Bool, Some(about.into()));
    observing.wanted = Some(wanted);
    let when = lowering.symbols.read(&mut lowering.pool, wanted);
    vec![Statement::when(when, body)]
}

fn set(
    lowering: &mut Lowering,
    word: &str,
    t: TransitionId,
    value: FormulaId,
    told: Told,
    out: &mut Vec<Statement>,
) -> VarId {
    let name = eco_format!("{word}_{}", lowering.transition_word(t));
    let target = lowering.symbols.fresh(Role::Observed, name, Type::Bool, None);
    out.push(Statement::Assign { target, value, origin: Origin::Transition(t), told });
    target
}

/// Where steps overlap, one that has been left is active for one micro-step beside its successor. By the rules it is not.
fn without_followers(lowering: &mut Lowering, task: &Task, out: &mut Vec<Statement>) -> IndexVec<StepId, FormulaId> {
    let net = &*lowering.net.clone();
    let mut after: IndexVec<TransitionId, FormulaId> = IndexVec::with_capacity(net.transitions.len());
    for (t, transition) in net.transitions.iter_enumerated() {
        let entered: Vec<FormulaId> = transition.entered().into_iter().map(|s| lowering.active(s)).collect();
        let any = lowering.pool.or(entered);
        let name = eco_format!("after_{}", lowering.transition_word(t));
        after.push(lowering.named(Origin::Transition(t), &name, any, out));
    }
    let of = |s: StepId| {
        let followed: Vec<FormulaId> = task.arcs.out_of_step(s).iter().map(|t| after[*t]).collect();
        let followed = lowering.pool.or(followed);
        let alone = lowering.pool.not(followed);
        let value = lowering.pool.and([lowering.active(s), alone]);
        let name = eco_format!("still_{}", net.places[s].label);
        lowering.named(Origin::Step(s), &name, value, out)
    };
    net.places.indices().map(of).collect()
}
