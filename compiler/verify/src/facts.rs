//! What is seen of micro-steps: what claims that are always asked count (all micro-steps, initial and livelocked ones too).

use grafc_logic::scan::{Flag, Program, Role, StepId, TransitionId, VarId};
use indexmap::IndexSet;
use rustc_hash::FxBuildHasher;

/// Something that happened in a micro-step.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(crate) enum Fact {
    /// A step was active, at the start or after a micro-step.
    Active(StepId),
    /// A transition was cleared.
    Cleared(TransitionId),
    /// Two transitions after this step were cleared together.
    Selection(StepId),
    /// A step was activated by a clearing while it was active, and was not deactivated in that micro-step.
    Reentry(StepId),
    /// Stored actions gave a variable different values.
    AllocConflict,
    /// Orders on a grafcet asked for different situations.
    ForceConflict,
    /// The reaction would not end (R9).
    Livelock,
    /// In the state reached, what this assertion says is false.
    Broken(usize),
    /// In the state reached, what this claim wants is true.
    Wanted(usize),
}

/// Which steps are active, by their places.
pub(crate) type Active = Vec<bool>;

/// Looks at micro-steps.
pub(crate) struct Facts {
    /// The steps before each transition of the chart, and those after it.
    around: Vec<(Vec<StepId>, Vec<StepId>)>,
    flags: Vec<(VarId, Fact)>,
    seen: IndexSet<Fact, FxBuildHasher>,
    /// By step, whether a transition before it was cleared, and how many after it.
    entered: Vec<bool>,
    left: Vec<u32>,
}

impl Facts {
    /// For the transitions and flags of a program.
    pub(crate) fn new(program: &Program) -> Facts {
        let transitions = program.observing.iter().flat_map(|observing| &observing.transitions);
        let of = |t: TransitionId| {
            let (before, after) = program.elements.around(t);
            (before.to_vec(), after.to_vec())
        };
        let conflicts = [(Flag::AllocConflict, Fact::AllocConflict), (Flag::ForceConflict, Fact::ForceConflict)];
        let flags = conflicts
            .into_iter()
            .flat_map(|(flag, fact)| program.of_role(Role::Flag(flag)).map(move |(v, _)| (v, fact)));
        Facts {
            around: transitions.map(|seen| of(seen.transition)).collect(),
            flags: flags.collect(),
            seen: IndexSet::default(),
            entered: vec![false; program.steps.len()],
            left: vec![0; program.steps.len()],
        }
    }

    /// A reaction begins.
    pub(crate) fn forget(&mut self) {
        self.seen.clear();
    }

    /// What was seen since then.
    pub(crate) fn seen(&self) -> impl Iterator<Item = Fact> + '_ {
        self.seen.iter().copied()
    }

    /// A fact.
    pub(crate) fn note(&mut self, fact: Fact) {
        self.seen.insert(fact);
    }

    /// The flags that can tell of a conflict.
    pub(crate) fn flags(&self) -> impl Iterator<Item = (VarId, Fact)> + use<> {
        self.flags.clone().into_iter()
    }

    /// A situation.
    pub(crate) fn situation(&mut self, active: &[bool]) {
        for (s, _) in active.iter().enumerate().filter(|(_, active)| **active) {
            self.seen.insert(Fact::Active(StepId::from_usize(s)));
        }
    }

    /// A micro-step from a situation to another by these transitions.
    pub(crate) fn micro_step(&mut self, before: &[bool], cleared: &[TransitionId], after: &[bool]) {
        self.situation(after);
        for t in cleared {
            self.seen.insert(Fact::Cleared(*t));
        }
        let around = |t: &TransitionId| self.around.get(t.index());
        let is_of_chart = |s: &&StepId| s.index() < before.len();
        for (pre, post) in cleared.iter().filter_map(around) {
            for s in pre.iter().filter(is_of_chart) {
                self.left[s.index()] += 1;
            }
            for s in post.iter().filter(is_of_chart) {
                self.entered[s.index()] = true;
            }
        }
        for (pre, post) in cleared.iter().filter_map(around) {
            for s in pre.iter().chain(post).filter(is_of_chart) {
                let place = s.index();
                if self.left[place] > 1 {
                    self.seen.insert(Fact::Selection(*s));
                }
                if self.entered[place] && self.left[place] == 0 && before[place] && after[place] {
                    self.seen.insert(Fact::Reentry(*s));
                }
            }
        }
        for (pre, post) in cleared.iter().filter_map(around) {
            for s in pre.iter().chain(post).filter(is_of_chart) {
                (self.left[s.index()], self.entered[s.index()]) = (0, false);
            }
        }
    }
}
