//! The search for components.
//!
//! From a step that none covers, the search follows the token: forward, into one of the steps after each transition that
//! leaves, and back to where the token of each transition that enters comes from. It takes in new steps as long as there
//! are any. Where only covered ones are left to bring the token, the new steps are a branch beside one of the components
//! found so far, which leaves out what the branch replaces:
//!
//! - a step before or after a transition that has a new step at the same side, and so on along the token, until a
//!   transition is reached that has a new step before it;
//! - a step after a transition that only a new step comes after now: the transition brings the token to the branch.
//!
//! Only what lies around the branch and around the steps left out has to be looked at; branches between the same
//! transitions leave out the same steps, so that they are looked at once.
//!
//! Where the search has chosen wrongly among several steps, two steps of the set turn up at one side of a transition: it
//! starts again without the step chosen.

use super::Surroundings;
use super::family::{Component, Family, Region, Side};
use super::reason::Reason;
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// Searches that fail look at at most this many steps and arcs for each step and arc of the net.
const EFFORT: usize = 64;

/// One search takes at most this part of what is left.
const SHARE: usize = 8;

/// A search may always look at this many, as long as any are left.
const LEAST: usize = 4_096;

/// How often a search from one step starts, at the most.
const TRIES: usize = 8;

/// No more components than this are tried as the base of a branch.
const BASES: usize = 4;

/// No more steps than this are considered where one of several has to be chosen.
const CHOICES: usize = 32;

/// Why a search fails, and the step to do without when it starts again.
struct Stop {
    reason: Reason,
    instead_of: Option<StepId>,
}

/// Something noted in one search only.
type Noted<T> = Option<(u32, T)>;

pub(super) struct Search<'n> {
    net: &'n Net,
    around: &'n Surroundings<'n>,
    pub(super) family: Family,
    /// Why a step is in no component: what has been proved, or where the last search failed.
    reasons: IndexVec<StepId, Option<Reason>>,
    /// Steps that no component can hold.
    out: IndexVec<StepId, bool>,
    /// How many components there were when a search from a step failed.
    failed_at: IndexVec<StepId, Option<usize>>,
    /// Regions by base and by the transitions that lead out of and into the rest of it.
    regions: FxHashMap<(usize, Vec<Touch>), usize>,
    /// Where a step to choose may still be found.
    first: FxHashMap<(TransitionId, Side), usize>,
    effort: usize,

    /// The number of the present search, the work it has done and the work it may do.
    number: u32,
    work: usize,
    allowed: usize,
    /// Steps that it has to do without.
    banned: Vec<StepId>,
    /// The new steps, each with the last choice that led to it.
    chosen: IndexVec<StepId, Noted<Option<StepId>>>,
    before: IndexVec<TransitionId, Noted<StepId>>,
    after: IndexVec<TransitionId, Noted<StepId>>,
    initial: Option<StepId>,
    link: Option<StepId>,
    forced: Vec<Noted<StepId>>,
    /// The steps left out of the present base, by the number of the attempt, each with the choice that led to it.
    removed: IndexVec<StepId, Noted<Option<StepId>>>,
    attempt: u32,
}

/// A transition around a branch that touches the base as well, and whether a step of the branch is before and after it.
type Touch = (TransitionId, bool, bool);

impl<'n> Search<'n> {
    /// `undecided` says of a step why more than one transition after it may clear.
    pub(super) fn new(net: &'n Net, around: &'n Surroundings<'n>, undecided: IndexVec<StepId, Option<Reason>>) -> Self {
        let arcs: usize = net.transitions.iter().map(|t| t.pre.len() + t.post.len()).sum();
        let mut search = Search {
            net,
            around,
            family: Family::new(net),
            out: undecided.iter().map(Option::is_some).collect(),
            reasons: undecided,
            failed_at: net.places.iter().map(|_| None).collect(),
            regions: FxHashMap::default(),
            first: FxHashMap::default(),
            effort: EFFORT * (net.places.len() + arcs),
            number: 0,
            work: 0,
            allowed: 0,
            banned: Vec::new(),
            chosen: net.places.iter().map(|_| None).collect(),
            before: net.transitions.iter().map(|_| None).collect(),
            after: net.transitions.iter().map(|_| None).collect(),
            initial: None,
            link: None,
            forced: vec![None; around.orders],
            removed: net.places.iter().map(|_| None).collect(),
            attempt: 0,
        };
        search.rule_out();
        search
    }

    /// Why a step is in no component.
    pub(super) fn reason(&self, s: StepId) -> Reason {
        self.reasons[s].unwrap_or(Reason::GivenUp)
    }

    /// By rule 2 no component holds a step that a transition leads to before which no component holds a step.
    fn rule_out(&mut self) {
        let net = self.net;
        let mut left: IndexVec<TransitionId, usize> = net.transitions.iter().map(|t| t.pre.len()).collect();
        let mut out: Vec<StepId> = net.places.indices().filter(|s| self.out[*s]).collect();
        let sources: Vec<TransitionId> = left.iter_enumerated().filter(|(_, n)| **n == 0).map(|(t, _)| t).collect();
        for t in sources {
            out.extend(self.rule_out_after(t, Reason::Source(t)));
        }
        while let Some(s) = out.pop() {
            for t in self.around.leaving(s) {
                left[*t] -= 1;
                if left[*t] == 0 {
                    out.extend(self.rule_out_after(*t, Reason::From(*t)));
                }
            }
        }
    }

    fn rule_out_after(&mut self, t: TransitionId, reason: Reason) -> Vec<StepId> {
        let steps: Vec<StepId> = self.net.transitions[t].post.iter().copied().filter(|s| !self.out[*s]).collect();
        for s in &steps {
            self.out[*s] = true;
            self.reasons[*s] = Some(reason);
        }
        steps
    }

    /// Searches from each step that is not covered yet, from where tokens start first; once more where a component has
    /// been found since, which may be a base.
    pub(super) fn run(&mut self) {
        let starts = |s: &StepId| self.net.places[*s].initial || self.net.places[*s].activated;
        let (mut steps, others): (Vec<StepId>, Vec<StepId>) = self.net.places.indices().partition(starts);
        steps.extend(others);
        for s in steps.iter().chain(&steps) {
            if self.is_open(*s) && self.failed_at[*s] != Some(self.family.components.len()) {
                self.search(*s);
            }
        }
    }

    fn is_open(&self, s: StepId) -> bool {
        !self.out[s] && self.family.owner(s).is_none()
    }

    fn search(&mut self, first: StepId) {
        self.banned.clear();
        self.work = 0;
        self.allowed = self.effort.min(self.effort / SHARE + LEAST);
        self.failed_at[first] = Some(self.family.components.len());
        let mut worth = 0;
        for _ in 0..TRIES {
            match self.grow(first).and_then(|steps| self.attach(steps)) {
                Ok(arcs) => {
                    worth = EFFORT * arcs;
                    break;
                }
                Err(stop) => {
                    if stop.reason != Reason::GivenUp {
                        self.reasons[first] = Some(stop.reason);
                    }
                    match stop.instead_of {
                        Some(s) => self.banned.push(s),
                        None => break,
                    }
                }
            }
        }
        self.effort = self.effort.saturating_sub(self.work.saturating_sub(worth));
    }

    fn spend(&mut self, work: usize) -> Result<(), Stop> {
        self.work += work + self.family.work();
        if self.work > self.allowed { Err(Stop { reason: Reason::GivenUp, instead_of: None }) } else { Ok(()) }
    }

    /// The new steps that the token can be followed to from the first.
    fn grow(&mut self, first: StepId) -> Result<Vec<StepId>, Stop> {
        self.number += 1;
        (self.initial, self.link) = (None, None);
        let around = self.around;
        let mut steps = Vec::new();
        let mut forward = Vec::new();
        let mut backward = 0;
        self.take(first, None)?;
        forward.push(first);
        loop {
            while let Some(s) = forward.pop() {
                steps.push(s);
                for t in around.leaving(s) {
                    if self.at(*t, Side::After).is_none()
                        && let Some((next, choice)) = self.choose(*t, Side::After, s)?
                    {
                        self.take(next, choice)?;
                        forward.push(next);
                    }
                }
            }
            let Some(s) = steps.get(backward).copied() else { return Ok(steps) };
            for t in around.entering(s) {
                if self.at(*t, Side::Before).is_none()
                    && let Some((next, choice)) = self.choose(*t, Side::Before, s)?
                {
                    self.take(next, choice)?;
                    forward.push(next);
                }
            }
            backward += 1;
        }
    }

    /// Takes a step into the set, unless another one there contradicts the rules 1, 2, 4 or 5.
    fn take(&mut self, s: StepId, choice: Option<StepId>) -> Result<(), Stop> {
        let (around, number) = (self.around, self.number);
        self.spend(1 + around.leaving(s).len() + around.entering(s).len() + around.forced_by[s].len())?;
        self.chosen[s] = Some((number, choice));
        let place = &self.net.places[s];
        if place.initial
            && let Some(other) = self.initial.replace(s)
        {
            return Err(self.contradiction(Reason::Initial(other, s), other, s));
        }
        if place.activated
            && !place.within.is_empty()
            && let Some(other) = self.link.replace(s)
        {
            return Err(self.contradiction(Reason::Links(other, s), other, s));
        }
        for order in &around.forced_by[s] {
            if let Some(other) = current(number, self.forced[*order].replace((number, s))) {
                return Err(self.contradiction(Reason::Forced(other, s), other, s));
            }
        }
        for t in around.leaving(s) {
            if let Some(other) = current(number, self.before[*t].replace((number, s))) {
                return Err(self.contradiction(Reason::Before(*t, other, s), other, s));
            }
        }
        for t in around.entering(s) {
            if let Some(other) = current(number, self.after[*t].replace((number, s))) {
                return Err(self.contradiction(Reason::After(*t, other, s), other, s));
            }
        }
        Ok(())
    }

    fn contradiction(&self, reason: Reason, one: StepId, other: StepId) -> Stop {
        Stop { reason, instead_of: self.choice(one).or(self.choice(other)) }
    }

    /// The last choice that led to a new step.
    fn choice(&self, s: StepId) -> Option<StepId> {
        current(self.number, self.chosen[s]).flatten()
    }

    /// The new step at a side of a transition.
    fn at(&self, t: TransitionId, side: Side) -> Option<StepId> {
        let noted = match side {
            Side::Before => self.before[t],
            Side::After => self.after[t],
        };
        current(self.number, noted)
    }

    /// A step at a side of a transition to take in, and the choice that leads to it; `beside` is on the other side. None
    /// if covered steps are to be preferred, or nothing.
    fn choose(
        &mut self,
        t: TransitionId,
        side: Side,
        beside: StepId,
    ) -> Result<Option<(StepId, Option<StepId>)>, Stop> {
        let steps = match side {
            Side::Before => &self.net.transitions[t].pre,
            Side::After => &self.net.transitions[t].post,
        };
        let mut first = self.first.get(&(t, side)).copied().unwrap_or_default();
        let passed = steps[first..].iter().take_while(|s| !self.is_open(**s)).count();
        if passed > 0 {
            first += passed;
            self.first.insert((t, side), first);
        }
        self.spend(1 + passed)?;
        let open = || steps[first..].iter().take(CHOICES).filter(|s| self.is_open(**s) && !self.banned.contains(s));
        let fresh = open().find(|s| self.failed_at[**s].is_none());
        let failed = || open().next().filter(|_| !self.family.is_known(t, side));
        let Some(next) = fresh.or_else(failed).copied() else { return Ok(None) };
        let choice = if steps.len() > 1 { Some(next) } else { self.choice(beside) };
        Ok(Some((next, choice)))
    }

    /// Makes a component of new steps, alone or beside another one. Returns how many arcs there are around them.
    fn attach(&mut self, steps: Vec<StepId>) -> Result<usize, Stop> {
        let around = self.around;
        let arcs = steps.iter().map(|s| 1 + around.leaving(*s).len() + around.entering(*s).len()).sum();
        let entering = steps.iter().flat_map(|s| around.entering(*s)).copied();
        let unfed: Vec<TransitionId> = entering.filter(|t| self.at(*t, Side::Before).is_none()).collect();
        let Some(first) = unfed.first() else {
            self.add(steps, None);
            return Ok(arcs);
        };
        let mut stop = self.unfed(*first);
        for base in self.bases(&unfed)? {
            match self.leave_out(base, &steps) {
                Ok(region) => {
                    self.add(steps, Some((base, region)));
                    return Ok(arcs);
                }
                Err(found) if stop.instead_of.is_none() => stop = found,
                Err(_) => {}
            }
        }
        Err(stop)
    }

    /// Nothing goes together with what the transition leads to that could bring it the token.
    fn unfed(&self, t: TransitionId) -> Stop {
        let instead_of = self.at(t, Side::After).and_then(|s| self.choice(s));
        Stop { reason: Reason::Origin(t), instead_of }
    }

    /// Components that bring the token to one of these transitions.
    fn bases(&mut self, unfed: &[TransitionId]) -> Result<Vec<usize>, Stop> {
        let mut bases = Vec::new();
        for t in unfed.iter().take(BASES) {
            for s in self.net.transitions[*t].pre.iter().take(CHOICES) {
                self.spend(1)?;
                if let Some(owner) = self.family.owner(*s)
                    && bases.len() < BASES
                    && !bases.contains(&owner)
                {
                    bases.push(owner);
                }
            }
        }
        Ok(bases)
    }

    /// The region that a base has to leave out for the steps to be a branch beside the rest.
    fn leave_out(&mut self, base: usize, steps: &[StepId]) -> Result<usize, Stop> {
        let around = self.around;
        let mut touches = Vec::new();
        let mut replaced = Vec::new();
        for s in steps {
            let leaving = around.leaving(*s).iter();
            let only_entering = around.entering(*s).iter().filter(|t| self.at(**t, Side::Before).is_none());
            for t in leaving.chain(only_entering) {
                let (before, after) = (self.at(*t, Side::Before), self.at(*t, Side::After));
                let (base_before, base_after) =
                    (self.family.step_at(*t, Side::Before, base), self.family.step_at(*t, Side::After, base));
                match before {
                    Some(new) => replaced.extend(base_before.map(|s| (s, self.choice(new)))),
                    None if base_before.is_none() => return Err(self.unfed(*t)),
                    None => {}
                }
                if let Some(new) = after {
                    replaced.extend(base_after.map(|s| (s, self.choice(new))));
                }
                if base_before.is_some() || base_after.is_some() {
                    touches.push((*t, before.is_some(), after.is_some()));
                }
            }
        }
        self.spend(touches.len())?;
        touches.sort_unstable();
        let region = match self.regions.get(&(base, touches.clone())) {
            Some(known) => *known,
            None => {
                let steps = self.follow(base, replaced)?;
                let zone = touches.iter().map(|(t, _, _)| *t);
                let zone = zone
                    .chain(steps.iter().flat_map(|s| around.leaving(*s).iter().chain(around.entering(*s)).copied()));
                let mut zone: Vec<TransitionId> = zone.collect();
                zone.sort_unstable();
                zone.dedup();
                let region = self.family.add_region(Region { steps, zone });
                self.regions.insert((base, touches), region);
                region
            }
        };
        self.agrees(base, region, steps)?;
        Ok(region)
    }

    /// The steps to leave out: those that are replaced, and what they alone bring the token to.
    fn follow(&mut self, base: usize, replaced: Vec<(StepId, Option<StepId>)>) -> Result<Vec<StepId>, Stop> {
        let around = self.around;
        self.attempt += 1;
        let attempt = self.attempt;
        let mut steps = Vec::new();
        let mut stack = replaced;
        while let Some((s, choice)) = stack.pop() {
            if current(attempt, self.removed[s]).is_some() {
                continue;
            }
            self.removed[s] = Some((attempt, choice));
            steps.push(s);
            self.spend(1 + around.leaving(s).len())?;
            for t in around.leaving(s) {
                if self.at(*t, Side::Before).is_some() {
                    continue;
                }
                if let Some(new) = self.at(*t, Side::After) {
                    // The token of the branch would come from a step that is left out.
                    return Err(Stop { reason: Reason::Origin(*t), instead_of: choice.or(self.choice(new)) });
                }
                stack.extend(self.family.step_at(*t, Side::After, base).map(|next| (next, choice)));
            }
        }
        Ok(steps)
    }

    /// Rules 1, 4 and 5 for new steps and the rest of a base.
    fn agrees(&mut self, base: usize, region: usize, steps: &[StepId]) -> Result<(), Stop> {
        let kept = |s: &StepId| !self.family.leaves_out(region, *s);
        let component = &self.family.components[base];
        let (initial, link) = (component.initial.filter(kept), component.link.filter(kept));
        if let (Some(old), Some(new)) = (initial, self.initial) {
            return Err(self.contradiction(Reason::Initial(old, new), new, new));
        }
        if let (Some(old), Some(new)) = (link, self.link) {
            return Err(self.contradiction(Reason::Links(old, new), new, new));
        }
        for new in steps {
            for order in &self.around.forced_by[*new] {
                if let Some(old) = self.family.forced(*order, base).filter(kept) {
                    return Err(self.contradiction(Reason::Forced(old, *new), *new, *new));
                }
            }
        }
        self.spend(0)
    }

    fn add(&mut self, own: Vec<StepId>, base: Option<(usize, usize)>) {
        let kept = |s: &StepId| base.is_none_or(|(_, region)| !self.family.leaves_out(region, *s));
        let inherited = base.map(|(base, _)| &self.family.components[base]);
        let initial = self.initial.or(inherited.and_then(|base| base.initial.filter(kept)));
        let link = self.link.or(inherited.and_then(|base| base.link.filter(kept)));
        let forced = own.iter().flat_map(|s| self.around.forced_by[*s].iter().map(move |order| (*order, *s))).collect();
        self.family.add(Component { own, base, initial, link, forced }, self.around);
    }
}

/// What has been noted, if it was in the present search.
fn current<T>(number: u32, noted: Noted<T>) -> Option<T> {
    noted.filter(|(at, _)| *at == number).map(|(_, what)| what)
}
