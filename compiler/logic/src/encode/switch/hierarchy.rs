//! Enclosures and orders on the next situation, from the top of the hierarchy down.

use super::{Switch, assign_number, differs, next_in_set, origin_around, uncovered, value_of};
use crate::encode::choose::choose;
use crate::encode::clearings::Clearings;
use crate::encode::pulses::Pulses;
use crate::encode::settle;
use crate::encode::state_case::StateCase;
use crate::lower::Lowering;
use crate::scan::{Origin, Statement};
use grafc_formula::FormulaId;
use grafc_model::chart::{GrafcetId, StepId};

impl Switch<'_> {
    /// Enclosures and orders, grafcet by grafcet from the top down (R5).
    pub(super) fn settle(
        &self,
        lowering: &mut Lowering,
        clearings: &mut Clearings,
        mut pulses: Option<&mut Pulses>,
    ) -> Vec<Statement> {
        let net = &*lowering.net.clone();
        let acted_on = settle::acted_on(net);
        let mut out = Vec::new();
        for g in &net.hierarchy {
            let around = settle::around(lowering, *g, |lowering, e| uncovered::next(lowering, clearings, e));
            let known = &clearings.next;
            let mut next = |lowering: &mut Lowering, s: StepId| match known[s] {
                Some(next) => next,
                None => next_in_set(lowering, s),
            };
            let in_force = settle::orders(lowering, self.task.components, *g, around, &mut next, &mut out);
            let pulses = pulses.as_deref_mut();
            out.extend(uncovered::settle(lowering, clearings, &acted_on, *g, (around, in_force.as_ref()), pulses));
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
            out.extend(self.run(lowering, clearings, *g));
            // Events of covered steps compare the state with the next one, which is final now.
            for s in &net.grafcets[*g].steps {
                if lowering.situation.bit(*s).is_none() {
                    clearings.next[*s] = Some(next_in_set(lowering, *s));
                }
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
                let inside: Vec<usize> = self.layout.enclosed(*s).collect();
                let emptied = emptied(lowering, Origin::Step(*s), &inside);
                let started = started(lowering, Origin::Step(*s), &inside);
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
            let inside: Vec<usize> = self.layout.enclosed(*s).collect();
            out.extend(follow(lowering, Origin::Step(*s), (lowering.active(*s), next), &inside));
        }
        out
    }

    /// What several steps of a grafcet run begins with the first of them and ends with the last; where one hands over to
    /// another, it goes on (R15).
    fn run(&self, lowering: &mut Lowering, clearings: &Clearings, g: GrafcetId) -> Vec<Statement> {
        let mut out = Vec::new();
        for child in &self.layout.shared[g] {
            let next = settle::around(lowering, *child, |lowering, e| uncovered::next(lowering, clearings, e));
            let Some(next) = next else { continue };
            let net = &*lowering.net.clone();
            let was = lowering.one_active(net.within(*child));
            out.extend(follow(lowering, origin_around(net, *child), (was, next), &self.layout.sets_of[*child]));
        }
        out
    }
}

/// Sets end where what they lie within was active and is not any more, and begin where it is and was not.
fn follow(
    lowering: &mut Lowering,
    origin: Origin,
    (was, is): (FormulaId, FormulaId),
    sets: &[usize],
) -> Vec<Statement> {
    let (gone, fresh) = (lowering.pool.not(is), lowering.pool.not(was));
    let ends = (lowering.pool.and([was, gone]), emptied(lowering, origin, sets));
    let begins = (lowering.pool.and([is, fresh]), started(lowering, origin, sets));
    choose(lowering, [ends, begins].into_iter().filter(|(_, body)| !body.is_empty()).collect())
}

fn emptied(lowering: &mut Lowering, origin: Origin, sets: &[usize]) -> Vec<Statement> {
    let mut body = Vec::new();
    for index in sets {
        let set = &lowering.situation.sets[*index];
        let (next, idle) = (set.next, set.idle);
        body.push(assign_number(lowering, origin, next, idle));
    }
    body
}

fn started(lowering: &mut Lowering, origin: Origin, sets: &[usize]) -> Vec<Statement> {
    let mut body = Vec::new();
    for index in sets {
        let set = &lowering.situation.sets[*index];
        let (next, first) = (set.next, set.steps.iter().copied().find(|s| lowering.net.places[*s].activated));
        if let Some(s) = first {
            body.push(assign_number(lowering, origin, next, value_of(lowering, s)));
        }
    }
    body
}
