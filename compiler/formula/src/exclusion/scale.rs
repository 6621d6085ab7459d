//! Where the operand of comparisons can lie.
//!
//! The constants that an operand is compared with cut its values into intervals, and an atom for each cut says on which
//! side the operand lies. Cuts are ordered, so that each atom implies the next:
//!
//! ```text
//! whole numbers and times, cut at k:        x < k                  x <= k is  x < k + 1
//! reals, cut twice at c:                    x < c  and  x <= c
//! ```
//!
//! A real that is no number satisfies no comparison but `<>`. It lies on neither side of a cut, so that one more atom
//! says whether the operand is a number, and without it neither `<` nor its opposite holds. Two operands are compared
//! like their difference with zero.

use crate::{Comparison, Formula, FormulaId, Pool, Type, Value};

/// What is compared.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Quantity {
    /// A value, with constants.
    Value(FormulaId),
    /// Two values with each other; the one with the smaller id is on the left.
    Difference(FormulaId, FormulaId),
}

/// A cut: everything below the number, and the number itself if `inclusive`.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
pub(super) struct Cut {
    number: Number,
    inclusive: bool,
}

#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
enum Number {
    Whole(i128),
    Real(f64),
}

/// A comparison as a condition on a quantity.
pub(super) struct Measured {
    pub(super) quantity: Quantity,
    /// Whether the quantity can be no number.
    pub(super) real: bool,
    comparison: Comparison,
    number: Number,
}

/// A side of a comparison as a conjunction: below `before`, not below `from`, each if it is given.
pub(super) struct Interval {
    pub(super) from: Option<Cut>,
    pub(super) before: Option<Cut>,
    /// The comparison holds outside of it, and where there is no number.
    pub(super) outside: bool,
}

impl Measured {
    /// None if nothing is known of the comparison.
    pub(super) fn new(pool: &Pool, comparison: Comparison, a: FormulaId, b: FormulaId) -> Option<Self> {
        let real = matches!(pool.ty(a), Type::Real | Type::Lreal);
        let (quantity, comparison, number) = match (pool.get(a), pool.get(b)) {
            (Formula::Constant(c), _) => (Quantity::Value(b), comparison.mirrored(), number(pool.ty(a), *c)?),
            (_, Formula::Constant(c)) => (Quantity::Value(a), comparison, number(pool.ty(a), *c)?),
            _ if a < b => (Quantity::Difference(a, b), comparison, zero(real)),
            _ if a > b => (Quantity::Difference(b, a), comparison.mirrored(), zero(real)),
            _ => return None,
        };
        Some(Measured { quantity, real, comparison, number })
    }

    /// Where the quantity lies if the comparison holds.
    pub(super) fn interval(&self) -> Interval {
        let below = self.below(false);
        let up_to = self.below(true);
        let within = |from, before| Interval { from, before, outside: false };
        match self.comparison {
            Comparison::Less => within(None, Some(below)),
            Comparison::LessEqual => within(None, Some(up_to)),
            Comparison::Equal => within(Some(below), Some(up_to)),
            Comparison::Greater => within(Some(up_to), None),
            Comparison::GreaterEqual => within(Some(below), None),
            Comparison::NotEqual => Interval { outside: true, ..within(Some(below), Some(up_to)) },
        }
    }

    /// Whole numbers up to k are those below k + 1.
    fn below(&self, inclusive: bool) -> Cut {
        match self.number {
            Number::Whole(k) => Cut { number: Number::Whole(k + i128::from(inclusive)), inclusive: false },
            Number::Real(_) => Cut { number: self.number, inclusive },
        }
    }
}

fn zero(real: bool) -> Number {
    if real { Number::Real(0.0) } else { Number::Whole(0) }
}

/// A constant as the type holds it: two that are the same single are the same.
fn number(ty: Type, constant: Value) -> Option<Number> {
    match constant {
        Value::Int(n) | Value::Time(n) => Some(Number::Whole(i128::from(n))),
        Value::Real(x) if x.is_nan() => None,
        Value::Real(x) if ty == Type::Real => Some(Number::Real(f64::from(x as f32) + 0.0)),
        Value::Real(x) => Some(Number::Real(x + 0.0)),
        Value::Bool(_) => None,
    }
}
