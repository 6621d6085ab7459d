//! What engines look for, and what they find.

use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::facts::Fact;
use crate::limit::Limit;
use std::fmt;

/// What is looked for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(crate) enum Goal {
    /// A micro-step in which this is seen.
    Fact(Fact),
    /// A state from which no path reaches another situation.
    Stuck,
    /// A state from which no path reaches an initial situation.
    Homeless,
    /// A state reached from one with the first of a pair without meeting the second, from which the second cannot be
    /// reached, or a reaction from there that does not end; by its place among the claims of this kind.
    Lost(usize),
}

/// The answers of one reaction.
pub(crate) type Answers = Vec<(Atom, bool)>;

/// Reactions one after the other, from the initial one on.
pub(crate) type Way = Vec<Answers>;

/// What was found of a goal.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Finding {
    /// No behaviour meets it.
    Never,
    /// This way does, if delays may end so.
    Met(Way),
    /// Some behaviour does, by exact states: that is proved, and no way is made.
    Happens,
    /// It is not decided.
    Open(Reason),
}

/// Why something is not decided.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Reason {
    /// A limit was hit.
    Limit(Limit),
    /// There is a way, but no times were found in which delays end so.
    Delays,
    /// Something cannot be followed.
    Beyond(Beyond),
    /// The reference simulator does not do what was found: a fault of ours.
    NotReplayed,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::Limit(limit) => limit.fmt(f),
            Reason::Delays => f.write_str("only if delays end in an order for which no times were found"),
            Reason::Beyond(beyond) => beyond.fmt(f),
            Reason::NotReplayed => f.write_str("the trace that was found does not replay, which is a fault of grafc"),
        }
    }
}

/// How much was looked at.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Searched {
    /// States; a number beyond 2^53 is not exact.
    pub states: f64,
    /// Why there may be more; none if these are all.
    pub limit: Option<Limit>,
}

/// Whether to go on, asked now and then with how many states are known and how many of them were looked at.
pub(crate) type Stop<'s> = &'s mut dyn FnMut(usize, usize) -> Option<Limit>;

/// A way of finding out what a chart can come to.
pub(crate) trait Engine {
    /// What of each goal is found.
    ///
    /// # Errors
    /// What of the chart it cannot follow.
    fn find(&mut self, goals: &[Goal], stop: Stop) -> Result<Vec<Finding>, Beyond>;

    /// How much it looked at.
    fn searched(&self) -> Searched;

    /// The way to a state in which the assumptions allow no inputs, if there is one; an empty one if it is the start.
    fn barred(&self) -> Option<&Way>;
}
