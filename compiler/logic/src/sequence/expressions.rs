//! Conditions and values as formulas over the variables of a sequential function chart.
//!
//! What needs memory of its own from scan to scan has no place in such a chart: edges, delays of anything but a step. Those
//! that inputs alone decide are found before it is called (`prepare`).

use super::prepared::Prepared;
use super::{Reasons, SequenceStep, When, is_small};
use crate::scan::{Role, VarId, Variable};
use ecow::EcoString;
use grafc_diagnostics::Span;
use grafc_formula::{Arithmetic, Comparison, FormulaId, Pool, Type, Value};
use grafc_model::chart::{DelayTime, ExprId, ExprKind, Mode, StepId, VariableId};
use grafc_model::reaction::Profile;
use grafc_net::Net;
use index_vec::IndexVec;
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

pub(super) struct Expressions<'n> {
    pub net: &'n Net,
    steps: IndexVec<StepId, (VarId, VarId)>,
    pub profile: Profile,
    pub pool: Pool,
    /// The markers of steps.
    pub markers: IndexMap<StepId, VarId, FxBuildHasher>,
    /// What is found before the chart is called.
    pub prepared: Prepared,
    /// How many variables the chart and its steps have, and those that follow.
    pub variables: usize,
    pub more: Vec<Variable>,
    /// What commands of grafcets are called, and those that are found before the chart is called (none if they are not).
    pub names: FxHashMap<ExprId, EcoString>,
    pub commands: FxHashMap<ExprId, Option<FormulaId>>,
    /// What is known of the expressions for one owner.
    pub known: FxHashMap<ExprId, FormulaId>,
    pub owner: Option<StepId>,
    /// When it is done, if it is part of an action that stores.
    pub done: Option<When>,
}

impl<'n> Expressions<'n> {
    pub fn new(
        net: &'n Net,
        steps: &IndexVec<StepId, SequenceStep>,
        names: FxHashMap<ExprId, EcoString>,
        profile: Profile,
    ) -> Self {
        let variables = net.variables.len() + 2 * steps.len();
        let steps = steps.iter().map(|step| (step.active, step.duration)).collect();
        let (pool, markers, known) = (Pool::default(), IndexMap::default(), FxHashMap::default());
        let (prepared, more) = (Prepared::default(), Vec::new());
        let commands = FxHashMap::default();
        Expressions {
            net,
            steps,
            profile,
            pool,
            markers,
            prepared,
            variables,
            more,
            names,
            commands,
            known,
            owner: None,
            done: None,
        }
    }

    /// The variable that was declared in the chart.
    pub fn declared(&self, variable: VariableId) -> VarId {
        VarId::from_usize(variable.index())
    }

    /// The activity of a step, as its owner or another reads it.
    pub fn active(&mut self, step: StepId, owner: Option<StepId>) -> FormulaId {
        let variable = match self.markers.get(&step) {
            _ if owner == Some(step) => self.steps[step].0,
            Some(marker) => *marker,
            None => {
                let place = &self.net.places[step];
                let marker = self.fresh(Role::Memory, format!("at_{}", place.label));
                let variable = &mut self.more[marker.index() - self.variables];
                // Conditions of the first scan read it before the step has set it.
                variable.set_initial(Value::Bool(place.initial));
                variable.comment = Some(format!("step {} is active", place.label).into());
                self.markers.insert(step, marker);
                marker
            }
        };
        self.pool.variable(variable, Type::Bool)
    }

    /// The activity of a step as what is being said reads it. What is stored reads the situation of before, and is done when
    /// the steps have changed: of its own step that is known, any other is noted before the chart is called.
    fn activity(&mut self, step: StepId) -> FormulaId {
        match self.done {
            None => self.active(step, self.owner),
            Some(When::Activation) if self.owner == Some(step) => self.pool.truth(false),
            Some(When::Deactivation) if self.owner == Some(step) => self.pool.truth(true),
            Some(When::Activation | When::Deactivation | When::EachScan) => self.active_before(step),
        }
    }

    /// An expression of an action that stores.
    pub fn deed(&mut self, root: ExprId, step: StepId, when: When, reasons: &mut Reasons) -> FormulaId {
        self.done = Some(when);
        let formula = self.formula(root, Some(step), reasons);
        self.done = None;
        formula
    }

    /// The time since the activation of a step, which only the step itself and the transition after it can name.
    fn duration(&mut self, step: StepId, span: Span, reasons: &mut Reasons) -> FormulaId {
        if self.owner != Some(step) {
            reasons.add(span, "the time of a step other than the one right before it");
        }
        self.pool.variable(self.steps[step].1, Type::Time)
    }

    /// An expression of a step or of the transition after it; what cannot be said is a reason.
    pub fn formula(&mut self, root: ExprId, owner: Option<StepId>, reasons: &mut Reasons) -> FormulaId {
        self.owner = owner;
        self.known.clear();
        let mut wanted = Vec::new();
        let mut seen = FxHashSet::default();
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            if self.known.contains_key(&id) || !seen.insert(id) {
                continue;
            }
            if let Some(command) = self.command(id, reasons) {
                self.known.insert(id, command);
                continue;
            }
            wanted.push(id);
            open.extend(self.net.exprs[id].kind.operands());
        }
        // Operands have the smaller ids.
        wanted.sort_unstable();
        for id in wanted {
            let formula = self.one(id, reasons);
            self.known.insert(id, formula);
        }
        let formula = self.known[&root];
        if !is_small(&self.pool, formula) {
            reasons.add(self.net.exprs[root].span, "is too long for a drawing");
        }
        formula
    }

    fn one(&mut self, id: ExprId, reasons: &mut Reasons) -> FormulaId {
        let expr = &self.net.exprs[id];
        let is_leaf = |this: &Self, id: ExprId| this.pool.is_leaf(this.known[&id]);
        match expr.kind {
            ExprKind::Literal(value) => self.pool.constant(value, expr.ty),
            ExprKind::Variable(variable) => {
                match self.net.variables[variable].mode {
                    Mode::Given | Mode::Stored => {}
                    Mode::Wire => reasons.add(expr.span, "reads what continuous actions set"),
                }
                self.pool.variable(self.declared(variable), expr.ty)
            }
            ExprKind::StepActive(step) => self.activity(step),
            ExprKind::StepTime(step) => self.duration(step, expr.span, reasons),
            ExprKind::MacroActive(within) => {
                let mut steps = Vec::new();
                let mut open = vec![within];
                while let Some(id) = open.pop() {
                    steps.extend(self.net.macro_steps[id].places.iter().copied());
                    open.extend(self.net.macro_steps[id].inner.iter().copied());
                }
                steps.sort_unstable();
                self.any(steps)
            }
            ExprKind::GrafcetActive(grafcet) => self.any(self.net.grafcets[grafcet].steps.clone()),
            // Pulse orders have no place there.
            ExprKind::GrafcetFrozen(_) => self.pool.truth(false),
            ExprKind::Not(a) => self.pool.not(self.known[&a]),
            ExprKind::And(a, b) => self.pool.and([self.known[&a], self.known[&b]]),
            ExprKind::Or(a, b) => self.pool.or([self.known[&a], self.known[&b]]),
            ExprKind::Xor(a, b) => self.pool.xor(self.known[&a], self.known[&b]),
            ExprKind::Rise(e) if self.is_known_before(e) => self.edge(e, true, reasons),
            ExprKind::Fall(e) if self.is_known_before(e) => self.edge(e, false, reasons),
            ExprKind::Rise(_) | ExprKind::Fall(_) => {
                reasons.add(expr.span, "an edge of what is not known before the chart is called");
                self.pool.truth(false)
            }
            ExprKind::Delay { on, operand, off } => self.delay(id, on, operand, off, reasons),
            ExprKind::Compare(op, a, b) => self.pool.compare(op, self.known[&a], self.known[&b]),
            ExprKind::Arithmetic(op, a, b) => {
                match op {
                    Arithmetic::Divide | Arithmetic::Modulo => {
                        reasons.add(expr.span, "a division, which needs a guard")
                    }
                    Arithmetic::Add | Arithmetic::Subtract | Arithmetic::Multiply => {}
                }
                if !is_leaf(self, a) || !is_leaf(self, b) {
                    reasons.add(expr.span, "an intermediate result, which needs a variable of its own");
                }
                self.pool.arithmetic(op, expr.ty, self.known[&a], self.known[&b])
            }
            ExprKind::Negate(a) => {
                if !is_leaf(self, a) {
                    reasons.add(expr.span, "an intermediate result, which needs a variable of its own");
                }
                self.pool.negate(self.known[&a])
            }
            ExprKind::Widen(a) => self.pool.widen(expr.ty, self.known[&a]),
        }
    }

    fn any(&mut self, steps: Vec<StepId>) -> FormulaId {
        let active: Vec<FormulaId> = steps.into_iter().map(|step| self.activity(step)).collect();
        self.pool.or(active)
    }

    /// To stability, a delay of a step begins with the step, and so does the step's time.
    fn delay(
        &mut self,
        id: ExprId,
        on: DelayTime,
        operand: ExprId,
        off: DelayTime,
        reasons: &mut Reasons,
    ) -> FormulaId {
        let span = self.net.exprs[id].span;
        if self.is_known_before(operand) {
            return self.delay_before(operand, on, off, reasons);
        }
        let ExprKind::StepActive(step) = self.net.exprs[operand].kind else {
            reasons.add(span, "a delay of what is not known before the chart is called, which needs a timer");
            return self.pool.truth(false);
        };
        if off.ms > 0 {
            reasons.add(span, "an off-delay, which needs a timer");
        }
        let limit = match on.constant {
            Some(constant) => self.pool.variable(self.declared(constant), Type::Time),
            None => self.pool.constant(Value::Time(on.ms), Type::Time),
        };
        let duration = self.duration(step, span, reasons);
        let long_enough = self.pool.compare(Comparison::GreaterEqual, duration, limit);
        let active = self.active(step, self.owner);
        self.pool.and([active, long_enough])
    }
}
