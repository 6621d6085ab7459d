//! What a program shows of its micro-steps to somebody who looks on: variables of the role `Observed`, which nothing reads
//! but a target.
//!
//! ```text
//! conditions of the micro-step
//! enabled_t := X_pre AND X_e AND NOT frozen;  cleared_t := enabled_t AND condition        transitions
//! …                                                                       the micro-step itself
//! frozen_G, forced_s, order_w of the situation reached                                    situation
//! done_a of stored actions, from what was and what is;  acts_a with the outputs           actions
//! ```
//!
//! All of it is written anew from the net and the rules, whatever the encoding has proved, left out or put elsewhere.

mod actions;
mod delays;
mod situation;
mod transitions;

use crate::encode::input_event::InputEvent;
use crate::encode::task::Task;
use crate::lower::{Context, Lowering, Moment};
use crate::scan::{Observed, Observing, Origin, Statement, VarId};
use actions::{Acting, Done};
use grafc_formula::FormulaId;
use grafc_model::chart::TransitionId;
use grafc_model::reaction::Profile;
use index_vec::IndexVec;

/// What is shown, and what waits for later sections.
pub(crate) struct Watch {
    observed: Observed,
    observing: Observing,
    done: Done,
    acting: Acting,
}

impl Watch {
    /// Nothing is looked at so far.
    pub(crate) fn new(observed: Observed) -> Option<Watch> {
        (observed != Observed::Nothing).then(|| Watch {
            observed,
            observing: Observing { observed, ..Observing::default() },
            done: Done::default(),
            acting: Acting::default(),
        })
    }

    fn all(&self) -> bool {
        self.observed == Observed::All
    }

    /// Before anything of a micro-step is written: from the old situation, with conditions as the chart has them.
    pub(crate) fn before(
        &mut self,
        lowering: &mut Lowering,
        task: &Task,
        conditions: &IndexVec<TransitionId, FormulaId>,
        input_event: &mut InputEvent,
    ) -> Vec<Statement> {
        let mut out = transitions::statements(lowering, task, conditions, self.observed, &mut self.observing);
        if self.all() {
            out.extend(self.done.before(lowering, task, &mut self.observing, input_event));
        }
        out
    }

    /// At the end of a micro-step: of the situation reached, and what was done on the way.
    pub(crate) fn after_micro_step(&mut self, lowering: &mut Lowering, profile: Profile) -> Vec<Statement> {
        if !self.all() {
            return Vec::new();
        }
        let mut out = situation::statements(lowering, &mut self.observing);
        out.extend(self.done.after(lowering, &mut self.acting, profile));
        out
    }

    /// With the outputs, before anything overrides them: wires that nothing else computes, and which actions assign.
    pub(crate) fn with_outputs(&mut self, lowering: &mut Lowering) -> Vec<Statement> {
        if !self.all() {
            return Vec::new();
        }
        actions::continuous(lowering, Context::new(Moment::After), &mut self.acting)
    }

    /// What says of continuous actions on outputs whether they act: what overrides outputs overrides this as well.
    pub(crate) fn acting_on_outputs(&self, lowering: &Lowering) -> Vec<(VarId, Origin)> {
        self.acting.on_outputs(&lowering.net)
    }

    /// What the initial reaction has to write for it.
    pub(crate) fn at_start(&self, lowering: &mut Lowering) -> Option<Statement> {
        self.done.at_start(lowering)
    }

    /// The same of a situation that has been given back.
    pub(crate) fn restored(&mut self, lowering: &mut Lowering) -> Vec<Statement> {
        if !self.all() {
            return Vec::new();
        }
        let mut out = situation::statements(lowering, &mut self.observing);
        out.extend(actions::continuous(lowering, Context::new(Moment::Restored), &mut self.acting));
        out
    }

    /// The table of what is shown.
    pub(crate) fn finish(mut self, lowering: &Lowering) -> Observing {
        if self.all() {
            self.observing.delays = delays::seen(lowering);
        }
        self.observing.actions = self.acting.by_place.into_iter().collect();
        self.observing
    }
}
