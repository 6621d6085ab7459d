//! The situations of a commanded grafcet, and which order comes in which of them: those of its commanders and its own
//! together, all that conditions might let happen.

use super::{Does, Making, Refused};
use grafc_diagnostics::Span;
use grafc_model::chart::{Event, GrafcetId, PulseKind, StepId, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::{BTreeMap, BTreeSet};

/// More micro-steps are not tried.
const WORK: usize = 200_000;

/// A network with more situations is none that a person would read: each order is a transition from each of them. More
/// transitions after one step would not be compared either.
const SITUATIONS: usize = 100;

/// What is done to a grafcet as a whole.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum Case {
    /// What it is within is left.
    Ends,
    /// An order on it sets a situation.
    Forced(usize),
    /// Killed and started.
    Restart,
    /// Killed.
    Kill,
    /// Started while it rests or is kept.
    Start,
    /// Started and frozen at once.
    StartKept,
    /// Frozen.
    Freeze,
    /// Resumed.
    Resume,
    /// What it is within becomes active.
    Begins,
}

impl Case {
    /// Whether it comes while steps are active and they do not just go on.
    pub(super) fn keeps_from_clearing(self) -> bool {
        match self {
            Case::Ends | Case::Forced(_) | Case::Restart | Case::Kill | Case::Freeze => true,
            Case::Start | Case::StartKept | Case::Resume | Case::Begins => false,
        }
    }
}

/// What has been found.
#[derive(Default)]
pub(super) struct Explored {
    /// All situations, of steps, of the one in which the grafcet rests, and of twins.
    pub(super) situations: Vec<Vec<StepId>>,
    /// Which situation follows where something is done to one. Of a freezing it is that without clearings.
    pub(super) moves: BTreeMap<(Vec<StepId>, Case), Vec<StepId>>,
    /// Situations that something is done to, and that are what follows of it.
    pub(super) still: BTreeSet<(Vec<StepId>, Case)>,
    /// What comes at once.
    pub(super) meets: Meets,
    frozen_at: FxHashSet<StepId>,
    resumed_at: FxHashSet<StepId>,
}

/// Which orders may come at once, so that the conditions of some have to say that others do not.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Meets {
    pub(super) ends_forced: bool,
    pub(super) begins_forced: bool,
    pub(super) forced_pulse: bool,
    pub(super) kill_start: bool,
    pub(super) kill_freeze: bool,
    pub(super) kill_resume: bool,
    pub(super) start_freeze: bool,
    pub(super) resume_freeze: bool,
}

impl Explored {
    /// Whether a step may be active when the grafcet is frozen.
    pub(super) fn freezes_at(&self, s: StepId) -> bool {
        self.frozen_at.contains(&s)
    }

    /// Whether a step may be kept when the grafcet is resumed.
    pub(super) fn resumes_at(&self, s: StepId, twins: &FxHashMap<StepId, StepId>) -> bool {
        twins.get(&s).is_some_and(|twin| self.resumed_at.contains(twin))
    }
}

/// The transitions of a network.
pub(super) struct Moves<'n> {
    pub(super) net: &'n Net,
    pub(super) of: &'n [TransitionId],
    pub(super) does: &'n IndexVec<TransitionId, Does>,
    pub(super) from: &'n FxHashMap<TransitionId, Vec<StepId>>,
}

/// What happens to a network in a micro-step.
struct Happens {
    does: Does,
    cleared: Vec<TransitionId>,
    next: Vec<StepId>,
}

type Situation = Vec<StepId>;

fn sorted(mut steps: Situation) -> Situation {
    steps.sort_unstable();
    steps.dedup();
    steps
}

impl Moves<'_> {
    /// All that may happen in a situation, if it is not too much.
    fn options(&self, situation: &Situation, most: usize) -> Option<Vec<Happens>> {
        let mut found = Vec::new();
        let enabled = |wanted: Does| -> Vec<TransitionId> {
            let able = |t: &TransitionId| self.net.transitions[*t].pre.iter().all(|s| situation.contains(s));
            self.of.iter().copied().filter(|t| self.does[*t] == wanted).filter(able).collect()
        };
        let own = enabled(Does::Own);
        for cleared in self.independent(&own, most)? {
            found.push(self.happens(situation, Does::Own, cleared));
        }
        for t in self.of.iter().filter(|t| self.from.get(*t) == Some(situation)) {
            found.push(self.happens(situation, self.does[*t], vec![*t]));
        }
        let keeping = enabled(Does::Keeps);
        if !keeping.is_empty() {
            for cleared in self.independent(&keeping, most)? {
                let taken: usize = cleared.iter().map(|t| self.net.transitions[*t].pre.len()).sum();
                if taken == situation.len() {
                    found.push(self.happens(situation, Does::Keeps, cleared));
                }
            }
        }
        let resuming = enabled(Does::Resumes);
        if !resuming.is_empty() {
            found.push(self.happens(situation, Does::Resumes, resuming));
        }
        (found.len() <= most).then_some(found)
    }

    /// All sets of these transitions of which no two have a step before them in common.
    fn independent(&self, transitions: &[TransitionId], most: usize) -> Option<Vec<Vec<TransitionId>>> {
        let mut sets: Vec<Vec<TransitionId>> = vec![Vec::new()];
        for t in transitions {
            let pre = &self.net.transitions[*t].pre;
            let apart = |other: &TransitionId| !self.net.transitions[*other].pre.iter().any(|s| pre.contains(s));
            let with: Vec<Vec<TransitionId>> = sets
                .iter()
                .filter(|set| set.iter().all(apart))
                .map(|set| set.iter().copied().chain([*t]).collect())
                .collect();
            sets.extend(with);
            if sets.len() > most {
                return None;
            }
        }
        Some(sets)
    }

    fn happens(&self, situation: &Situation, does: Does, cleared: Vec<TransitionId>) -> Happens {
        let of = |t: &TransitionId| &self.net.transitions[*t];
        let left: Vec<StepId> = cleared.iter().flat_map(|t| of(t).pre.iter().copied()).collect();
        let mut next: Situation = situation.iter().copied().filter(|s| !left.contains(s)).collect();
        next.extend(cleared.iter().flat_map(|t| of(t).post.iter().copied()));
        Happens { does, cleared, next: sorted(next) }
    }
}

/// A commander in a micro-step.
struct Seen<'s> {
    old: &'s Situation,
    happens: &'s Happens,
    /// Whether it has an active step before.
    is_active: bool,
}

/// Whether something is given, as far as is known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Whether {
    No,
    Maybe,
    Yes,
}

impl From<bool> for Whether {
    fn from(yes: bool) -> Whether {
        if yes { Whether::Yes } else { Whether::No }
    }
}

impl Whether {
    fn or(self, other: Whether) -> Whether {
        match (self, other) {
            (Whether::Yes, _) | (_, Whether::Yes) => Whether::Yes,
            (Whether::No, Whether::No) => Whether::No,
            _ => Whether::Maybe,
        }
    }

    fn unless_no(self) -> Whether {
        if self == Whether::No { Whether::No } else { Whether::Maybe }
    }

    fn values(self) -> &'static [bool] {
        match self {
            Whether::No => &[false],
            Whether::Maybe => &[false, true],
            Whether::Yes => &[true],
        }
    }
}

/// Goes through the situations of a grafcet and its commanders.
pub(super) fn find(making: &Making, g: GrafcetId, rest: StepId) -> Result<Explored, Refused> {
    Explorer::new(making, g, rest).run()
}

struct Explorer<'m> {
    making: &'m Making,
    g: GrafcetId,
    span: Span,
    rest: StepId,
    commanders: Vec<GrafcetId>,
    started: Situation,
    linked: Situation,
    found: Explored,
}

impl<'m> Explorer<'m> {
    fn new(making: &'m Making, g: GrafcetId, rest: StepId) -> Explorer<'m> {
        let (net, given) = (&making.net, &making.given[g]);
        let of = |s: &StepId| net.places[*s].grafcet;
        let mut commanders: Vec<GrafcetId> = given.within.iter().chain(&given.runs).map(of).collect();
        commanders.extend(given.orders.iter().map(|(s, _)| of(s)));
        commanders.extend(given.pulses.iter().map(|place| net.commander(net.pulses[*place].event)));
        commanders.extend(&given.above);
        let around: Vec<GrafcetId> = commanders.iter().flat_map(|c| making.around(*c)).collect();
        commanders.extend(around.into_iter().filter(|c| making.given[*c].is_pulsed()));
        commanders.sort_unstable();
        commanders.dedup();
        let steps = &net.grafcets[g].steps;
        let which = |wanted: &dyn Fn(StepId) -> bool| steps.iter().copied().filter(|s| wanted(*s)).collect();
        Explorer {
            making,
            g,
            span: net.grafcets[g].span,
            rest,
            commanders,
            started: sorted(which(&|s| net.places[s].started)),
            linked: sorted(which(&|s| net.places[s].activated)),
            found: Explored::default(),
        }
    }

    /// What a network is in at the start.
    fn start(&self, g: GrafcetId) -> Situation {
        let net = &self.making.net;
        let own = net.places.iter_enumerated().filter(|(_, place)| place.grafcet == g && place.initial);
        sorted(own.map(|(s, _)| s).collect())
    }

    fn run(mut self) -> Result<Explored, Refused> {
        let making = self.making;
        let span = self.span;
        let too_many = |what: &str| (span, format!("is commanded and has too many situations{what}"));
        let first: Vec<Situation> = self.commanders.iter().chain([&self.g]).map(|c| self.start(*c)).collect();
        let mut seen: BTreeSet<Vec<Situation>> = BTreeSet::from([first.clone()]);
        let mut open = vec![first];
        let mut work = 0_usize;
        while let Some(joint) = open.pop() {
            let (own, commanders) = joint.split_last().expect("its own situation is the last");
            let mut options = Vec::new();
            for (c, situation) in self.commanders.iter().zip(commanders) {
                options
                    .push(making.moves(*c).options(situation, WORK).ok_or_else(|| too_many(", with its commanders"))?);
            }
            let count = options.iter().try_fold(1_usize, |count, options| count.checked_mul(options.len()));
            work = count.map_or(WORK + 1, |count| work.saturating_add(count));
            if work > WORK {
                return Err(too_many(", with its commanders"));
            }
            let is_active: Vec<bool> =
                self.commanders.iter().zip(commanders).map(|(c, situation)| self.is_active(*c, situation)).collect();
            let mut turn = vec![0_usize; options.len()];
            loop {
                let seen_of = |place: usize| Seen {
                    old: &commanders[place],
                    happens: &options[place][turn[place]],
                    is_active: is_active[place],
                };
                let chosen: Vec<Seen> = (0..options.len()).map(seen_of).collect();
                for next in self.answers(own, &chosen)? {
                    let mut joint: Vec<Situation> = chosen.iter().map(|seen| seen.happens.next.clone()).collect();
                    joint.push(next);
                    if seen.insert(joint.clone()) {
                        open.push(joint);
                    }
                    work += 1;
                }
                let Some(place) = (0..turn.len()).find(|place| turn[*place] + 1 < options[*place].len()) else { break };
                turn[place] += 1;
                turn[..place].fill(0);
            }
        }
        let situations: BTreeSet<&Situation> = seen.iter().filter_map(|joint| joint.last()).collect();
        if situations.len() > SITUATIONS {
            return Err(too_many(""));
        }
        self.found.situations = situations.into_iter().cloned().collect();
        Ok(self.found)
    }

    /// Whether a step of the chart is active in a network.
    fn is_active(&self, c: GrafcetId, situation: &Situation) -> bool {
        situation.iter().any(|s| self.making.net.grafcets[c].steps.contains(s))
    }

    fn seen<'s, 'c>(&self, chosen: &'s [Seen<'c>], c: GrafcetId) -> Option<&'s Seen<'c>> {
        self.commanders.iter().position(|known| *known == c).map(|place| &chosen[place])
    }

    fn was(&self, chosen: &[Seen], s: StepId) -> bool {
        self.seen(chosen, self.making.net.places[s].grafcet).is_some_and(|seen| seen.old.contains(&s))
    }

    fn is(&self, chosen: &[Seen], s: StepId) -> bool {
        self.seen(chosen, self.making.net.places[s].grafcet).is_some_and(|seen| seen.happens.next.contains(&s))
    }

    /// Whether a grafcet is killed or frozen, or what is around it (R15.1).
    fn stopped(&self, chosen: &[Seen], c: GrafcetId) -> bool {
        let around = self.making.around(c);
        std::iter::once(c).chain(around).any(|c| {
            self.seen(chosen, c)
                .is_some_and(|seen| matches!(seen.happens.does, Does::Keeps | Does::All(Case::Kill | Case::Restart)))
        })
    }

    /// Pulses that commanders give, by kind, and what is passed on of a kill and of a freezing.
    fn given(&self, chosen: &[Seen]) -> ([Whether; 4], [Whether; 2]) {
        let (net, given) = (&self.making.net, &self.making.given[self.g]);
        let mut kinds = [Whether::No; 4];
        let mut give = |kind: PulseKind, known: Whether| kinds[kind as usize] = kinds[kind as usize].or(known);
        for pulse in given.pulses.iter().map(|place| &net.pulses[*place]) {
            let goes_on = !self.stopped(chosen, net.commander(pulse.event));
            let known = match pulse.event {
                Event::Event(s, _) => Whether::from(goes_on && self.was(chosen, s)).unless_no(),
                Event::Deactivation(s) => (goes_on && self.was(chosen, s) && !self.is(chosen, s)).into(),
                Event::Activation(s) => (self.is(chosen, s) && !self.was(chosen, s)).into(),
                Event::Clearing(t) => {
                    let seen = self.seen(chosen, net.transitions[t].grafcet);
                    let clears = |seen: &Seen| seen.happens.cleared.contains(&t);
                    // A forced grafcet, or one that is left, may clear it all the same.
                    let hidden = |seen: &Seen| matches!(seen.happens.does, Does::All(_));
                    let enabled = net.transitions[t].pre.iter().all(|s| self.was(chosen, *s));
                    match seen {
                        Some(seen) if clears(seen) => goes_on.into(),
                        Some(seen) if enabled && hidden(seen) => Whether::from(goes_on).unless_no(),
                        Some(_) => Whether::No,
                        None => Whether::Maybe,
                    }
                }
                Event::EachScan(..) => Whether::No,
            };
            give(pulse.kind, known);
        }
        let runs = &given.runs;
        let (was, is) = (runs.iter().any(|s| self.was(chosen, *s)), runs.iter().any(|s| self.is(chosen, *s)));
        if is && !was {
            let resumed = runs.iter().any(|s| {
                self.is(chosen, *s)
                    && self.seen(chosen, net.places[*s].grafcet).is_some_and(|seen| seen.happens.does == Does::Resumes)
            });
            give(if resumed { PulseKind::Resume } else { PulseKind::Start }, Whether::Yes);
        }
        let goes_on = |s: &&StepId| self.was(chosen, **s) && !self.stopped(chosen, net.places[**s].grafcet);
        if was && !is && runs.iter().any(|s| goes_on(&s)) {
            give(PulseKind::Kill, Whether::Yes);
        }
        let mut passed = [Whether::No; 2];
        for above in &given.above {
            let Some(seen) = self.seen(chosen, *above) else { continue };
            let own = seen.happens.does == Does::Own && seen.is_active;
            let kill = match seen.happens.does {
                _ if self.making.kills[*above].is_none() || own => Whether::No,
                Does::All(Case::Kill | Case::Restart) => Whether::Yes,
                Does::Keeps | Does::Resumes => Whether::No,
                Does::Own | Does::All(_) => Whether::Maybe,
            };
            let freeze = match seen.happens.does {
                _ if self.making.freezes[*above].is_none() || own => Whether::No,
                Does::Keeps | Does::All(Case::StartKept) => Whether::Yes,
                Does::Resumes => Whether::No,
                Does::Own | Does::All(_) => Whether::Maybe,
            };
            passed = [passed[0].or(kill), passed[1].or(freeze)];
        }
        (kinds, passed)
    }

    /// The situations that may follow of the grafcet's own.
    fn answers(&mut self, own: &Situation, chosen: &[Seen]) -> Result<Vec<Situation>, Refused> {
        let given = &self.making.given[self.g];
        let within = &given.within;
        let was = within.is_empty() || within.iter().any(|s| self.was(chosen, *s));
        let is = within.is_empty() || within.iter().any(|s| self.is(chosen, *s));
        let order = given.orders.iter().position(|(s, _)| self.is(chosen, *s));
        let forced = order.and_then(|order| Some((order, given.orders[order].1.clone()?)));
        self.found.meets.ends_forced |= was && !is && forced.is_some();
        self.found.meets.begins_forced |= !was && is && forced.is_some();
        if !is {
            let next = vec![self.rest];
            if was {
                self.note(own, Case::Ends, &next)?;
            }
            return Ok(vec![next]);
        }
        let kept = given.keepers.iter().any(|s| self.was(chosen, *s));
        let (kinds, passed) = self.given(chosen);
        let mut found = Vec::new();
        let [kill, resume, start, freeze] = kinds.map(Whether::values);
        for direct in combinations([kill, resume, start, freeze]) {
            let [kill, resume, start, freeze] = direct;
            let kinds = direct.into_iter().filter(|given| *given).count();
            // A kill with a start is a restart (R15.1).
            if kinds > 2 || kinds == 2 && !(kill && start) {
                let why = "may be given different pulse orders at once, which no flag would tell";
                return Err((self.span, why.to_owned()));
            }
            for [above_kills, above_freezes] in combinations(passed.map(Whether::values)) {
                let (kill, freeze) = (kill || above_kills, freeze || above_freezes);
                let meets = &mut self.found.meets;
                meets.forced_pulse |= forced.is_some() && (kill || resume || start || freeze);
                meets.kill_start |= kill && start;
                meets.kill_freeze |= kill && freeze;
                meets.kill_resume |= kill && resume;
                meets.start_freeze |= start && freeze;
                meets.resume_freeze |= resume && freeze;
                if let Some((order, set)) = &forced {
                    let next = if set.is_empty() { vec![self.rest] } else { sorted(set.clone()) };
                    self.note(own, Case::Forced(*order), &next)?;
                    found.push(next);
                } else if !was {
                    let next = if self.linked.is_empty() { vec![self.rest] } else { self.linked.clone() };
                    self.note(own, Case::Begins, &next)?;
                    found.push(next);
                } else {
                    found.extend(self.pulsed(own, [kill, resume, start, freeze], kept)?);
                }
            }
        }
        Ok(found)
    }

    /// What pulse orders, or none, make of a situation.
    fn pulsed(
        &mut self,
        own: &Situation,
        [kill, resume, start, freeze]: [bool; 4],
        kept: bool,
    ) -> Result<Vec<Situation>, Refused> {
        let started = if self.started.is_empty() { vec![self.rest] } else { self.started.clone() };
        let twins = |making: &Making, situation: &Situation| -> Situation {
            sorted(situation.iter().filter_map(|s| making.twins.get(s).copied()).collect())
        };
        let is_active = self.is_active(self.g, own);
        let is_frozen = !is_active && *own != [self.rest];
        let (case, next) = if !is_active && start {
            if freeze && !kill && started != [self.rest] {
                (Case::StartKept, twins(self.making, &started))
            } else {
                (Case::Start, started)
            }
        } else if kill {
            if start { (Case::Restart, started) } else { (Case::Kill, vec![self.rest]) }
        } else if is_active && start {
            return Err((self.span, "may be started while it is active, which adds its initial steps".to_owned()));
        } else if is_frozen && resume && !freeze {
            let kept = |s: &StepId| self.making.twins.get(s).is_some_and(|twin| own.contains(twin));
            self.found.resumed_at.extend(own.iter().copied());
            let steps = &self.making.net.grafcets[self.g].steps;
            (Case::Resume, sorted(steps.iter().copied().filter(kept).collect()))
        } else {
            let mut after = vec![own.clone()];
            if !kept && is_active {
                let options = self.making.moves(self.g).options(own, WORK);
                let options =
                    options.ok_or_else(|| (self.span, "is commanded and has too many situations".to_owned()))?;
                after = options.into_iter().map(|happens| happens.next).collect();
            }
            if freeze && is_active {
                self.found.frozen_at.extend(own.iter().copied());
                self.found.moves.insert((own.clone(), Case::Freeze), twins(self.making, own));
                after = after.iter().map(|situation| twins(self.making, situation)).collect();
            }
            return Ok(after);
        };
        self.note(own, case, &next)?;
        Ok(vec![next])
    }

    /// Notes what is done to a situation as a whole.
    fn note(&mut self, own: &Situation, case: Case, next: &Situation) -> Result<(), Refused> {
        if own == next {
            self.found.still.insert((own.clone(), case));
            return Ok(());
        }
        let leaves = own.iter().any(|s| !next.contains(s));
        let enters = next.iter().any(|s| !own.contains(s));
        if case != Case::Resume && !(leaves && enters) {
            let why = "is commanded from a situation into one with some of the same steps, and more or fewer of them";
            return Err((self.span, why.to_owned()));
        }
        self.found.moves.insert((own.clone(), case), next.clone());
        Ok(())
    }
}

/// All choices of a value each.
fn combinations<const N: usize>(values: [&[bool]; N]) -> Vec<[bool; N]> {
    let mut all = vec![[false; N]];
    for (place, values) in values.into_iter().enumerate() {
        all = all
            .into_iter()
            .flat_map(|chosen| {
                values.iter().map(move |value| {
                    let mut chosen = chosen;
                    chosen[place] = *value;
                    chosen
                })
            })
            .collect();
    }
    all
}
