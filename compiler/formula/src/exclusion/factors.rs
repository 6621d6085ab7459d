//! What the factors of conditions say without a decision diagram, and which of them have to do with each other.
//!
//! A factor that is a variable or a comparison, or the negation of one, is a *literal*. Comparisons with constants say
//! between which bounds a quantity lies. Where all literals of two conditions hold, each of the other factors is true,
//! false or open; one that is false refutes the conjunction:
//!
//! ```text
//! a OR b    and    NOT (a OR b) AND NOT c AND d       not a, not b: the first is false
//! ```
//!
//! This finds a long chain of priorities exclusive in time that is proportional to its text. Factors that share no
//! variable are satisfied independently, so a decision diagram is needed only for a group that is connected by variables.

use super::EdgeFacts;
use super::scale::{Cut, Interval, Measured, Quantity};
use crate::{Formula, FormulaId, Pool};
use rustc_hash::FxHashMap;

/// Factors are evaluated under literals as long as a condition has no more operators and operands than this.
const EVALUATED: usize = 8_192;

/// What is known of formulas.
type Known = FxHashMap<FormulaId, bool>;

/// Whether factors of two conditions contradict each other in plain sight.
pub(super) fn contradict(facts: &EdgeFacts, pool: &Pool, a: FormulaId, b: FormulaId) -> bool {
    if [a, b].iter().any(|c| pool.as_truth(*c) == Some(false)) {
        return true;
    }
    let (mut known, mut open, mut bounds) = (Known::default(), Vec::new(), Bounds::default());
    for factor in [&a, &b].into_iter().flat_map(|condition| pool.factors(condition)) {
        let (inner, asserted) = match pool.get(*factor) {
            Formula::Not(inner) => (*inner, false),
            _ => (*factor, true),
        };
        if known.insert(inner, asserted).is_some_and(|other| other != asserted) {
            return true;
        }
        match pool.get(inner) {
            Formula::Variable(v) if asserted => {
                if let Some(edge) = facts.edge(*v)
                    && known.insert(edge.now, edge.rising).is_some_and(|other| other != edge.rising)
                {
                    return true;
                }
            }
            Formula::Compare(comparison, [x, y]) => {
                bounds.add(Measured::new(pool, *comparison, *x, *y), asserted);
            }
            Formula::And(_) | Formula::Or(_) | Formula::Xor(..) => open.push(*factor),
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => {}
        }
    }
    if bounds.contradict() {
        return true;
    }
    let mut left = EVALUATED;
    open.into_iter().any(|factor| evaluate(pool, factor, &known, &mut left) == Some(false))
}

/// What a factor is where the literals hold; nothing is known of it if that takes too much work.
fn evaluate(pool: &Pool, factor: FormulaId, literals: &Known, left: &mut usize) -> Option<bool> {
    let mut values: FxHashMap<FormulaId, Option<bool>> = FxHashMap::default();
    // That the factor is true was noted as well, and is what is asked.
    let inner = match pool.get(factor) {
        Formula::Not(inner) => *inner,
        _ => factor,
    };
    let known = |f: FormulaId| if f == factor || f == inner { None } else { literals.get(&f).copied() };
    let mut stack = vec![factor];
    while let Some(f) = stack.last().copied() {
        if values.contains_key(&f) {
            stack.pop();
            continue;
        }
        if let Some(value) = known(f).or_else(|| pool.as_truth(f)) {
            values.insert(f, Some(value));
            continue;
        }
        let value = match pool.get(f) {
            Formula::And(_) | Formula::Or(_) | Formula::Not(_) | Formula::Xor(..) => {
                let waiting = stack.len();
                stack.extend(pool.operands(f).filter(|operand| !values.contains_key(operand)));
                *left = left.checked_sub(1 + stack.len() - waiting)?;
                if stack.len() > waiting {
                    continue;
                }
                let operands: Vec<Option<bool>> = pool.operands(f).map(|operand| values[&operand]).collect();
                join(pool.get(f), &operands)
            }
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => None,
        };
        values.insert(f, value);
    }
    values[&factor]
}

/// What an operator makes of operands.
fn join(operator: &Formula, operands: &[Option<bool>]) -> Option<bool> {
    let junction = |neutral: bool| {
        if operands.contains(&Some(!neutral)) {
            Some(!neutral)
        } else {
            operands.iter().all(Option::is_some).then_some(neutral)
        }
    };
    match operator {
        Formula::And(_) => junction(true),
        Formula::Or(_) => junction(false),
        Formula::Not(_) => operands[0].map(|a| !a),
        Formula::Xor(..) => operands[0].zip(operands[1]).map(|(a, b)| a != b),
        Formula::Constant(_)
        | Formula::Variable(_)
        | Formula::TimerDone(_)
        | Formula::TimerElapsed(_)
        | Formula::Compare(..)
        | Formula::Arithmetic(..)
        | Formula::Negate(_)
        | Formula::Widen(_) => None,
    }
}

/// Where quantities lie if all comparisons that are literals hold.
#[derive(Default)]
struct Bounds {
    of: FxHashMap<Quantity, (Option<Cut>, Option<Cut>)>,
    /// Where they do not lie.
    outside: Vec<(Quantity, Interval)>,
}

impl Bounds {
    fn add(&mut self, measured: Option<Measured>, asserted: bool) {
        let Some(measured) = measured else { return };
        let interval = measured.interval();
        let (from, before) = match (asserted, interval.outside, interval.from, interval.before) {
            (true, false, from, before) | (false, true, from, before) => (from, before),
            // Of a real it might also be that it is no number.
            (false, false, from @ Some(_), None) if !measured.real => (None, from),
            (false, false, None, before @ Some(_)) if !measured.real => (before, None),
            (true, true, ..) => {
                self.outside.push((measured.quantity, interval));
                return;
            }
            (false, false, ..) => return,
        };
        let known = self.of.entry(measured.quantity).or_default();
        // Nothing is less than no bound from below.
        if from > known.0 {
            known.0 = from;
        }
        known.1 = match (known.1, before) {
            (Some(a), Some(b)) => Some(if b < a { b } else { a }),
            (a, b) => a.or(b),
        };
    }

    fn contradict(&self) -> bool {
        let empty = |(from, before): &(Option<Cut>, Option<Cut>)| from.zip(*before).is_some_and(|(a, b)| a >= b);
        let one = |(quantity, interval): &(Quantity, Interval)| {
            self.of.get(quantity).is_some_and(|bounds| *bounds == (interval.from, interval.before))
        };
        self.of.values().any(empty) || self.outside.iter().any(one)
    }
}

/// Factors that are connected by what they read.
pub(super) struct Group {
    pub(super) factors: Vec<FormulaId>,
}

/// The factors of all conditions in groups, each in the order in which they come.
pub(super) fn groups(facts: &EdgeFacts, pool: &Pool, conditions: &[FormulaId]) -> Vec<Group> {
    let mut factors: Vec<FormulaId> = conditions.iter().flat_map(|c| pool.factors(c)).copied().collect();
    factors.sort_unstable();
    factors.dedup();
    // The first factor that reads each variable, and for each factor one of its group that comes before it.
    let mut readers: FxHashMap<FormulaId, usize> = FxHashMap::default();
    let mut linked: Vec<usize> = (0..factors.len()).collect();
    let root = |linked: &mut Vec<usize>, mut at: usize| {
        while linked[at] != at {
            linked[at] = linked[linked[at]];
            at = linked[at];
        }
        at
    };
    for (number, factor) in factors.iter().enumerate() {
        for leaf in read(facts, pool, *factor) {
            let other = *readers.entry(leaf).or_insert(number);
            let (a, b) = (root(&mut linked, other), root(&mut linked, number));
            linked[a.max(b)] = a.min(b);
        }
    }
    let mut groups: Vec<Group> = Vec::new();
    let mut number_of: FxHashMap<usize, usize> = FxHashMap::default();
    for (number, factor) in factors.into_iter().enumerate() {
        let group = *number_of.entry(root(&mut linked, number)).or_insert_with(|| {
            groups.push(Group { factors: Vec::new() });
            groups.len() - 1
        });
        groups[group].factors.push(factor);
    }
    groups
}

/// What a condition reads, an edge as its operand.
pub(super) fn read<'p>(
    facts: &'p EdgeFacts,
    pool: &'p Pool,
    condition: FormulaId,
) -> impl Iterator<Item = FormulaId> + 'p {
    let leaf = move |f: FormulaId| match pool.get(f) {
        Formula::Variable(v) => Some(facts.edge(*v).map_or(f, |edge| edge.now)),
        _ => (pool.is_leaf(f) && pool.as_constant(f).is_none()).then_some(f),
    };
    pool.below(condition).into_iter().filter_map(leaf)
}
