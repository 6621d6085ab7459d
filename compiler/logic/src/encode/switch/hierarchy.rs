//! Enclosures and orders on the next situation, from the top of the hierarchy down.

use super::{Switch, assign_number, differs, next_in_set, uncovered, value_of, within};
use crate::encode::choose::choose;
use crate::encode::clearings::Clearings;
use crate::encode::settle;
use crate::encode::state_case::StateCase;
use crate::lower::Lowering;
use crate::scan::{Origin, Statement};
use grafc_model::chart::{GrafcetId, StepId};

impl Switch<'_> {
    /// Enclosures and orders, grafcet by grafcet from the top down (R5).
    pub(super) fn settle(&self, lowering: &mut Lowering, clearings: &mut Clearings) -> Vec<Statement> {
        let net = &*lowering.net.clone();
        let acted_on = settle::acted_on(net);
        let mut out = Vec::new();
        for g in &net.hierarchy {
            let around = within(net, *g).map(|e| uncovered::next(lowering, clearings, e));
            let known = &clearings.next;
            let mut next = |lowering: &mut Lowering, s: StepId| match known[s] {
                Some(next) => next,
                None => next_in_set(lowering, s),
            };
            let in_force = settle::orders(lowering, self.task.components, *g, around, &mut next, &mut out);
            out.extend(uncovered::settle(lowering, clearings, &acted_on, *g, around, in_force.as_ref()));
            if let Some(in_force) = in_force {
                for index in &self.layout.sets_of[*g] {
                    let set = lowering.situation.sets[*index].clone();
                    let mut branches = Vec::new();
                    for (when, steps) in &in_force.orders {
                        let member = steps.iter().find(|s| set.steps.binary_search(s).is_ok());
                        let value = member.map_or(set.idle, |s| value_of(lowering, *s));
                        let when = lowering.pool.and(around.into_iter().chain([*when]));
                        branches.push((when, vec![assign_number(lowering, Origin::Orders(*g), set.next, value)]));
                    }
                    out.extend(choose(lowering, branches));
                }
            }
            out.extend(self.enclose(lowering, clearings, *g));
        }
        // Events of covered steps compare the state with the next one.
        for s in net.places.indices() {
            if lowering.situation.bit(s).is_none() {
                clearings.next[s] = Some(next_in_set(lowering, s));
            }
        }
        out
    }

    /// What the steps of a grafcet enclose is emptied with them and starts with them (R5a).
    fn enclose(&self, lowering: &mut Lowering, clearings: &Clearings, g: GrafcetId) -> Vec<Statement> {
        let net = &*lowering.net.clone();
        let mut out = Vec::new();
        if self.layout.inside.is_empty() {
            return out;
        }
        for index in &self.layout.sets_of[g] {
            let set = lowering.situation.sets[*index].clone();
            let (mut left, mut come) = (StateCase::default(), StateCase::default());
            for s in &set.steps {
                let (emptied, started) = (self.emptied(lowering, *s), self.started(lowering, *s));
                left.add(lowering, *s, emptied);
                come.add(lowering, *s, started);
            }
            let body: Vec<Statement> = left.case(set.variable).into_iter().chain(come.case(set.next)).collect();
            if !body.is_empty() {
                let moves = differs(lowering, set.variable, set.next);
                out.extend(choose(lowering, vec![(moves, body)]));
            }
        }
        for s in &net.grafcets[g].steps {
            let Some(next) = clearings.next[*s].filter(|_| lowering.situation.bit(*s).is_some()) else { continue };
            let active = lowering.active(*s);
            let (gone, fresh) = (lowering.pool.not(next), lowering.pool.not(active));
            for (when, body) in [
                (lowering.pool.and([active, gone]), self.emptied(lowering, *s)),
                (lowering.pool.and([next, fresh]), self.started(lowering, *s)),
            ] {
                if !body.is_empty() {
                    out.extend(choose(lowering, vec![(when, body)]));
                }
            }
        }
        out
    }

    fn emptied(&self, lowering: &mut Lowering, e: StepId) -> Vec<Statement> {
        let mut body = Vec::new();
        for index in self.layout.enclosed(e) {
            let set = &lowering.situation.sets[index];
            let (next, idle) = (set.next, set.idle);
            body.push(assign_number(lowering, Origin::Step(e), next, idle));
        }
        body
    }

    fn started(&self, lowering: &mut Lowering, e: StepId) -> Vec<Statement> {
        let mut body = Vec::new();
        for index in self.layout.enclosed(e) {
            let set = &lowering.situation.sets[index];
            let (next, first) = (set.next, set.steps.iter().copied().find(|s| lowering.net.places[*s].activated));
            if let Some(s) = first {
                body.push(assign_number(lowering, Origin::Step(e), next, value_of(lowering, s)));
            }
        }
        body
    }
}
