//! The decision diagram of a pair of conditions.

use super::Case;
use super::edges::EdgeFacts;
use super::scale::{Cut, Measured, Quantity};
use crate::{Formula, FormulaId, Pool, Type, Value, VarId};
use biodivine_lib_bdd::{Bdd, BddVariable, BddVariableSet, op_function};
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::LazyLock;

/// A condition with more operators and operands than this is compared by its factors only.
const SIZE: usize = 256;

/// A pair with more atoms than this is not examined.
const ATOMS: u16 = 48;

/// Longer lists of cases are not made.
const CASES: usize = 16;

/// Larger diagrams are given up.
const NODES: usize = 4_096;

/// The variables of all decision diagrams.
static VARIABLES: LazyLock<BddVariableSet> = LazyLock::new(|| BddVariableSet::new_anonymous(ATOMS));

/// The micro-step of which an atom tells.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum When {
    /// Both: there is only one, or the atom keeps its value.
    Always,
    Earlier,
    Later,
}

/// What a variable of the diagram stands for.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Atom {
    /// A Boolean formula that is not looked into.
    Formula(FormulaId, When),
    /// The memory of an edge.
    Old(VarId, When),
    /// Whether a quantity is a number.
    Number(Quantity, When),
    /// Whether a quantity lies below one of its cuts, by the number of the cut.
    Below(Quantity, When, usize),
}

pub(super) struct Proof<'p> {
    facts: &'p EdgeFacts,
    pool: &'p Pool,
    /// The variables that keep their values, if the conditions are of two micro-steps.
    stable: Option<&'p dyn Fn(VarId) -> bool>,
    atoms: FxHashMap<Atom, BddVariable>,
    /// The cuts of each quantity in ascending order.
    cuts: FxHashMap<(Quantity, When), Vec<Cut>>,
}

impl<'p> Proof<'p> {
    pub(super) fn new(facts: &'p EdgeFacts, pool: &'p Pool, stable: Option<&'p dyn Fn(VarId) -> bool>) -> Self {
        Proof { facts, pool, stable, atoms: FxHashMap::default(), cuts: FxHashMap::default() }
    }

    /// Whether `a` and `b` are never true together, `b` later than `a` if some variables are told to be stable. False if
    /// that takes too much work.
    pub(super) fn refuted(mut self, a: FormulaId, b: FormulaId) -> bool {
        self.refutes(a, b).unwrap_or(false)
    }

    /// Whether conditions of one micro-step are never all true. False if that takes too much work.
    pub(super) fn all_refuted(mut self, conditions: &[FormulaId]) -> bool {
        let conditions: Vec<(When, FormulaId)> = conditions.iter().map(|c| (When::Always, *c)).collect();
        self.conjunction(&conditions).is_some_and(|all| all.is_false())
    }

    /// For which values of the `kept` variables conditions of one micro-step can all hold; see `EdgeFacts::cases`.
    pub(super) fn cases(mut self, conditions: &[FormulaId], kept: &dyn Fn(VarId) -> bool) -> Option<Vec<Case>> {
        let conditions: Vec<(When, FormulaId)> = conditions.iter().map(|c| (When::Always, *c)).collect();
        let all = self.conjunction(&conditions)?;
        let mut variables: FxHashMap<BddVariable, VarId> = FxHashMap::default();
        let mut others = Vec::new();
        for (atom, variable) in &self.atoms {
            let kept = match atom {
                Atom::Formula(f, _) => match self.pool.get(*f) {
                    Formula::Variable(v) => Some(*v).filter(|v| kept(*v)),
                    _ => None,
                },
                Atom::Old(..) | Atom::Number(..) | Atom::Below(..) => None,
            };
            match kept {
                Some(v) => drop(variables.insert(*variable, v)),
                None => others.push(*variable),
            }
        }
        others.sort_unstable();
        let projected = all.exists(&others);
        let clauses: Vec<Case> = projected
            .sat_clauses()
            .take(CASES + 1)
            .map(|clause| clause.to_values().into_iter().map(|(x, value)| (variables[&x], value)).collect())
            .collect();
        (clauses.len() <= CASES).then_some(clauses)
    }

    fn refutes(&mut self, a: FormulaId, b: FormulaId) -> Option<bool> {
        Some(self.conjunction(&[(When::Earlier, a), (When::Later, b)])?.is_false())
    }

    fn conjunction(&mut self, conditions: &[(When, FormulaId)]) -> Option<Bdd> {
        let mut all_below = Vec::with_capacity(conditions.len());
        for (_, condition) in conditions {
            all_below.push(below(self.pool, *condition)?);
        }
        let mut order = Vec::new();
        for ((when, _), below) in conditions.iter().zip(&all_below) {
            self.cut(*when, below, &mut order);
        }
        let mut all = self.scales(&order)?;
        for ((when, root), below) in conditions.iter().zip(&all_below) {
            let diagram = self.diagram(*when, *root, below)?;
            all = and(&all, &diagram)?;
            if all.is_false() {
                break;
            }
        }
        Some(all)
    }

    /// Collects the cuts of all quantities, and the quantities in the order in which they come.
    fn cut(&mut self, when: When, below: &[FormulaId], order: &mut Vec<(Quantity, When, bool)>) {
        for f in below {
            let Some(measured) = self.measured(*f) else { continue };
            let when = self.when(when, *f);
            let interval = measured.interval();
            let cuts = self.cuts.entry((measured.quantity, when)).or_insert_with(|| {
                order.push((measured.quantity, when, measured.real));
                Vec::new()
            });
            cuts.extend(interval.from.into_iter().chain(interval.before));
        }
    }

    /// Gives each cut its atom and says that each implies the next.
    fn scales(&mut self, order: &[(Quantity, When, bool)]) -> Option<Bdd> {
        let mut all = VARIABLES.mk_true();
        for (quantity, when, real) in order {
            if *real {
                self.atom(Atom::Number(*quantity, *when))?;
            }
            let cuts = self.cuts.get_mut(&(*quantity, *when))?;
            cuts.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
            cuts.dedup();
            for index in 0..cuts.len() {
                let here = self.atom(Atom::Below(*quantity, *when, index))?;
                if let Some(before) = index.checked_sub(1) {
                    let before = self.atom(Atom::Below(*quantity, *when, before))?;
                    let implies = or(&not(&before), &here)?;
                    all = and(&all, &implies)?;
                }
            }
        }
        Some(all)
    }

    fn diagram(&mut self, when: When, root: FormulaId, below: &[FormulaId]) -> Option<Bdd> {
        let mut made: FxHashMap<FormulaId, Bdd> = FxHashMap::default();
        let pool = self.pool;
        for f in below.iter().filter(|f| is_boolean(pool, **f)) {
            let folded = |list: &[FormulaId], first: Bdd, op: fn(&Bdd, &Bdd) -> Option<Bdd>| {
                list.iter().try_fold(first, |all, operand| op(&all, made.get(operand)?))
            };
            let diagram = match pool.get(*f) {
                Formula::Constant(Value::Bool(true)) => VARIABLES.mk_true(),
                Formula::Constant(_) => VARIABLES.mk_false(),
                Formula::Not(a) => not(made.get(a)?),
                Formula::And(list) => folded(pool.list(*list), VARIABLES.mk_true(), and)?,
                Formula::Or(list) => folded(pool.list(*list), VARIABLES.mk_false(), or)?,
                Formula::Xor([a, b]) => binary(made.get(a)?, made.get(b)?, op_function::xor)?,
                Formula::Variable(v) => self.variable(when, *f, *v)?,
                Formula::Compare(..) => self.comparison(when, *f)?,
                Formula::TimerDone(_) => self.leaf(when, *f)?,
                // Not Boolean: inside comparisons only.
                Formula::TimerElapsed(_) | Formula::Arithmetic(..) | Formula::Negate(_) | Formula::Widen(_) => continue,
            };
            made.insert(*f, diagram);
        }
        made.remove(&root)
    }

    /// A variable, or what an edge says of its operand (X4).
    fn variable(&mut self, when: When, f: FormulaId, v: VarId) -> Option<Bdd> {
        let Some(edge) = self.facts.edge(v).copied() else { return self.leaf(when, f) };
        let at = self.when(when, edge.now);
        if self.stable.is_some() && when == When::Later && at == When::Always {
            return Some(VARIABLES.mk_false());
        }
        let now = self.leaf(when, edge.now)?;
        let old = self.atom(Atom::Old(edge.old, if self.stable.is_some() { when } else { When::Always }))?;
        if edge.rising { and(&now, &not(&old)) } else { and(&not(&now), &old) }
    }

    /// A Boolean formula that is not looked into.
    fn leaf(&mut self, when: When, f: FormulaId) -> Option<Bdd> {
        match self.pool.as_truth(f) {
            Some(true) => Some(VARIABLES.mk_true()),
            Some(false) => Some(VARIABLES.mk_false()),
            None => {
                let when = self.when(when, f);
                self.atom(Atom::Formula(f, when))
            }
        }
    }

    fn comparison(&mut self, when: When, f: FormulaId) -> Option<Bdd> {
        let Some(measured) = self.measured(f) else { return self.leaf(when, f) };
        let when = self.when(when, f);
        let interval = measured.interval();
        let mut inside = VARIABLES.mk_true();
        if measured.real {
            inside = self.atom(Atom::Number(measured.quantity, when))?;
        }
        for (cut, asserted) in [(interval.from, false), (interval.before, true)] {
            let Some(cut) = cut else { continue };
            let index = self.cuts.get(&(measured.quantity, when))?.iter().position(|c| *c == cut)?;
            let below = self.atom(Atom::Below(measured.quantity, when, index))?;
            inside = and(&inside, &if asserted { below } else { not(&below) })?;
        }
        Some(if interval.outside { not(&inside) } else { inside })
    }

    fn measured(&self, f: FormulaId) -> Option<Measured> {
        match self.pool.get(f) {
            Formula::Compare(comparison, [a, b]) => Measured::new(self.pool, *comparison, *a, *b),
            _ => None,
        }
    }

    /// Of which micro-step a formula of a condition tells. One reads a timer as of its last call, which may have been in
    /// between.
    fn when(&self, when: When, f: FormulaId) -> When {
        let Some(stable) = self.stable else { return When::Always };
        let keeps = |f: &FormulaId| match self.pool.get(*f) {
            Formula::Variable(v) => stable(*v) && self.facts.edge(*v).is_none(),
            Formula::TimerDone(_) | Formula::TimerElapsed(_) => false,
            Formula::Constant(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => true,
        };
        let fixed = below(self.pool, f).is_some_and(|below| below.iter().all(keeps));
        if fixed { When::Always } else { when }
    }

    /// The variable of an atom; none if there are too many.
    fn atom(&mut self, atom: Atom) -> Option<Bdd> {
        let next = self.atoms.len();
        if next == usize::from(ATOMS) && !self.atoms.contains_key(&atom) {
            return None;
        }
        let variable = *self.atoms.entry(atom).or_insert_with(|| BddVariable::from_index(next));
        Some(VARIABLES.mk_var(variable))
    }
}

/// Whether a formula is one that others join.
fn is_boolean(pool: &Pool, f: FormulaId) -> bool {
    pool.ty(f) == Type::Bool
}

fn not(a: &Bdd) -> Bdd {
    a.not()
}

fn and(a: &Bdd, b: &Bdd) -> Option<Bdd> {
    binary(a, b, op_function::and)
}

fn or(a: &Bdd, b: &Bdd) -> Option<Bdd> {
    binary(a, b, op_function::or)
}

fn binary(a: &Bdd, b: &Bdd, op: fn(Option<bool>, Option<bool>) -> Option<bool>) -> Option<Bdd> {
    Bdd::binary_op_with_limit(NODES, a, b, op)
}

/// Every formula below a condition, operands before operators; none if there are too many.
pub(super) fn below(pool: &Pool, root: FormulaId) -> Option<Vec<FormulaId>> {
    let mut seen = FxHashSet::default();
    let mut ids = Vec::new();
    let mut stack = vec![root];
    while let Some(id) = stack.pop() {
        if !seen.insert(id) {
            continue;
        }
        ids.push(id);
        for operand in pool.operands(id) {
            stack.push(operand);
            if stack.len() + ids.len() > SIZE {
                return None;
            }
        }
    }
    ids.sort_unstable();
    Some(ids)
}
