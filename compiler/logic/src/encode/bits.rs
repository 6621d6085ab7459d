//! A micro-step where each step has a bit: clearings, next situation, stored actions, and only then the bits are
//! written.

use super::sequent;
use super::task::Task;
use crate::encode::by_grafcet::{headed, sorted};
use crate::encode::clearings::{Clearings, StepEvents};
use crate::encode::heading::heading;
use crate::encode::input_event::InputEvent;
use crate::encode::next_activity::next_activity;
use crate::encode::pulses::Pulses;
use crate::encode::settle;
use crate::encode::stored;
use crate::lower::situation::Holder;
use crate::lower::{Context, Lowering};
use crate::options::Encoding;
use crate::scan::{Heading, Origin, Part, Role, Statement, Told, VarId};
use grafc_formula::{Formula, FormulaId, Type};
use grafc_model::chart::StepId;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

pub(super) fn micro_step(
    lowering: &mut Lowering,
    cx: &mut Context,
    task: &Task,
    input_event: &mut InputEvent,
    out: &mut Vec<Statement>,
) {
    heading(out, Heading::MemoryOfEdges, edges(lowering, task.again));
    if task.encoding == Encoding::Sequent
        && let Some(statements) = sequent::in_place(lowering, task)
    {
        out.extend(statements);
        return;
    }
    let overlaps = task.encoding.overlaps();
    let (frozen, freezing) = settle::frozen(lowering);
    heading(out, Heading::FrozenGrafcets, freezing);
    // The textbook's triggers write conditions out; elsewhere each clearing is named and latched.
    let (mut clearings, latched) = Clearings::new(lowering, task, &frozen, !overlaps);
    sorted(out, lowering, Part::TransitionsThatClear, latched);

    let ahead = ahead(lowering, task);
    let mut waited_for = Vec::new();
    let mut pulses = lowering.net.has_commands().then(|| Pulses::new(lowering, task, input_event, &mut waited_for));
    heading(out, Heading::EnclosuresAndOrders, waited_for);
    let next = next_situation(lowering, task, &mut clearings, &ahead, pulses.as_mut());
    headed(out, lowering, Part::NextSituation, next);
    if let Some(again) = task.again {
        let mut terms = if overlaps || pulses.is_some() {
            differences(lowering, &clearings)
        } else {
            clearings.changes(lowering, task, |_| false, |_| false)
        };
        terms.extend(pulses.iter().flat_map(|pulses| pulses.changes.iter().copied()));
        out.extend(tell(lowering, again, terms));
    }

    let step_events = StepEvents::new(lowering, &clearings, task.components);
    let actions = stored::actions(lowering, cx, task, &clearings, step_events, input_event);
    heading(out, Heading::StoredActions, actions);

    let mut situation = Vec::with_capacity(lowering.net.places.len());
    for s in lowering.net.places.indices() {
        let Holder::Bit(target) = lowering.situation.holder(s) else { continue };
        if let Some(value) = clearings.next[s] {
            if value != lowering.active(s) {
                situation.push(Statement::Assign { target, value, origin: Origin::Step(s), told: Told::Comment });
            }
        } else if task.encoding != Encoding::Sequent
            && let Some(place) = clearings.set_and_reset(lowering, s, overlaps)
        {
            // In place: clearings were latched, and a step reads no activity but its own.
            let value = next_activity(task.encoding, &mut lowering.pool, &place);
            situation.push(Statement::Assign { target, value, origin: Origin::Step(s), told: Told::Comment });
        }
    }
    if task.encoding == Encoding::Sequent && !ahead.iter().any(|needed| *needed) {
        let moves = sequent::moves(lowering, task, &clearings, |lowering, s| lowering.situation.bit(s));
        heading(out, Heading::Situation, moves);
    } else {
        // A large chart has no room for them beside statements that are put under headings.
        drop(clearings);
        sorted(out, lowering, Part::Situation, situation);
    }
    out.extend(pulses.into_iter().flat_map(|pulses| pulses.remembered));
}

/// Steps whose next activity is computed before it is written: because others need it or act on it, or because every
/// step reads its neighbours.
fn ahead(lowering: &Lowering, task: &Task) -> IndexVec<StepId, bool> {
    let mut ahead = settle::acted_on(&lowering.net);
    // What pulse orders ask for may come from anywhere.
    let all = lowering.net.has_commands()
        || match task.encoding {
            Encoding::RTrigger | Encoding::STrigger => true,
            // On copies, or not at all.
            Encoding::Sequent => ahead.iter().any(|needed| *needed),
            Encoding::SinglePhase | Encoding::Switch => false,
        };
    if all {
        ahead.iter_mut().for_each(|needed| *needed = true);
    }
    ahead
}

/// Computes the next activity of these steps, from the top of the hierarchy down.
fn next_situation(
    lowering: &mut Lowering,
    task: &Task,
    clearings: &mut Clearings,
    ahead: &IndexVec<StepId, bool>,
    mut pulses: Option<&mut Pulses>,
) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let mut statements = Vec::new();
    if !ahead.iter().any(|needed| *needed) {
        return statements;
    }
    let mut variables: IndexVec<StepId, Option<VarId>> = net.places.iter().map(|_| None).collect();
    for s in net.places.indices().filter(|s| ahead[*s]) {
        let name = format!("next_{}", net.places[s].label);
        variables[s] = Some(lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None));
    }
    if task.encoding == Encoding::Sequent {
        for (s, target) in variables.iter_enumerated().filter_map(|(s, v)| v.map(|v| (s, v))) {
            statements.push(Statement::assign(Origin::Step(s), target, lowering.active(s)));
        }
        statements.extend(sequent::moves(lowering, task, clearings, |_, s| variables[s]));
    }
    for g in &net.hierarchy {
        let grafcet = &net.grafcets[*g];
        let within =
            settle::around(lowering, *g, |lowering, e| clearings.next[e].unwrap_or_else(|| lowering.active(e)));
        let known = &clearings.next;
        let mut next = |lowering: &mut Lowering, s: StepId| known[s].unwrap_or_else(|| lowering.active(s));
        let in_force = settle::orders(lowering, task.components, *g, within, &mut next, &mut statements);
        let mut acted: FxHashMap<StepId, FormulaId> = FxHashMap::default();
        if let Some(pulses) = &mut pulses {
            for s in &grafcet.steps {
                let own = own(lowering, task, clearings, &variables, *s);
                acted.insert(*s, settle::linked(lowering, *s, own));
            }
            pulses.act(lowering, clearings, *g, (within, in_force.as_ref()), &mut acted, &mut statements);
        }
        for s in &grafcet.steps {
            let Some(target) = variables[*s] else { continue };
            let read = lowering.symbols.read(&mut lowering.pool, target);
            let value = match acted.get(s) {
                Some(acted) => settle::ordered(lowering, *s, *acted, within, in_force.as_ref()),
                None => {
                    let own = own(lowering, task, clearings, &variables, *s);
                    settle::settled(lowering, *s, own, within, in_force.as_ref())
                }
            };
            clearings.next[*s] = Some(if value == lowering.active(*s) {
                // Nothing ever changes it.
                value
            } else {
                if value != read {
                    statements.push(Statement::assign(Origin::Step(*s), target, value));
                }
                read
            });
        }
    }
    statements
}

/// What clearings alone make of a step.
fn own(
    lowering: &mut Lowering,
    task: &Task,
    clearings: &Clearings,
    variables: &IndexVec<StepId, Option<VarId>>,
    s: StepId,
) -> FormulaId {
    if let (Encoding::Sequent, Some(target)) = (task.encoding, variables[s]) {
        return lowering.symbols.read(&mut lowering.pool, target);
    }
    match clearings.set_and_reset(lowering, s, task.encoding.overlaps()) {
        Some(place) => next_activity(task.encoding, &mut lowering.pool, &place),
        None => lowering.active(s),
    }
}

/// Whether any step changes, one by one.
fn differences(lowering: &mut Lowering, clearings: &Clearings) -> Vec<FormulaId> {
    let mut terms = Vec::new();
    for s in lowering.net.places.indices() {
        if let Some(next) = clearings.next[s] {
            let active = lowering.active(s);
            terms.push(lowering.pool.xor(next, active));
        }
    }
    terms
}

/// Whether an edge operand has changed, before the memory forgets it: `again` begins with that.
pub(super) fn edges(lowering: &mut Lowering, again: Option<VarId>) -> Vec<Statement> {
    let mut statements = Vec::new();
    if let Some(target) = again.filter(|_| !lowering.edges.is_empty()) {
        let value = lowering.edges_changed();
        statements.push(Statement::assign(Origin::Chart, target, value));
    }
    statements.extend(lowering.remember_operands());
    statements
}

/// Another micro-step is needed where one of the terms holds (R8); edges have spoken before.
fn tell(lowering: &mut Lowering, again: VarId, mut terms: Vec<FormulaId>) -> Option<Statement> {
    if !lowering.edges.is_empty() {
        let edges = lowering.symbols.read(&mut lowering.pool, again);
        terms.insert(0, edges);
    }
    let value = lowering.pool.or(terms);
    let unchanged = matches!(lowering.pool.get(value), Formula::Variable(v) if *v == again);
    (!unchanged).then_some(Statement::assign(Origin::Chart, again, value))
}
