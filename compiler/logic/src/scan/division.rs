//! Divisions by what may be 0, and the guards that they need.
//!
//! A quotient by 0 is 0 and raises the flag DIV0. The least whole number has no negative in its type, and a processor may
//! stop at the attempt to divide it by -1: by -1 the quotient is the negative, which wraps around. Constants other than 0
//! divide inside a formula.

use super::{Origin, Program, VarId};
use grafc_formula::{FormulaId, Type, Value};

/// `target := dividend / divisor`, or 0 and the flag DIV0 if the divisor is 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Division {
    /// What is written.
    pub target: VarId,
    /// `true` for the remainder.
    pub modulo: bool,
    /// A formula without operators.
    pub dividend: FormulaId,
    /// A formula without operators; of constants only 0, since others divide inside a formula.
    pub divisor: FormulaId,
    /// The flag to raise.
    pub flag: VarId,
    /// Where it comes from.
    pub origin: Origin,
}

/// What is asked of the divisor before a processor may divide.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Guard {
    /// Nothing: it is the constant 0, so the result is 0 and the flag is raised in any case.
    Never,
    /// Whether it is 0.
    Zero,
    /// Whether it is 0, and whether it is -1.
    ZeroAndMinusOne {
        /// What comes out by -1.
        quotient: ByMinusOne,
        /// The dividend is a constant, and not the least one: a processor divides it by -1 as well, so there is no need to
        /// ask for that.
        fits: bool,
    },
}

/// What comes out where the divisor is -1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ByMinusOne {
    /// Of a remainder, 0.
    Zero,
    /// The dividend, a constant: the least number of its type, whose negative wraps around to itself.
    Dividend,
    /// The negative of the dividend, which wraps around.
    Negative,
}

impl Guard {
    /// What comes out where the divisor is -1, if that has to be asked.
    pub fn by_minus_one(self) -> Option<ByMinusOne> {
        match self {
            Guard::Never | Guard::Zero | Guard::ZeroAndMinusOne { fits: true, .. } => None,
            Guard::ZeroAndMinusOne { quotient, fits: false } => Some(quotient),
        }
    }
}

impl Program {
    /// What a division asks of its divisor.
    pub fn guard(&self, division: &Division) -> Guard {
        let Division { target, modulo, dividend, divisor, .. } = *division;
        if self.pool.as_constant(divisor).is_some() {
            return Guard::Never;
        }
        // Types of 16 bits are divided at 32 and wrap around where they are stored; those without sign have no -1.
        if self.variables[target].ty != Type::Dint || self.pool.ty(divisor) != Type::Dint {
            return Guard::Zero;
        }
        let constant = self.pool.as_constant(dividend);
        let least = constant == Some(Value::Int(i64::from(i32::MIN)));
        let quotient = match modulo {
            true => ByMinusOne::Zero,
            false if least => ByMinusOne::Dividend,
            false => ByMinusOne::Negative,
        };
        Guard::ZeroAndMinusOne { quotient, fits: constant.is_some() && !least }
    }
}
