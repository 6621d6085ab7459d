//! What may clear together in a part, and all situations that come of it.
//!
//! R4 clears transitions together: what a step loses by one and gets by another it keeps. Yet most that clear together
//! might as well do so one after the other, and then nothing is to be said of sets of them. Two have to be taken as one
//! *move* where
//!
//! - they share a step before them, since the one would take what the other waits for;
//! - the one leads to a step that the other leaves, which is active already: the step stays active (rule 5);
//! - the condition of the one reads a step that the other changes, since both are decided before anything is written.
//!
//! The last two have an order: done one after the other, first the one that leaves the step or reads it and then the other,
//! they come to the same situation. So the second looks for the first and not the other way round: what goes round in such an
//! order is found from any of its transitions.
//!
//! Moves are made of transitions one by one, and only where all of them are enabled in a situation found so far. So any
//! transitions that clear together in such a situation fall into moves which, done one after the other in that order, come
//! to the same situation.

use super::parts::Part;
use super::sets::{Act, NONE, SetId, Sets};
use crate::analysis::Conditions;
use crate::analysis::canonical::Canonical;
use crate::analysis::rivals::Rivals;
use grafc_formula::exclusion::EdgeFacts;
use grafc_model::chart::{StepId, TransitionId};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeSet;

/// A part with more moves than this for each of its transitions is given up.
const MOVES: usize = 4;

/// A move of more transitions is not made.
const TOGETHER: usize = 6;

/// What is asked about a part.
pub(super) struct Question<'a> {
    pub(super) canonical: &'a Canonical<'a>,
    pub(super) part: &'a Part,
    pub(super) conditions: &'a Conditions,
    pub(super) facts: &'a EdgeFacts,
    pub(super) rivals: &'a Rivals,
    /// The number that a step has in the part.
    pub(super) number: &'a FxHashMap<StepId, u16>,
}

/// What has been found of a part.
pub(super) struct Closure {
    pub(super) sets: Sets,
    pub(super) reached: SetId,
    /// Transitions that may clear while a step after them is active that they do not leave.
    pub(super) entering_active: FxHashSet<(TransitionId, StepId)>,
    /// Pairs of transitions that are enabled at once and have to do with each other.
    pub(super) meeting: FxHashSet<(TransitionId, TransitionId)>,
}

/// A transition of the part.
struct Single {
    id: TransitionId,
    before: BTreeSet<u16>,
    after: BTreeSet<u16>,
    /// The steps of the part that its condition reads.
    reads: BTreeSet<u16>,
}

/// Transitions that clear together.
struct Move {
    members: BTreeSet<usize>,
    /// In which cases its conditions can hold, each with what it asks for, its steps before included.
    cases: Vec<Vec<(u16, bool)>>,
    /// What it does in each case.
    acts: Vec<Vec<Act>>,
    /// The situations that it was last applied to.
    applied: SetId,
}

struct Search<'a> {
    question: &'a Question<'a>,
    singles: Vec<Single>,
    /// Those of a transition.
    rivals: Vec<Vec<usize>>,
    /// The transitions after each step, those that read it, and those that may lead to it while it is active.
    leaving: Vec<Vec<usize>>,
    readers: Vec<Vec<usize>>,
    entered_active: Vec<Vec<usize>>,
    moves: Vec<Move>,
    made: FxHashSet<BTreeSet<usize>>,
    excluded: FxHashMap<(usize, usize), bool>,
    found: Closure,
}

/// All situations of a part; none if that takes too much work.
pub(super) fn close(question: &Question, allowed: usize) -> Option<Closure> {
    let search = Search::new(question, true, allowed / 2)?;
    let reading = search.singles.iter().any(|single| !single.reads.is_empty());
    // What conditions read makes moves of many transitions where it goes criss-cross; without it they stay few.
    search.run().or_else(|| if reading { Search::new(question, false, allowed / 2)?.run() } else { None })
}

impl<'a> Search<'a> {
    fn new(question: &'a Question, reading: bool, allowed: usize) -> Option<Search<'a>> {
        let (part, number) = (question.part, question.number);
        let net = &question.canonical.net;
        let numbers = |steps: &[StepId]| steps.iter().map(|s| number[s]).collect::<BTreeSet<u16>>();
        let mut search = Search {
            question,
            singles: Vec::with_capacity(part.transitions.len()),
            rivals: Vec::with_capacity(part.transitions.len()),
            leaving: vec![Vec::new(); part.steps.len()],
            readers: vec![Vec::new(); part.steps.len()],
            entered_active: vec![Vec::new(); part.steps.len()],
            moves: Vec::new(),
            made: FxHashSet::default(),
            excluded: FxHashMap::default(),
            found: Closure {
                sets: Sets::new(allowed),
                reached: NONE,
                entering_active: FxHashSet::default(),
                meeting: FxHashSet::default(),
            },
        };
        for start in part.starts(question.canonical) {
            let steps: Vec<u16> = numbers(&start).into_iter().collect();
            let one = search.found.sets.one(&steps);
            search.found.reached = search.found.sets.union(search.found.reached, one)?;
        }
        for t in &part.transitions {
            let transition = &net.transitions[*t];
            let reads = if reading { search.reads(*t) } else { BTreeSet::new() };
            let (before, after) = (numbers(&transition.pre), numbers(&transition.post));
            search.singles.push(Single { id: *t, before, after, reads });
        }
        // What lies first in the part moves first.
        search.singles.sort_by(|a, b| (a.before.first(), a.id).cmp(&(b.before.first(), b.id)));
        for (index, single) in search.singles.iter().enumerate() {
            single.before.iter().for_each(|s| search.leaving[usize::from(*s)].push(index));
            single.reads.iter().for_each(|s| search.readers[usize::from(*s)].push(index));
        }
        let place: FxHashMap<TransitionId, usize> =
            search.singles.iter().enumerate().map(|(index, single)| (single.id, index)).collect();
        for single in &search.singles {
            let Question { canonical, rivals, .. } = question;
            let of = rivals.of(canonical.transition[single.id]).iter();
            search.rivals.push(of.map(|t| place[&canonical.transition_rank[*t]]).collect());
        }
        for index in 0..search.singles.len() {
            search.make(BTreeSet::from([index]))?;
        }
        Some(search)
    }

    /// The steps of the part that a condition reads.
    fn reads(&self, t: TransitionId) -> BTreeSet<u16> {
        let Question { canonical, conditions, facts, .. } = self.question;
        let condition = conditions.of_transition[canonical.transition[t]];
        let mut read = BTreeSet::new();
        for v in facts.variables(&conditions.lowering.pool, condition) {
            read.extend(self.step_of(v));
        }
        read
    }

    /// The number of the step whose activity a variable is.
    fn step_of(&self, v: grafc_formula::VarId) -> Option<u16> {
        let step = self.question.conditions.lowering.situation.step_of(v)?;
        self.question.number.get(&self.question.canonical.rank[step]).copied()
    }

    /// Makes a move of these transitions, unless there is one.
    fn make(&mut self, members: BTreeSet<usize>) -> Option<()> {
        if !self.made.insert(members.clone()) {
            return Some(());
        }
        let (mut before, mut after) = (BTreeSet::new(), BTreeSet::new());
        for single in members.iter().map(|m| &self.singles[*m]) {
            before.extend(&single.before);
            after.extend(&single.after);
        }
        let mut cases = Vec::new();
        for mut case in self.cases(&members) {
            case.extend(before.iter().map(|s| (*s, true)));
            case.sort_unstable();
            case.dedup();
            // A condition that asks for a step before the transition to be inactive never holds.
            if case.windows(2).all(|pair| pair[0].0 != pair[1].0) {
                cases.push(case);
            }
        }
        let acts = cases.iter().map(|case| acts(case, &before, &after)).collect();
        self.moves.push(Move { members, cases, acts, applied: NONE });
        (self.moves.len() <= MOVES * (self.singles.len() + MOVES)).then_some(())
    }

    /// In which cases the conditions of transitions hold together.
    fn cases(&self, members: &BTreeSet<usize>) -> Vec<Vec<(u16, bool)>> {
        let Question { canonical, conditions, facts, .. } = self.question;
        if members.iter().all(|m| self.singles[*m].reads.is_empty()) {
            return vec![Vec::new()];
        }
        let of: Vec<_> =
            members.iter().map(|m| conditions.of_transition[canonical.transition[self.singles[*m].id]]).collect();
        let cases = facts.cases(&conditions.lowering.pool, &of, &|v| self.step_of(v).is_some());
        let numbered = |case: Vec<_>| case.into_iter().filter_map(|(v, value)| Some((self.step_of(v)?, value)));
        cases.map_or_else(|| vec![Vec::new()], |cases| cases.into_iter().map(|case| numbered(case).collect()).collect())
    }

    fn run(mut self) -> Option<Closure> {
        loop {
            self.apply()?;
            self.look_at_active_steps()?;
            let before = self.moves.len();
            for index in 0..before {
                self.join(index)?;
            }
            if self.moves.len() == before {
                break;
            }
        }
        for index in 0..self.moves.len() {
            let members: Vec<usize> = self.moves[index].members.iter().copied().collect();
            if let [a, b] = members[..]
                && self.possible(index, &[])?
            {
                self.found.meeting.insert((self.singles[a].id, self.singles[b].id));
            }
        }
        Some(self.found)
    }

    /// Applies all moves until nothing new comes of them.
    fn apply(&mut self) -> Option<()> {
        let mut done = false;
        while !done {
            done = true;
            for index in 0..self.moves.len() {
                if self.moves[index].applied == self.found.reached {
                    continue;
                }
                self.moves[index].applied = self.found.reached;
                for acts in &self.moves[index].acts {
                    let came = self.found.sets.changed(self.found.reached, acts)?;
                    self.found.reached = self.found.sets.union(self.found.reached, came)?;
                }
                done &= self.moves[index].applied == self.found.reached;
            }
        }
        Some(())
    }

    /// Whether a move may happen in a situation found so far in which other steps are active or not.
    fn possible(&mut self, index: usize, also: &[(u16, bool)]) -> Option<bool> {
        for case in &self.moves[index].cases {
            let mut wanted = [case.as_slice(), also].concat();
            wanted.sort_unstable();
            wanted.dedup();
            if wanted.windows(2).all(|pair| pair[0].0 != pair[1].0)
                && self.found.sets.has(self.found.reached, &wanted)?
            {
                return Some(true);
            }
        }
        Some(false)
    }

    /// Finds transitions that may lead to a step that is active already.
    fn look_at_active_steps(&mut self) -> Option<()> {
        // The first moves are those of the transitions one by one.
        for index in 0..self.singles.len() {
            let single = &self.singles[index];
            let fresh: Vec<u16> = single.after.difference(&single.before).copied().collect();
            for s in fresh {
                let key = (self.singles[index].id, self.question.part.steps[usize::from(s)]);
                if !self.found.entering_active.contains(&key) && self.possible(index, &[(s, true)])? {
                    self.found.entering_active.insert(key);
                    self.entered_active[usize::from(s)].push(index);
                }
            }
        }
        Some(())
    }

    /// Makes the moves that come of one and a further transition that has to do with it.
    fn join(&mut self, index: usize) -> Option<()> {
        let members: Vec<usize> = self.moves[index].members.iter().copied().collect();
        let mut others: BTreeSet<usize> = BTreeSet::new();
        for m in &members {
            others.extend(&self.rivals[*m]);
            let single = &self.singles[*m];
            for s in single.after.difference(&single.before) {
                if self.entered_active[usize::from(*s)].contains(m) {
                    others.extend(&self.leaving[usize::from(*s)]);
                }
            }
            others
                .extend(single.before.symmetric_difference(&single.after).flat_map(|s| &self.readers[usize::from(*s)]));
        }
        self.found.sets.spend(1 + others.len())?;
        for other in others {
            if !members.contains(&other) && !members.iter().any(|m| self.exclude(*m, other)) {
                self.join_with(index, other)?;
            }
        }
        Some(())
    }

    fn join_with(&mut self, index: usize, other: usize) -> Option<()> {
        let mut members = self.moves[index].members.clone();
        members.insert(other);
        if self.made.contains(&members) {
            return Some(());
        }
        let also: Vec<(u16, bool)> = self.singles[other].before.iter().map(|s| (*s, true)).collect();
        match self.possible(index, &also)? {
            true if members.len() > TOGETHER => None,
            true => self.make(members),
            false => Some(()),
        }
    }

    /// Whether the conditions of two transitions never hold together. Of those that share a step that is known.
    fn exclude(&mut self, a: usize, b: usize) -> bool {
        let key = (a.min(b), a.max(b));
        if let Some(known) = self.excluded.get(&key) {
            return *known;
        }
        let Question { canonical, conditions, facts, .. } = self.question;
        let [x, y] = [a, b].map(|t| conditions.of_transition[canonical.transition[self.singles[t].id]]);
        let exclude = facts.exclude(&conditions.lowering.pool, x, y);
        self.excluded.insert(key, exclude);
        exclude
    }
}

/// What a move does in a case.
fn acts(case: &[(u16, bool)], before: &BTreeSet<u16>, after: &BTreeSet<u16>) -> Vec<Act> {
    let mut acts: Vec<Act> = case.iter().map(|(s, must)| Act { step: *s, must: Some(*must), becomes: None }).collect();
    let asked: BTreeSet<u16> = case.iter().map(|(s, _)| *s).collect();
    acts.extend(after.difference(&asked).map(|s| Act { step: *s, must: None, becomes: None }));
    acts.sort_unstable_by_key(|act| act.step);
    for act in &mut acts {
        if after.contains(&act.step) {
            act.becomes = Some(true);
        } else if before.contains(&act.step) {
            act.becomes = Some(false);
        }
    }
    acts
}
