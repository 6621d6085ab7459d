//! Operations on decision diagrams that end when there is no more room or time.

use crate::beyond::Beyond;
use crate::goal::Stop;
use crate::limit::Limit;
use biodivine_lib_bdd::{Bdd, BddVariable, op_function};

/// Why a diagram was not made.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Halt {
    /// A limit was hit.
    Limit(Limit),
    /// Something cannot be followed.
    Beyond(Beyond),
}

impl From<Beyond> for Halt {
    fn from(beyond: Beyond) -> Self {
        Halt::Beyond(beyond)
    }
}

/// Makes diagrams.
pub(crate) struct Sets<'s> {
    stop: Stop<'s>,
    /// How many reactions deep the search is, to be told.
    pub(crate) depth: usize,
    most: usize,
}

impl<'s> Sets<'s> {
    /// Diagrams of at most so many nodes.
    pub(crate) fn new(stop: Stop<'s>, most: usize) -> Self {
        Sets { stop, depth: 0, most }
    }

    fn kept(&mut self, made: Option<Bdd>) -> Result<Bdd, Halt> {
        let made = made.filter(|made| made.size() <= self.most).ok_or(Halt::Limit(Limit::Nodes))?;
        match (self.stop)(made.size(), self.depth) {
            Some(limit) => Err(Halt::Limit(limit)),
            None => Ok(made),
        }
    }

    pub(crate) fn and(&mut self, a: &Bdd, b: &Bdd) -> Result<Bdd, Halt> {
        let made = Bdd::binary_op_with_limit(self.most, a, b, op_function::and);
        self.kept(made)
    }

    pub(crate) fn or(&mut self, a: &Bdd, b: &Bdd) -> Result<Bdd, Halt> {
        let made = Bdd::binary_op_with_limit(self.most, a, b, op_function::or);
        self.kept(made)
    }

    /// What is in the first and not in the second.
    pub(crate) fn minus(&mut self, a: &Bdd, b: &Bdd) -> Result<Bdd, Halt> {
        let made = Bdd::binary_op_with_limit(self.most, a, b, op_function::and_not);
        self.kept(made)
    }

    /// Both, whatever these variables are.
    pub(crate) fn and_exists(&mut self, a: &Bdd, b: &Bdd, variables: &[BddVariable]) -> Result<Bdd, Halt> {
        if a.is_false() || b.is_false() {
            return self.and(a, b);
        }
        self.kept(Some(Bdd::binary_op_with_exists(a, b, op_function::and, variables)))
    }

    /// One after the other, so that no step is larger than need be.
    pub(crate) fn exists(&mut self, a: &Bdd, variables: &[BddVariable]) -> Result<Bdd, Halt> {
        self.kept(Some(a.exists(variables)))
    }

    /// The diagram with a function in the place of a variable. The function may read the variable, which what the crate has
    /// for it does not stand (version 0.5.27).
    pub(crate) fn substitute(&mut self, a: &Bdd, variable: BddVariable, function: &Bdd) -> Result<Bdd, Halt> {
        if !a.support_set_contains(&variable) {
            return Ok(a.clone());
        }
        let (yes, no) = (a.var_restrict(variable, true), a.var_restrict(variable, false));
        self.kept(Some(Bdd::if_then_else(function, &yes, &no)))
    }
}
