//! Transitions that one row of inputs lets clear in a circle: `1 -> 2 : start`, `2 -> 1 : stop`, with both pressed.
//!
//! Inputs stand still during a reaction (R9), so while they are so the situation changes without end, and the reaction is
//! given up at its bound (LIVELOCK). Looked at are conditions of Boolean inputs alone: an edge is over after one
//! micro-step, a delay waits for time to pass. A circle is told of only after the row has been tried, step by step: what
//! else the row lets clear may lead out of it. That is done where a grafcet stands by itself: an enclosure is given up
//! with its enclosing step, an order stops a circle, and a circle through an enclosing or a forcing step takes other
//! grafcets along. Nor is a circle told of through a step after which two transitions may clear together (W0409): that
//! these inputs may be true at once has been said there.

use super::possible::Never;
use crate::analysis::together::questions::Questions;
use crate::analysis::together::witness::{self, Case, SearchResult};
use grafc_model::chart::{ExprId, ExprKind, Mode, StepId, TransitionId, Type, Value, VariableId, VariableKind};
use grafc_net::Net;
use index_vec::{IndexVec, index_vec};
use rustc_hash::{FxHashMap, FxHashSet};

/// Longer circles are not looked for.
const LONGEST: usize = 64;

/// From one step so many transitions are tried at most.
const MOST: usize = 2_048;

/// And so many in all for each step of the net, beyond the first few.
const TRIED: usize = 64;

/// When circles are followed, so many active steps are looked at for each step of the net, beyond [`MOST`] of them.
const FOLLOWED: usize = 256;

/// More transitions beside the first are not looked at after one step.
const AFTER: usize = 8;

/// Transitions in a circle, and what the inputs are while all of them hold.
#[derive(Clone)]
pub(crate) struct Ring {
    /// In order of the circle, from the one that comes first in the text.
    pub(crate) transitions: Vec<TransitionId>,
    pub(crate) row: Case,
}

/// At most one for each set of steps that circles share.
pub(super) fn find(asked: &mut Questions, never: &Never) -> Vec<Ring> {
    let net = asked.analysis.net();
    let mut told_or_above: FxHashSet<StepId> = net.places.iter().filter_map(|place| place.within).collect();
    told_or_above.extend(net.grafcets.iter().flat_map(|grafcet| &grafcet.orders).map(|order| order.step));
    told_or_above.extend(asked.analysis.together().clearings.iter().map(|clashes| clashes.step));
    let literals: IndexVec<TransitionId, Option<Literals>> = net
        .transitions
        .iter_enumerated()
        .map(|(t, transition)| {
            let stands_alone = transition.within.is_none() && net.grafcets[transition.grafcet].orders.is_empty();
            let counts = stands_alone
                && !transition.pre.is_empty()
                && transition.pre.iter().all(|step| !told_or_above.contains(step))
                && !never.clears[t]
                && is_of_inputs(net, transition.condition);
            counts.then(|| factors(net, transition.condition))
        })
        .collect();
    let mut found = Vec::new();
    // A step is left for good once it was the start of a search, so each circle is looked for from its first step.
    let mut done: IndexVec<StepId, bool> = index_vec![false; net.places.len()];
    let component = components(net, asked, &literals);
    let mut told: FxHashSet<usize> = FxHashSet::default();
    let mut left = MOST + TRIED * net.places.len();
    let mut followed = MOST + FOLLOWED * net.places.len();
    for start in net.places.indices() {
        let Some(number) = component[start] else { continue };
        if told.contains(&number) {
            continue;
        }
        let mut search = Search {
            net,
            asked,
            literals: &literals,
            component: &component,
            done: &done,
            start,
            left: &mut left,
            followed: &mut followed,
        };
        if let Some(ring) = search.run() {
            told.insert(number);
            found.push(ring);
        }
        done[start] = true;
    }
    found
}

/// The inputs that a condition asserts or denies as factors.
type Literals = Vec<(VariableId, bool)>;

struct Search<'q, 'a> {
    net: &'a Net,
    asked: &'q mut Questions<'a>,
    literals: &'q IndexVec<TransitionId, Option<Literals>>,
    component: &'q IndexVec<StepId, Option<usize>>,
    done: &'q IndexVec<StepId, bool>,
    start: StepId,
    /// How many transitions may still be tried.
    left: &'q mut usize,
    /// How many active steps may still be looked at.
    followed: &'q mut usize,
}

impl Search<'_, '_> {
    /// Goes along the arcs and back, as long as the factors of the conditions agree.
    fn run(&mut self) -> Option<Ring> {
        let mut row: FxHashMap<VariableId, (bool, usize)> = FxHashMap::default();
        let mut path: Vec<(TransitionId, StepId)> = Vec::new();
        let mut on_path: FxHashSet<StepId> = FxHashSet::default();
        let mut open: Vec<Vec<(TransitionId, StepId)>> = vec![self.next(self.start)];
        let mut tried = 0;
        while let Some(choices) = open.last_mut() {
            let Some((t, to)) = choices.pop() else {
                open.pop();
                if let Some((back, to)) = path.pop() {
                    self.take_back(&mut row, back);
                    on_path.remove(&to);
                }
                continue;
            };
            tried += 1;
            let left = self.left.checked_sub(1).filter(|_| tried < MOST)?;
            *self.left = left;
            if path.len() >= LONGEST || on_path.contains(&to) || !self.agrees(&row, t) {
                continue;
            }
            path.push((t, to));
            if to == self.start {
                let transitions: Vec<TransitionId> = path.iter().map(|(t, _)| *t).collect();
                if let Some(ring) = self.ring(&transitions) {
                    return Some(ring);
                }
                path.pop();
                continue;
            }
            for (v, value) in self.literals[t].iter().flatten() {
                row.entry(*v).or_insert((*value, 0)).1 += 1;
            }
            on_path.insert(to);
            let next = self.next(to);
            open.push(next);
        }
        None
    }

    fn take_back(&self, row: &mut FxHashMap<VariableId, (bool, usize)>, t: TransitionId) {
        for (v, _) in self.literals[t].iter().flatten() {
            if let Some((_, count)) = row.get_mut(v) {
                *count -= 1;
                if *count == 0 {
                    row.remove(v);
                }
            }
        }
    }

    fn agrees(&self, row: &FxHashMap<VariableId, (bool, usize)>, t: TransitionId) -> bool {
        self.literals[t].iter().flatten().all(|(v, value)| row.get(v).is_none_or(|(known, _)| known == value))
    }

    /// The transitions after a step within its component, each with a step that it leads to; the last is tried first.
    fn next(&self, step: StepId) -> Vec<(TransitionId, StepId)> {
        let mut next = Vec::new();
        for t in self.asked.analysis.arcs.leaving(step).iter().take(AFTER).copied() {
            let steps = self.net.transitions[t].post.iter().copied().take(AFTER);
            let within = |to: &StepId| self.component[*to] == self.component[step] && !self.done[*to] && *to != step;
            if self.literals[t].is_some() {
                next.extend(steps.filter(within).map(|to| (t, to)));
            }
        }
        next.reverse();
        next
    }

    /// The circle, if there is a row of inputs with which it goes on without end.
    fn ring(&mut self, path: &[TransitionId]) -> Option<Ring> {
        let net = self.net;
        let conditions: Vec<ExprId> = path.iter().map(|t| net.transitions[*t].condition).collect();
        let SearchResult::Case(row) = witness::search(self.asked, &conditions, &[]) else { return None };
        if row.is_empty() {
            return None; // W0407
        }
        let mut inputs: FxHashMap<VariableId, bool> = FxHashMap::default();
        for (atom, value) in &row {
            let ExprKind::Variable(v) = net.exprs[(*atom)?].kind else { return None };
            inputs.insert(v, *value);
        }
        self.goes_on(path, &inputs).then_some(())?;
        let first = (0..path.len()).min_by_key(|i| net.transitions[path[*i]].span)?;
        let transitions = path[first..].iter().chain(&path[..first]).copied().collect();
        Some(Ring { transitions, row })
    }

    /// Whether the situation before the first transition is never at rest with this row. Transitions on which something
    /// else decides stay uncleared, as they may.
    fn goes_on(&mut self, path: &[TransitionId], inputs: &FxHashMap<VariableId, bool>) -> bool {
        let net = self.net;
        let mut situation = net.transitions[path[0]].pre.clone();
        situation.sort_unstable();
        let mut seen: FxHashSet<Vec<StepId>> = FxHashSet::default();
        for _ in 0..4 * path.len() + 8 {
            let Some(left) = self.followed.checked_sub(situation.len()) else { return false };
            *self.followed = left;
            if !seen.insert(situation.clone()) {
                return true;
            }
            let arcs = &self.asked.analysis.arcs;
            // Each of them once: a synchronisation comes after many steps.
            let after: FxHashSet<TransitionId> =
                situation.iter().flat_map(|step| arcs.leaving(*step)).copied().collect();
            let clears = |t: &TransitionId| {
                let ready = net.transitions[*t].pre.iter().all(|step| situation.binary_search(step).is_ok());
                ready && self.literals[*t].is_some() && holds(net, net.transitions[*t].condition, inputs)
            };
            let cleared: FxHashSet<TransitionId> = after.into_iter().filter(clears).collect();
            let left: FxHashSet<StepId> = cleared.iter().flat_map(|t| &net.transitions[*t].pre).copied().collect();
            let mut next: Vec<StepId> = situation.iter().copied().filter(|step| !left.contains(step)).collect();
            next.extend(cleared.iter().flat_map(|t| &net.transitions[*t].post));
            next.sort_unstable();
            next.dedup();
            if next == situation {
                return false;
            }
            situation = next;
        }
        false
    }
}

/// Whether a condition is of Boolean inputs and constants alone.
fn is_of_inputs(net: &Net, condition: ExprId) -> bool {
    let mut open = vec![condition];
    while let Some(e) = open.pop() {
        let counts = match net.exprs[e].kind {
            ExprKind::Variable(v) => net.variables[v].mode == Mode::Given && net.variables[v].ty == Type::Bool,
            ExprKind::Literal(Value::Bool(_))
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..) => true,
            ExprKind::Literal(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => false,
        };
        if !counts {
            return false;
        }
        open.extend(net.exprs[e].kind.operands());
    }
    true
}

/// The inputs among the factors of a condition.
fn factors(net: &Net, condition: ExprId) -> Literals {
    let input = |v: VariableId| net.variables[v].kind == VariableKind::Input;
    let mut literals = Literals::new();
    let mut open = vec![condition];
    while let Some(e) = open.pop() {
        if let ExprKind::And(a, b) = net.exprs[e].kind {
            open.extend([b, a]);
        } else if let ExprKind::Variable(v) = net.exprs[e].kind {
            literals.extend(input(v).then_some((v, true)));
        } else if let ExprKind::Not(a) = net.exprs[e].kind
            && let ExprKind::Variable(v) = net.exprs[a].kind
        {
            literals.extend(input(v).then_some((v, false)));
        }
    }
    literals
}

/// The value of a condition of inputs; those that nothing is said of are false.
fn holds(net: &Net, condition: ExprId, inputs: &FxHashMap<VariableId, bool>) -> bool {
    let mut inside = vec![condition];
    let mut at = 0;
    while let Some(e) = inside.get(at).copied() {
        inside.extend(net.exprs[e].kind.operands());
        at += 1;
    }
    // Operands have smaller ids than what uses them.
    inside.sort_unstable();
    inside.dedup();
    let mut values: FxHashMap<ExprId, bool> = FxHashMap::default();
    for e in inside {
        let of = |a: ExprId| values.get(&a).copied().unwrap_or(false);
        let value = match net.exprs[e].kind {
            ExprKind::Variable(v) => match (inputs.get(&v), net.variables[v].initial) {
                (Some(value), _) => *value,
                (None, Value::Bool(value)) => net.variables[v].kind != VariableKind::Input && value,
                (None, Value::Int(_) | Value::Real(_) | Value::Time(_)) => false,
            },
            ExprKind::Literal(value) => value == Value::Bool(true),
            ExprKind::Not(a) => !of(a),
            ExprKind::And(a, b) => of(a) && of(b),
            ExprKind::Or(a, b) => of(a) || of(b),
            ExprKind::Xor(a, b) => of(a) != of(b),
            // None of these is in a condition of inputs.
            ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => false,
        };
        values.insert(e, value);
    }
    values.get(&condition).copied().unwrap_or(false)
}

/// The steps that lie on circles of such transitions, those of one circle with one number (Tarjan). The circles lead
/// through steps and transitions in turn, so that a transition with n steps on both sides is 2 n arcs and not n * n.
fn components(
    net: &Net,
    asked: &Questions,
    literals: &IndexVec<TransitionId, Option<Literals>>,
) -> IndexVec<StepId, Option<usize>> {
    let steps = net.places.len();
    let successors = |node: usize| -> Box<dyn Iterator<Item = usize>> {
        if node < steps {
            let counted = asked.analysis.arcs.leaving(StepId::from_usize(node)).iter();
            Box::new(counted.filter(|t| literals[**t].is_some()).map(move |t| steps + t.index()))
        } else {
            Box::new(net.transitions[TransitionId::from_usize(node - steps)].post.iter().map(|step| step.index()))
        }
    };
    let count = steps + net.transitions.len();
    let mut number: Vec<usize> = vec![usize::MAX; count];
    let mut low = number.clone();
    let mut component: IndexVec<StepId, Option<usize>> = index_vec![None; steps];
    let mut is_open = vec![false; count];
    let (mut next_number, mut next_component) = (0, 0);
    let mut stack: Vec<usize> = Vec::new();
    for root in 0..steps {
        if number[root] != usize::MAX {
            continue;
        }
        let mut calls: Vec<(usize, Box<dyn Iterator<Item = usize>>)> = Vec::new();
        let mut enter = |node: usize, number: &mut Vec<usize>, low: &mut Vec<usize>| {
            number[node] = next_number;
            low[node] = next_number;
            next_number += 1;
        };
        enter(root, &mut number, &mut low);
        stack.push(root);
        is_open[root] = true;
        calls.push((root, successors(root)));
        while let Some((node, rest)) = calls.last_mut() {
            let node = *node;
            match rest.next() {
                Some(to) if number[to] == usize::MAX => {
                    enter(to, &mut number, &mut low);
                    stack.push(to);
                    is_open[to] = true;
                    calls.push((to, successors(to)));
                }
                Some(to) => {
                    if is_open[to] {
                        low[node] = low[node].min(number[to]);
                    }
                }
                None => {
                    calls.pop();
                    if let Some((above, _)) = calls.last() {
                        low[*above] = low[*above].min(low[node]);
                    }
                    if low[node] == number[node] {
                        let from = stack.iter().rposition(|n| *n == node).unwrap_or_default();
                        let members = stack.split_off(from);
                        // A circle that comes back to its only step at once is none.
                        let is_circle = members.iter().filter(|n| **n < steps).count() > 1;
                        for member in members {
                            is_open[member] = false;
                            if member < steps && is_circle {
                                component[StepId::from_usize(member)] = Some(next_component);
                            }
                        }
                        next_component += 1;
                    }
                }
            }
        }
    }
    component
}
