//! Operations on decision diagrams that end when there is no more room or time.

use crate::beyond::Beyond;
use crate::goal::Stop;
use crate::limit::Limit;
use biodivine_lib_bdd::{Bdd, BddVariable, op_function};
use rustc_hash::FxHashMap;

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
    /// The nodes of all that was made.
    pub(crate) work: usize,
}

impl<'s> Sets<'s> {
    /// Diagrams of at most so many nodes.
    pub(crate) fn new(stop: Stop<'s>, most: usize) -> Self {
        Sets { stop, depth: 0, most, work: 0 }
    }

    /// Whether to go on, for somebody else to ask.
    pub(crate) fn stop(&mut self) -> Stop<'_> {
        self.stop
    }

    fn kept(&mut self, made: Option<Bdd>) -> Result<Bdd, Halt> {
        let made = made.filter(|made| made.size() <= self.most).ok_or(Halt::Limit(Limit::Nodes))?;
        self.work = self.work.saturating_add(made.size());
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

    /// Both, if that takes no more than so many nodes.
    pub(crate) fn small_and(&mut self, a: &Bdd, b: &Bdd, most: usize) -> Result<Option<Bdd>, Halt> {
        Bdd::binary_op_with_limit(most, a, b, op_function::and).map(|made| self.kept(Some(made))).transpose()
    }

    /// Whether they have nothing in common.
    pub(crate) fn are_apart(&self, a: &Bdd, b: &Bdd) -> bool {
        Bdd::check_binary_op(usize::MAX, a, b, op_function::and).is_some_and(|(is_not_empty, _)| !is_not_empty)
    }

    /// With other variables in the places of some, which keeps their order.
    pub(crate) fn renamed(
        &mut self,
        a: Bdd,
        names: impl Iterator<Item = (BddVariable, BddVariable)>,
    ) -> Result<Bdd, Halt> {
        let names: FxHashMap<BddVariable, BddVariable> = names.collect();
        let mut nodes = a.to_nodes();
        // The first two are the constants.
        for node in nodes.iter_mut().skip(2) {
            node.var = names.get(&node.var).copied().unwrap_or(node.var);
        }
        self.kept(Bdd::from_nodes(&nodes).ok())
    }
}
