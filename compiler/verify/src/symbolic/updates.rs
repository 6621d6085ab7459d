//! What happens to all variables at once, as a relation in parts: what each variable becomes stands in its second place, and
//! is moved to the first in the end. A variable is left out as soon as no part to come reads it.

use super::bits::Bit;
use super::sets::{Halt, Sets};
use biodivine_lib_bdd::{Bdd, BddVariable, BddVariableSet};
use std::collections::{BTreeSet, HashSet};

/// Parts are put together up to so many nodes.
const NODES_OF_PART: usize = 1_500;

/// New values of variables, each a function of the old ones; those that stay are not named.
pub(crate) struct Updates {
    parts: Vec<Part>,
    changed: Vec<Bit>,
    functions: Vec<(Bit, Bdd)>,
}

/// The new values of some variables.
struct Part {
    relation: Bdd,
    /// Where they stand.
    new: Vec<BddVariable>,
    /// What it is made of.
    reads: HashSet<BddVariable>,
}

impl Updates {
    /// New values, each a function of the old ones; those that stay need not be named.
    pub(crate) fn new(all: &BddVariableSet, new: Vec<(Bit, Bdd)>, sets: &mut Sets) -> Result<Updates, Halt> {
        let new = new.into_iter().filter(|(bit, function)| *function != all.mk_var(bit.now));
        let mut new: Vec<(Bit, Bdd)> = new.collect();
        new.sort_by_key(|(bit, _)| bit.now);
        let mut parts: Vec<Part> = Vec::new();
        for (bit, function) in &new {
            let reads = function.support_set();
            let relation = sets.iff(&all.mk_var(bit.old), function)?;
            if let Some(last) = parts.last_mut()
                && let Some(both) = sets.small_and(&last.relation, &relation, NODES_OF_PART)?
            {
                last.relation = both;
                last.new.push(bit.old);
                last.reads.extend(reads);
                continue;
            }
            parts.push(Part { relation, new: vec![bit.old], reads });
        }
        Ok(Updates { parts, changed: new.iter().map(|(bit, _)| *bit).collect(), functions: new })
    }

    /// What changes, each with the function of what was before.
    pub(crate) fn functions(&self) -> impl Iterator<Item = &(Bit, Bdd)> {
        self.functions.iter()
    }

    /// The states after it, whatever some variables were that stay.
    pub(crate) fn image(&self, states: &Bdd, left_out: &[BddVariable], sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut open: BTreeSet<BddVariable> = self.changed.iter().map(|bit| bit.now).collect();
        open.extend(left_out);
        let mut over = |rest: &[Part]| -> Vec<BddVariable> {
            let done: Vec<BddVariable> =
                open.iter().filter(|v| !rest.iter().any(|part| part.reads.contains(v))).copied().collect();
            done.iter().for_each(|v| _ = open.remove(v));
            done
        };
        let unread = over(&self.parts);
        let mut states = if unread.is_empty() { states.clone() } else { sets.exists(states, &unread)? };
        for (place, part) in self.parts.iter().enumerate() {
            states = sets.and_exists(&states, &part.relation, &over(&self.parts[place + 1..]))?;
        }
        sets.renamed(states, self.changed.iter().map(|bit| (bit.old, bit.now)))
    }

    /// Of some states those from which these are reached.
    pub(crate) fn before(&self, states: &Bdd, among: &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let states = sets.renamed(states.clone(), self.changed.iter().map(|bit| (bit.now, bit.old)))?;
        let mut states = sets.and(&states, among)?;
        for part in self.parts.iter().rev() {
            states = sets.and_exists(&states, &part.relation, &part.new)?;
        }
        Ok(states)
    }
}
