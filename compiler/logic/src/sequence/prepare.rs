//! What is found before a sequential function chart is called.
//!
//! A sequential function chart has no memory for edges and no timers beside its conditions. But what is known when it is
//! called can be found then: so statements that are done before the chart find it, and the chart is given it as further
//! inputs. Edge operands are compared with what they were in the call before (X4), delays are brought up to date in each
//! call (X5).
//!
//! Where a call is one micro-step, that is the context of this micro-step (R14): inputs, the situation as markers of the
//! steps show it, and what was stored. To stability, edges and delays of steps have been seen by the end of the call
//! before; there it is what inputs alone decide.

use super::Reasons;
use super::expressions::Expressions;
use crate::lower::words::operand_word;
use crate::scan::{Origin, Preset, Role, Statement, Timer, VarId, Variable};
use ecow::EcoString;
use grafc_formula::{Formula, FormulaId, Type};
use grafc_model::chart::{DelayTime, ExprId, ExprKind, Mode, StepId, VariableId, VariableKind};
use grafc_model::reaction::Evolution;
use rustc_hash::FxHashSet;

impl Expressions<'_> {
    /// Whether a value is known when the chart is called.
    pub fn is_known_before(&self, root: ExprId) -> bool {
        let once = match self.profile.evolution {
            Evolution::Stable => false,
            Evolution::Scan => true,
        };
        let (mut open, mut seen) = (vec![root], FxHashSet::default());
        while let Some(id) = open.pop() {
            let kind = &self.net.exprs[id].kind;
            let known = match kind {
                ExprKind::Variable(variable) => {
                    let variable = &self.net.variables[*variable];
                    match variable.kind {
                        VariableKind::Input | VariableKind::Constant => true,
                        VariableKind::Output => once && variable.mode == Mode::Stored,
                        VariableKind::Internal => false,
                    }
                }
                ExprKind::StepActive(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_) => once,
                ExprKind::StepTime(_) | ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Delay { .. } => false,
                ExprKind::Literal(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => true,
            };
            if !known {
                return false;
            }
            open.extend(kind.operands().filter(|operand| seen.insert(*operand)));
        }
        true
    }

    /// An operand as it is before the chart is called, where no step has a part in it that only itself can name.
    fn before(&mut self, operand: ExprId, reasons: &mut Reasons) -> FormulaId {
        let (owner, done, known) = (self.owner.take(), self.done.take(), std::mem::take(&mut self.known));
        let formula = self.formula(operand, None, reasons);
        (self.owner, self.done, self.known) = (owner, done, known);
        self.show_markers(formula);
        formula
    }

    /// The activity of a step before the chart is called, which is given to it.
    pub fn active_before(&mut self, step: StepId) -> FormulaId {
        let marker = self.active(step, None);
        self.show_markers(marker);
        let given = match self.prepared.active.get(&step) {
            Some(given) => *given,
            None => {
                let given = self.give(format!("was_{}", self.net.places[step].label), marker);
                self.prepared.active.insert(step, given);
                given
            }
        };
        self.pool.variable(given, Type::Bool)
    }

    /// A command of a grafcet, if it has a name and can be found before the chart is called: else each condition says it.
    pub fn command(&mut self, id: ExprId, reasons: &mut Reasons) -> Option<FormulaId> {
        if let Some(known) = self.commands.get(&id) {
            return *known;
        }
        let name = self.names.remove(&id)?;
        let value = self.before(id, reasons);
        let found = self.is_known_outside(value) && !self.pool.is_leaf(value);
        let given = found.then(|| {
            let given = self.give(name.to_string(), value);
            self.pool.variable(given, Type::Bool)
        });
        self.commands.insert(id, given);
        given
    }

    /// The chart shows the markers that a formula reads.
    fn show_markers(&mut self, formula: FormulaId) {
        let markers: FxHashSet<VarId> = self.markers.values().copied().collect();
        for id in self.pool.below(formula) {
            if let Formula::Variable(variable) = self.pool.get(id)
                && markers.contains(variable)
                && self.prepared.is_shown.insert(*variable)
            {
                self.prepared.shown.push(*variable);
            }
        }
    }

    /// Whether all that a value reads is known outside of the chart: inputs, constants, outputs that are stored, what is
    /// found before it, and the markers of steps.
    pub fn is_known_outside(&self, value: FormulaId) -> bool {
        self.pool.below(value).into_iter().all(|id| match self.pool.get(id) {
            Formula::Variable(v) => match self.net.variables.get(VariableId::from_usize(v.index())) {
                Some(variable) => match variable.kind {
                    VariableKind::Input | VariableKind::Constant => true,
                    VariableKind::Output => variable.mode == Mode::Stored,
                    VariableKind::Internal => false,
                },
                None => v.index() >= self.variables,
            },
            Formula::TimerDone(_) | Formula::TimerElapsed(_) => false,
            Formula::Constant(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => true,
        })
    }

    /// Finds an output behind the chart.
    pub fn afterwards(&mut self, target: VariableId, value: FormulaId) {
        self.show_markers(value);
        let statement = Statement::assign(Origin::Actions(target), self.declared(target), value);
        self.prepared.after.push(statement);
    }

    /// `↑e` or `↓e` of an operand that is known before.
    pub fn edge(&mut self, operand: ExprId, rises: bool, reasons: &mut Reasons) -> FormulaId {
        let current = self.before(operand, reasons);
        if let Some(variable) = self.prepared.edges.get(&(current, rises)) {
            return self.pool.variable(*variable, Type::Bool);
        }
        let word = self.word(operand);
        let old = match self.prepared.old.get(&current) {
            Some(old) => *old,
            None => {
                let old = self.fresh(Role::Memory, format!("old_{word}"));
                self.prepared.memory.push(old);
                self.prepared.old.insert(current, old);
                // There is no edge at the start.
                self.prepared.first.push(Statement::assign(Origin::Chart, old, current));
                self.prepared.last.push(Statement::assign(Origin::Chart, old, current));
                old
            }
        };
        let was = self.pool.variable(old, Type::Bool);
        let value = if rises {
            let was_not = self.pool.not(was);
            self.pool.and([current, was_not])
        } else {
            let is_not = self.pool.not(current);
            self.pool.and([is_not, was])
        };
        let found = self.give(format!("{}_{word}", if rises { "rise" } else { "fall" }), value);
        self.prepared.edges.insert((current, rises), found);
        self.pool.variable(found, Type::Bool)
    }

    /// `on/e/off` of an operand that is known before. An off-delay is a TON of the negation and a bit, as everywhere.
    pub fn delay_before(&mut self, operand: ExprId, on: DelayTime, off: DelayTime, reasons: &mut Reasons) -> FormulaId {
        let current = self.before(operand, reasons);
        if let Some(variable) = self.prepared.delays.get(&(current, on.ms, off.ms)) {
            return self.pool.variable(*variable, Type::Bool);
        }
        let word = self.word(operand);
        let mut value = current;
        if on.ms > 0 {
            value = self.timer(format!("on_{word}"), on, value);
        }
        if off.ms > 0 {
            let held = self.fresh(Role::Memory, format!("held_{word}"));
            self.prepared.memory.push(held);
            let low = self.pool.not(value);
            let over = self.timer(format!("off_{word}"), off, low);
            let (still, not_over) = (self.pool.variable(held, Type::Bool), self.pool.not(over));
            let keeps = self.pool.and([still, not_over]);
            value = self.pool.or([value, keeps]);
            self.prepared.before.push(Statement::assign(Origin::Chart, held, value));
            value = still;
        }
        let found = self.give(format!("delayed_{word}"), value);
        self.prepared.delays.insert((current, on.ms, off.ms), found);
        self.pool.variable(found, Type::Bool)
    }

    /// Brings a new timer up to date; whether it has run out.
    fn timer(&mut self, name: String, time: DelayTime, input: FormulaId) -> FormulaId {
        let constant = time.constant.map(|constant| self.declared(constant));
        let timer = Timer { name, preset: Some(Preset { ms: time.ms, constant }), comment: None };
        let timer = self.prepared.timers.push(timer);
        self.prepared.before.push(Statement::CallTimer { timer, input, origin: Origin::Chart });
        self.pool.timer_done(timer)
    }

    /// Finds a value, and gives it to the chart.
    fn give(&mut self, name: String, value: FormulaId) -> VarId {
        let target = self.fresh(Role::Temporary, name);
        self.prepared.given.push(target);
        self.prepared.before.push(Statement::assign(Origin::Chart, target, value));
        target
    }

    /// A new variable behind those of the chart.
    pub fn fresh(&mut self, role: Role, name: String) -> VarId {
        self.more.push(Variable::new(role, name, Type::Bool));
        VarId::from_usize(self.variables + self.more.len() - 1)
    }

    /// A word for what an operand is.
    fn word(&self, operand: ExprId) -> EcoString {
        operand_word(self.net, operand)
    }

    /// The mark of the first call, if something waits for it.
    pub fn first_call(&mut self) -> (Vec<Statement>, Option<VarId>) {
        if self.prepared.first.is_empty() {
            return (Vec::new(), None);
        }
        let started = self.fresh(Role::Memory, "started".to_string());
        self.prepared.memory.push(started);
        let (yes, is_started) = (self.pool.truth(true), self.pool.variable(started, Type::Bool));
        let at_first = self.pool.not(is_started);
        let mut body = vec![Statement::assign(Origin::Chart, started, yes)];
        body.append(&mut self.prepared.first);
        (vec![Statement::when(at_first, body)], Some(started))
    }
}
