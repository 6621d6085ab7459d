//! Operations on decision diagrams that end when there is no more room or time.

use crate::beyond::Beyond;
use crate::budget::Budget;
use crate::goal::Stop;
use crate::limit::Limit;
use biodivine_lib_bdd::{Bdd, BddVariable, op_function};
use rustc_hash::{FxHashMap, FxHashSet};

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

/// So many pairs of nodes may be looked at for each node that a diagram may have: they are remembered, too.
const PAIRS_PER_NODE: u64 = 10;

/// Between two questions whether to go on, so many of them are looked at; a small operation looks at a few.
const AT_ONCE: u64 = 1 << 14;

/// What a pair of nodes comes to, if that is known: what an operation does.
type Operation = fn(Option<bool>, Option<bool>) -> Option<bool>;

/// Makes diagrams.
pub(crate) struct Sets<'s> {
    budget: Budget<'s>,
    most: usize,
    /// The nodes of all that was made.
    pub(crate) work: usize,
}

impl<'s> Sets<'s> {
    /// Diagrams of at most so many nodes.
    pub(crate) fn new(stop: Stop<'s>, most: usize) -> Self {
        Sets { budget: Budget::new(stop).asked_every(AT_ONCE), most, work: 0 }
    }

    /// Whether to go on, for somebody else to ask.
    pub(crate) fn stop(&mut self) -> Stop<'_> {
        self.budget.stop()
    }

    /// How many reactions deep the search is, to be told.
    pub(crate) fn at_depth(&mut self, depth: usize) {
        self.budget.depth.set(depth);
    }

    /// Does what looks at pairs of nodes, until there is no more room or time.
    fn watched<T>(&self, does: impl FnOnce(&Budget) -> T) -> Result<T, Halt> {
        // An operation asks twice for each pair.
        self.budget.allow((self.most as u64).saturating_mul(2 * PAIRS_PER_NODE), u64::MAX);
        let done = does(&self.budget);
        match self.budget.limit() {
            Some(limit) => Err(Halt::Limit(limit)),
            None if self.budget.is_over() => Err(Halt::Limit(Limit::Nodes)),
            None => Ok(done),
        }
    }

    fn kept(&mut self, made: Option<Bdd>) -> Result<Bdd, Halt> {
        let made = made.filter(|made| made.size() <= self.most).ok_or(Halt::Limit(Limit::Nodes))?;
        self.work = self.work.saturating_add(made.size());
        self.budget.met.set(made.size());
        self.budget.spend(made.size() as u64);
        self.budget.limit().map_or(Ok(made), |limit| Err(Halt::Limit(limit)))
    }

    fn made(&mut self, a: &Bdd, b: &Bdd, operation: Operation) -> Result<Bdd, Halt> {
        let most = self.most;
        let made = self.watched(|budget| Bdd::binary_op_with_limit(most, a, b, within(budget, operation)))?;
        self.kept(made)
    }

    pub(crate) fn and(&mut self, a: &Bdd, b: &Bdd) -> Result<Bdd, Halt> {
        self.made(a, b, op_function::and)
    }

    pub(crate) fn or(&mut self, a: &Bdd, b: &Bdd) -> Result<Bdd, Halt> {
        self.made(a, b, op_function::or)
    }

    /// What is in the first and not in the second.
    pub(crate) fn minus(&mut self, a: &Bdd, b: &Bdd) -> Result<Bdd, Halt> {
        self.made(a, b, op_function::and_not)
    }

    /// What is in one alone.
    pub(crate) fn xor(&mut self, a: &Bdd, b: &Bdd) -> Result<Bdd, Halt> {
        self.made(a, b, op_function::xor)
    }

    /// What is in both or in none.
    pub(crate) fn iff(&mut self, a: &Bdd, b: &Bdd) -> Result<Bdd, Halt> {
        self.made(a, b, op_function::iff)
    }

    /// The one where something holds, the other where it does not.
    pub(crate) fn choice(&mut self, when: &Bdd, yes: &Bdd, no: &Bdd) -> Result<Bdd, Halt> {
        if when.is_true() {
            return Ok(yes.clone());
        }
        let yes = self.and(when, yes)?;
        let no = self.minus(no, when)?;
        self.or(&yes, &no)
    }

    /// Both, whatever these variables are.
    pub(crate) fn and_exists(&mut self, a: &Bdd, b: &Bdd, variables: &[BddVariable]) -> Result<Bdd, Halt> {
        if a.is_false() || b.is_false() {
            return self.and(a, b);
        }
        let variables: FxHashSet<BddVariable> = variables.iter().copied().collect();
        let is_left_out = |v| variables.contains(&v);
        let made = self.watched(|budget| {
            Bdd::binary_op_nested(a, b, is_left_out, within(budget, op_function::and), within(budget, op_function::or))
        })?;
        self.kept(Some(made))
    }

    /// Whatever these variables are.
    pub(crate) fn exists(&mut self, a: &Bdd, variables: &[BddVariable]) -> Result<Bdd, Halt> {
        self.and_exists(a, a, variables)
    }

    /// Both, if that takes no more than so many nodes.
    pub(crate) fn small_and(&mut self, a: &Bdd, b: &Bdd, most: usize) -> Result<Option<Bdd>, Halt> {
        let made = self.watched(|budget| Bdd::binary_op_with_limit(most, a, b, within(budget, op_function::and)))?;
        made.map(|made| self.kept(Some(made))).transpose()
    }

    /// Whether they have nothing in common.
    pub(crate) fn are_apart(&mut self, a: &Bdd, b: &Bdd) -> Result<bool, Halt> {
        let made = self.watched(|budget| Bdd::check_binary_op(usize::MAX, a, b, within(budget, op_function::and)))?;
        Ok(made.is_some_and(|(is_not_empty, _)| !is_not_empty))
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

/// The operation, which comes to its end at once when no more may be done: what it makes then is worth nothing. There is no
/// other way to end one.
fn within(budget: &Budget, operation: Operation) -> impl Fn(Option<bool>, Option<bool>) -> Option<bool> {
    move |a, b| {
        budget.spend(1);
        if budget.is_over() { Some(false) } else { operation(a, b) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use biodivine_lib_bdd::BddVariableSet;
    use std::cell::Cell;

    /// So many pairs of variables, all the first ones before all the others, that are the same in each pair: each more takes
    /// twice as many nodes.
    fn same(pairs: u16, sets: &mut Sets) -> Bdd {
        let all = BddVariableSet::new_anonymous(2 * pairs);
        let of = |place: u16| all.mk_var(BddVariable::from_index(usize::from(place)));
        let mut same = all.mk_true();
        for place in 0..pairs {
            let pair = sets.iff(&of(place), &of(pairs + place)).expect("a small diagram");
            same = sets.and(&same, &pair).expect("a diagram");
        }
        same
    }

    /// Once what comes out is there, whether to go on is asked in any case.
    #[test]
    fn an_operation_asks_whether_to_go_on_while_it_runs() {
        let mut go_on = |_, _| None;
        let large = same(14, &mut Sets::new(&mut go_on, usize::MAX));
        assert!(large.size() as u64 > AT_ONCE, "{}", large.size());
        let other = large.not();
        let rest = [BddVariable::from_index(3)];
        let asked = Cell::new(0);
        let mut count = |_, _| {
            asked.set(asked.get() + 1);
            None
        };
        let mut sets = Sets::new(&mut count, usize::MAX);
        let operations: [&dyn Fn(&mut Sets) -> bool; 5] = [
            &|sets| sets.and(&large, &large).is_ok(),
            &|sets| sets.and_exists(&large, &large, &rest).is_ok(),
            &|sets| sets.exists(&other, &rest).is_ok(),
            &|sets| sets.small_and(&large, &large, usize::MAX).is_ok(),
            &|sets| sets.are_apart(&large, &other).is_ok(),
        ];
        for (place, operation) in operations.iter().enumerate() {
            asked.set(0);
            assert!(operation(&mut sets), "{place}");
            assert!(asked.get() > 1, "{place}: {}", asked.get());
        }
        let mut stop = |_, _| Some(Limit::Time);
        let sets = Sets::new(&mut stop, usize::MAX);
        let ended = sets.watched(|budget| Bdd::binary_op(&large, &large, within(budget, op_function::and)));
        assert_eq!(ended, Err(Halt::Limit(Limit::Time)));
    }

    #[test]
    fn an_operation_ends_where_it_takes_too_much_room() {
        let mut go_on = |_, _| None;
        let large = same(14, &mut Sets::new(&mut go_on, usize::MAX));
        let mut sets = Sets::new(&mut go_on, large.size() / 2 / PAIRS_PER_NODE as usize);
        let rest = [BddVariable::from_index(3)];
        assert_eq!(sets.and_exists(&large, &large, &rest), Err(Halt::Limit(Limit::Nodes)));
        assert_eq!(sets.exists(&large, &rest), Err(Halt::Limit(Limit::Nodes)));
        // Of this nothing is left but the pairs that were looked at; and it is no end of all that is done.
        let (other, none) = (large.not(), large.and_not(&large));
        assert_eq!(sets.are_apart(&large, &other), Err(Halt::Limit(Limit::Nodes)));
        assert_eq!(sets.are_apart(&none, &none), Ok(true));
    }
}
