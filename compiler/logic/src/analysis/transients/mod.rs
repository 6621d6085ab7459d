//! How many micro-steps a reaction can need (R8, R9), from the net alone.
//!
//! A reaction ends with the first micro-step in which nothing changes: no step, no stored variable and no operand of an
//! edge. Inputs and time stand still meanwhile. So whatever changes in a micro-step after the first was brought about
//! by something that changed in the micro-step before it, or in the same one: by a clearing that activated the step
//! before another transition, by a variable that a condition reads, by an order that settles a grafcet again. `causes`
//! is the graph of all changes that are possible at all with an edge from each cause to its effects; it is made in
//! `values` (expressions), `situation` (clearings, enclosures, orders) and `stored` (stored actions), which say why
//! each list of causes is complete. A change in micro-step k is the end of a path that begins with a change in
//! micro-step 1 and along which k - 1 edges lead into the next micro-step. So the longest path (`longest`) gives the
//! last micro-step in which something changes, the one after it finds nothing, and where changes cause each other in a
//! circle no bound is known.
//!
//! What is fixed in a reaction keeps the graph small (`stable`): of two conditions that contradict each other on inputs
//! no matter which other changes lie between only one can hold in one reaction, so no clearing follows the other, and
//! an edge of inputs is over after the first micro-step. A circle all around which no such pair is adjacent may still
//! hold one: then the two values of an input are looked at one after the other (`cases`), each with the transitions
//! that it admits.
//!
//! All this is said of evolutions in which every reaction before ended by itself, and of encodings without overlap.

mod bound;
mod cases;
mod causes;
mod conditions;
mod longest;
mod situation;
mod stable;
mod stored;
#[cfg(test)]
mod tests;
mod values;

use crate::analysis::Analysis;
use crate::scan::{Role, VarId};
use causes::{Causes, Change, Way};
use grafc_model::chart::{Arithmetic, ExprId, ExprKind, Mode, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;
use longest::Times;
use stable::Stable;

/// Where more pairs of transitions meet in a step than so many for each, they are not compared one by one.
const PAIRS: usize = 16;

/// How many micro-steps the reactions of a net need.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Transients {
    /// No reaction, the initial one included, runs more micro-steps, the last of which finds nothing changed; none if
    /// no bound is known.
    pub longest: Option<u32>,
    /// Transitions that clear one after the other before the last change of a longest reaction.
    pub chain: Vec<TransitionId>,
    /// Where no bound is known: transitions that may make each other clear in a circle, as far as transitions do it.
    pub cycle: Vec<TransitionId>,
    /// Whether a second micro-step never does anything: neither to the state (situation, variables, memories of edges
    /// and delays) nor to the flags.
    pub single: bool,
    /// Whether a second micro-step at most brings delays up to date with the situation.
    pub single_but_delays: bool,
}

impl Transients {
    /// No bound is known.
    pub(super) fn unknown() -> Self {
        Transients { longest: None, chain: Vec::new(), cycle: Vec::new(), single: false, single_but_delays: false }
    }

    /// Whether it is proved that no reaction hits a bound on micro-steps.
    pub fn ends_within(&self, bound: u32) -> bool {
        self.longest.is_some_and(|longest| longest <= bound)
    }
}

impl Analysis {
    /// Whether a variable is an input or a constant, and so the same throughout a reaction.
    pub(super) fn is_fixed(&self, v: VarId) -> bool {
        matches!(self.conditions.lowering.symbols.table[v].role, Role::Input | Role::Constant)
    }
}

/// The analysis of a flat net: one after all passes but those for overlapping steps.
pub(super) fn find(analysis: &Analysis) -> Transients {
    let net = analysis.net();
    let stable = Stable::new(net);
    let occasions = values::occasions(net, &stable);
    let mut causes = Causes::new(net);
    values::add(net, &occasions, &mut causes);
    let ways = situation::Ways::new(analysis, &stable, &occasions);
    situation::add(net, &ways, &mut causes);
    stored::add(net, &ways, &occasions, &mut causes);
    drop(ways);
    let effects = causes.take_effects();
    let watched = Watched::new(net);
    let mut result =
        Transients { longest: Some(1), chain: Vec::new(), cycle: Vec::new(), single: true, single_but_delays: true };
    for case in cases::times(net, &causes, &effects, &stable) {
        match case {
            Ok(times) => watched.add(&times, &causes, &mut result),
            Err(cycle) => {
                return Transients { longest: None, chain: Vec::new(), cycle, single: false, single_but_delays: false };
            }
        }
    }
    result
}

/// Which changes matter, and how.
struct Watched<'n> {
    net: &'n Net,
    operand_of_edge: IndexVec<ExprId, bool>,
    operand_of_delay: IndexVec<ExprId, bool>,
    divisor: IndexVec<ExprId, bool>,
}

/// Why a change matters.
#[derive(Clone, Copy, Default)]
struct Matters {
    /// After it R8 asks for another micro-step.
    repeat: bool,
    /// A call of one micro-step must not leave it out.
    needed: bool,
    /// It lets a delay begin.
    delays: bool,
}

impl<'n> Watched<'n> {
    fn new(net: &'n Net) -> Self {
        let none: IndexVec<ExprId, bool> = net.exprs.iter().map(|_| false).collect();
        let mut watched = Watched { net, operand_of_edge: none.clone(), operand_of_delay: none.clone(), divisor: none };
        for expr in &net.exprs {
            match expr.kind {
                ExprKind::Rise(a) | ExprKind::Fall(a) => watched.operand_of_edge[a] = true,
                ExprKind::Delay { operand, .. } => watched.operand_of_delay[operand] = true,
                ExprKind::Arithmetic(Arithmetic::Divide | Arithmetic::Modulo, _, by) => watched.divisor[by] = true,
                ExprKind::Arithmetic(Arithmetic::Add | Arithmetic::Subtract | Arithmetic::Multiply, ..)
                | ExprKind::Literal(_)
                | ExprKind::Variable(_)
                | ExprKind::StepActive(_)
                | ExprKind::StepTime(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Compare(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => {}
            }
        }
        watched
    }

    /// All of them.
    fn all(&self) -> impl Iterator<Item = (Change, Matters)> + '_ {
        let net = self.net;
        let state = Matters { repeat: true, needed: true, delays: false };
        // Without a change of the situation or of a variable a clearing or an event may still tell a conflict.
        let happens = Matters { needed: true, ..Matters::default() };
        let steps = net.places.indices().flat_map(|s| [Change::Activated(s), Change::Deactivated(s)]);
        let stored = net.variables.iter_enumerated().filter(|(_, variable)| variable.mode == Mode::Stored);
        let variables = stored.flat_map(|(v, _)| Way::BOTH.map(|way| Change::Variable(v, way)));
        let clearings = net.transitions.indices().map(Change::Clears);
        let actions = (0..net.stored.len()).flat_map(|action| [Change::Occurs(action), Change::Differs(action)]);
        let values = net.exprs.indices().flat_map(|e| {
            let of_edge = self.operand_of_edge[e];
            // A divisor because of DIV0.
            let needed = of_edge || self.divisor[e];
            let matters = Matters { repeat: of_edge, needed, delays: self.operand_of_delay[e] };
            Way::BOTH.map(|way| (Change::Expr(e, way), matters))
        });
        let of_state = steps.chain(variables).map(move |change| (change, state));
        of_state.chain(clearings.chain(actions).map(move |change| (change, happens))).chain(values)
    }

    /// Takes the times of one case into the result.
    fn add(&self, times: &Times, causes: &Causes, result: &mut Transients) {
        let mut last: Option<(u32, u32)> = None;
        for (change, matters) in self.all() {
            let number = causes.number(change);
            let Some(time) = times.of(number) else { continue };
            let is_later = time > 1;
            result.single_but_delays &= !(is_later && matters.needed);
            result.single &= !(is_later && (matters.needed || matters.delays));
            // Of several that come last the first by number.
            let is_last = last.is_none_or(|(latest, first)| latest < time || latest == time && number < first);
            if matters.repeat && is_last {
                last = Some((time, number));
            }
        }
        if let Some((time, change)) = last
            && result.longest.is_some_and(|longest| longest < time + 1)
        {
            result.longest = Some(time + 1);
            result.chain = times.back_from(change).filter_map(|c| causes.transition(self.net, c)).collect();
            result.chain.dedup();
            result.chain.reverse();
        }
    }
}
