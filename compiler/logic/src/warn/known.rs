//! What the rules know of a net.

use crate::analysis::components::{self, Components};
use crate::encode::clearings::Flow;
use crate::lower::{Context, Lowering, Moment};
use grafc_formula::exclusion::EdgeFacts;
use grafc_formula::{Formula, FormulaId};
use grafc_model::chart::{Event, ExprId, ExprKind, StepId, TransitionId, VariableId, VariableKind};
use grafc_net::Net;
use grafc_net::net::Forced;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// No more enclosing steps than this are looked at for one step, nor more orders for one grafcet.
const LOOKED_AT: usize = 8;

/// A net, its conditions as formulas, and what excludes what.
pub(super) struct Known<'n> {
    pub(super) net: &'n Net,
    lowering: Lowering<'n>,
    cx: Context,
    pub(super) conditions: IndexVec<TransitionId, FormulaId>,
    /// Expressions of actions on an event, by the number of the action.
    pub(super) events: FxHashMap<usize, FormulaId>,
    facts: EdgeFacts,
    components: Components,
    pub(super) flow: Flow,
}

impl<'n> Known<'n> {
    pub(super) fn new(net: &'n Net) -> Self {
        let mut lowering = Lowering::new(net, None);
        let mut cx = Context::new(Moment::MicroStep);
        let conditions = net.transitions.iter().map(|t| lowering.expr(&mut cx, t.condition)).collect();
        let mut events = FxHashMap::default();
        for (index, action) in net.stored.iter().enumerate() {
            if let Event::Event(_, expr) = action.event {
                events.insert(index, lowering.expr(&mut cx, expr));
            }
        }
        let components = components::analyse(net, &lowering.pool, &lowering.edges, &conditions).components;
        let facts = EdgeFacts::new(&lowering.edges);
        Known { net, conditions, events, facts, components, flow: Flow::new(net), lowering, cx }
    }

    /// The formula of a condition or value in a micro-step: equal formulas have equal values.
    pub(super) fn formula(&mut self, expr: ExprId) -> FormulaId {
        self.lowering.expr(&mut self.cx, expr)
    }

    /// The formula of a value, in which a constant of the chart is its value.
    pub(super) fn value(&mut self, expr: ExprId) -> FormulaId {
        if let ExprKind::Variable(v) = self.net.exprs[expr].kind
            && self.net.variables[v].kind == VariableKind::Constant
        {
            return self.lowering.pool.constant(self.net.variables[v].initial, self.net.exprs[expr].ty);
        }
        self.formula(expr)
    }

    /// A condition that is denied, or as it is.
    pub(super) fn literal(&mut self, condition: FormulaId, asserted: bool) -> FormulaId {
        if asserted { condition } else { self.lowering.pool.not(condition) }
    }

    /// The constant that a condition is, if it is one.
    pub(super) fn truth(&self, condition: FormulaId) -> Option<bool> {
        self.lowering.pool.as_truth(condition)
    }

    pub(super) fn get(&self, condition: FormulaId) -> &Formula {
        self.lowering.pool.get(condition)
    }

    /// Whether two conditions never hold in the same micro-step.
    pub(super) fn exclude(&self, a: FormulaId, b: FormulaId) -> bool {
        self.facts.exclude(&self.lowering.pool, a, b)
    }

    /// Whether no situation holds both steps: one token serves both or what encloses them, or one forces the other away.
    pub(super) fn never_together(&self, a: StepId, b: StepId) -> bool {
        a != b
            && (self.around(a).any(|a| self.around(b).any(|b| a != b && self.share_a_token(a, b)))
                || self.forces_away(a, b)
                || self.forces_away(b, a))
    }

    fn share_a_token(&self, a: StepId, b: StepId) -> bool {
        let others = self.components.of(b);
        self.components.of(a).iter().any(|component| others.contains(component))
    }

    /// A step and the steps around it, which are active whenever it is (I1).
    fn around(&self, step: StepId) -> impl Iterator<Item = StepId> {
        std::iter::successors(Some(step), |s| self.net.places[*s].within).take(LOOKED_AT)
    }

    /// Whether an order of one step, or one that wins over it, keeps the other step inactive (R2, I2).
    fn forces_away(&self, forcing: StepId, step: StepId) -> bool {
        let orders = &self.net.grafcets[self.net.places[step].grafcet].orders;
        for order in orders.iter().take(LOOKED_AT) {
            match &order.forced {
                Forced::Steps(steps) if steps.binary_search(&step).is_err() => {
                    if order.step == forcing {
                        return true;
                    }
                }
                Forced::Steps(_) | Forced::Current => return false,
            }
        }
        false
    }

    /// The stored actions by what they write, as places in `net.stored`.
    pub(super) fn writers(&self) -> BTreeMap<VariableId, Vec<usize>> {
        let mut writers: BTreeMap<VariableId, Vec<usize>> = BTreeMap::new();
        for (index, action) in self.net.stored.iter().enumerate() {
            writers.entry(action.target).or_default().push(index);
        }
        writers
    }
}
