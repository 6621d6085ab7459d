//! What happens in a micro-step: clearings, activations and deactivations as net changes (R6), and the events of stored
//! actions (R7).

use crate::analysis::components::Components;
use crate::encode::settle::Frozen;
use crate::encode::single_phase;
use crate::encode::task::{SetReset, Task};
use crate::lower::Lowering;
use crate::scan::{Origin, Role, Statement, Told, VarId};
use ecow::{EcoString, eco_format};
use grafc_formula::{Formula, FormulaId};
use grafc_model::chart::{StepId, TransitionId, Type};
use grafc_net::{Arcs, Net};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// Whether a transition clears, as the factors of a conjunction (R3): its steps are active, what encloses it is, nothing
/// freezes it, and its condition holds. A step within another is never active without that, so the factor is needed
/// only where no step comes before.
pub(crate) fn clears(
    lowering: &mut Lowering,
    t: TransitionId,
    condition: FormulaId,
    frozen: &Frozen,
    simplify: bool,
) -> Vec<FormulaId> {
    let net = &*lowering.net.clone();
    let transition = &net.transitions[t];
    let mut factors: Vec<FormulaId> = Vec::with_capacity(transition.pre.len() + 3);
    if !transition.within.is_empty() && (transition.pre.is_empty() || !simplify) {
        factors.push(lowering.one_active(&transition.within));
    }
    factors.extend(transition.pre.iter().map(|s| lowering.active(*s)));
    if let Some(frozen) = frozen[transition.grafcet] {
        factors.push(lowering.pool.not(frozen));
    }
    factors.extend(left_to_clear(lowering, t));
    factors.push(condition);
    factors
}

/// What R15 asks of a transition: a grafcet that is frozen by a pulse has no active step, so only a source transition could
/// clear; and one of a child waits for an active step.
pub(crate) fn left_to_clear(lowering: &mut Lowering, t: TransitionId) -> Vec<FormulaId> {
    let grafcet = lowering.net.transitions[t].grafcet;
    if !lowering.net.transitions[t].pre.is_empty() {
        return Vec::new();
    }
    let is_frozen = lowering.is_frozen(grafcet);
    let mut factors = vec![lowering.pool.not(is_frozen)];
    if lowering.net.grafcets[grafcet].child {
        let steps = lowering.net.grafcets[grafcet].steps.clone();
        let active: Vec<FormulaId> = steps.iter().map(|s| lowering.active(*s)).collect();
        factors.push(lowering.pool.or(active));
    }
    factors
}

/// A term of so many operands gets a variable where it would be written more than [`FEW_TIMES`]: n steps before a
/// transition and m after it are then n + m operands, not n times m.
const LONG: usize = 16;

/// A long term is written out where that is no more often than this.
const FEW_TIMES: usize = 2;

/// What a micro-step does to each step, as formulas.
pub(crate) struct Clearings<'a> {
    /// The transitions around each step.
    pub(crate) arcs: &'a Arcs,
    /// Whether each transition clears.
    pub(crate) cleared: IndexVec<TransitionId, FormulaId>,
    /// Where steps overlap, what shows that a step after this transition is active, as the terms of a disjunction; a
    /// transition that newly leads nowhere shows it by its clearing.
    followed: IndexVec<TransitionId, Vec<FormulaId>>,
    /// The next activity of steps for which it has been computed, because others need it or enclosures and orders act
    /// on them.
    pub(crate) next: IndexVec<StepId, Option<FormulaId>>,
}

impl<'a> Clearings<'a> {
    /// With the clearing of each transition latched in a variable before anything is written, if `latch`; else written
    /// out wherever it is needed, if it is not long and needed often.
    pub(crate) fn new(
        lowering: &mut Lowering,
        task: &Task<'a>,
        frozen: &Frozen,
        latch: bool,
    ) -> (Self, Vec<Statement>) {
        let net = &*lowering.net.clone();
        let mut statements = Vec::with_capacity(if latch { net.transitions.len() } else { 0 });
        let mut cleared = IndexVec::with_capacity(net.transitions.len());
        for t in net.transitions.indices() {
            let factors = clears(lowering, t, task.conditions[t], frozen, task.simplify);
            let value = lowering.pool.and(factors);
            let latched = latch || is_long_and_needed_often(lowering, t, value);
            if !latched || lowering.pool.as_truth(value).is_some() {
                cleared.push(value);
                continue;
            }
            let mut name = EcoString::from("clr_");
            name.push_str(&lowering.transition_word(t));
            let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
            statements.push(Statement::Assign { target, value, origin: Origin::Transition(t), told: Told::All });
            cleared.push(lowering.symbols.read(&mut lowering.pool, target));
        }
        let next = net.places.iter().map(|_| None).collect();
        let followed = if task.encoding.overlaps() {
            net.transitions.indices().map(|t| followed(lowering, t, cleared[t], &mut statements)).collect()
        } else {
            IndexVec::new()
        };
        (Clearings { arcs: task.arcs, cleared, followed, next }, statements)
    }

    /// What is known of clearings where they are not all latched at once, and no steps overlap.
    pub(crate) fn with(arcs: &'a Arcs, net: &Net, cleared: IndexVec<TransitionId, FormulaId>) -> Self {
        Clearings { arcs, cleared, followed: IndexVec::new(), next: net.places.iter().map(|_| None).collect() }
    }

    fn any(&self, lowering: &mut Lowering, transitions: impl IntoIterator<Item = TransitionId>) -> FormulaId {
        lowering.pool.or(transitions.into_iter().map(|t| self.cleared[t]))
    }

    /// What decides on the next activity of a step; none if no transition touches it.
    pub(crate) fn set_and_reset(&self, lowering: &mut Lowering, s: StepId, overlaps: bool) -> Option<SetReset> {
        if self.arcs.into_step(s).is_empty() && self.arcs.out_of_step(s).is_empty() {
            // A self-loop alone neither activates nor deactivates: set dominates.
            return None;
        }
        let set = self.any(lowering, self.arcs.into_step(s).iter().chain(self.arcs.loops(s)).copied());
        let reset = if overlaps {
            self.followed(lowering, s)
        } else {
            self.any(lowering, self.arcs.out_of_step(s).iter().chain(self.arcs.loops(s)).copied())
        };
        Some(SetReset { active: lowering.active(s), set, reset })
    }

    /// A successor of `s` is active.
    fn followed(&self, lowering: &mut Lowering, s: StepId) -> FormulaId {
        let terms: Vec<FormulaId> = self.arcs.out_of_step(s).iter().flat_map(|t| &self.followed[*t]).copied().collect();
        lowering.pool.or(terms)
    }

    /// `s` is active after the micro-step and was not before.
    pub(crate) fn activated(&self, lowering: &mut Lowering, components: &Components, s: StepId) -> FormulaId {
        if let Some(next) = self.next[s] {
            let inactive = lowering.pool.not(lowering.active(s));
            return lowering.pool.and([next, inactive]);
        }
        let into = self.arcs.into_step(s).iter().copied();
        if components.covers(s) {
            // The step that the token of a component comes to was inactive.
            return self.any(lowering, into);
        }
        self.activated_by(lowering, s, into)
    }

    /// `s` was inactive, and one of these transitions into it clears.
    fn activated_by(
        &self,
        lowering: &mut Lowering,
        s: StepId,
        transitions: impl IntoIterator<Item = TransitionId>,
    ) -> FormulaId {
        let (set, active) = (self.any(lowering, transitions), lowering.active(s));
        let inactive = lowering.pool.not(active);
        lowering.pool.and([set, inactive])
    }

    /// `s` is active after the micro-step.
    pub(crate) fn active_after(&self, lowering: &mut Lowering, s: StepId) -> FormulaId {
        if let Some(next) = self.next[s] {
            return next;
        }
        // Where steps overlap, the next activity of each has been computed.
        match self.set_and_reset(lowering, s, false) {
            Some(place) => single_phase::next(&mut lowering.pool, &place),
            None => lowering.active(s),
        }
    }

    /// `s` was active before the micro-step and is not after.
    pub(crate) fn deactivated(&self, lowering: &mut Lowering, components: &Components, s: StepId) -> FormulaId {
        if let Some(next) = self.next[s] {
            let gone = lowering.pool.not(next);
            return lowering.pool.and([lowering.active(s), gone]);
        }
        let out_of = self.arcs.out_of_step(s).iter().copied();
        if components.covers(s) {
            return self.any(lowering, out_of);
        }
        self.deactivated_by(lowering, s, out_of)
    }

    /// One of these transitions out of `s` clears, and none that leads into it or back to it.
    fn deactivated_by(
        &self,
        lowering: &mut Lowering,
        s: StepId,
        transitions: impl IntoIterator<Item = TransitionId>,
    ) -> FormulaId {
        let reset = self.any(lowering, transitions);
        let set = self.any(lowering, self.arcs.into_step(s).iter().chain(self.arcs.loops(s)).copied());
        let not_set = lowering.pool.not(set);
        lowering.pool.and([reset, not_set])
    }

    /// Whether the bits of the situation, or other steps `of_interest`, change, as the terms of a disjunction: the clearings that move the token of a
    /// component, and for what no component covers, activation and deactivation step by step. A transition that waits
    /// for an edge is left out: the edge itself asks for another micro-step; and so is one whose clearing is `told`
    /// otherwise. What enclosures and orders do needs no term: it happens where a step that encloses or forces changes.
    pub(crate) fn changes(
        &self,
        lowering: &mut Lowering,
        task: &Task,
        of_interest: impl Fn(StepId) -> bool,
        told: impl Fn(TransitionId) -> bool,
    ) -> Vec<FormulaId> {
        let net = &*lowering.net.clone();
        let edges: FxHashSet<VarId> = lowering.edges.iter().flat_map(|e| [e.rise, e.fall]).flatten().collect();
        let is_edge = |f: &FormulaId| matches!(lowering.pool.get(*f), Formula::Variable(v) if edges.contains(v));
        let quiet: IndexVec<TransitionId, bool> = task
            .conditions
            .iter_enumerated()
            .map(|(t, c)| told(t) || lowering.pool.factors(c).iter().any(is_edge))
            .collect();
        let bits: Vec<StepId> =
            net.places.indices().filter(|s| lowering.situation.bit(*s).is_some() || of_interest(*s)).collect();
        let mut moves: IndexVec<TransitionId, bool> = net.transitions.iter().map(|_| false).collect();
        for s in bits.iter().filter(|s| task.components.covers(**s)) {
            self.arcs.out_of_step(*s).iter().for_each(|t| moves[*t] = true);
        }
        let moving = net.transitions.indices().filter(|t| moves[*t] && !quiet[*t]);
        let mut terms: Vec<FormulaId> = moving.map(|t| self.cleared[t]).collect();
        for s in bits {
            let others =
                |list: &[TransitionId]| list.iter().copied().filter(|t| !moves[*t] && !quiet[*t]).collect::<Vec<_>>();
            let (into, out_of) = (others(self.arcs.into_step(s)), others(self.arcs.out_of_step(s)));
            if !into.is_empty() {
                terms.push(self.activated_by(lowering, s, into));
            }
            if !out_of.is_empty() {
                terms.push(self.deactivated_by(lowering, s, out_of));
            }
        }
        terms
    }
}

/// Whether the clearing of a transition would be written out many times at some length: once for each step after it and,
/// if it newly leads nowhere, for each before it.
fn is_long_and_needed_often(lowering: &Lowering, t: TransitionId, clearing: FormulaId) -> bool {
    let transition = &lowering.net.transitions[t];
    let resets = if transition.entered().is_empty() { transition.pre.len() } else { 0 };
    transition.post.len() + resets > FEW_TIMES && lowering.pool.below(clearing).len() >= LONG
}

/// What shows that a step after a transition is active (a step that it leads back to was so before): the activity of
/// each; one variable, if many steps lead to many; or else the clearing.
fn followed(
    lowering: &mut Lowering,
    t: TransitionId,
    clearing: FormulaId,
    statements: &mut Vec<Statement>,
) -> Vec<FormulaId> {
    let transition = &lowering.net.transitions[t];
    let successors: Vec<FormulaId> = transition.entered().into_iter().map(|s| lowering.active(s)).collect();
    if successors.is_empty() {
        return vec![clearing];
    }
    if successors.len() < LONG || transition.pre.len() <= FEW_TIMES {
        return successors;
    }
    let name = eco_format!("after_{}", lowering.transition_word(t));
    let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
    let value = lowering.pool.or(successors);
    statements.push(Statement::assign(Origin::Transition(t), target, value));
    vec![lowering.symbols.read(&mut lowering.pool, target)]
}

/// Activations and deactivations that stored actions wait for; one that several wait for becomes a variable.
pub(crate) struct StepEvents {
    activated: FxHashMap<StepId, FormulaId>,
    deactivated: FxHashMap<StepId, FormulaId>,
    /// The statements that set the variables.
    pub(crate) statements: Vec<Statement>,
}

impl StepEvents {
    /// Counts what the stored actions wait for.
    pub(crate) fn new(lowering: &mut Lowering, clearings: &Clearings, components: &Components) -> Self {
        use grafc_model::chart::Event;
        let net = &*lowering.net.clone();
        let mut uses: FxHashMap<(StepId, bool), usize> = FxHashMap::default();
        for action in &net.stored {
            match action.event {
                Event::Activation(s) => *uses.entry((s, true)).or_default() += 1,
                Event::Deactivation(s) => *uses.entry((s, false)).or_default() += 1,
                Event::Event(..) | Event::Clearing(_) | Event::EachScan(..) => {}
            }
        }
        let mut events =
            StepEvents { activated: FxHashMap::default(), deactivated: FxHashMap::default(), statements: Vec::new() };
        for s in net.places.indices() {
            for (activation, word) in [(true, "act"), (false, "deact")] {
                let Some(count) = uses.get(&(s, activation)) else { continue };
                let value = if activation {
                    clearings.activated(lowering, components, s)
                } else {
                    clearings.deactivated(lowering, components, s)
                };
                let simple = lowering.pool.is_leaf(value);
                let value = if simple || *count == 1 {
                    value
                } else {
                    let name = format!("{word}_{}", net.places[s].label);
                    let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
                    events.statements.push(Statement::assign(Origin::Step(s), target, value));
                    lowering.symbols.read(&mut lowering.pool, target)
                };
                if activation { &mut events.activated } else { &mut events.deactivated }.insert(s, value);
            }
        }
        events
    }

    /// The activation of a step that some stored action waits for.
    pub(crate) fn activated(&self, s: StepId) -> FormulaId {
        self.activated[&s]
    }

    /// The deactivation of a step that some stored action waits for.
    pub(crate) fn deactivated(&self, s: StepId) -> FormulaId {
        self.deactivated[&s]
    }
}
