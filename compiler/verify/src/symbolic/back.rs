//! What leads to what: backwards from states, reaction by reaction.

use super::found::{Found, Layers, Reactions};
use super::sets::{Halt, Sets};
use crate::goal::{Finding, Reason};
use crate::limit::Limit;
use crate::machine::Machine;
use biodivine_lib_bdd::Bdd;

/// States that meet a goal, whatever delays do, and those that may.
pub(super) struct Meeting {
    pub(super) certain: Bdd,
    pub(super) possible: Bdd,
}

/// A reaction that ends soon is one of so many micro-steps more than one.
const SOON: usize = 3;

/// Which ways of time are looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Time {
    /// Any.
    Any,
    /// All delays that run are over, or none.
    Sure,
}

impl Found {
    /// All reactions from all states; where these are wider than there are, those that end soon.
    pub(super) fn all_reactions(&self, sets: &mut Sets) -> Result<Reactions, Halt> {
        let enter = self.begin(&self.reached, sets)?;
        if !self.is_wide {
            return Ok(self.reactions(enter, sets)?.0);
        }
        let mut reactions = Reactions { heads: vec![enter], is_endless: false };
        for soon in 0..SOON {
            let more = sets.and(&reactions.heads[soon], &self.relation.again)?;
            let heads = self.relation.step.image(&more, &[], sets)?;
            reactions.heads.push(heads);
        }
        Ok(reactions)
    }

    /// The states with a reaction that ends in one of these.
    fn before(&self, states: &Bdd, time: Time, all: &Reactions, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut ending = self.relation.bits.all.mk_false();
        for heads in all.heads.iter().rev() {
            let resting = sets.minus(heads, &self.relation.again)?;
            let last = self.relation.last.before(states, &resting, sets)?;
            if !ending.is_false() {
                let more = sets.and(heads, &self.relation.again)?;
                ending = self.relation.step.before(&ending, &more, sets)?;
            }
            ending = sets.or(&ending, &last)?;
        }
        let mut among = sets.and(&self.reached, &self.relation.allowed)?;
        if time == Time::Sure {
            let all = |over: bool| self.relation.ends.iter().map(|v| (*v, over)).collect::<Vec<_>>();
            let (over, running) = (among.select(&all(true)), among.select(&all(false)));
            among = sets.or(&over, &running)?;
        }
        let before = self.relation.begin.before(&ending, &among, sets)?;
        sets.exists(&before, &self.relation.asked)
    }

    /// The states from which one of these can be reached.
    fn leading_to(&self, states: &Bdd, time: Time, all: &Reactions, sets: &mut Sets) -> Result<Bdd, Halt> {
        let (mut leading, mut new) = (states.clone(), states.clone());
        while !new.is_false() {
            let before = self.before(&new, time, all, sets)?;
            new = sets.minus(&before, &leading)?;
            leading = sets.or(&leading, &new)?;
        }
        Ok(leading)
    }

    pub(super) fn homeless(&self, all: &Reactions, sets: &mut Sets) -> Result<Meeting, Halt> {
        let home = self.with_situation_of(&self.first, sets)?;
        let home = sets.and(&home, &self.reached)?;
        let mut away = |time| {
            let returns = self.leading_to(&home, time, all, sets)?;
            sets.minus(&self.reached, &returns)
        };
        let certain = away(Time::Any)?;
        let possible = if self.relation.ends.is_empty() { certain.clone() } else { away(Time::Sure)? };
        Ok(Meeting { certain, possible })
    }

    /// The states in a situation that one of these has. What holds the situation is kept, all else is left open.
    fn with_situation_of(&self, states: &Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut holds = std::collections::HashSet::new();
        self.relation.active.iter().for_each(|active| holds.extend(active.support_set()));
        let others: Vec<_> = self.relation.kept.iter().filter(|v| !holds.contains(v)).copied().collect();
        sets.exists(states, &others)
    }

    /// The states from which no other situation can be reached. One that is not homeless can leave its situation if that is
    /// none of the start.
    pub(super) fn stuck(&self, homeless: Option<&Meeting>, all: &Reactions, sets: &mut Sets) -> Result<Meeting, Halt> {
        let certain = self.stuck_in(homeless.map(|homeless| &homeless.certain), Time::Any, all, sets)?;
        let possible = if self.relation.ends.is_empty() {
            certain.clone()
        } else {
            self.stuck_in(homeless.map(|homeless| &homeless.possible), Time::Sure, all, sets)?
        };
        Ok(Meeting { certain, possible })
    }

    fn stuck_in(&self, homeless: Option<&Bdd>, time: Time, all: &Reactions, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut rest = self.reached.clone();
        if let Some(homeless) = homeless {
            let home = self.with_situation_of(&self.first, sets)?;
            let home = sets.and(&home, &self.reached)?;
            rest = sets.or(&home, homeless)?;
        }
        let looked_at = rest.clone();
        for active in &self.relation.active {
            for (here, there) in [(active.clone(), active.not()), (active.not(), active.clone())] {
                let may_move = sets.and(&rest, &here)?;
                if may_move.is_false() {
                    continue;
                }
                let there = sets.and(&self.reached, &there)?;
                let before = self.before(&there, time, all, sets)?;
                let moves = sets.and(&may_move, &before)?;
                rest = sets.minus(&rest, &moves)?;
            }
        }
        // What does not move in one reaction may in several, all in one situation.
        let mut alive = sets.minus(&looked_at, &rest)?;
        if homeless.is_some() {
            let others = sets.minus(&self.reached, &looked_at)?;
            alive = sets.or(&alive, &others)?;
        }
        while !rest.is_false() {
            let before = self.before(&alive, time, all, sets)?;
            let moves = sets.and(&rest, &before)?;
            if moves.is_false() {
                break;
            }
            rest = sets.minus(&rest, &moves)?;
            alive = moves;
        }
        // Where it may have come to its end, it may stay.
        sets.minus(&rest, &self.relation.is_final)
    }

    /// Whether the second of a pair can be reached from everywhere.
    pub(super) fn is_never_lost(&self, place: usize, all: &Reactions, sets: &mut Sets) -> Result<bool, Halt> {
        let Some((_, to)) = self.relation.leads.get(place) else { return Ok(false) };
        let goals = sets.and(&self.reached, to)?;
        let leading = self.leading_to(&goals, Time::Sure, all, sets)?;
        Ok(sets.minus(&self.reached, &leading)?.is_false())
    }

    /// What of one thing leads to another is lost.
    pub(super) fn lost(
        &self,
        place: usize,
        all: &Reactions,
        machine: &mut Machine,
        sets: &mut Sets,
    ) -> Result<Finding, Halt> {
        let Some((from, to)) = self.relation.leads.get(place) else {
            return Ok(Finding::Open(Reason::Limit(Limit::States)));
        };
        let goals = sets.and(&self.reached, to)?;
        let may = self.leading_to(&goals, Time::Any, all, sets)?;
        let must =
            if self.relation.ends.is_empty() { may.clone() } else { self.leading_to(&goals, Time::Sure, all, sets)? };
        // What is reached from the first without the second, by the number of reactions from the start.
        let seeds = sets.and(&self.reached, from)?;
        let seeds = sets.minus(&seeds, to)?;
        let no = self.relation.bits.all.mk_false();
        let (mut region, mut next, mut is_open) = (no.clone(), no, false);
        let mut layers =
            Layers { rings: Vec::new(), reactions: vec![Reactions::default()], seeds: Some(seeds.clone()) };
        for depth in 0.. {
            let mut ring = next;
            if let Some(all) = self.layers.rings.get(depth) {
                let begin = sets.and(all, &seeds)?;
                ring = sets.or(&ring, &begin)?;
            } else if ring.is_false() {
                break;
            }
            ring = sets.minus(&ring, &region)?;
            region = sets.or(&region, &ring)?;
            layers.rings.push(ring.clone());
            let bad = sets.minus(&ring, &may)?;
            if !bad.is_false() {
                return Ok(Finding::Met(self.way_through(&layers, depth, &bad, machine, sets)?));
            }
            is_open |= !sets.minus(&ring, &must)?.is_false();
            let enter = self.begin(&ring, sets)?;
            let (reactions, ended) = self.reactions(enter, sets)?;
            let is_endless = reactions.is_endless;
            layers.reactions.push(reactions);
            if is_endless {
                return Ok(Finding::Met(self.way_to_no_end(&layers, machine, sets)?));
            }
            next = sets.minus(&ended, to)?;
        }
        Ok(if is_open { Finding::Open(Reason::Delays) } else { Finding::Never })
    }
}
