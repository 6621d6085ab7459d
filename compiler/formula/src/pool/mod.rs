//! Hash-consed formulas.
//!
//! A [`Pool`] holds each formula once, children before parents: equal formulas have equal ids, and a loop over ids
//! meets every operand before what uses it. The constructors apply only laws that keep a formula recognisable
//! (constants, double negation, repeated operands).

mod rewrite;

use crate::number;
pub use grafc_model::chart::{Arithmetic, Comparison, Type, Value};
use hashbrown::HashTable;
use index_vec::{IndexVec, define_index_type};
use rustc_hash::{FxBuildHasher, FxHashSet, FxHasher};
use std::hash::{Hash, Hasher};
use std::{iter, slice};

define_index_type! {
    /// A variable of a program.
    pub struct VarId = u32;
    DISPLAY_FORMAT = "v{}";
    DEBUG_FORMAT = "v{}";
}

define_index_type! {
    /// A timer of a program.
    pub struct TimerId = u32;
    DISPLAY_FORMAT = "d{}";
    DEBUG_FORMAT = "d{}";
}

define_index_type! {
    /// A formula of a [`Pool`].
    pub struct FormulaId = u32;
    DISPLAY_FORMAT = "f{}";
    DEBUG_FORMAT = "f{}";
}

/// The forms of formula. Operands of `And`, `Or`, `Not` and `Xor` are Boolean.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Formula {
    /// A constant of the type.
    Constant(Value),
    /// The value of a variable at the moment of reading.
    Variable(VarId),
    /// Whether a timer's input has been true for its preset, as of the timer's last call.
    TimerDone(TimerId),
    /// For how long a timer's input has been true, as of the timer's last call; 0 while it is false.
    TimerElapsed(TimerId),
    /// Negation.
    Not(FormulaId),
    /// Conjunction of two or more, none of them a conjunction.
    And(List),
    /// Disjunction of two or more, none of them a disjunction.
    Or(List),
    /// Exclusive disjunction; also Boolean inequality.
    Xor([FormulaId; 2]),
    /// Both sides have the same type.
    Compare(Comparison, [FormulaId; 2]),
    /// Never nested in another `Arithmetic`, `Negate` or `Compare`, save through a variable of its type: the statement
    /// that stores it wraps it around. Divides only by a constant other than 0 and -1: see `Statement::Divide`.
    Arithmetic(Arithmetic, [FormulaId; 2]),
    /// Arithmetic negation; nested at most as deep as `Arithmetic` is.
    Negate(FormulaId),
    /// A conversion without loss to the type.
    Widen(FormulaId),
}

/// Up to so many operands are compared one by one, which needs no table.
const SHORT: usize = 16;

/// Where in its pool the operands of a conjunction or disjunction lie: [`Pool::list`] has them.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct List {
    begin: u32,
    length: u32,
}

/// All formulas of one program.
///
/// There are many, and they stay to the end: so they are small, and lists lie one behind the other.
#[derive(Clone, Debug, Default)]
pub struct Pool {
    formulas: Vec<Formula>,
    types: Vec<Type>,
    /// How deep each is, as [`Pool::depth`] tells it.
    depths: Vec<u8>,
    /// The operands of all conjunctions and disjunctions.
    lists: Vec<FormulaId>,
    /// All formulas by what they are but those that read a variable.
    known: HashTable<FormulaId>,
    /// The formula that reads a variable, or [`NONE`]: a table of these needs no hashing, and they are half of all formulas.
    reads: IndexVec<VarId, FormulaId>,
    /// How many formulas are in both: all, but none from [`Pool::shrink_to_fit`] on, until one is added.
    listed: usize,
    /// The operands of the junction that is being made: a list of its own is needed for a new one only.
    operands: Vec<FormulaId>,
}

/// No formula.
const NONE: FormulaId = FormulaId::from_raw_unchecked(u32::MAX);

/// A formula to be found or made. If it is a junction these are its operands, which need not lie in the pool.
struct Candidate<'l> {
    formula: Formula,
    ty: Type,
    list: &'l [FormulaId],
}

impl Candidate<'_> {
    fn hash(&self) -> u64 {
        let mut state = FxHasher::default();
        self.ty.hash(&mut state);
        std::mem::discriminant(&self.formula).hash(&mut state);
        match self.formula {
            Formula::Constant(Value::Bool(b)) => b.hash(&mut state),
            Formula::Constant(Value::Int(n) | Value::Time(n)) => n.hash(&mut state),
            Formula::Constant(Value::Real(x)) => x.to_bits().hash(&mut state),
            Formula::Variable(v) => v.hash(&mut state),
            Formula::TimerDone(t) | Formula::TimerElapsed(t) => t.hash(&mut state),
            Formula::Not(a) | Formula::Negate(a) | Formula::Widen(a) => a.hash(&mut state),
            Formula::And(_) | Formula::Or(_) => self.list.hash(&mut state),
            Formula::Xor(pair) => pair.hash(&mut state),
            Formula::Compare(op, pair) => (op, pair).hash(&mut state),
            Formula::Arithmetic(op, pair) => (op, pair).hash(&mut state),
        }
        state.finish()
    }

    /// Constants are the same only if they are the same to the bit.
    fn is(&self, other: &Candidate) -> bool {
        let same = match (self.formula, other.formula) {
            (Formula::Constant(Value::Real(a)), Formula::Constant(Value::Real(b))) => a.to_bits() == b.to_bits(),
            (Formula::And(_), Formula::And(_)) | (Formula::Or(_), Formula::Or(_)) => self.list == other.list,
            (a, b) => a == b,
        };
        same && self.ty == other.ty
    }
}

impl Pool {
    /// No formula, and room for so many, with so many operands of conjunctions and disjunctions.
    pub fn with_capacity(formulas: usize, operands: usize) -> Pool {
        Pool {
            formulas: Vec::with_capacity(formulas),
            types: Vec::with_capacity(formulas),
            depths: Vec::with_capacity(formulas),
            lists: Vec::with_capacity(operands),
            known: HashTable::with_capacity(formulas / 2),
            reads: IndexVec::new(),
            listed: 0,
            operands: Vec::new(),
        }
    }

    /// When hardly any formula will be added: lists that were doubled last are half empty.
    pub fn shrink_to_fit(&mut self) {
        self.formulas.shrink_to_fit();
        self.types.shrink_to_fit();
        self.depths.shrink_to_fit();
        self.lists.shrink_to_fit();
        (self.known, self.reads, self.listed) = (HashTable::new(), IndexVec::new(), 0);
    }

    /// The formula of an id.
    pub fn get(&self, id: FormulaId) -> &Formula {
        &self.formulas[id.index()]
    }

    /// The operands of a conjunction or disjunction.
    pub fn list(&self, list: List) -> &[FormulaId] {
        in_list(&self.lists, list)
    }

    /// The type of a formula.
    pub fn ty(&self, id: FormulaId) -> Type {
        self.types[id.index()]
    }

    /// How many formulas there are; ids count up to it.
    pub fn len(&self) -> usize {
        self.formulas.len()
    }

    /// Whether there is no formula.
    pub fn is_empty(&self) -> bool {
        self.formulas.is_empty()
    }

    /// Whether a formula has no operands: a constant, a variable or a timer.
    pub fn is_leaf(&self, id: FormulaId) -> bool {
        self.depths[id.index()] == 0
    }

    /// The factors of a conjunction; of any other formula itself.
    pub fn factors<'a>(&'a self, id: &'a FormulaId) -> &'a [FormulaId] {
        if let Formula::And(list) = self.get(*id) { self.list(*list) } else { slice::from_ref(id) }
    }

    /// All ids, operands before operators.
    pub fn ids(&self) -> impl Iterator<Item = FormulaId> + use<> {
        (0..self.formulas.len()).map(FormulaId::from_usize)
    }

    /// The operands of a formula, from left to right.
    #[inline]
    pub fn operands(&self, id: FormulaId) -> iter::Copied<slice::Iter<'_, FormulaId>> {
        let operands = match self.get(id) {
            Formula::Constant(_) | Formula::Variable(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) => &[],
            Formula::Not(a) | Formula::Negate(a) | Formula::Widen(a) => slice::from_ref(a),
            Formula::Xor(pair) | Formula::Compare(_, pair) | Formula::Arithmetic(_, pair) => pair.as_slice(),
            Formula::And(list) | Formula::Or(list) => self.list(*list),
        };
        operands.iter().copied()
    }

    fn add(&mut self, formula: Formula, ty: Type) -> FormulaId {
        self.add_candidate(&Candidate { formula, ty, list: &[] })
    }

    fn add_candidate(&mut self, candidate: &Candidate) -> FormulaId {
        self.list_all();
        let hash = candidate.hash();
        if let Some(known) = self.find(candidate, hash) {
            return known;
        }
        let id = self.push(candidate);
        let Pool { formulas, types, lists, known, .. } = self;
        known.insert_unique(hash, id, |id| as_candidate(formulas, types, lists, *id).hash());
        id
    }

    /// Adds a formula that is not there yet to the pool, though not to a table.
    fn push(&mut self, candidate: &Candidate) -> FormulaId {
        let id = FormulaId::from_usize(self.formulas.len());
        let list = List { begin: self.lists.len() as u32, length: candidate.list.len() as u32 };
        self.lists.extend_from_slice(candidate.list);
        self.formulas.push(match candidate.formula {
            Formula::And(_) => Formula::And(list),
            Formula::Or(_) => Formula::Or(list),
            other => other,
        });
        self.types.push(candidate.ty);
        let below = self.operands(id).map(|o| self.depths[o.index()].saturating_add(1)).max();
        self.depths.push(below.unwrap_or(0));
        self.listed += 1;
        id
    }

    /// Makes the tables of all formulas, if they are not there.
    fn list_all(&mut self) {
        if self.listed == self.formulas.len() {
            return;
        }
        for id in self.ids() {
            if let Formula::Variable(v) = self.formulas[id.index()] {
                self.list_read(v, id);
                continue;
            }
            let Pool { formulas, types, lists, known, .. } = self;
            let hash = |id: &FormulaId| as_candidate(formulas, types, lists, *id).hash();
            known.insert_unique(hash(&id), id, hash);
        }
        self.listed = self.formulas.len();
    }

    fn list_read(&mut self, variable: VarId, id: FormulaId) {
        if self.reads.len() <= variable.index() {
            self.reads.resize(variable.index() + 1, NONE);
        }
        self.reads[variable] = id;
    }

    fn find(&self, candidate: &Candidate, hash: u64) -> Option<FormulaId> {
        debug_assert_eq!(self.listed, self.formulas.len(), "the table is asked before a formula is added to it");
        let Pool { formulas, types, lists, .. } = self;
        self.known.find(hash, |id| candidate.is(&as_candidate(formulas, types, lists, *id))).copied()
    }

    /// How many operators stand above one another in a formula: 0 for a variable or constant. More than 255 are not counted.
    pub fn depth(&self, id: FormulaId) -> u8 {
        self.depths[id.index()]
    }

    /// A constant of a type.
    pub fn constant(&mut self, value: Value, ty: Type) -> FormulaId {
        self.add(Formula::Constant(value), ty)
    }

    /// `TRUE` or `FALSE`.
    pub fn truth(&mut self, value: bool) -> FormulaId {
        self.constant(Value::Bool(value), Type::Bool)
    }

    /// The truth value of a formula that is a Boolean constant.
    pub fn as_truth(&self, id: FormulaId) -> Option<bool> {
        match self.get(id) {
            Formula::Constant(Value::Bool(b)) => Some(*b),
            _ => None,
        }
    }

    /// The value of a formula that is a constant.
    pub fn as_constant(&self, id: FormulaId) -> Option<Value> {
        match self.get(id) {
            Formula::Constant(value) => Some(*value),
            _ => None,
        }
    }

    /// The value of a variable, which has one type.
    pub fn variable(&mut self, variable: VarId, ty: Type) -> FormulaId {
        self.list_all();
        if let Some(known) = self.reads.get(variable).copied().filter(|known| *known != NONE) {
            debug_assert_eq!(self.ty(known), ty, "a variable has one type");
            return known;
        }
        let id = self.push(&Candidate { formula: Formula::Variable(variable), ty, list: &[] });
        self.list_read(variable, id);
        id
    }

    /// Whether a timer has run out.
    pub fn timer_done(&mut self, timer: TimerId) -> FormulaId {
        self.add(Formula::TimerDone(timer), Type::Bool)
    }

    /// For how long a timer has run.
    pub fn timer_elapsed(&mut self, timer: TimerId) -> FormulaId {
        self.add(Formula::TimerElapsed(timer), Type::Time)
    }

    /// `NOT a`.
    pub fn not(&mut self, a: FormulaId) -> FormulaId {
        match *self.get(a) {
            Formula::Constant(Value::Bool(b)) => self.truth(!b),
            Formula::Not(inner) => inner,
            _ => self.add(Formula::Not(a), Type::Bool),
        }
    }

    /// The negation of a formula, if the pool holds it already.
    pub fn known_not(&self, a: FormulaId) -> Option<FormulaId> {
        let looked_for = match *self.get(a) {
            Formula::Constant(Value::Bool(b)) => Formula::Constant(Value::Bool(!b)),
            Formula::Not(inner) => return Some(inner),
            _ => Formula::Not(a),
        };
        let candidate = Candidate { formula: looked_for, ty: Type::Bool, list: &[] };
        self.find(&candidate, candidate.hash())
    }

    /// The conjunction of the operands; `TRUE` of none.
    pub fn and(&mut self, operands: impl IntoIterator<Item = FormulaId>) -> FormulaId {
        self.junction(operands, true)
    }

    /// The disjunction of the operands; `FALSE` of none.
    pub fn or(&mut self, operands: impl IntoIterator<Item = FormulaId>) -> FormulaId {
        self.junction(operands, false)
    }

    /// A conjunction (`neutral` true) or a disjunction: nested ones of the same kind are taken in, neutral and repeated
    /// operands are dropped, the first occurrence keeps its place.
    fn junction(&mut self, operands: impl IntoIterator<Item = FormulaId>, neutral: bool) -> FormulaId {
        let mut list = std::mem::take(&mut self.operands);
        list.clear();
        let made = self.junction_of(operands, neutral, &mut list);
        self.operands = list;
        made
    }

    fn junction_of(
        &mut self,
        operands: impl IntoIterator<Item = FormulaId>,
        neutral: bool,
        list: &mut Vec<FormulaId>,
    ) -> FormulaId {
        for operand in operands {
            match (self.get(operand), neutral) {
                (Formula::Constant(Value::Bool(b)), _) if *b == neutral => {}
                (Formula::Constant(Value::Bool(_)), _) => return operand,
                (Formula::And(inner), true) | (Formula::Or(inner), false) => list.extend_from_slice(self.list(*inner)),
                _ => list.push(operand),
            }
        }
        let contradicts = if list.len() <= SHORT {
            let mut kept = 0;
            for at in 0..list.len() {
                if !list[..kept].contains(&list[at]) {
                    list[kept] = list[at];
                    kept += 1;
                }
            }
            list.truncate(kept);
            list.iter().any(|id| matches!(self.get(*id), Formula::Not(inner) if list.contains(inner)))
        } else {
            let mut seen = FxHashSet::with_capacity_and_hasher(list.len(), FxBuildHasher);
            list.retain(|id| seen.insert(*id));
            list.iter().any(|id| matches!(self.get(*id), Formula::Not(inner) if seen.contains(inner)))
        };
        if contradicts {
            return self.truth(!neutral);
        }
        match list.as_slice() {
            [] => self.truth(neutral),
            [only] => *only,
            list => {
                let formula = if neutral { Formula::And(List::default()) } else { Formula::Or(List::default()) };
                self.add_candidate(&Candidate { formula, ty: Type::Bool, list })
            }
        }
    }

    /// `a XOR b`, which is also `a <> b` of Booleans.
    pub fn xor(&mut self, a: FormulaId, b: FormulaId) -> FormulaId {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(false), _) => b,
            (_, Some(false)) => a,
            (Some(true), _) => self.not(b),
            (_, Some(true)) => self.not(a),
            (None, None) if a == b => self.truth(false),
            (None, None) => self.add(Formula::Xor([a, b]), Type::Bool),
        }
    }

    /// A comparison of two operands of one type; of Booleans only equality.
    pub fn compare(&mut self, op: Comparison, a: FormulaId, b: FormulaId) -> FormulaId {
        match (self.ty(a), op) {
            (Type::Bool, Comparison::Equal) => {
                let differ = self.xor(a, b);
                self.not(differ)
            }
            (Type::Bool, Comparison::NotEqual) => self.xor(a, b),
            _ => match (self.as_constant(a), self.as_constant(b)) {
                (Some(a), Some(b)) => self.truth(number::compare(op, a, b)),
                (None, _) | (_, None) => self.add(Formula::Compare(op, [a, b]), Type::Bool),
            },
        }
    }

    /// Whether a variable that holds one value would change by taking the other. Two reals that are no numbers are the
    /// same here, although `<>` holds between them: else a chart that stores one would never be stable.
    pub fn differs(&mut self, a: FormulaId, b: FormulaId) -> FormulaId {
        let differs = self.compare(Comparison::NotEqual, a, b);
        if !matches!(self.ty(a), Type::Real | Type::Lreal) {
            return differs;
        }
        let (a_is_number, b_is_number) = (self.compare(Comparison::Equal, a, a), self.compare(Comparison::Equal, b, b));
        let some_number = self.or([a_is_number, b_is_number]);
        self.and([differs, some_number])
    }

    /// An arithmetic operation; see [`Formula::Arithmetic`] for what may be its operands. Constants are computed here:
    /// compilers of PLCs refuse an operation on literals whose result leaves the range of the type.
    pub fn arithmetic(&mut self, op: Arithmetic, ty: Type, a: FormulaId, b: FormulaId) -> FormulaId {
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(a), Some(b)) => self.constant(number::arithmetic(op, ty, a, b), ty),
            (None, _) | (_, None) => self.add(Formula::Arithmetic(op, [a, b]), ty),
        }
    }

    /// `-a`.
    pub fn negate(&mut self, a: FormulaId) -> FormulaId {
        let ty = self.ty(a);
        match self.as_constant(a) {
            Some(a) => self.constant(number::negate(ty, a), ty),
            None => self.add(Formula::Negate(a), ty),
        }
    }

    /// A conversion without loss; a constant is converted here.
    pub fn widen(&mut self, ty: Type, a: FormulaId) -> FormulaId {
        if self.ty(a) == ty {
            return a;
        }
        match (*self.get(a), ty) {
            (Formula::Constant(Value::Int(n)), Type::Real | Type::Lreal) => self.constant(Value::Real(n as f64), ty),
            (Formula::Constant(value), _) => self.constant(value, ty),
            _ => self.add(Formula::Widen(a), ty),
        }
    }
}

fn in_list(lists: &[FormulaId], list: List) -> &[FormulaId] {
    &lists[list.begin as usize..][..list.length as usize]
}

/// A formula that a pool of these tables holds.
fn as_candidate<'l>(formulas: &[Formula], types: &[Type], lists: &'l [FormulaId], id: FormulaId) -> Candidate<'l> {
    let formula = formulas[id.index()];
    let list = match formula {
        Formula::And(list) | Formula::Or(list) => in_list(lists, list),
        Formula::Constant(_)
        | Formula::Variable(_)
        | Formula::TimerDone(_)
        | Formula::TimerElapsed(_)
        | Formula::Not(_)
        | Formula::Xor(..)
        | Formula::Compare(..)
        | Formula::Arithmetic(..)
        | Formula::Negate(_)
        | Formula::Widen(_) => &[],
    };
    Candidate { formula, ty: types[id.index()], list }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_takes_no_more_room_than_a_constant() {
        assert_eq!(size_of::<Formula>(), size_of::<Value>());
    }

    #[test]
    fn equal_formulas_are_one_however_many_there_are() {
        let mut pool = Pool::default();
        let mut all = Vec::new();
        for _ in 0..2 {
            for v in 0..1_000 {
                let [a, b] = [v, v + 1].map(|v| pool.variable(VarId::from_usize(v), Type::Bool));
                let not = pool.not(b);
                all.extend([pool.and([a, not]), pool.or([a, not]), pool.xor(a, b)]);
            }
        }
        let (first, second) = all.split_at(3_000);
        assert_eq!(first, second);
        // The variables, their negations but that of the first, and three for each pair.
        assert_eq!(pool.len(), 1_001 + 1_000 + 3_000);
        let zeros = [0.0, -0.0].map(|zero| pool.constant(Value::Real(zero), Type::Real));
        assert_ne!(zeros[0], zeros[1]);
    }
}
