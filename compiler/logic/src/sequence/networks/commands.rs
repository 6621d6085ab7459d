//! When orders on a grafcet come, as conditions over the old situation and inputs.
//!
//! A step becomes active where a transition of its network that leads to it clears, and is left where one that leaves it
//! does; both are known once the network of the commander is.

use super::explore::{Case, Explored};
use super::{Does, Making};
use ecow::eco_format;
use grafc_model::chart::{Event, ExprId, GrafcetId, PulseKind, StepId, TransitionId};
use rustc_hash::FxHashMap;

/// The conditions.
pub(super) struct Commands {
    /// For each thing that is done to the grafcet as a whole, when it is.
    pub(super) when: FxHashMap<Case, ExprId>,
    /// A kill, given or passed on.
    pub(super) kill: Option<ExprId>,
    /// A freezing.
    pub(super) freeze: Option<ExprId>,
}

impl Commands {
    /// Those of a grafcet, for all that may be done to it.
    pub(super) fn of(making: &mut Making, g: GrafcetId, explored: &Explored) -> Commands {
        let name = making.net.grafcets[g].name.clone();
        let meets = explored.meets;
        let [kill, resume, start, freeze] = making.pulses_on(g);
        let above = making.given[g].above.clone();
        let passed = |which: &index_vec::IndexVec<GrafcetId, Option<ExprId>>| -> Vec<ExprId> {
            above.iter().filter_map(|above| which[*above]).collect()
        };
        let (kills, freezes) = (passed(&making.kills), passed(&making.freezes));
        let kill = making.or([kill].into_iter().chain(kills));
        let freeze = making.or([freeze].into_iter().chain(freezes));
        let within = making.given[g].within.clone();
        let (ends, begins) = (making.ends(&within), making.begins(&within));
        let orders = making.given[g].orders.clone();
        let mut forced = Vec::new();
        let mut nexts: Vec<ExprId> = Vec::new();
        for (place, (step, set)) in orders.iter().enumerate() {
            let next = making.next(*step);
            // Orders that set another situation are never in force with it.
            let earlier: Vec<ExprId> =
                orders.iter().zip(&nexts).filter(|((_, other), _)| other == set).map(|(_, next)| *next).collect();
            let earlier: Vec<ExprId> = earlier.into_iter().map(|next| making.not(next)).collect();
            let when = making.and([next].into_iter().chain(earlier));
            if set.is_some() {
                let label = &making.net.places[*step].label;
                let named = eco_format!("force_{name}_by_{label}");
                making.names.insert(when, named);
                forced.push((Case::Forced(place), when));
            }
            nexts.push(next);
        }
        let any_forced = making.or(forced.iter().map(|(_, when)| *when).collect::<Vec<_>>());
        for (word, expr) in [
            ("kill", kill),
            ("resume", resume),
            ("start", start),
            ("freeze", freeze),
            ("leave", ends),
            ("enter", begins),
        ] {
            making.names.entry(expr).or_insert_with(|| eco_format!("{word}_{name}"));
        }

        let [no_kill, no_start, no_freeze, no_forced, no_ends] =
            [kill, start, freeze, any_forced, ends].map(|expr| making.not(expr));
        let only = |condition: bool, expr: ExprId| condition.then_some(expr);
        let free = only(meets.forced_pulse, no_forced);
        let mut when = FxHashMap::default();
        when.insert(Case::Ends, ends);
        for (case, expr) in forced {
            when.insert(case, making.and([Some(expr), only(meets.ends_forced, no_ends)].into_iter().flatten()));
        }
        when.insert(
            Case::Begins,
            making.and([Some(begins), only(meets.begins_forced, no_forced)].into_iter().flatten()),
        );
        when.insert(Case::Restart, making.and([Some(kill), Some(start), free].into_iter().flatten()));
        when.insert(Case::Kill, making.and([Some(kill), only(meets.kill_start, no_start), free].into_iter().flatten()));
        let anew = meets.start_freeze.then(|| if meets.kill_freeze { making.or([kill, no_freeze]) } else { no_freeze });
        when.insert(Case::Start, making.and([Some(start), anew, free].into_iter().flatten()));
        let lives = only(meets.kill_freeze, no_kill);
        when.insert(Case::StartKept, making.and([Some(start), Some(freeze), lives, free].into_iter().flatten()));
        when.insert(Case::Freeze, making.and([Some(freeze), lives, free].into_iter().flatten()));
        let lives = only(meets.kill_resume, no_kill);
        let goes_on = only(meets.resume_freeze, no_freeze);
        when.insert(Case::Resume, making.and([Some(resume), lives, goes_on, free].into_iter().flatten()));
        let known = |making: &mut Making, expr: ExprId| (expr != making.never()).then_some(expr);
        Commands { when, kill: known(making, kill), freeze: known(making, freeze) }
    }
}

impl Making {
    fn never(&mut self) -> ExprId {
        self.or([])
    }

    /// That a transition is enabled and its condition, or what stands for it, holds; of a step before it that may be known.
    pub(super) fn clears(&mut self, t: TransitionId, known: Option<StepId>, condition: ExprId) -> ExprId {
        let pre = self.net.transitions[t].pre.clone();
        let active: Vec<ExprId> = pre.into_iter().filter(|s| Some(*s) != known).map(|s| self.active(s)).collect();
        self.and(active.into_iter().chain([condition]))
    }

    /// That one of the transitions clears which do what is asked for.
    fn one_clears(&mut self, transitions: &[TransitionId], wanted: impl Fn(Does) -> bool) -> ExprId {
        let wanted: Vec<TransitionId> = transitions.iter().copied().filter(|t| wanted(self.does[*t])).collect();
        let terms: Vec<ExprId> =
            wanted.into_iter().map(|t| self.clears(t, None, self.net.transitions[t].condition)).collect();
        self.or(terms)
    }

    fn activated(&mut self, s: StepId, wanted: impl Fn(Does) -> bool) -> ExprId {
        let transitions = self.entering.get(&s).cloned().unwrap_or_default();
        self.one_clears(&transitions, wanted)
    }

    fn deactivated(&mut self, s: StepId, wanted: impl Fn(Does) -> bool) -> ExprId {
        let transitions = self.leaving.get(&s).cloned().unwrap_or_default();
        self.one_clears(&transitions, wanted)
    }

    /// The next activity of a step.
    fn next(&mut self, s: StepId) -> ExprId {
        let active = self.active(s);
        let mut stays = vec![active];
        for t in self.leaving.get(&s).cloned().unwrap_or_default() {
            let clears = self.clears(t, Some(s), self.net.transitions[t].condition);
            stays.push(self.not(clears));
        }
        let stays = self.and(stays);
        let comes = self.activated(s, |_| true);
        self.or([comes, stays])
    }

    /// That the first of these steps becomes active.
    fn begins(&mut self, steps: &[StepId]) -> ExprId {
        let comes: Vec<ExprId> = steps.iter().map(|s| self.activated(*s, |_| true)).collect();
        let comes = self.or(comes);
        let none = self.none_active(steps);
        self.and(none.into_iter().chain([comes]))
    }

    /// That none is active; of one it need not be said, since it only becomes active where it is not.
    fn none_active(&mut self, steps: &[StepId]) -> Option<ExprId> {
        if steps.len() < 2 {
            return None;
        }
        let active: Vec<ExprId> = steps.iter().map(|s| self.active(*s)).collect();
        let none: Vec<ExprId> = active.into_iter().map(|active| self.not(active)).collect();
        Some(self.and(none))
    }

    /// That the last of these steps is left.
    fn ends(&mut self, steps: &[StepId]) -> ExprId {
        let left: Vec<ExprId> = steps.iter().map(|s| self.deactivated(*s, |_| true)).collect();
        self.ends_if(steps, left)
    }

    /// That none of these steps goes on being active, if one is left.
    fn ends_if(&mut self, steps: &[StepId], left: Vec<ExprId>) -> ExprId {
        let left = self.or(left);
        if steps.len() < 2 {
            return left;
        }
        let next: Vec<ExprId> = steps.iter().map(|s| self.next(*s)).collect();
        let none: Vec<ExprId> = next.into_iter().map(|next| self.not(next)).collect();
        self.and([left].into_iter().chain(none))
    }

    /// When pulses of each kind are given to a grafcet.
    fn pulses_on(&mut self, g: GrafcetId) -> [ExprId; 4] {
        let mut given: [Vec<ExprId>; 4] = Default::default();
        for place in self.given[g].pulses.clone() {
            let pulse = self.net.pulses[place].clone();
            let commander = self.net.commander(pulse.event);
            let around = self.around_goes_on(commander);
            let occurs = match pulse.event {
                Event::Event(s, expr) => {
                    let active = self.active(s);
                    let goes_on = self.grafcet_goes_on(commander);
                    self.and([active, expr].into_iter().chain(goes_on))
                }
                Event::Clearing(t) => {
                    let bare = self.bare.get(&t).copied().unwrap_or(self.net.transitions[t].condition);
                    let clears = self.clears(t, None, bare);
                    let goes_on = self.grafcet_goes_on(commander);
                    self.and([clears].into_iter().chain(goes_on))
                }
                Event::Deactivation(s) => self.deactivated(s, goes_on),
                Event::Activation(s) => self.activated(s, |_| true),
                Event::EachScan(..) => continue,
            };
            let drops = !matches!(pulse.event, Event::Activation(_));
            let term = self.and([Some(occurs), around.filter(|_| drops)].into_iter().flatten());
            given[pulse.kind as usize].push(term);
        }
        let runs = self.given[g].runs.clone();
        if !runs.is_empty() {
            let begins = self.begins(&runs);
            let resumed: Vec<ExprId> = runs.iter().map(|s| self.activated(*s, |does| does == Does::Resumes)).collect();
            let resumed = self.or(resumed);
            let anew = self.not(resumed);
            let resume = self.and([begins, resumed]);
            given[PulseKind::Resume as usize].push(resume);
            let start = self.and([begins, anew]);
            given[PulseKind::Start as usize].push(start);
            let left: Vec<ExprId> = runs
                .iter()
                .map(|s| {
                    let left = self.deactivated(*s, goes_on);
                    let around = self.around_goes_on(self.net.places[*s].grafcet);
                    self.and([left].into_iter().chain(around))
                })
                .collect();
            let kill = self.ends_if(&runs, left);
            given[PulseKind::Kill as usize].push(kill);
        }
        given.map(|terms| self.or(terms))
    }

    /// That a grafcet is neither killed nor frozen while a step of it is active; nothing, if it never is.
    fn grafcet_goes_on(&mut self, g: GrafcetId) -> Option<ExprId> {
        let stops: Vec<ExprId> = [self.kills[g], self.freezes[g]].into_iter().flatten().collect();
        if stops.is_empty() {
            return None;
        }
        let stopped = self.or(stops);
        Some(self.not(stopped))
    }

    /// The same of what is around it.
    fn around_goes_on(&mut self, g: GrafcetId) -> Option<ExprId> {
        let around: Vec<GrafcetId> = self.around(g).collect();
        let terms: Vec<ExprId> = around.into_iter().filter_map(|g| self.grafcet_goes_on(g)).collect();
        (!terms.is_empty()).then(|| self.and(terms))
    }
}

/// Whether a network does what is neither a kill nor a freezing.
fn goes_on(does: Does) -> bool {
    !matches!(does, Does::Keeps | Does::All(Case::Kill | Case::Restart))
}
