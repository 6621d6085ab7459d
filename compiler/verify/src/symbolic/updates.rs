//! What happens to all variables at once, as updates of one after the other: so a set of states is moved on, or back, without
//! a second copy of all variables. What is still to be read is put aside before it is written.

use super::bits::Bit;
use super::sets::{Halt, Sets};
use biodivine_lib_bdd::{Bdd, BddVariable, BddVariableSet};
use std::collections::HashSet;

/// Updates, in the order in which they are done.
pub(crate) struct Updates {
    all: BddVariableSet,
    list: Vec<(BddVariable, Bdd)>,
    /// What was put aside, which nothing reads in the end.
    aside: Vec<BddVariable>,
}

impl Updates {
    /// New values, each a function of the old ones; those that stay need not be named.
    pub(crate) fn new(all: &BddVariableSet, new: Vec<(Bit, Bdd)>, sets: &mut Sets) -> Result<Updates, Halt> {
        let new = new.into_iter().filter(|(bit, function)| *function != all.mk_var(bit.now));
        // Each with what it reads.
        let mut pending: Vec<(Bit, Bdd, HashSet<BddVariable>)> =
            new.map(|(bit, function)| (bit, function.clone(), function.support_set())).collect();
        let (mut list, mut aside) = (Vec::with_capacity(pending.len()), Vec::new());
        while !pending.is_empty() {
            let readers = |place: usize| {
                let now = pending[place].0.now;
                pending
                    .iter()
                    .enumerate()
                    .filter(|(other, (_, _, reads))| *other != place && reads.contains(&now))
                    .count()
            };
            // What nobody else waits to read; else what the fewest do.
            let counts = (0..pending.len()).map(|place| (readers(place), place));
            let (count, next) = counts.min().unwrap_or_default();
            let (bit, function, _) = pending.remove(next);
            if count > 0 {
                let old = all.mk_var(bit.old);
                list.push((bit.old, all.mk_var(bit.now)));
                aside.push(bit.old);
                for (_, other, reads) in pending.iter_mut().filter(|(_, _, reads)| reads.contains(&bit.now)) {
                    *other = sets.substitute(other, bit.now, &old)?;
                    *reads = other.support_set();
                }
            }
            list.push((bit.now, function));
        }
        Ok(Updates { all: all.clone(), list, aside })
    }

    /// The states after it.
    pub(crate) fn image(&self, states: &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut states = states.clone();
        for (variable, function) in &self.list {
            let new = self.all.mk_var(*variable);
            states = if reads(function, *variable) {
                let yes = sets.and_exists(&states, function, &[*variable])?;
                let no = sets.and_exists(&states, &function.not(), &[*variable])?;
                let (yes, no) = (sets.and(&yes, &new)?, sets.minus(&no, &new)?);
                sets.or(&yes, &no)?
            } else {
                let rest = sets.exists(&states, &[*variable])?;
                sets.and(&rest, &new.iff(function))?
            };
        }
        sets.exists(&states, &self.aside)
    }

    /// The states before it, of all that there are: those from which these are reached.
    pub(crate) fn before(&self, states: &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut states = states.clone();
        for (variable, function) in self.list.iter().rev() {
            states = sets.substitute(&states, *variable, function)?;
        }
        Ok(states)
    }
}

fn reads(function: &Bdd, variable: BddVariable) -> bool {
    function.support_set().contains(&variable)
}
