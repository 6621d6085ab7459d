//! All states, part by part: of each connected grafcet alone, with what it reads, it is kept which states and heads there may
//! be, whatever the others do. So it grows with the sum of the parts, where exact states grow with their product; and what
//! none of these states does, nothing does.

use super::counters::Counters;
use super::relation::Relation;
use super::sets::{Halt, Sets};
use super::updates::Updates;
use biodivine_lib_bdd::{Bdd, BddVariable};
use std::collections::HashSet;

/// All states, and heads.
pub(super) struct Parts {
    parts: Vec<Part>,
}

/// Some variables.
struct Part {
    variables: HashSet<BddVariable>,
    heads: Bdd,
    states: Bdd,
    step: Moving,
    last: Moving,
    begin: Moving,
}

/// What happens to the variables of a part.
struct Moving {
    updates: Updates,
    /// Where it may happen, as far as what is needed tells.
    allowed: Bdd,
    /// What has to be known: what is read, and what stays.
    needed: HashSet<BddVariable>,
    /// What of that belongs to others.
    others: Vec<BddVariable>,
    /// The parts that know of it.
    known_by: Vec<usize>,
}

impl Parts {
    /// Of a program's relation, all that can be reached.
    pub(super) fn new(relation: &Relation, counters: &Counters, sets: &mut Sets) -> Result<Parts, Halt> {
        let groups: Vec<HashSet<BddVariable>> =
            relation.bits.parts.iter().map(|part| part.iter().copied().collect()).collect();
        let (yes, no) = (relation.bits.all.mk_true(), relation.bits.all.mk_false());
        let rests = relation.again.not();
        let mut parts = Vec::with_capacity(groups.len());
        for variables in &groups {
            let moving = |updates: &Updates, allowed: &Bdd, sets: &mut Sets| -> Result<Moving, Halt> {
                let of_part = updates.functions().filter(|(bit, _)| variables.contains(&bit.now)).cloned();
                let updates = Updates::new(&relation.bits.all, of_part.collect(), sets)?;
                let mut needed = HashSet::new();
                updates.functions().for_each(|(_, function)| needed.extend(function.support_set()));
                let is_changed = |v: &BddVariable| updates.functions().any(|(bit, _)| bit.now == *v);
                needed.extend(variables.iter().filter(|v| !is_changed(v)));
                let others = needed.iter().copied().filter(|v| !variables.contains(v)).collect();
                let knows = |place: &usize| !groups[*place].is_disjoint(&needed);
                let known_by = (0..groups.len()).filter(knows).collect();
                Ok(Moving { updates, allowed: onto(allowed, &needed, sets)?, needed, others, known_by })
            };
            parts.push(Part {
                variables: variables.clone(),
                heads: onto(&relation.start, variables, sets)?,
                states: no.clone(),
                step: moving(&relation.step, &yes, sets)?,
                last: moving(&relation.last, &rests, sets)?,
                begin: moving(&relation.begin, &relation.allowed, sets)?,
            });
        }
        let mut found = Parts { parts };
        found.explore(relation, counters, sets)?;
        Ok(found)
    }

    fn explore(&mut self, relation: &Relation, counters: &Counters, sets: &mut Sets) -> Result<(), Halt> {
        let asked: HashSet<BddVariable> = relation.asked.iter().copied().collect();
        let ends: HashSet<BddVariable> = relation.ends.iter().copied().collect();
        let within: HashSet<BddVariable> = relation.within.iter().copied().collect();
        let all = vec![true; self.parts.len()];
        let (mut new_heads, mut new_states) = (all.clone(), all.iter().map(|_| false).collect::<Vec<bool>>());
        while new_heads.contains(&true) || new_states.contains(&true) {
            let is_new = |moving: &Moving, new: &[bool]| moving.known_by.iter().any(|place| new[*place]);
            let (mut heads, mut states) = (vec![false; all.len()], vec![false; all.len()]);
            for place in 0..self.parts.len() {
                let part = &self.parts[place];
                let mut more = relation.bits.all.mk_false();
                if is_new(&part.step, &new_heads) {
                    more = self.moved(&part.step, |part| &part.heads, sets)?;
                }
                if is_new(&part.begin, &new_states) {
                    let begins = self.moved(&part.begin, |part| &part.states, sets)?;
                    let begins = sets.exists(&begins, &common(&part.variables, &ends))?;
                    more = sets.or(&more, &begins)?;
                }
                let more = counters.widened(more, sets)?;
                let mut rests = relation.bits.all.mk_false();
                if is_new(&part.last, &new_heads) {
                    rests = self.moved(&part.last, |part| &part.heads, sets)?;
                    rests = sets.exists(&rests, &common(&part.variables, &asked))?;
                    rests = sets.exists(&rests, &common(&part.variables, &within))?;
                    rests = counters.widened(rests, sets)?;
                }
                let part = &mut self.parts[place];
                for (set, more, is_new) in
                    [(&mut part.heads, more, &mut heads[place]), (&mut part.states, rests, &mut states[place])]
                {
                    let both = sets.or(set, &more)?;
                    *is_new = both != *set;
                    *set = both;
                }
            }
            (new_heads, new_states) = (heads, states);
        }
        Ok(())
    }

    /// What a part may become.
    fn moved(&self, moving: &Moving, of: impl Fn(&Part) -> &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut from = moving.allowed.clone();
        for place in &moving.known_by {
            let known = onto(of(&self.parts[*place]), &moving.needed, sets)?;
            from = sets.and(&from, &known)?;
        }
        moving.updates.image(&from, &moving.others, sets)
    }

    /// Whether something is seen before no micro-step.
    pub(super) fn never(&self, seen: &Bdd, sets: &mut Sets) -> Result<bool, Halt> {
        let support = seen.support_set();
        let mut here = seen.clone();
        for part in self.parts.iter().filter(|part| !part.variables.is_disjoint(&support)) {
            let known = onto(&part.heads, &support, sets)?;
            here = sets.and(&here, &known)?;
            if here.is_false() {
                return Ok(true);
            }
        }
        // What parts know together.
        for part in self.parts.iter().filter(|part| !part.variables.is_disjoint(&support)) {
            here = sets.and(&here, &part.heads)?;
        }
        Ok(here.is_false())
    }

    /// All states, as far as the parts know.
    pub(super) fn states(&self, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut all: Option<Bdd> = None;
        for part in &self.parts {
            all = Some(match all {
                Some(all) => sets.and(&all, &part.states)?,
                None => part.states.clone(),
            });
        }
        all.ok_or(Halt::Limit(crate::limit::Limit::Nodes))
    }
}

/// A set as far as some variables tell.
fn onto(set: &Bdd, variables: &HashSet<BddVariable>, sets: &mut Sets) -> Result<Bdd, Halt> {
    let mut others: Vec<BddVariable> = set.support_set().into_iter().filter(|v| !variables.contains(v)).collect();
    if others.is_empty() {
        return Ok(set.clone());
    }
    others.sort_unstable();
    sets.exists(set, &others)
}

fn common(a: &HashSet<BddVariable>, b: &HashSet<BddVariable>) -> Vec<BddVariable> {
    let mut both: Vec<BddVariable> = a.intersection(b).copied().collect();
    both.sort_unstable();
    both
}
