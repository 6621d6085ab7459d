//! All situations that a part of a net can come to, where there are not too many to be found.
//!
//! A *part* is what transitions connect (`parts`). Its situations are those that come of a few first ones by clearings:
//!
//! - the initial situation, as R5 and R10 settle it;
//! - if the grafcet is within a step, the empty one, and the steps with activation links;
//! - each situation that an order forces on the grafcet.
//!
//! Every situation of the part, after whichever micro-step, is among them. Proof, by induction over micro-steps. What R3
//! and R4 make of a situation of the part comes of it by clearings of transitions whose steps before are active, as `moves`
//! takes them together; that some of these are kept from clearing, by freezing, by an inactive enclosing step or by their
//! conditions, only leaves some out. Then R5: where the enclosing step is inactive, the part is empty. Where it starts, the
//! part was empty and nothing in it has cleared, for nothing in it was enabled, so that the links alone are active. An
//! order in force leaves what it finds, or makes the situation of the grafcet the forced one. So it does not matter which
//! step forces or encloses, and when.
//!
//! Since each micro-step stays among them, so do all situations of an evolution, transient ones included, however many
//! micro-steps a call has and wherever LIVELOCK ends it: what is proved holds with `--evolution stable` and `scan` alike.
//! It does not hold where steps overlap; see [`Encoding::overlaps`](crate::Encoding::overlaps).
//!
//! There may be more situations here than the chart ever comes to: inputs, variables and other parts are taken to be free.
//! What is never met here never happens; what is met here may not.
//!
//! The work is counted and bounded by the size of the net, never timed.

pub(crate) mod known;
mod moves;
pub(crate) mod parts;
mod sets;
#[cfg(test)]
mod tests;

use super::Conditions;
use super::canonical::Canonical;
use super::rivals::Rivals;
use grafc_formula::exclusion::EdgeFacts;
use grafc_model::chart::{StepId, TransitionId};
use index_vec::IndexVec;
use known::Known;
use moves::Question;
use parts::Part;
use rustc_hash::{FxHashMap, FxHashSet};
use sets::Diagram;
use std::sync::Arc;

/// Larger parts are not looked at.
const STEPS: usize = 256;

/// Nor those with more arcs.
const ARCS: usize = 2_048;

/// The work allowed for each step of a part.
const WORK: usize = 64;

/// The work that all parts may share beyond that.
const SHARED: usize = 1_000_000;

/// The situations of those parts of which they were found.
#[derive(Clone)]
pub(crate) struct Reachable {
    parts: Arc<Vec<Reached>>,
    /// The part of a step, and its number there.
    part_of: IndexVec<StepId, Option<(u32, u16)>>,
}

/// The situations of a part.
pub(crate) struct Reached {
    /// The steps, those of one branch together.
    pub(crate) steps: Vec<StepId>,
    situations: Diagram,
    /// For each step the steps that are active together with it in some situation, a bit each.
    together: Vec<u64>,
    entering_active: FxHashSet<(TransitionId, StepId)>,
    meeting: FxHashSet<(TransitionId, TransitionId)>,
}

impl Reachable {
    /// The situations of the parts that are `wanted`, beside those that are known.
    pub(crate) fn find(
        canonical: &Canonical,
        parts: &[Part],
        conditions: &Conditions,
        facts: &EdgeFacts,
        rivals: &Rivals,
        known: &[Known],
        wanted: impl Fn(&Part) -> bool,
    ) -> Reachable {
        let is_known: FxHashSet<StepId> = known.iter().flat_map(|known| known.steps.iter().copied()).collect();
        let unknown = |part: &Part| !part.steps.iter().any(|s| is_known.contains(&canonical.step[*s]));
        let compared = |part: &Part| !part.steps.iter().any(|s| rivals.many(canonical.step[*s]));
        let small = |part: &Part| part.steps.len() <= STEPS && part.arcs <= ARCS;
        let wanted: Vec<&Part> =
            parts.iter().filter(|part| small(part) && compared(part) && unknown(part) && wanted(part)).collect();
        let mut found = Vec::new();
        let mut part_of: IndexVec<StepId, Option<(u32, u16)>> = canonical.net.places.iter().map(|_| None).collect();
        for part in &wanted {
            let number = part.steps.iter().zip(0..).map(|(s, number)| (*s, number)).collect();
            let question = Question { canonical, part, conditions, facts, rivals, number: &number };
            let allowed = WORK * part.steps.len() + SHARED / wanted.len();
            let Some(reached) = Reached::find(&question, allowed) else { continue };
            for (s, step) in reached.steps.iter().zip(0..) {
                part_of[*s] = Some((found.len() as u32, step));
            }
            found.push(reached);
        }
        for reached in known.iter().filter_map(|known| known.reached(canonical.net.places.len(), rivals)) {
            for (s, step) in reached.steps.iter().zip(0..) {
                part_of[*s] = Some((found.len() as u32, step));
            }
            found.push(reached);
        }
        Reachable { parts: Arc::new(found), part_of }
    }

    /// The parts of which all situations are known.
    pub(crate) fn parts(&self) -> &[Reached] {
        &self.parts
    }

    /// The part of a step.
    pub(crate) fn part(&self, s: StepId) -> Option<&Reached> {
        self.part_of[s].map(|(part, _)| &self.parts[part as usize])
    }

    /// Whether two steps of one part may be active together.
    pub(crate) fn together(&self, a: StepId, b: StepId) -> Option<bool> {
        let ((part, a), (other, b)) = (self.part_of[a]?, self.part_of[b]?);
        (part == other).then(|| self.parts[part as usize].are_together(a, b))
    }

    /// Whether some situation may hold all of these steps, as far as is known.
    pub(crate) fn all_active(&self, steps: &[StepId]) -> bool {
        let mut of: FxHashMap<u32, Vec<(u16, bool)>> = FxHashMap::default();
        for (part, number) in steps.iter().filter_map(|s| self.part_of[*s]) {
            of.entry(part).or_default().push((number, true));
        }
        of.into_iter().all(|(part, mut wanted)| {
            wanted.sort_unstable();
            wanted.dedup();
            self.parts[part as usize].situations.has(&wanted)
        })
    }
}

impl Reached {
    fn find(question: &Question, allowed: usize) -> Option<Reached> {
        let closure = moves::close(question, allowed)?;
        let canonical = question.canonical;
        let (step, transition) = (|s: StepId| canonical.step[s], |t: TransitionId| canonical.transition[t]);
        let situations = closure.sets.only(closure.reached);
        let steps: Vec<StepId> = question.part.steps.iter().map(|s| step(*s)).collect();
        let together = together(&situations, steps.len());
        let entering_active = closure.entering_active.into_iter().map(|(t, s)| (transition(t), step(s))).collect();
        let pair = |(a, b)| {
            let (a, b): (TransitionId, TransitionId) = (transition(a), transition(b));
            (a.min(b), a.max(b))
        };
        let meeting = closure.meeting.into_iter().map(pair).collect();
        Some(Reached { steps, situations, together, entering_active, meeting })
    }

    fn are_together(&self, a: u16, b: u16) -> bool {
        let words = self.steps.len().div_ceil(64);
        self.together[usize::from(a) * words + usize::from(b) / 64] >> (b % 64) & 1 == 1
    }

    /// Whether a transition may clear while a step after it, which it does not leave, is active.
    pub(crate) fn enters_active(&self, t: TransitionId, s: StepId) -> bool {
        self.entering_active.contains(&(t, s))
    }

    /// Whether two rivals may clear in one micro-step.
    pub(crate) fn meet(&self, a: TransitionId, b: TransitionId) -> bool {
        self.meeting.contains(&(a.min(b), a.max(b)))
    }

    /// Whether in every situation one of these steps is active; they are given by their place in `steps`.
    pub(crate) fn always_one_of(&self, places: &[usize]) -> bool {
        let mut none: Vec<(u16, bool)> = places.iter().map(|place| (*place as u16, false)).collect();
        none.sort_unstable();
        !self.situations.has(&none)
    }

    /// The situations, each with its active steps in order of declaration; none if there are more than that.
    pub(crate) fn situations(&self, most: usize) -> Option<Vec<Vec<StepId>>> {
        let named = |places: Vec<u16>| {
            let mut steps: Vec<StepId> = places.iter().map(|place| self.steps[usize::from(*place)]).collect();
            steps.sort_unstable();
            steps
        };
        let mut situations: Vec<Vec<StepId>> = self.situations.each(most)?.into_iter().map(named).collect();
        situations.sort_unstable();
        Some(situations)
    }

    /// How many situations there are, if that is no astronomical number.
    pub(crate) fn count(&self) -> Option<u64> {
        self.situations.count()
    }
}

/// Which steps are active together in some situation.
fn together(situations: &Diagram, steps: usize) -> Vec<u64> {
    let words = steps.div_ceil(64);
    let mut together = vec![0_u64; steps * words];
    // The steps that are active somewhere in what a node holds.
    let mut below: Vec<Vec<u64>> = vec![vec![0; words]; 2];
    for node in &situations.nodes[2..] {
        let with = &below[node.with as usize];
        let mut all = with.clone();
        let s = usize::from(node.step);
        for (word, bits) in with.iter().enumerate() {
            together[s * words + word] |= bits;
        }
        for (all, bits) in all.iter_mut().zip(&below[node.without as usize]) {
            *all |= bits;
        }
        all[s / 64] |= 1 << (s % 64);
        below.push(all);
    }
    for a in 0..steps {
        for b in 0..a {
            let is = |x: usize, y: usize| together[x * words + y / 64] >> (y % 64) & 1;
            let either = is(a, b) | is(b, a);
            together[a * words + b / 64] |= either << (b % 64);
            together[b * words + a / 64] |= either << (a % 64);
        }
    }
    together
}
