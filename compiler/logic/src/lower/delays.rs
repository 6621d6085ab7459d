//! Delays and step durations (X2, X5).
//!
//! `on/e/off` is TOF(TON(e, on), off), each part left out where its time is zero. The off-delay is a TON on the negated
//! signal and a bit that it resets, because targets disagree on the output of TOF before its first true input.

use super::words::duration_word;
use super::{Context, Lowering, Moment};
use crate::scan::{Origin, Preset, Role, Statement, Timer, TimerId, VarId};
use crate::spell::in_signs;
use ecow::{EcoString, eco_format};
use grafc_formula::{Formula, FormulaId, Type, Value};
use grafc_model::chart::{DelayTime, ExprId, ExprKind, Note, StepId};

/// A delay that has been lowered, by one of its timers.
#[derive(Clone, Debug)]
pub(crate) struct LoweredDelay {
    /// The delay in the chart.
    pub(crate) expr: ExprId,
    /// What it is part of.
    pub(crate) origin: Origin,
    /// What measures it.
    pub(crate) timer: TimerId,
    /// Of an off-delay, what it holds.
    pub(crate) held: Option<VarId>,
}

impl Lowering {
    /// Brings the timers of step durations up to date with the situation.
    pub(crate) fn call_step_timers(&self) -> Vec<Statement> {
        let call = |(s, t): (&StepId, &TimerId)| Statement::CallTimer {
            timer: *t,
            input: self.active(*s),
            origin: Origin::Step(*s),
        };
        self.step_timers.iter().map(call).collect()
    }

    pub(super) fn delay(
        &mut self,
        cx: &mut Context,
        e: ExprId,
        on: DelayTime,
        operand: ExprId,
        off: DelayTime,
    ) -> FormulaId {
        match cx.moment {
            Moment::First if on.ms > 0 => self.pool.truth(false),
            Moment::First => cx.exprs[operand],
            Moment::After => self.delay_values[&e],
            Moment::Restored => {
                let value = self.delay_values[&e];
                // Of a call that was given up, or is one micro-step, the operand has changed since: it is kept.
                if on.ms == 0
                    && off.ms == 0
                    && let Formula::Variable(now) = *self.pool.get(value)
                {
                    self.symbols.table[now].role = Role::Memory;
                }
                value
            }
            Moment::MicroStep => {
                let input = cx.exprs[operand];
                let value = match self.delay_of.get(&(input, on, off)) {
                    Some(known) => *known,
                    None => {
                        let value = self.run_delay(cx, e, input, on, operand, off);
                        self.delay_of.insert((input, on, off), value);
                        value
                    }
                };
                self.delay_values.insert(e, value);
                value
            }
        }
    }

    fn run_delay(
        &mut self,
        cx: &mut Context,
        e: ExprId,
        input: FormulaId,
        on: DelayTime,
        operand: ExprId,
        off: DelayTime,
    ) -> FormulaId {
        let (base, comment) = self.delay_word(e, on, operand, off);
        let raised = if on.ms > 0 {
            let timer = self.timer(format!("on_{base}"), on, comment.clone());
            cx.statements.push(Statement::CallTimer { timer, input, origin: cx.origin });
            self.delays.push(LoweredDelay { expr: e, origin: cx.origin, timer, held: None });
            self.pool.timer_done(timer)
        } else {
            input
        };
        if off.ms > 0 {
            let held = self.symbols.fresh(Role::Memory, eco_format!("held_{base}"), Type::Bool, comment.clone());
            let timer = self.timer(format!("off_{base}"), off, comment.clone());
            self.delays.push(LoweredDelay { expr: e, origin: cx.origin, timer, held: Some(held) });
            let low = self.pool.not(raised);
            cx.statements.push(Statement::CallTimer { timer, input: low, origin: cx.origin });
            let (still, over) = (self.symbols.read(&mut self.pool, held), self.pool.timer_done(timer));
            let not_over = self.pool.not(over);
            let keeps = self.pool.and([still, not_over]);
            let value = self.pool.or([raised, keeps]);
            cx.statements.push(Statement::assign(cx.origin, held, value));
            still
        } else if on.ms > 0 {
            raised
        } else {
            // No delay at all: still a value of this micro-step, which outputs read after the situation has changed.
            let value = self.symbols.fresh(Role::Temporary, eco_format!("now_{base}"), Type::Bool, None);
            cx.statements.push(Statement::assign(cx.origin, value, input));
            self.symbols.read(&mut self.pool, value)
        }
    }

    fn timer(&mut self, name: String, time: DelayTime, comment: Option<Note>) -> TimerId {
        let constant = time.constant.map(|c| self.symbols.declared(c));
        self.timers.push(Timer { name, preset: Some(Preset { ms: time.ms, constant }), comment })
    }

    /// `Tn`: its timer runs as soon as the step is active, see `compile`.
    pub(super) fn step_time(&mut self, cx: &Context, step: StepId) -> FormulaId {
        if cx.moment == Moment::First {
            return self.constant(Value::Time(0), Type::Time);
        }
        let label = &self.net.places[step].label;
        let timers = &mut self.timers;
        let timer = *self.step_timers.entry(step).or_insert_with(|| {
            timers.push(Timer {
                name: format!("T{label}"),
                preset: None,
                comment: Some(format!("duration of step {label}").into()),
            })
        });
        self.pool.timer_elapsed(timer)
    }

    /// What a delay is called by: its operand and, if another delay of that came before, its time as well. Beside it what the
    /// name cannot say.
    fn delay_word(&mut self, e: ExprId, on: DelayTime, operand: ExprId, off: DelayTime) -> (EcoString, Option<Note>) {
        let mut word = self.operand_word(operand);
        if self.delay_words.contains(&word) {
            let time = if on.ms > 0 { on } else { off };
            let time = match time.constant {
                Some(constant) => self.net.variables[constant].name.clone(),
                None => duration_word(time.ms),
            };
            word = eco_format!("{word}_{time}");
        }
        self.delay_words.insert(word.clone());
        let speaks_for_itself = match &self.net.exprs[operand].kind {
            ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::Literal(_) => off.ms == 0 || on.ms == 0,
            ExprKind::StepTime(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => false,
        };
        let comment = (!speaks_for_itself).then(|| in_signs(&self.net, e).into());
        (word, comment)
    }
}
