//! Steps that are never active and transitions that never clear, each with its cause.
//!
//! A step may be active if it is in the initial situation (settled, R10), if a transition that may clear leads to it, if
//! its activation link or an order may place it, and if what encloses it may be active (I1). An order places only if its
//! step may be active, a link only if its enclosing step may. A transition may clear if all steps before it, the step
//! around it and the steps whose activity its condition asks for may be active, and if nothing refutes it: a condition
//! that never holds, or two of these steps that are proved never to be active together. The least solution of this holds
//! whatever can happen: freezing, conditions, and what else happens at once, only take away from it. So a step that is
//! not in it is never active (R4, R5), and a transition that is not in it never clears (R3).
//!
//! One cause is told once: after it is assumed away, what still is impossible has another one.

use super::constant::Constant;
use crate::analysis::together::questions::Questions;
use crate::analysis::together::witness::{self, SearchResult};
use grafc_model::chart::{ExprId, ExprKind, StepId, TransitionId, below};
use grafc_net::Net;
use grafc_net::net::{Forced, Steps};
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashMap;
use smallvec::SmallVec;

/// Transitions: mostly few.
pub(super) type Transitions = SmallVec<[TransitionId; 4]>;

/// Of the steps that a transition needs, so many are compared with each other.
const COMPARED: usize = 8;

/// Where steps wait for each other in circles, so many steps are looked at for each step of the net.
const LOOKED_AT: usize = 16;

/// A step that is never active, not because another one is not.
#[derive(Clone, Debug)]
pub(crate) struct Idle {
    pub(crate) step: StepId,
    /// Whether transitions lead to it, which wait for it themselves.
    pub(crate) is_entered: bool,
    /// How many other steps are never active because of it.
    pub(crate) others: usize,
    /// Transitions that need it, the first few.
    pub(crate) needed_by: Vec<TransitionId>,
}

/// Of the transitions that need a step which is never active, so many are named.
const NAMED: usize = 3;

/// Why a transition never clears though each step that it needs may be active.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Why {
    /// Its condition never holds.
    Constant,
    /// Two steps that it needs are never active together.
    Apart(StepId, StepId),
    /// Its condition never holds while the steps before it are active.
    Condition,
    /// The steps before it are never active all at once.
    AtOnce,
}

/// What never happens, by its causes.
#[derive(Clone, Debug)]
pub(crate) struct Never {
    pub(crate) steps: Vec<Idle>,
    /// In order of the transitions.
    pub(crate) transitions: Vec<(TransitionId, Why)>,
    /// All transitions that never clear, for whatever cause.
    pub(crate) clears: IndexVec<TransitionId, bool>,
}

pub(super) fn find(asked: &mut Questions, constant: &[Constant]) -> Never {
    let refuted = refuted(asked, constant);
    let net = asked.analysis.net();
    let mut possible = Possible::new(asked);
    possible.refuted = refuted.iter().map(Option::is_some).collect();
    possible.begin();
    possible.spread();
    let clears: IndexVec<TransitionId, bool> = possible.clears.clone();
    let causes = refuted.into_iter_enumerated().filter_map(|(t, why)| Some((t, why?)));
    let mut transitions: Vec<(TransitionId, Why)> = causes.collect();
    for (t, _) in &transitions {
        possible.refuted[*t] = false;
        possible.try_to_clear(*t);
    }
    possible.spread();
    // One that needs a step which is never active for another cause is told of there.
    transitions.retain(|(t, _)| possible.missing[*t] == 0);
    let steps = idle(net, &mut possible);
    Never { steps, transitions, clears: clears.into_iter().map(|clears| !clears).collect() }
}

/// The transitions that a proof refutes.
fn refuted(asked: &mut Questions, constant: &[Constant]) -> IndexVec<TransitionId, Option<Why>> {
    let net = asked.analysis.net();
    let mut refuted: IndexVec<TransitionId, Option<Why>> = net.transitions.iter().map(|_| None).collect();
    for found in constant.iter().filter(|found| !found.value) {
        if let Some(t) = found.transition {
            refuted[t] = Some(Why::Constant);
        }
    }
    for t in net.transitions.indices() {
        if refuted[t].is_some() {
            continue;
        }
        let transition = &net.transitions[t];
        let reads_steps = reads_steps(net, transition.condition);
        if !reads_steps && transition.pre.len() + usize::from(transition.encloser().is_some()) < 2 {
            continue;
        }
        let needed = needed(net, t);
        let compared = &needed[..needed.len().min(COMPARED)];
        let mut pairs = compared.iter().enumerate().flat_map(|(i, a)| compared[i + 1..].iter().map(move |b| (*a, *b)));
        if let Some((a, b)) = pairs.find(|(a, b)| asked.analysis.never_together(*a, *b)) {
            refuted[t] = Some(Why::Apart(a, b));
        } else if reads_steps {
            let before = &net.transitions[t].pre;
            let active: Vec<StepId> = before.iter().copied().take(COMPARED).collect();
            match witness::search(asked, &[net.transitions[t].condition], &active) {
                SearchResult::Impossible => refuted[t] = Some(Why::Condition),
                SearchResult::Case(_) | SearchResult::Unknown => {}
            }
        }
    }
    refuted
}

fn reads_steps(net: &Net, condition: ExprId) -> bool {
    below(&net.exprs, condition).any(|e| matches!(net.exprs[e].kind, ExprKind::StepActive(_)))
}

/// The steps that must be active when a transition clears: those before it, and those that its condition asks for.
fn needed(net: &Net, t: TransitionId) -> Steps {
    let transition = &net.transitions[t];
    let mut needed = transition.pre.clone();
    needed.extend(transition.encloser());
    let (mut first, mut open) = (Some(transition.condition), Vec::new());
    while let Some(e) = first.take().or_else(|| open.pop()) {
        match net.exprs[e].kind {
            ExprKind::And(a, b) => open.extend([b, a]),
            // An on-delay alone is false as soon as its operand is (X5), and an edge asks for its operand now (X4).
            ExprKind::Delay { operand, off, .. } if off.ms == 0 => open.push(operand),
            ExprKind::Rise(operand) => open.push(operand),
            ExprKind::StepActive(step) => needed.push(step),
            ExprKind::Delay { .. }
            | ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::Not(_)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Fall(_)
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => {}
        }
    }
    needed.sort_unstable();
    needed.dedup();
    needed
}

/// Steps that another one activates; most activate none.
type Placed = FxHashMap<StepId, Vec<StepId>>;

/// What may be active and clear, as far as it has been found.
struct Possible<'n> {
    net: &'n Net,
    active: IndexVec<StepId, bool>,
    clears: IndexVec<TransitionId, bool>,
    refuted: IndexVec<TransitionId, bool>,
    /// The steps that each transition still waits for, by number.
    missing: IndexVec<TransitionId, usize>,
    /// The transitions that need a step.
    waiting: IndexVec<StepId, Transitions>,
    /// The steps with a link within a step.
    linked: Placed,
    /// The steps that the orders of a step place.
    placed: Placed,
    /// The steps that wait for what encloses them only.
    enclosed: Placed,
    new: Vec<StepId>,
}

impl<'n> Possible<'n> {
    fn new(asked: &Questions<'n>) -> Self {
        let net = asked.analysis.net();
        let mut possible = Possible {
            net,
            active: index_vec![false; net.places.len()],
            clears: index_vec![false; net.transitions.len()],
            refuted: IndexVec::new(),
            missing: index_vec![0; net.transitions.len()],
            waiting: net.places.iter().map(|_| Transitions::new()).collect(),
            linked: Placed::default(),
            placed: Placed::default(),
            enclosed: Placed::default(),
            new: Vec::new(),
        };
        for t in net.transitions.indices() {
            let needed = needed(net, t);
            possible.missing[t] = needed.len();
            needed.into_iter().for_each(|step| possible.waiting[step].push(t));
        }
        for (step, place) in net.places.iter_enumerated().filter(|(_, place)| place.activated) {
            for around in &place.within {
                possible.linked.entry(*around).or_default().push(step);
            }
        }
        for order in net.grafcets.iter().flat_map(|grafcet| &grafcet.orders) {
            if let Forced::Steps(steps) = &order.forced {
                possible.placed.entry(order.step).or_default().extend(steps);
            }
        }
        possible
    }

    fn begin(&mut self) {
        for (step, place) in self.net.places.iter_enumerated() {
            if place.initial {
                self.activate(step);
            }
        }
        self.net.transitions.indices().for_each(|t| self.try_to_clear(t));
    }

    fn activate(&mut self, step: StepId) {
        let around = &self.net.places[step].within;
        if !around.is_empty() && !around.iter().any(|e| self.active[*e]) {
            around.iter().for_each(|e| self.enclosed.entry(*e).or_default().push(step));
        } else if !std::mem::replace(&mut self.active[step], true) {
            self.new.push(step);
        }
    }

    fn try_to_clear(&mut self, t: TransitionId) {
        if self.missing[t] == 0 && !self.refuted[t] && !std::mem::replace(&mut self.clears[t], true) {
            let net = self.net;
            net.transitions[t].post.iter().for_each(|step| self.activate(*step));
        }
    }

    /// Goes on until nothing new is possible; gives back how many steps became possible.
    fn spread(&mut self) -> usize {
        let mut count = 0;
        while let Some(step) = self.new.pop() {
            count += 1;
            for t in std::mem::take(&mut self.waiting[step]) {
                self.missing[t] -= 1;
                self.try_to_clear(t);
            }
            for list in [&mut self.linked, &mut self.placed, &mut self.enclosed].map(|lists| lists.remove(&step)) {
                list.into_iter().flatten().for_each(|step| self.activate(step));
            }
        }
        count
    }
}

/// The causes among the steps that are not possible; all steps are possible afterwards, or too much was looked at.
fn idle(net: &Net, possible: &mut Possible) -> Vec<Idle> {
    let mut leads_to: IndexVec<StepId, Option<TransitionId>> = index_vec![None; net.places.len()];
    for (t, transition) in net.transitions.iter_enumerated() {
        transition.post.iter().for_each(|step| _ = leads_to[*step].get_or_insert(t));
    }
    let mut placed_by: IndexVec<StepId, Option<StepId>> = index_vec![None; net.places.len()];
    for order in net.grafcets.iter().flat_map(|grafcet| &grafcet.orders) {
        if let Forced::Steps(steps) = &order.forced {
            steps.iter().for_each(|step| _ = placed_by[*step].get_or_insert(order.step));
        }
    }
    // What a step waits for, if there is anything: it is not possible either, or the step would be.
    let up = |possible: &Possible, step: StepId| {
        let unmet = |t: TransitionId| needed(net, t).into_iter().find(|need| !possible.active[*need]);
        let place = &net.places[step];
        let is_meant = place.initial || place.activated || leads_to[step].is_some() || placed_by[step].is_some();
        let is_waiting = is_meant && !place.within.iter().any(|around| possible.active[*around]);
        let around = place.within.first().copied().filter(|_| is_waiting);
        around.or_else(|| unmet(leads_to[step]?)).or_else(|| placed_by[step].filter(|step| !possible.active[*step]))
    };
    let mut found = Vec::new();
    let mut tell = |possible: &mut Possible, step: StepId| {
        let needed_by = possible.waiting[step].iter().take(NAMED).copied().collect();
        possible.active[step] = true;
        possible.new.push(step);
        let others = possible.spread() - 1;
        found.push(Idle { step, is_entered: leads_to[step].is_some(), others, needed_by });
    };
    for step in net.places.indices() {
        if !possible.active[step] && up(possible, step).is_none() {
            tell(possible, step);
        }
    }
    let mut left = LOOKED_AT * net.places.len();
    let mut walk = 0;
    let mut walk_of: IndexVec<StepId, usize> = index_vec![walk; net.places.len()];
    for start in net.places.indices() {
        while !possible.active[start] && left > 0 {
            // Up, until a step comes again: it is one of a circle.
            let mut at = start;
            walk += 1;
            let root = loop {
                if std::mem::replace(&mut walk_of[at], walk) == walk {
                    break at;
                }
                left = left.saturating_sub(1);
                match up(possible, at) {
                    Some(next) if left > 0 => at = next,
                    Some(_) | None => break at,
                }
            };
            // Of the circle, the step that comes first in the text.
            let circle =
                std::iter::successors(up(possible, root), |step| up(possible, *step).filter(|_| *step != root));
            let first = circle.take(left.max(1)).min().unwrap_or(root).min(root);
            tell(possible, first);
        }
    }
    found.sort_by_key(|idle| idle.step);
    found
}
