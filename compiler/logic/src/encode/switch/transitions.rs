//! The transitions, which read the old situation and write the next one.

use super::moves::{changes_of, home};
use super::{Switch, assign_number, assign_truth, encloser};
use crate::encode::choose::choose;
use crate::encode::clearings::clears;
use crate::encode::settle;
use crate::encode::state_case::StateCase;
use crate::lower::Lowering;
use crate::lower::situation::equals;
use crate::scan::{Origin, Role, Statement, Told};
use ecow::eco_format;
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{GrafcetId, StepId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// StateCase nest no deeper than this; what is enclosed deeper starts again at the top, where an idle state costs a test.
const DEEPEST: usize = 16;

impl Switch<'_> {
    /// The transitions: those around bits latched one by one, the others in the arms of their first step.
    pub(super) fn transitions(&mut self, lowering: &mut Lowering, frozen: &settle::Frozen) -> Vec<Statement> {
        let net = &*lowering.net.clone();
        let mut latched = Vec::new();
        let mut moves = Vec::new();
        let mut branches: FxHashMap<StepId, Vec<(FormulaId, Vec<Statement>)>> = FxHashMap::default();
        for (t, transition) in net.transitions.iter_enumerated() {
            let factors = clears(lowering, t, self.task.conditions[t], frozen, self.task.simplify);
            let mut body = Vec::new();
            let origin = Origin::Transition(t);
            let changes = changes_of(lowering, t);
            for (set, value) in &changes {
                body.push(assign_number(lowering, origin, lowering.situation.sets[*set].next, *value));
            }
            let home = home(lowering, t);
            let mut cleared = lowering.pool.truth(false);
            if let (Some(set), Some(number)) = (home, self.numbered.transitions.get(&t).copied()) {
                let variable = self.numbered.variable[&set];
                body.push(assign_number(lowering, origin, variable, number));
                cleared = equals(&lowering.symbols, &mut lowering.pool, variable, number);
            }
            if home.is_none() || !body.is_empty() {
                body.push(assign_truth(lowering, origin, self.moved.variable, true));
            }
            let told = self.moved.asks_again || changes.is_empty();
            if let Some(again) = self.task.again.filter(|_| !told) {
                body.push(assign_truth(lowering, origin, again, true));
            }
            match (home, transition.pre.first()) {
                (Some(_), Some(first)) => {
                    let own = lowering.active(*first);
                    let when = lowering.pool.and(factors.into_iter().filter(|f| *f != own));
                    body.iter_mut().take(1).for_each(Statement::tell);
                    if !body.is_empty() {
                        branches.entry(*first).or_default().push((when, body));
                    }
                }
                _ => {
                    let value = lowering.pool.and(factors);
                    let name = eco_format!("clr_{}", lowering.transition_word(t));
                    let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
                    latched.push(Statement::Assign { target, value, origin, told: Told::All });
                    cleared = lowering.symbols.read(&mut lowering.pool, target);
                    moves.extend(choose(lowering, vec![(cleared, body)]));
                }
            }
            self.cleared.push(cleared);
        }
        let mut out = Vec::new();
        out.push(assign_truth(lowering, Origin::Chart, self.moved.variable, false));
        if let Some(again) = self.task.again.filter(|_| !self.moved.asks_again && lowering.edges.is_empty()) {
            out.push(assign_truth(lowering, Origin::Chart, again, false));
        }
        out.extend(latched);
        out.extend(self.nest(lowering, branches));
        out.extend(moves);
        out
    }

    /// Puts the branches of each step into the arms of its set, and those of an enclosure into the arm of the step that
    /// encloses it; from the bottom of the hierarchy up. What several steps run stands once, behind what runs it.
    fn nest(
        &self,
        lowering: &Lowering,
        mut branches: FxHashMap<StepId, Vec<(FormulaId, Vec<Statement>)>>,
    ) -> Vec<Statement> {
        let net = &*lowering.net.clone();
        // The step in whose arm each grafcet stands, if in any, and how deep that is.
        let mut at: IndexVec<GrafcetId, (Option<StepId>, usize)> = net.grafcets.iter().map(|_| (None, 0)).collect();
        for g in &net.hierarchy {
            let parent = net.within(*g).first().map(|e| net.places[*e].grafcet);
            at[*g] = match (parent, encloser(lowering, *g)) {
                (Some(parent), Some(e)) if at[parent].1 + 1 < DEEPEST => (Some(e), at[parent].1 + 1),
                (Some(parent), None) if net.within(*g).len() > 1 => at[parent],
                _ => (None, 0),
            };
        }
        let mut nested: FxHashMap<StepId, Vec<Statement>> = FxHashMap::default();
        let mut top: BTreeMap<GrafcetId, Vec<Statement>> = BTreeMap::new();
        for g in net.hierarchy.iter().rev() {
            // What is nested comes from the last to the first, and is put in order when its arm is written.
            for index in self.layout.sets_of[*g].iter().rev() {
                let set = &lowering.situation.sets[*index];
                let mut arms = StateCase::default();
                for s in &set.steps {
                    let mut body = choose(lowering, branches.remove(s).unwrap_or_default());
                    body.extend(nested.remove(s).unwrap_or_default().into_iter().rev());
                    arms.add(lowering, *s, body);
                }
                let case = arms.case(set.variable);
                match at[*g].0 {
                    Some(e) => nested.entry(e).or_default().extend(case),
                    None => top.entry(*g).or_default().extend(case),
                }
            }
        }
        top.into_values().flat_map(|cases| cases.into_iter().rev()).collect()
    }
}
