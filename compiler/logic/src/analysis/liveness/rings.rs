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
use crate::analysis::parts::Parts;
use crate::analysis::together::questions::Questions;
use crate::analysis::together::witness::{self, Case, SearchResult};
use grafc_model::chart::{ExprId, ExprKind, Mode, StepId, TransitionId, Type, Value, VariableId, VariableKind, below};
use grafc_net::Net;
use index_vec::{IndexVec, index_vec};
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;

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
    let factors = Factors::of(asked, never);
    let mut found = Vec::new();
    let mut left = MOST + TRIED * net.places.len();
    let (part_of, parts) = parts(asked, &factors);
    let mut is_over: Vec<bool> = parts.iter().map(|part| part.is_one_circle && part.steps > LONGEST).collect();
    let mut search = Search::new(asked, &factors, &part_of);
    for start in net.places.indices() {
        let Some(part) = part_of[start].filter(|part| !is_over[*part]) else { continue };
        let ring = search.from(start, &mut left);
        // A part that is one circle has been seen whole.
        is_over[part] = ring.is_some() || parts[part].is_one_circle;
        found.extend(ring);
    }
    found
}

/// The inputs that the conditions assert or deny as factors, of those transitions that are looked at.
struct Factors {
    all: Vec<(VariableId, bool)>,
    /// Where those of each transition lie.
    of: IndexVec<TransitionId, Option<Range<usize>>>,
}

impl Factors {
    fn of(asked: &Questions, never: &Never) -> Factors {
        let net = asked.analysis.net();
        let mut told_or_above: IndexVec<StepId, bool> = index_vec![false; net.places.len()];
        let around = net.places.iter().flat_map(|place| place.within.iter().copied());
        let forcing = net.grafcets.iter().flat_map(|grafcet| &grafcet.orders).map(|order| order.step);
        let told = asked.analysis.together().clearings.iter().map(|clashes| clashes.step);
        around.chain(forcing).chain(told).for_each(|step| told_or_above[step] = true);
        let mut factors = Factors { all: Vec::new(), of: IndexVec::with_capacity(net.transitions.len()) };
        for (t, transition) in net.transitions.iter_enumerated() {
            let stands_alone = transition.within.is_empty() && net.grafcets[transition.grafcet].orders.is_empty();
            let counts = stands_alone
                && !transition.pre.is_empty()
                && transition.pre.iter().all(|step| !told_or_above[*step])
                && !never.clears[t]
                && is_of_inputs(net, transition.condition);
            let begin = factors.all.len();
            if counts {
                add_factors(net, transition.condition, &mut factors.all);
            }
            factors.of.push(counts.then_some(begin..factors.all.len()));
        }
        factors
    }

    fn counts(&self, t: TransitionId) -> bool {
        self.of[t].is_some()
    }

    fn get(&self, t: TransitionId) -> &[(VariableId, bool)] {
        self.of[t].as_ref().map_or(&[], |range| &self.all[range.clone()])
    }
}

/// Steps that lie on circles together.
struct Part {
    steps: usize,
    /// Whether it has no other way than once round.
    is_one_circle: bool,
}

/// The part of each step that lies on a circle of transitions that are looked at.
fn parts(asked: &Questions, factors: &Factors) -> (IndexVec<StepId, Option<usize>>, Vec<Part>) {
    let net = asked.analysis.net();
    // The circles lead through steps and transitions in turn, so that a transition with n steps on both sides is 2 n arcs
    // and not n * n.
    let steps = net.places.len() as u32;
    let successor = |node: u32, place: usize| match node.checked_sub(steps) {
        None => asked.analysis.arcs.leaving(StepId::from_raw(node)).get(place).map(|t| steps + t.raw()),
        Some(t) => net.transitions[TransitionId::from_raw(t)].post.get(place).map(|step| step.raw()),
    };
    let counts = |node: u32| node.checked_sub(steps).is_none_or(|t| factors.counts(TransitionId::from_raw(t)));
    let nodes = net.places.len() + net.transitions.len();
    let mut part_of: Vec<Option<usize>> = vec![None; nodes];
    let mut parts: Vec<Part> = Vec::new();
    for part in Parts::of(nodes, 0..steps, successor, counts).in_order() {
        // A circle that comes back to its only step at once is none.
        let count = part.iter().filter(|node| **node < steps).count();
        if count > 1 {
            part.iter().for_each(|node| part_of[*node as usize] = Some(parts.len()));
            let arcs = part.iter().flat_map(|node| (0..).map_while(|place| successor(*node, place)));
            let within = arcs.filter(|node| part_of[*node as usize] == Some(parts.len())).count();
            parts.push(Part { steps: count, is_one_circle: within == part.len() });
        }
    }
    part_of.truncate(net.places.len());
    (part_of.into(), parts)
}

/// What is still to be done on the way through the transitions.
#[derive(Clone, Copy)]
enum Move {
    /// Go along a transition to a step.
    Forth(TransitionId, StepId),
    /// Take back the last one.
    Back,
}

/// Looks for circles, from one step after the other.
struct Search<'q, 'a> {
    net: &'a Net,
    asked: &'q mut Questions<'a>,
    factors: &'q Factors,
    part_of: &'q IndexVec<StepId, Option<usize>>,
    /// A step is left for good once it was the start of a search, so each circle is looked for from its first step.
    done: IndexVec<StepId, bool>,
    /// The transitions on the way, each with the step that it was followed to.
    way: Vec<(TransitionId, StepId)>,
    is_on_way: IndexVec<StepId, bool>,
    /// What the factors on the way ask of each input, and how many of them do.
    row: IndexVec<VariableId, (bool, u32)>,
    open: Vec<Move>,
    /// How many active steps may still be looked at.
    followed: usize,
}

impl<'q, 'a> Search<'q, 'a> {
    fn new(asked: &'q mut Questions<'a>, factors: &'q Factors, part_of: &'q IndexVec<StepId, Option<usize>>) -> Self {
        let net = asked.analysis.net();
        Search {
            net,
            asked,
            factors,
            part_of,
            done: index_vec![false; net.places.len()],
            way: Vec::new(),
            is_on_way: index_vec![false; net.places.len()],
            row: index_vec![(false, 0); net.variables.len()],
            open: Vec::new(),
            followed: MOST + FOLLOWED * net.places.len(),
        }
    }

    /// A circle from a step back to it; of the transitions that may still be tried, those that were are taken away.
    fn from(&mut self, start: StepId, left: &mut usize) -> Option<Ring> {
        let may_try = (*left).min(MOST);
        let mut tried = 0;
        let ring = self.run(start, may_try, &mut tried);
        *left -= tried;
        self.open.clear();
        while !self.way.is_empty() {
            self.back();
        }
        self.done[start] = true;
        ring
    }

    /// Goes along the arcs and back, as long as the factors of the conditions agree.
    fn run(&mut self, start: StepId, may_try: usize, tried: &mut usize) -> Option<Ring> {
        self.open_after(start);
        while let Some(next) = self.open.pop() {
            let Move::Forth(t, to) = next else {
                self.back();
                continue;
            };
            if *tried == may_try {
                return None;
            }
            *tried += 1;
            if self.way.len() >= LONGEST || self.is_on_way[to] || !self.agrees(t) {
                continue;
            }
            self.forth(t, to);
            if to == start {
                let transitions: Vec<TransitionId> = self.way.iter().map(|(t, _)| *t).collect();
                if let Some(ring) = self.ring(&transitions) {
                    return Some(ring);
                }
                self.back();
                continue;
            }
            self.open.push(Move::Back);
            self.open_after(to);
        }
        None
    }

    fn forth(&mut self, t: TransitionId, to: StepId) {
        self.way.push((t, to));
        self.is_on_way[to] = true;
        for (v, value) in self.factors.get(t) {
            let (known, count) = &mut self.row[*v];
            if *count == 0 {
                *known = *value;
            }
            *count += 1;
        }
    }

    fn back(&mut self) {
        if let Some((t, to)) = self.way.pop() {
            self.is_on_way[to] = false;
            self.factors.get(t).iter().for_each(|(v, _)| self.row[*v].1 -= 1);
        }
    }

    fn agrees(&self, t: TransitionId) -> bool {
        self.factors.get(t).iter().all(|(v, value)| match self.row[*v] {
            (_, 0) => true,
            (known, _) => known == *value,
        })
    }

    /// Puts the transitions after a step within its part on the stack, the first on top.
    fn open_after(&mut self, step: StepId) {
        let from = self.open.len();
        for t in self.asked.analysis.arcs.leaving(step).iter().take(AFTER).copied().filter(|t| self.factors.counts(*t))
        {
            let steps = self.net.transitions[t].post.iter().copied().take(AFTER);
            let within = |to: &StepId| self.part_of[*to] == self.part_of[step] && !self.done[*to] && *to != step;
            self.open.extend(steps.filter(within).map(|to| Move::Forth(t, to)));
        }
        self.open[from..].reverse();
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
        let mut situation = net.transitions[path[0]].pre.to_vec();
        situation.sort_unstable();
        let mut seen: FxHashSet<Vec<StepId>> = FxHashSet::default();
        for _ in 0..4 * path.len() + 8 {
            let Some(left) = self.followed.checked_sub(situation.len()) else { return false };
            self.followed = left;
            if !seen.insert(situation.clone()) {
                return true;
            }
            let arcs = &self.asked.analysis.arcs;
            // Each of them once: a synchronisation comes after many steps.
            let after: FxHashSet<TransitionId> =
                situation.iter().flat_map(|step| arcs.leaving(*step)).copied().collect();
            let clears = |t: &TransitionId| {
                let ready = net.transitions[*t].pre.iter().all(|step| situation.binary_search(step).is_ok());
                ready && self.factors.counts(*t) && holds(net, net.transitions[*t].condition, inputs)
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
    below(&net.exprs, condition).all(|e| match net.exprs[e].kind {
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
        | ExprKind::GrafcetFrozen(_)
        | ExprKind::Rise(_)
        | ExprKind::Fall(_)
        | ExprKind::Delay { .. }
        | ExprKind::Compare(..)
        | ExprKind::Arithmetic(..)
        | ExprKind::Negate(_)
        | ExprKind::Widen(_) => false,
    })
}

/// The inputs among the factors of a condition.
fn add_factors(net: &Net, condition: ExprId, factors: &mut Vec<(VariableId, bool)>) {
    let input = |v: VariableId| net.variables[v].kind == VariableKind::Input;
    let (mut first, mut open) = (Some(condition), Vec::new());
    while let Some(e) = first.take().or_else(|| open.pop()) {
        if let ExprKind::And(a, b) = net.exprs[e].kind {
            open.extend([b, a]);
        } else if let ExprKind::Variable(v) = net.exprs[e].kind {
            factors.extend(input(v).then_some((v, true)));
        } else if let ExprKind::Not(a) = net.exprs[e].kind
            && let ExprKind::Variable(v) = net.exprs[a].kind
        {
            factors.extend(input(v).then_some((v, false)));
        }
    }
}

/// The value of a condition of inputs; those that nothing is said of are false.
fn holds(net: &Net, condition: ExprId, inputs: &FxHashMap<VariableId, bool>) -> bool {
    let mut inside: Vec<ExprId> = below(&net.exprs, condition).collect();
    // Operands have smaller ids than what uses them.
    inside.sort_unstable();
    inside.dedup();
    let mut values: FxHashMap<ExprId, bool> = FxHashMap::default();
    for e in inside {
        let of = |a: ExprId| values.get(&a).copied().unwrap_or(false);
        let value = match net.exprs[e].kind {
            ExprKind::Variable(v) => match (inputs.get(&v), net.variables[v].initial()) {
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
            | ExprKind::GrafcetFrozen(_)
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
