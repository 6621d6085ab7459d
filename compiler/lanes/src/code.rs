//! The operations, and where values lie.

use grafc_formula::{Arithmetic, Comparison, TimerId, Type};
use index_vec::define_index_type;
use std::ops::Range;

/// So many scenarios are run at once.
pub const LANES: usize = crate::Word::BITS as usize;

define_index_type! {
    /// Where a Boolean of all lanes lies.
    pub(crate) struct BoolAt = u32;
}

define_index_type! {
    /// Where whole numbers or times lie, one a lane.
    pub(crate) struct WholeAt = u32;
}

define_index_type! {
    /// Where reals lie, one a lane.
    pub(crate) struct RealAt = u32;
}

/// Where the values of a formula or variable lie.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum At {
    Bool(BoolAt),
    Whole(WholeAt),
    Real(RealAt),
}

impl At {
    /// Where the Boolean lies that this must be: the program has been verified.
    pub(crate) fn bool(self) -> BoolAt {
        match self {
            At::Bool(at) => at,
            At::Whole(_) | At::Real(_) => unreachable!("it is Boolean, and lies at {self:?}"),
        }
    }
}

/// An operation. Those of formulas are done in all lanes; those of statements keep their result in the lanes that the
/// statement is reached in.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Operation {
    Not(BoolAt, BoolAt),
    And(BoolAt, BoolAt, BoolAt),
    Or(BoolAt, BoolAt, BoolAt),
    Xor(BoolAt, BoolAt, BoolAt),
    CompareWholes(BoolAt, Comparison, WholeAt, WholeAt),
    CompareReals(BoolAt, Comparison, RealAt, RealAt),
    TimerDone(BoolAt, TimerId),
    TimerElapsed(WholeAt, TimerId),
    Wholes(WholeAt, Arithmetic, Type, WholeAt, WholeAt),
    Reals(RealAt, Arithmetic, Type, RealAt, RealAt),
    NegateWholes(WholeAt, Type, WholeAt),
    NegateReals(RealAt, Type, RealAt),
    Widen(RealAt, WholeAt),
    KeepBool(BoolAt, BoolAt),
    KeepWhole(WholeAt, WholeAt),
    KeepReal(RealAt, RealAt),
    /// Target, whether it is the remainder, type, dividend, divisor, and the flag to raise by 0.
    DivideWholes(WholeAt, bool, Type, (WholeAt, WholeAt), BoolAt),
    DivideReals(RealAt, bool, Type, (RealAt, RealAt), BoolAt),
    CallTimer(TimerId, BoolAt),
}

/// What is done one after the other.
pub(crate) type Body = Vec<Part>;

/// A part of a section.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Part {
    /// Operations without a choice.
    Operations(Range<usize>),
    /// The body of the number that a lane has, if there is one.
    Case { of: WholeAt, bodies: Vec<(i64, Body)> },
    /// The first branch whose condition is true, or the last body.
    If { branches: Vec<Branch>, otherwise: Body },
}

/// A branch of a choice.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Branch {
    /// What has to be done to know the condition.
    pub operations: Range<usize>,
    pub when: BoolAt,
    pub body: Body,
}
