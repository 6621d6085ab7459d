//! All states, ring by ring, with what is seen on the way.

use super::counters::Counters;
use super::relation::Relation;
use super::sets::{Halt, Sets};
use crate::facts::Fact;
use crate::goal::{Finding, Goal, Reason};
use crate::limit::Limit;
use crate::machine::Machine;
use biodivine_lib_bdd::Bdd;
use grafc_logic::scan::Program;
use rustc_hash::FxHashMap;

/// What was found on the way.
pub(super) struct Found {
    pub(super) relation: Relation,
    /// All states.
    pub(super) reached: Bdd,
    pub(super) layers: Layers,
    /// The states after the initial reaction.
    pub(super) first: Bdd,
    /// Whether a reaction may not end.
    pub(super) is_endless: bool,
    /// At most so many micro-steps are a reaction.
    pub(super) most: u32,
    /// Whether there may be fewer states.
    pub(super) is_wide: bool,
    /// Numbers that are looked at only as far as they count; none if all states are exact.
    pub(super) counters: Option<Counters>,
}

/// States and heads, by how far they are from where a search began.
pub(super) struct Layers {
    /// States by the number of reactions.
    pub(super) rings: Vec<Bdd>,
    /// The reactions that lead to the ring of this number.
    pub(super) reactions: Vec<Reactions>,
    /// The states in which it began, each in the ring that it has among all states; none if it began before the start.
    pub(super) seeds: Option<Bdd>,
}

/// Reactions from some states.
#[derive(Default)]
pub(super) struct Reactions {
    /// What stands before each micro-step, of those that come so far.
    pub(super) heads: Vec<Bdd>,
    /// Whether those at the last micro-step that need another go on without end.
    pub(super) is_endless: bool,
}

/// What is looked for on the way.
pub(super) struct Looking<'l, 'p> {
    pub(super) machine: &'l mut Machine<'p>,
    /// What was not seen yet.
    pub(super) facts: Vec<Fact>,
    pub(super) findings: &'l mut FxHashMap<Goal, Finding>,
}

impl Looking<'_, '_> {
    /// All states were looked at: what was not seen never happens.
    pub(super) fn none_is_left(&mut self) {
        self.findings.extend(self.facts.drain(..).map(|fact| (Goal::Fact(fact), Finding::Never)));
    }
}

impl Found {
    pub(super) fn new(relation: Relation, program: &Program) -> Found {
        let no = relation.bits.all.mk_false();
        let layers = Layers { rings: Vec::new(), reactions: Vec::new(), seeds: None };
        let most = program.repeat.and_then(|repeat| repeat.limit).map_or(u32::MAX, |limit| limit.bound);
        Found {
            relation,
            reached: no.clone(),
            first: no,
            layers,
            is_endless: false,
            most,
            counters: None,
            is_wide: false,
        }
    }

    /// All states once more, with those that differ only in how far a number is beyond what it is compared with.
    pub(super) fn widen(&mut self, counters: Counters) {
        let no = self.relation.bits.all.mk_false();
        self.layers = Layers { rings: Vec::new(), reactions: Vec::new(), seeds: None };
        (self.reached, self.is_endless, self.counters, self.is_wide) = (no, false, Some(counters), true);
    }

    fn widened(&self, states: Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        match &self.counters {
            Some(counters) => counters.widened(states, sets),
            None => Ok(states),
        }
    }

    /// All states, ring by ring; false if that would take more than so many nodes, in all.
    pub(super) fn explore(&mut self, work: usize, looking: &mut Looking, sets: &mut Sets) -> Result<bool, Halt> {
        let most = sets.work.saturating_add(work);
        let mut enter = match self.layers.rings.last() {
            // It goes on where it was.
            Some(ring) => self.begin(ring, sets)?,
            None => {
                self.look_at_start(looking, sets)?;
                self.relation.start.clone()
            }
        };
        loop {
            sets.at_depth(self.layers.rings.len());
            let (reactions, ended) = self.reactions(enter, sets)?;
            self.is_endless |= reactions.is_endless;
            self.layers.reactions.push(reactions);
            self.look(looking, sets)?;
            let ended = self.widened(ended, sets)?;
            let ring = sets.minus(&ended, &self.reached)?;
            self.reached = sets.or(&self.reached, &ring)?;
            let is_last = ring.is_false();
            if self.layers.rings.is_empty() && self.counters.is_none() {
                self.first.clone_from(&ring);
            }
            self.layers.rings.push(ring);
            if is_last {
                return Ok(true);
            }
            if sets.work >= most {
                return Ok(false);
            }
            enter = self.begin(&self.layers.rings[self.layers.rings.len() - 1], sets)?;
        }
    }

    /// What is seen before the first micro-step.
    fn look_at_start(&self, looking: &mut Looking, sets: &mut Sets) -> Result<(), Halt> {
        let mut rest = Vec::new();
        for fact in std::mem::take(&mut looking.facts) {
            let mut finding = None;
            for (_, inputs) in self.relation.at_start.iter().filter(|(other, _)| *other == fact) {
                if finding.is_none() && !sets.are_apart(&self.relation.start, inputs)? {
                    finding = Some(if self.needs_no_way(fact) {
                        Finding::Happens
                    } else {
                        let here = sets.and(&self.relation.start, inputs)?;
                        Finding::Met(self.way_at_start(&here, looking.machine)?)
                    });
                }
            }
            match finding {
                Some(finding) => _ = looking.findings.insert(Goal::Fact(fact), finding),
                None => rest.push(fact),
            }
        }
        looking.facts = rest;
        Ok(())
    }

    /// What is seen in the latest reactions.
    fn look(&self, looking: &mut Looking, sets: &mut Sets) -> Result<(), Halt> {
        let depth = self.layers.reactions.len() - 1;
        for (micro_step, heads) in self.layers.reactions[depth].heads.iter().enumerate() {
            let mut rest = Vec::new();
            for fact in std::mem::take(&mut looking.facts) {
                let seen = match self.relation.facts.get(&fact) {
                    Some(seen) if !sets.are_apart(heads, seen)? => seen,
                    _ => {
                        rest.push(fact);
                        continue;
                    }
                };
                // It may be that only states do it that there are not.
                if self.counters.is_some() {
                    looking.findings.insert(Goal::Fact(fact), Finding::Open(Reason::Limit(Limit::Numbers)));
                    continue;
                }
                let finding = if self.needs_no_way(fact) {
                    Finding::Happens
                } else {
                    let here = sets.and(heads, seen)?;
                    Finding::Met(self.way_to_head(depth, micro_step, &here, looking.machine, sets)?)
                };
                looking.findings.insert(Goal::Fact(fact), finding);
            }
            looking.facts = rest;
        }
        Ok(())
    }

    /// Of what is wanted it need not be shown how it comes about, if there are no delays that might not end so.
    fn needs_no_way(&self, fact: Fact) -> bool {
        self.relation.ends.is_empty() && matches!(fact, Fact::Active(_) | Fact::Cleared(_) | Fact::Wanted(_))
    }

    /// The heads of first micro-steps after states.
    pub(super) fn begin(&self, states: &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let with_inputs = sets.and(states, &self.relation.allowed)?;
        self.relation.begin.image(&with_inputs, &self.relation.ends, sets)
    }

    /// Reactions from their first micro-steps on, and the states that they end in.
    pub(super) fn reactions(&self, enter: Bdd, sets: &mut Sets) -> Result<(Reactions, Bdd), Halt> {
        let mut ended = self.relation.bits.all.mk_false();
        let mut reactions = Reactions::default();
        let mut heads = enter;
        while !heads.is_false() {
            // All that come back to what they were come back for ever (R9), and what takes more than the bound is given up.
            if reactions.heads.contains(&heads) || reactions.heads.len() >= self.most as usize {
                reactions.is_endless = true;
                break;
            }
            let last = sets.minus(&heads, &self.relation.again)?;
            let last = self.relation.last.image(&last, &self.relation.asked, sets)?;
            let last = sets.exists(&last, &self.relation.within)?;
            ended = sets.or(&ended, &last)?;
            let more = sets.and(&heads, &self.relation.again)?;
            reactions.heads.push(heads);
            heads = self.relation.step.image(&more, &[], sets)?;
            heads = self.widened(heads, sets)?;
        }
        Ok((reactions, ended))
    }

    pub(super) fn count(&self) -> f64 {
        let unused = self.relation.bits.all.num_vars() as usize - self.relation.kept.len();
        (self.reached.exact_cardinality() >> unused).to_string().parse().unwrap_or(f64::INFINITY)
    }
}
