//! Hash-consed formulas.
//!
//! A [`Pool`] holds each formula once, children before parents: equal formulas have equal ids, and a loop over ids
//! meets every operand before what uses it. The constructors apply only laws that keep a formula recognisable
//! (constants, double negation, repeated operands).

mod rewrite;

use crate::number;
pub use grafc_model::chart::{Arithmetic, Comparison, Type, Value};
use index_vec::define_index_type;
use indexmap::{Equivalent, IndexSet};
use rustc_hash::{FxBuildHasher, FxHashSet};
use std::hash::{Hash, Hasher};
use std::{array, slice};

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
#[derive(Clone, PartialEq, Debug)]
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
    And(Box<[FormulaId]>),
    /// Disjunction of two or more, none of them a disjunction.
    Or(Box<[FormulaId]>),
    /// Exclusive disjunction; also Boolean inequality.
    Xor(FormulaId, FormulaId),
    /// Both sides have the same type.
    Compare(Comparison, FormulaId, FormulaId),
    /// Never nested in another `Arithmetic`, `Negate` or `Compare`, save through a variable of its type: the statement
    /// that stores it wraps it around. Divides only by a constant other than 0 and -1: see `Statement::Divide`.
    Arithmetic(Arithmetic, FormulaId, FormulaId),
    /// Arithmetic negation; nested at most as deep as `Arithmetic` is.
    Negate(FormulaId),
    /// A conversion without loss to the type.
    Widen(FormulaId),
}

/// Up to so many operands are compared one by one, which needs no table.
const SHORT: usize = 16;

/// All formulas of one program.
#[derive(Clone, Debug, Default)]
pub struct Pool {
    nodes: IndexSet<TypedFormula, FxBuildHasher>,
    depths: Vec<u32>,
    /// The operands of the junction that is being made: a list of its own is needed for a new one only.
    operands: Vec<FormulaId>,
}

/// A formula and its type. Constants are the same only if they are the same to the bit.
#[derive(Clone, Debug)]
struct TypedFormula {
    formula: Formula,
    ty: Type,
}

impl PartialEq for TypedFormula {
    fn eq(&self, other: &TypedFormula) -> bool {
        let same = match (&self.formula, &other.formula) {
            (Formula::Constant(Value::Real(a)), Formula::Constant(Value::Real(b))) => a.to_bits() == b.to_bits(),
            (a, b) => a == b,
        };
        same && self.ty == other.ty
    }
}

impl Eq for TypedFormula {}

impl Hash for TypedFormula {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.ty.hash(state);
        std::mem::discriminant(&self.formula).hash(state);
        match &self.formula {
            Formula::Constant(Value::Bool(b)) => b.hash(state),
            Formula::Constant(Value::Int(n) | Value::Time(n)) => n.hash(state),
            Formula::Constant(Value::Real(x)) => x.to_bits().hash(state),
            Formula::Variable(v) => v.hash(state),
            Formula::TimerDone(t) | Formula::TimerElapsed(t) => t.hash(state),
            Formula::Not(a) | Formula::Negate(a) | Formula::Widen(a) => a.hash(state),
            Formula::And(list) | Formula::Or(list) => list.hash(state),
            Formula::Xor(a, b) => (a, b).hash(state),
            Formula::Compare(op, a, b) => (op, a, b).hash(state),
            Formula::Arithmetic(op, a, b) => (op, a, b).hash(state),
        }
    }
}

/// The operands of a formula.
enum Operands<'p> {
    List(slice::Iter<'p, FormulaId>),
    Pair(array::IntoIter<FormulaId, 2>),
}

impl Iterator for Operands<'_> {
    type Item = FormulaId;

    fn next(&mut self) -> Option<FormulaId> {
        match self {
            Operands::List(list) => list.next().copied(),
            Operands::Pair(pair) => pair.next(),
        }
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        match self {
            Operands::List(list) => list.size_hint(),
            Operands::Pair(pair) => pair.size_hint(),
        }
    }
}

impl DoubleEndedIterator for Operands<'_> {
    fn next_back(&mut self) -> Option<FormulaId> {
        match self {
            Operands::List(list) => list.next_back().copied(),
            Operands::Pair(pair) => pair.next_back(),
        }
    }
}

/// A conjunction or disjunction to look for: the node of it, without a list of its own.
struct Junction<'l> {
    conjunction: bool,
    list: &'l [FormulaId],
}

impl Hash for Junction<'_> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        // As the node does it.
        let none = Box::default();
        let form = if self.conjunction { Formula::And(none) } else { Formula::Or(none) };
        Type::Bool.hash(state);
        std::mem::discriminant(&form).hash(state);
        self.list.hash(state);
    }
}

impl Equivalent<TypedFormula> for Junction<'_> {
    fn equivalent(&self, node: &TypedFormula) -> bool {
        match &node.formula {
            Formula::And(list) => self.conjunction && **list == *self.list,
            Formula::Or(list) => !self.conjunction && **list == *self.list,
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => false,
        }
    }
}

impl Pool {
    /// No formula, and room for so many.
    fn with_capacity(formulas: usize) -> Pool {
        let nodes = IndexSet::with_capacity_and_hasher(formulas, FxBuildHasher);
        Pool { nodes, depths: Vec::with_capacity(formulas), operands: Vec::new() }
    }

    /// The formula of an id.
    pub fn get(&self, id: FormulaId) -> &Formula {
        &self.nodes[id.index()].formula
    }

    /// The type of a formula.
    pub fn ty(&self, id: FormulaId) -> Type {
        self.nodes[id.index()].ty
    }

    /// How many formulas there are; ids count up to it.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there is no formula.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Whether a formula has no operands: a constant, a variable or a timer.
    pub fn is_leaf(&self, id: FormulaId) -> bool {
        self.depths[id.index()] == 0
    }

    /// The factors of a conjunction; of any other formula itself.
    pub fn factors<'a>(&'a self, id: &'a FormulaId) -> &'a [FormulaId] {
        if let Formula::And(list) = self.get(*id) { list } else { slice::from_ref(id) }
    }

    /// All ids, operands before operators.
    pub fn ids(&self) -> impl Iterator<Item = FormulaId> + use<> {
        (0..self.nodes.len()).map(FormulaId::from_usize)
    }

    /// The operands of a formula, from left to right.
    pub fn operands(&self, id: FormulaId) -> impl DoubleEndedIterator<Item = FormulaId> + '_ {
        match self.get(id) {
            Formula::Constant(_) | Formula::Variable(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) => {
                Operands::List([].iter())
            }
            Formula::Not(a) | Formula::Negate(a) | Formula::Widen(a) => Operands::List(slice::from_ref(a).iter()),
            Formula::Xor(a, b) | Formula::Compare(_, a, b) | Formula::Arithmetic(_, a, b) => {
                Operands::Pair([*a, *b].into_iter())
            }
            Formula::And(list) | Formula::Or(list) => Operands::List(list.iter()),
        }
    }

    fn add(&mut self, formula: Formula, ty: Type) -> FormulaId {
        let (index, new) = self.nodes.insert_full(TypedFormula { formula, ty });
        let id = FormulaId::from_usize(index);
        if new {
            let below = self.operands(id).map(|o| self.depths[o.index()] + 1).max();
            self.depths.push(below.unwrap_or(0));
        }
        id
    }

    /// How many operators stand above one another in a formula: 0 for a variable or constant.
    pub fn depth(&self, id: FormulaId) -> u32 {
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

    /// The value of a variable.
    pub fn variable(&mut self, variable: VarId, ty: Type) -> FormulaId {
        self.add(Formula::Variable(variable), ty)
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
        self.nodes.get_index_of(&TypedFormula { formula: looked_for, ty: Type::Bool }).map(FormulaId::from_usize)
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
                (Formula::And(inner), true) | (Formula::Or(inner), false) => list.extend(inner.iter()),
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
            let mut seen = FxHashSet::default();
            list.retain(|id| seen.insert(*id));
            list.iter().any(|id| matches!(self.get(*id), Formula::Not(inner) if seen.contains(inner)))
        };
        if contradicts {
            return self.truth(!neutral);
        }
        match list.as_slice() {
            [] => self.truth(neutral),
            [only] => *only,
            list => match self.nodes.get_index_of(&Junction { conjunction: neutral, list }) {
                Some(known) => FormulaId::from_usize(known),
                None if neutral => self.add(Formula::And(list.into()), Type::Bool),
                None => self.add(Formula::Or(list.into()), Type::Bool),
            },
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
            (None, None) => self.add(Formula::Xor(a, b), Type::Bool),
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
                (None, _) | (_, None) => self.add(Formula::Compare(op, a, b), Type::Bool),
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
            (None, _) | (_, None) => self.add(Formula::Arithmetic(op, a, b), ty),
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
        match (self.get(a).clone(), ty) {
            (Formula::Constant(Value::Int(n)), Type::Real | Type::Lreal) => self.constant(Value::Real(n as f64), ty),
            (Formula::Constant(value), _) => self.constant(value, ty),
            _ => self.add(Formula::Widen(a), ty),
        }
    }
}
