//! What the next situation brings about: another micro-step, outputs that follow a state, and the situation itself.

use super::moves::changes_of;
use super::{Switch, assign_number, assign_truth, copy, differs, encloser, entered, uncovered};
use crate::encode::choose::choose;
use crate::encode::clearings::Clearings;
use crate::encode::pulses::Pulses;
use crate::encode::state_case::StateCase;
use crate::lower::Lowering;
use crate::lower::situation::Set;
use crate::scan::{Origin, Statement, Told};
use grafc_model::chart::TransitionId;
use index_vec::IndexVec;

impl Switch<'_> {
    /// Bits that change ask for another micro-step; states have done so when they were written.
    pub(super) fn tell_changed_bits(
        &self,
        lowering: &mut Lowering,
        clearings: &Clearings,
        pulses: Option<&Pulses>,
    ) -> Option<Statement> {
        let again = self.task.again?;
        let commanded = lowering.net.commanded();
        let is_told =
            |t: TransitionId| commanded[lowering.net.transitions[t].grafcet] || !changes_of(lowering, t).is_empty();
        let told: IndexVec<TransitionId, bool> = lowering.net.transitions.indices().map(is_told).collect();
        let mut terms = clearings.changes(lowering, self.task, |_| false, |t| told[t]);
        terms.extend(uncovered::commanded(lowering, clearings, pulses));
        if terms.is_empty() {
            return None;
        }
        terms.insert(0, lowering.symbols.read(&mut lowering.pool, again));
        Some(Statement::assign(Origin::Chart, again, lowering.pool.or(terms)))
    }

    /// Outputs that follow a state.
    pub(super) fn follow(&self, lowering: &mut Lowering) -> Vec<Statement> {
        let mut out = Vec::new();
        let Some(followers) = self.task.followers else { return out };
        for (index, wires) in followers.of_set.iter().enumerate() {
            if wires.is_empty() {
                continue;
            }
            let set = lowering.situation.sets[index].clone();
            let (mut left, mut come) = (StateCase::default(), StateCase::default());
            for s in &set.steps {
                let mut off = Vec::new();
                for (wire, _) in followers.on_step(&lowering.net, *s) {
                    let target = lowering.symbols.declared(wire);
                    off.push(assign_truth(lowering, followers.origin(&lowering.net, *s, wire), target, false));
                }
                let on = entered(lowering, followers, *s);
                left.add(lowering, *s, off);
                come.add(lowering, *s, on);
            }
            let body: Vec<Statement> = left.case(set.variable).into_iter().chain(come.case(set.next)).collect();
            let moves = differs(lowering, set.variable, set.next);
            out.extend(choose(lowering, vec![(moves, body)]));
        }
        out
    }

    /// The next situation becomes the situation, from the bottom up: a state is read until what it encloses is written.
    pub(super) fn commit(&self, lowering: &mut Lowering, clearings: &Clearings) -> Vec<Statement> {
        let net = &*lowering.net.clone();
        let mut out = uncovered::commit(lowering, clearings, Told::Nothing);
        for g in net.hierarchy.iter().rev() {
            for index in &self.layout.sets_of[*g] {
                let set = lowering.situation.sets[*index].clone();
                out.extend(self.commit_enclosed(lowering, &set));
                let by_encloser = encloser(lowering, *g).is_some() && !self.layout.forced[*g];
                if !by_encloser {
                    out.push(copy(lowering, Origin::Chart, set.variable, set.next));
                }
            }
        }
        for variable in self.numbered.variable.values() {
            out.push(assign_number(lowering, Origin::Chart, *variable, 0));
        }
        out
    }

    /// Only what the step that was active and the one that will be enclose can have moved.
    fn commit_enclosed(&self, lowering: &mut Lowering, set: &Set) -> Vec<Statement> {
        let (mut was, mut will) = (StateCase::default(), StateCase::default());
        for s in &set.steps {
            let mut body = Vec::new();
            for index in self.layout.enclosed(*s) {
                let inner = &lowering.situation.sets[index];
                if !self.layout.forced[inner.grafcet] {
                    let (variable, next) = (inner.variable, inner.next);
                    body.push(copy(lowering, Origin::Step(*s), variable, next));
                }
            }
            was.add(lowering, *s, body.clone());
            will.add(lowering, *s, body);
        }
        let mut out: Vec<Statement> = was.case(set.variable).into_iter().collect();
        if let Some(case) = will.case(set.next) {
            let moves = differs(lowering, set.variable, set.next);
            out.extend(choose(lowering, vec![(moves, vec![case])]));
        }
        out
    }
}
