//! What outputs do in which situation: for who commissions a plant, and for who asks what stays on.

use crate::analysis::Analysis;
use crate::report::arrow;
use crate::spell::in_signs;
use grafc_model::chart::{Event, ExprKind, GrafcetId, Mode, StepId, Type, Value, VariableId, VariableKind};
use grafc_net::Net;
use grafc_net::net::Forced;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

/// Of a part of the chart with more situations, the steps are listed in their place.
const SITUATIONS: usize = 64;

/// What outputs do.
#[derive(Clone, Debug)]
pub struct OutputTable {
    /// Grafcet by grafcet, in order of declaration.
    pub rows: Vec<Row>,
    /// The outputs of stored actions, in order of declaration.
    pub stored: Vec<StoredOutput>,
}

/// A situation that steps which transitions connect can come to.
#[derive(Clone, Debug)]
pub struct Row {
    /// The grafcet.
    pub grafcet: GrafcetId,
    /// The active steps.
    pub steps: Vec<StepId>,
    /// Whether it is a whole situation. Else it is a single step, because the situations are too many or not all known:
    /// of steps that are active together, an output is on if one of them has it on.
    pub is_situation: bool,
    /// The outputs of continuous actions that are on or may be, and under which conditions.
    pub outputs: Vec<(VariableId, When)>,
}

/// When an output is on while steps are active.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum When {
    /// Always.
    Always,
    /// While one of these conditions is true, in the signs of the standard.
    If(Vec<String>),
}

/// An output of stored actions.
#[derive(Clone, Debug)]
pub struct StoredOutput {
    /// The output.
    pub variable: VariableId,
    /// What is stored and when, in words: `:= 1 on activation of 2`.
    pub written: Vec<String>,
    /// Whether actions set it and none ever resets it. Only of Boolean outputs.
    pub is_never_reset: bool,
    /// Orders `{}` that may leave it on: the grafcet whose actions set it, and the forcing step. Only of Boolean outputs.
    pub stays_on: Vec<(GrafcetId, StepId)>,
    /// Whether it outlives a restart of the controller.
    pub is_retained: bool,
}

/// What the outputs of a chart do.
pub fn output_table(analysis: &Analysis) -> OutputTable {
    let net = analysis.net();
    let stored = net.variables.iter_enumerated().filter(|(_, v)| v.kind == VariableKind::Output);
    let stored = stored.filter(|(_, v)| v.mode == Mode::Stored).map(|(v, _)| stored_output(net, v)).collect();
    OutputTable { rows: rows(analysis), stored }
}

fn rows(analysis: &Analysis) -> Vec<Row> {
    let net = analysis.net();
    let mut wires: FxHashMap<StepId, Vec<usize>> = FxHashMap::default();
    for (index, action) in net.continuous.iter().enumerate() {
        if net.variables[action.target].kind == VariableKind::Output {
            wires.entry(action.step).or_default().push(index);
        }
    }
    let mut rows = Vec::new();
    let mut listed: FxHashSet<StepId> = FxHashSet::default();
    for (g, grafcet) in net.grafcets.iter_enumerated() {
        let mut row = |steps: Vec<StepId>, is_situation| {
            let outputs = outputs(net, &wires, &steps);
            rows.push(Row { grafcet: g, steps, is_situation, outputs });
        };
        for s in grafcet.steps.iter().copied().filter(|s| !net.places[*s].auxiliary) {
            if listed.contains(&s) {
                continue;
            }
            let Some(situations) = analysis.reachable.part(s).and_then(|part| part.situations(SITUATIONS)) else {
                row(vec![s], analysis.one_token.contains(&s));
                continue;
            };
            listed.extend(situations.iter().flatten());
            situations.into_iter().filter(|steps| !steps.is_empty()).for_each(|steps| row(steps, true));
        }
    }
    rows
}

/// What is on while steps are active.
fn outputs(net: &Net, wires: &FxHashMap<StepId, Vec<usize>>, steps: &[StepId]) -> Vec<(VariableId, When)> {
    let mut on: IndexMap<VariableId, When, FxBuildHasher> = IndexMap::default();
    for action in steps.iter().filter_map(|s| wires.get(s)).flatten().map(|index| &net.continuous[*index]) {
        let known = on.entry(action.target).or_insert_with(|| When::If(Vec::new()));
        match (action.condition, known) {
            (None, known) => *known = When::Always,
            (Some(_), When::Always) => {}
            (Some(condition), When::If(conditions)) => {
                let condition = in_signs(net, condition);
                if !conditions.contains(&condition) {
                    conditions.push(condition);
                }
            }
        }
    }
    on.sort_unstable_keys();
    on.into_iter().collect()
}

fn stored_output(net: &Net, variable: VariableId) -> StoredOutput {
    let declared = &net.variables[variable];
    let actions = || net.stored.iter().filter(|action| action.target == variable);
    let is_bool = declared.ty == Type::Bool;
    let is = |value: bool| move |e: &grafc_model::chart::ExprId| matches!(net.exprs[*e].kind, ExprKind::Literal(Value::Bool(v)) if v == value);
    let is_never_reset = is_bool && !declared.momentary && actions().all(|action| is(true)(&action.value));
    let resets = |event: Event| actions().any(|action| action.event == event && is(false)(&action.value));
    // On no longer than a step that sets it, if that resets it when it is left.
    let outlives = |event: Event| match event {
        Event::Activation(s) | Event::Event(s, _) | Event::EachScan(s, _) => !resets(Event::Deactivation(s)),
        Event::Deactivation(_) | Event::Clearing(_) => true,
    };
    let grafcet_of = |event: Event| match event {
        Event::Activation(s) | Event::Event(s, _) | Event::Deactivation(s) | Event::EachScan(s, _) => {
            net.places[s].grafcet
        }
        Event::Clearing(t) => net.transitions[t].grafcet,
    };
    let set_in: FxHashSet<GrafcetId> = actions()
        .filter(|action| is_bool && !declared.momentary && !is(false)(&action.value) && outlives(action.event))
        .map(|action| grafcet_of(action.event))
        .collect();
    let mut stays_on = Vec::new();
    for g in net.grafcets.indices().filter(|g| set_in.contains(g)) {
        // Emptied with those that enclose it, however deep (R5a).
        let around = std::iter::successors(Some(g), |g| net.around(*g));
        for order in around.flat_map(|g| &net.grafcets[g].orders) {
            let empties = matches!(&order.forced, Forced::Steps(steps) if steps.is_empty());
            if empties && !resets(Event::Activation(order.step)) && !stays_on.contains(&(g, order.step)) {
                stays_on.push((g, order.step));
            }
        }
    }
    let written = actions().map(|action| {
        let label = |s: StepId| &net.places[s].label;
        let when = match action.event {
            Event::Event(s, e) => format!("on event {} in {}", in_signs(net, e), label(s)),
            Event::Deactivation(s) => format!("on deactivation of {}", label(s)),
            Event::Activation(s) => format!("on activation of {}", label(s)),
            Event::EachScan(s, None) => format!("each scan in {}", label(s)),
            Event::EachScan(s, Some(e)) => format!("each scan in {} if {}", label(s), in_signs(net, e)),
            Event::Clearing(t) => format!("when {} is cleared", arrow(net, t)),
        };
        format!(":= {} {when}", in_signs(net, action.value))
    });
    StoredOutput { variable, written: written.collect(), is_never_reset, stays_on, is_retained: declared.retain }
}
