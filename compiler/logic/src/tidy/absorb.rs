//! Shorter formulas that a reader still recognises.
//!
//! | what | where |
//! | --- | --- |
//! | constants, repeated operands, double negation | in the pool, always |
//! | what is known where a transition is enabled: its steps are active, those that exclude them are not | [`restrict`] |
//! | a long condition that several transitions share gets a name | [`share`] |
//! | absorption: `a OR a AND b` is `a`, `a OR NOT a AND b` is `a OR b`, and the same with AND and OR exchanged | [`absorb`] |
//!
//! Nothing is multiplied out, factored or reordered.

use super::words::formula_word;
use crate::analysis::components::Components;
use crate::lower::Lowering;
use crate::scan::{Choice, Origin, Program, Role, Statement};
use grafc_formula::{Formula, FormulaId, Pool, Type};
use grafc_model::chart::{StepId, TransitionId};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// A shared formula with fewer operands than this is not worth a name.
const WORTH_A_NAME: usize = 3;

/// Conditions as they are where their transition is enabled: a condition is looked at only then, so what it says of the
/// steps before the transition, and of steps that exclude these, is known.
pub(crate) fn restrict(
    lowering: &mut Lowering,
    components: &Components,
    conditions: &mut IndexVec<TransitionId, FormulaId>,
) {
    let net = &*lowering.net.clone();
    let step_of: FxHashMap<FormulaId, StepId> = net.places.indices().map(|s| (lowering.active(s), s)).collect();
    for (t, transition) in net.transitions.iter_enumerated() {
        if lowering.pool.is_leaf(conditions[t]) && !step_of.contains_key(&conditions[t]) {
            continue;
        }
        let mut known: FxHashMap<FormulaId, FormulaId> = FxHashMap::default();
        for f in lowering.pool.below(conditions[t]) {
            let Some(s) = step_of.get(&f) else { continue };
            let active = transition.pre.contains(s) || transition.encloser() == Some(*s);
            let excluded = !active
                && transition.pre.iter().any(|p| components.of(*p).iter().any(|c| components.of(*s).contains(c)));
            if active || excluded {
                known.insert(f, lowering.pool.truth(active));
            }
        }
        if !known.is_empty() {
            conditions[t] = lowering.pool.replace(conditions[t], &known);
        }
    }
}

/// Gives a name to what several conditions have in common, and returns the definitions.
pub(crate) fn share(lowering: &mut Lowering, conditions: &mut IndexVec<TransitionId, FormulaId>) -> Vec<Statement> {
    let mut uses: FxHashMap<FormulaId, u32> = FxHashMap::default();
    for condition in conditions.iter().filter(|condition| !lowering.pool.is_leaf(**condition)) {
        for f in lowering.pool.below(*condition) {
            if let Formula::And(list) | Formula::Or(list) = lowering.pool.get(f)
                && lowering.pool.list(*list).len() >= WORTH_A_NAME
            {
                *uses.entry(f).or_default() += 1;
            }
        }
    }
    let mut shared: Vec<FormulaId> = uses.into_iter().filter(|(_, n)| *n > 1).map(|(f, _)| f).collect();
    shared.sort_unstable();
    let mut statements = Vec::new();
    let mut by: FxHashMap<FormulaId, FormulaId> = FxHashMap::default();
    for f in shared {
        let value = lowering.pool.replace(f, &by);
        let name = formula_word(&lowering.pool, &lowering.symbols.table, &lowering.timers, value);
        let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
        statements.push(Statement::assign(Origin::Chart, target, value));
        by.insert(f, lowering.symbols.read(&mut lowering.pool, target));
    }
    if !by.is_empty() {
        for condition in conditions.iter_mut() {
            *condition = lowering.pool.replace(*condition, &by);
        }
    }
    statements
}

/// Absorption in every formula of a program.
pub(crate) fn absorb(program: &mut Program) {
    let pool = std::mem::take(&mut program.pool);
    let shorter = pool.ids().map(|_| None).collect();
    let mut absorbing = Absorbing { pool, shorter, open: Vec::new() };
    let restored = program.restoring.iter_mut().map(|restoring| &mut restoring.statements);
    let sections = [&mut program.first, &mut program.before, &mut program.micro_step, &mut program.after];
    for section in sections.into_iter().chain(restored) {
        absorbing.block(section);
    }
    program.pool = absorbing.pool;
}

struct Absorbing {
    pool: Pool,
    /// The shorter form of each formula that has been looked at.
    shorter: IndexVec<FormulaId, Option<FormulaId>>,
    /// Formulas that wait for their operands.
    open: Vec<FormulaId>,
}

impl Absorbing {
    /// Statements nest no deeper than lowering nests them.
    fn block(&mut self, statements: &mut [Statement]) {
        for statement in statements {
            match statement {
                Statement::Heading(_) | Statement::Divide(_) => {}
                Statement::Assign { value, .. } => *value = self.formula(*value),
                Statement::CallTimer { input, .. } => *input = self.formula(*input),
                Statement::Case { arms, .. } => arms.iter_mut().for_each(|arm| self.block(&mut arm.body)),
                Statement::If(choice) => {
                    let Choice { branches, otherwise } = &mut **choice;
                    for (when, body) in branches {
                        // A condition that has become constant would need another statement, so it stays as it is.
                        let shorter = self.formula(*when);
                        if self.pool.as_truth(shorter).is_none() {
                            *when = shorter;
                        }
                        self.block(body);
                    }
                    self.block(otherwise);
                }
            }
        }
    }

    /// The shorter form of a formula; those of its operands come first.
    fn formula(&mut self, root: FormulaId) -> FormulaId {
        if !self.pool.is_leaf(root) {
            self.open.push(root);
        }
        while let Some(id) = self.open.last().copied() {
            if self.shorter[id].is_none() {
                let waiting = self.open.len();
                let is_new = |operand: &FormulaId| !self.pool.is_leaf(*operand) && self.shorter[*operand].is_none();
                self.open.extend(self.pool.operands(id).filter(is_new));
                if self.open.len() > waiting {
                    continue;
                }
                self.shorter[id] = Some(self.one(id));
            }
            self.open.pop();
        }
        self.of(root)
    }

    fn of(&self, id: FormulaId) -> FormulaId {
        self.shorter[id].unwrap_or(id)
    }

    /// The shorter form of a formula whose operands have theirs.
    fn one(&mut self, id: FormulaId) -> FormulaId {
        let inner = if self.pool.operands(id).all(|operand| self.of(operand) == operand) {
            id
        } else {
            let operands = self.pool.operands(id).map(|o| (o, self.of(o))).collect();
            self.pool.rebuilt(id, &operands)
        };
        let dual = |of: &Formula, conjunction: bool| match of {
            Formula::Or(_) => conjunction,
            Formula::And(_) => !conjunction,
            _ => false,
        };
        let (list, conjunction) = match self.pool.get(inner) {
            Formula::And(list) => (*list, true),
            Formula::Or(list) => (*list, false),
            _ => return inner,
        };
        let list = self.pool.list(list);
        if !list.iter().any(|operand| dual(self.pool.get(*operand), conjunction)) {
            return inner;
        }
        let Some(kept) = kept(&self.pool, list, conjunction) else { return inner };
        junction(&mut self.pool, kept, conjunction)
    }
}

/// What is left of an operand of a conjunction or disjunction beside the others.
enum Kept {
    Whole(FormulaId),
    /// Of a dual junction, those of its operands that say something.
    Part(Vec<FormulaId>),
}

/// What is left of the operands of a conjunction or disjunction without what others make superfluous; none if that is
/// all of them.
fn kept(pool: &Pool, list: &[FormulaId], conjunction: bool) -> Option<Vec<Kept>> {
    let operands = Operands::new(pool, list);
    let inner = |operand: FormulaId| match (pool.get(operand), conjunction) {
        (Formula::Or(inner), true) | (Formula::And(inner), false) => pool.list(*inner),
        _ => &[],
    };
    let says_nothing = |f: &FormulaId| operands.contain(*f) || operands.contain_negation(pool, *f);
    if !list.iter().any(|operand| inner(*operand).iter().any(says_nothing)) {
        return None;
    }
    let mut kept = Vec::with_capacity(list.len());
    for operand in list {
        let inner = inner(*operand);
        if inner.iter().any(|i| operands.contain(*i)) {
            continue;
        }
        let left = || inner.iter().copied().filter(|i| !operands.contain_negation(pool, *i));
        kept.push(if left().count() == inner.len() { Kept::Whole(*operand) } else { Kept::Part(left().collect()) });
    }
    Some(kept)
}

/// The conjunction or disjunction of what is left.
fn junction(pool: &mut Pool, kept: Vec<Kept>, conjunction: bool) -> FormulaId {
    let operand = |kept: Kept| match kept {
        Kept::Whole(operand) => operand,
        Kept::Part(left) if conjunction => pool.or(left),
        Kept::Part(left) => pool.and(left),
    };
    let operands: Vec<FormulaId> = kept.into_iter().map(operand).collect();
    if conjunction { pool.and(operands) } else { pool.or(operands) }
}

/// The operands of a junction; of a long one in a table.
struct Operands<'l> {
    list: &'l [FormulaId],
    table: FxHashSet<FormulaId>,
    /// Whether one of them is a negation.
    have_negation: bool,
}

/// Up to so many operands are compared one by one.
const SHORT: usize = 16;

impl<'l> Operands<'l> {
    fn new(pool: &Pool, list: &'l [FormulaId]) -> Self {
        let table = if list.len() > SHORT { list.iter().copied().collect() } else { FxHashSet::default() };
        let have_negation = list.iter().any(|operand| matches!(pool.get(*operand), Formula::Not(_)));
        Operands { list, table, have_negation }
    }

    fn contain(&self, f: FormulaId) -> bool {
        if self.table.is_empty() { self.list.contains(&f) } else { self.table.contains(&f) }
    }

    fn contain_negation(&self, pool: &Pool, f: FormulaId) -> bool {
        match pool.get(f) {
            Formula::Not(inner) => self.contain(*inner),
            _ => self.have_negation && pool.known_not(f).is_some_and(|not| self.contain(not)),
        }
    }
}
