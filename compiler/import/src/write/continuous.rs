//! What a step computes in each scan and resets at its exit, as the continuous action that it is.
//!
//! ```text
//! ACTION Fill_active : valve := Fill.X AND low; END_ACTION     valve if low
//! ACTION Fill_exit : valve := Fill.X AND low; END_ACTION
//! ```
//!
//! SFC has no other form for an assignment condition. Where nobody reads the variable, one step sets it, and its value is
//! made of inputs and times alone, both are the same.

use super::maker::{Action, Maker, When};
use super::terms::{StepId, TermId, TermKind, VarId};
use grafc_syntax::ast::Type;
use rustc_hash::FxHashMap;

/// What is stored into a variable.
#[derive(Default)]
struct Writes {
    /// In each scan: the step and the value.
    scan: Option<(StepId, TermId)>,
    /// By whom it is reset at the exit.
    reset: Option<StepId>,
    /// Something else.
    others: bool,
}

impl Maker<'_> {
    /// Makes continuous actions of what is stored like one.
    pub fn continuous(&mut self) {
        let mut writes: FxHashMap<VarId, Writes> = FxHashMap::default();
        let of_steps = self.step_texts.iter_enumerated();
        let of_steps = of_steps.flat_map(|(step, text)| text.actions.iter().map(move |action| (Some(step), action)));
        for (step, action) in of_steps.chain(self.always.iter().map(|action| (None, action))) {
            let (variable, value, when) = match *action {
                Action::Stored { variable, value, when } => (variable, value, when),
                Action::Continuous { variable, .. } => {
                    writes.entry(variable).or_default().others = true;
                    continue;
                }
                Action::Pulse { .. } | Action::Run { .. } => continue,
            };
            let known = writes.entry(variable).or_default();
            match (step, when) {
                (Some(step), When::EachScan(None)) if known.scan.is_none() => known.scan = Some((step, value)),
                (Some(step), When::Deactivation) if known.reset.is_none() && self.terms.is(value, false) => {
                    known.reset = Some(step);
                }
                _ => known.others = true,
            }
        }
        let mut found: Vec<(VarId, StepId, TermId)> = Vec::new();
        for (variable, writes) in writes {
            let own = &self.variables.list[variable];
            let Some((step, value)) = writes.scan else { continue };
            let is_one = writes.reset == Some(step) && !writes.others && own.ty == Type::Bool && !own.used.read;
            if is_one && !own.retain && self.is_of_inputs(value) {
                found.push((variable, step, value));
            }
        }
        found.sort_unstable_by_key(|(variable, step, _)| (*step, *variable));
        for (variable, step, value) in found {
            let condition = self.terms.unless_always(value);
            let actions = &mut self.step_texts[step].actions;
            let is_own =
                |action: &Action| matches!(action, Action::Stored { variable: other, .. } if *other == variable);
            let place = actions.iter().position(is_own).unwrap_or_default();
            actions.retain(|action| !is_own(action));
            actions.insert(place.min(actions.len()), Action::Continuous { variable, condition });
            let used = &mut self.variables.list[variable].used;
            (used.stored, used.by_name) = (false, true);
        }
    }

    /// Whether a value is made of times and of what nothing in the chart sets.
    pub(super) fn is_of_inputs(&self, value: TermId) -> bool {
        let mut only = true;
        let all = self.terms.parts(value, 10_000, |term| match term.kind {
            TermKind::Variable(variable) => {
                let used = self.variables.list[variable].used;
                only &= !used.stored && !used.by_name && !used.helper;
            }
            TermKind::Active(_)
            | TermKind::ChildActive(_)
            | TermKind::ChildFrozen(_)
            | TermKind::Rise(_)
            | TermKind::Fall(_)
            | TermKind::Delay { .. } => only = false,
            TermKind::Bool(_)
            | TermKind::Integer(_)
            | TermKind::Real(_)
            | TermKind::Duration(_)
            | TermKind::Time(_)
            | TermKind::Not(_)
            | TermKind::Negate(_)
            | TermKind::Or(..)
            | TermKind::Xor(..)
            | TermKind::And(..)
            | TermKind::Pair(..) => {}
        });
        all && only
    }
}
