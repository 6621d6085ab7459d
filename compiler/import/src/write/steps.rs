//! What steps do, by the qualifiers of their actions (IEC 61131-3, 2.6.4).
//!
//! Statements are done in each scan, at the entry or at the exit. A Boolean variable as an action is a continuous action
//! as long as nobody stores into it; else each qualifier says what it stores. What a qualifier does beyond its step needs
//! a variable that remembers, and a step that is always active.

use super::effects::Done;
use super::maker::{Action, Maker, Scope, When};
use super::outcome::{Effects, Lost};
use super::resolve::{Environment, Site};
use super::terms::{Amount, StepId, TermId, TermKind, VarId};
use crate::code::tree::ExprId;
use crate::sfc::{Association, Qualifier, Target};
use crate::{Dialect, doubtful, lost};
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;

/// A Boolean variable as an action of a step.
pub struct Named {
    step: StepId,
    variable: VarId,
    qualifier: Qualifier,
    time: Option<ExprId>,
    site: Site,
    span: Span,
}

impl<'a> Maker<'a> {
    /// What the statements of all steps do; the actions that are variables are returned for later.
    pub fn bodies(&mut self) -> Vec<Named> {
        let mut named = Vec::new();
        for part in 0..self.parts.len() {
            let chart = self.parts[part].chart;
            for (place, step) in chart.steps.iter().enumerate() {
                let id = StepId::new(self.parts[part].first + place);
                self.body_of_step(part, id, &step.actions, &mut named);
            }
            self.beside(part, &chart.beside);
        }
        named
    }

    /// What is done in each scan while a chart goes on, whatever step is active.
    fn beside(&mut self, part: usize, statements: &'a [crate::code::tree::Statement]) {
        let scope = self.parts[part].scope.clone();
        let span = self.parts[part].span;
        let guard = match self.parts[part].called {
            Some(called) => called,
            None => self.terms.constant(true, span),
        };
        self.in_each_scan(vec![Done { site: Site { scope, part, own: None }, guard, statements }]);
    }

    /// Statements that belong to no step.
    fn in_each_scan(&mut self, bodies: Vec<Done<'a>>) {
        let effects = self.effects(bodies);
        for lost_one in effects.lost {
            self.tell_lost(&lost_one);
        }
        for order in effects.given {
            let message = format!("an order to `{}` is lost: no step gives it", self.parts[order.child].name);
            self.diagnostics.push(lost(order.span, message));
        }
        for variable in effects.order {
            for (guard, value) in effects.environment.get(&variable).cloned().unwrap_or_default() {
                self.always_stored(variable, value, guard);
            }
        }
    }

    fn body_of_step(&mut self, part: usize, step: StepId, actions: &'a [Association], named: &mut Vec<Named>) {
        let scope = self.parts[part].scope.clone();
        let (mut entry, mut during, mut exit): (Vec<Done>, Vec<Done>, Vec<Done>) = Default::default();
        for association in actions {
            let span = association.span;
            let site = |scope: Scope, active: bool| Site { scope, part, own: Some((step, active)) };
            let Some((inner, statements)) = self.statements(&scope, association) else {
                if !self.step_program(part, step, association) {
                    self.name(part, step, association, named);
                }
                continue;
            };
            let Some(guard) = self.timed(association, &site(scope.clone(), true), step) else { continue };
            let done =
                |scope: Scope, active: bool, guard: TermId| Done { site: site(scope, active), guard, statements };
            match association.qualifier {
                Qualifier::N | Qualifier::D | Qualifier::L | Qualifier::Main => {
                    // The scan in which a step is left does its actions once more.
                    if self.dialect == Dialect::Codesys && association.qualifier != Qualifier::Main {
                        let guard = self.terms.constant(true, span);
                        exit.push(done(inner.clone(), false, guard));
                    }
                    during.push(done(inner, true, guard));
                }
                Qualifier::P | Qualifier::P1 | Qualifier::Entry => {
                    if association.qualifier == Qualifier::P && self.dialect == Dialect::Codesys {
                        exit.push(done(inner.clone(), false, guard));
                    }
                    entry.push(done(inner, true, guard));
                }
                Qualifier::P0 | Qualifier::Exit => exit.push(done(inner, false, guard)),
                Qualifier::S | Qualifier::R | Qualifier::SD | Qualifier::DS | Qualifier::SL => {
                    self.stored_body(part, step, association, inner, statements);
                }
            }
        }
        let called = self.parts[part].called;
        for (bodies, when) in [(entry, When::Activation), (during, When::EachScan(called)), (exit, When::Deactivation)]
        {
            let effects = self.effects(bodies);
            self.write_effects(step, effects, when, part);
        }
    }

    /// An action whose name is a variable; a chart is written where it is called.
    fn name(&mut self, part: usize, step: StepId, association: &'a Association, named: &mut Vec<Named>) {
        let scope = self.parts[part].scope.clone();
        let Target::Named(name) = &association.action else { return };
        if self.action(&scope, name).is_some() {
            return;
        }
        let span = association.span;
        let site = Site { scope, part, own: Some((step, true)) };
        let is_known = self.unit(&site.scope).variables.find(name).is_some();
        if !is_known && name.contains('.') {
            let message = format!("the action `{name}` is lost: it is in none of the units of the file");
            self.diagnostics.push(lost(span, message));
            self.step_texts[step].lost.push(format!("action {name}"));
            return;
        }
        match self.target(name, Some(Type::Bool), span, &site) {
            Ok(variable) if self.variables.list[variable].ty == Type::Bool => {
                if association.qualifier != Qualifier::N
                    && !matches!(association.qualifier, Qualifier::L | Qualifier::D)
                {
                    self.variables.list[variable].used.stored = true;
                }
                self.variables.list[variable].used.by_name = true;
                let time = association.time;
                named.push(Named { step, variable, qualifier: association.qualifier, time, site, span });
            }
            Ok(_) | Err(_) => {
                let message = format!("the action `{name}` is lost: it is neither an action nor a Boolean variable");
                let mut said = lost(span, message);
                if self.units.contains_key(&name.to_lowercase()) {
                    said = said.help("it is a program: with `--dialect isagraf` it is a child, which the step runs");
                }
                self.diagnostics.push(said);
                self.step_texts[step].lost.push(format!("action {name}"));
            }
        }
    }

    /// The condition of a timed qualifier; true without one.
    fn timed(&mut self, association: &Association, site: &Site, step: StepId) -> Option<TermId> {
        let span = association.span;
        match association.qualifier {
            Qualifier::D => self.since(association.time, site, step, " >= ", span),
            Qualifier::L => self.since(association.time, site, step, " < ", span),
            _ => Some(self.terms.constant(true, span)),
        }
    }

    /// How long the step has been active, compared with a time. It counts from the activation, as IEC 61131-3 has it; a
    /// delay of the step's activity would begin a scan later.
    fn since(
        &mut self,
        time: Option<ExprId>,
        site: &Site,
        step: StepId,
        sign: &'static str,
        span: Span,
    ) -> Option<TermId> {
        let Some(time) = time else {
            self.diagnostics.push(lost(span, "an action is lost: its qualifier wants a time, and it has none"));
            return None;
        };
        match self.value(time, Type::Time, site, &Environment::default()) {
            Ok(cases) => {
                let (_, time) = *cases.first()?;
                let elapsed = self.terms.add(TermKind::Time(step), Some(Type::Time), span);
                Some(self.terms.logic(TermKind::Pair(sign, elapsed, time), span))
            }
            Err(loss) => {
                self.diagnostics.push(lost(span, format!("an action is lost: its time cannot be said: {}", loss.why)));
                None
            }
        }
    }

    /// Writes what bodies of a step do.
    fn write_effects(&mut self, step: StepId, effects: Effects, when: When, part: usize) {
        for lost_one in effects.lost {
            self.tell_lost(&lost_one);
            let lines = lost_one.text.lines().map(str::trim).filter(|line| !line.is_empty()).map(str::to_string);
            self.step_texts[step].lost.extend(lines);
        }
        let initial = self.parts[part].chart.steps[self.steps[step].step].initial;
        self.give(step, effects.given, when);
        for variable in effects.order {
            let cases = effects.environment.get(&variable).cloned().unwrap_or_default();
            for (guard, value) in cases {
                self.store(step, variable, guard, value, when, initial);
            }
        }
    }

    /// Says once of a statement that it is lost; several steps may do it.
    fn tell_lost(&mut self, statement: &Lost) {
        let range = statement.span.range();
        if self.once(format!("lost {} {}", range.start, range.end)) {
            self.diagnostics.push(lost(statement.span, format!("a statement is lost: {}", statement.why)));
        }
    }

    fn store(&mut self, step: StepId, variable: VarId, guard: TermId, value: TermId, when: When, initial: bool) {
        if self.terms.is(guard, false) {
            return;
        }
        let span = self.terms.terms[value].span;
        let unconditional = self.terms.is(guard, true);
        let is_bool = self.variables.list[variable].ty == Type::Bool;
        let constant = !self.has(value, |kind| {
            !matches!(kind, TermKind::Bool(_) | TermKind::Integer(_) | TermKind::Real(_) | TermKind::Duration(_))
        });
        let push = |maker: &mut Self, value: TermId, when: When| {
            maker.step_texts[step].actions.push(Action::Stored { variable, value, when });
        };
        match when {
            When::EachScan(called) => {
                let guard = called.map_or(guard, |called| self.terms.and(called, guard));
                let guard = self.terms.unless_always(guard);
                push(self, value, When::EachScan(guard));
            }
            // At the exit, a constant that the step has set all the time changes nothing.
            When::Deactivation
                if unconditional
                    && constant
                    && self.dialect == Dialect::Codesys
                    && self.sets(step, variable, value) => {}
            When::Activation | When::Deactivation if unconditional => push(self, value, when),
            When::Activation | When::Deactivation if is_bool => {
                let old = self.terms.add(TermKind::Variable(variable), Some(Type::Bool), span);
                let not = self.terms.not(guard);
                let (new, kept) = (self.terms.and(guard, value), self.terms.and(not, old));
                let value = self.terms.or(new, kept);
                push(self, value, when);
            }
            When::Activation if !initial => {
                // In the scan of its activation a step was not active before.
                let active = self.terms.logic(TermKind::Active(step), span);
                let not = self.terms.not(active);
                let guard = self.terms.and(not, guard);
                push(self, value, When::EachScan(Some(guard)));
            }
            When::Activation | When::Deactivation => {
                let name = self.variables.list[variable].path.clone();
                let message = format!(
                    "what sets `{name}` under a condition is lost: charts have no such action on activation or deactivation"
                );
                self.diagnostics.push(lost(span, message));
            }
        }
    }

    /// Whether a step sets a variable to a constant at all times.
    fn sets(&self, step: StepId, variable: VarId, constant: TermId) -> bool {
        self.step_texts[step].actions.iter().any(|action| match action {
            Action::Stored { variable: other, value, when: When::EachScan(None) | When::Activation } => {
                *other == variable && self.terms.terms[*value].kind == self.terms.terms[constant].kind
            }
            Action::Stored { .. } | Action::Continuous { .. } | Action::Pulse { .. } | Action::Run { .. } => false,
        })
    }

    /// An action of statements that goes on after its step, or is ended by one.
    fn stored_body(
        &mut self,
        part: usize,
        step: StepId,
        association: &'a Association,
        scope: Scope,
        statements: &'a [crate::code::tree::Statement],
    ) {
        let span = association.span;
        let Target::Named(name) = &association.action else {
            self.diagnostics.push(lost(span, "an action without a name is lost: nobody could reset it"));
            return;
        };
        let initial = self.parts[part].chart.steps[self.steps[step].step].initial;
        if association.qualifier == Qualifier::S && self.is_always(part, initial, name) {
            if self.once(format!("stored {}{name}", scope.prefix)) {
                let guard = self.terms.constant(true, span);
                self.in_each_scan(vec![Done { site: Site { scope, part, own: None }, guard, statements }]);
            }
            return;
        }
        let on = self.variables.helper(&format!("{}{name}.on", scope.prefix), Type::Bool, span);
        self.variables.list[on].used.stored = true;
        let set = !matches!(association.qualifier, Qualifier::R);
        if matches!(association.qualifier, Qualifier::SD | Qualifier::DS | Qualifier::SL) {
            let message = format!(
                "the time of the stored action `{name}` is lost: it is done from the activation of its step on"
            );
            self.diagnostics.push(lost(span, message));
        }
        let value = self.terms.constant(set, span);
        self.step_texts[step].actions.push(Action::Stored { variable: on, value, when: When::Activation });
        if !set || !self.once(format!("stored {}{name}", scope.prefix)) {
            return;
        }
        let message = format!("the stored action `{name}` begins and ends a scan later than its steps");
        self.diagnostics
            .push(doubtful(span, message).note("a chart sees in each scan what was stored in the scan before"));
        self.variables.list[on].used.read = true;
        let guard = self.terms.add(TermKind::Variable(on), Some(Type::Bool), span);
        self.in_each_scan(vec![Done { site: Site { scope, part, own: None }, guard, statements }]);
    }

    /// What is stored in each scan in which a guard holds, whatever step is active.
    fn always_stored(&mut self, variable: VarId, value: TermId, guard: TermId) {
        let guard = self.terms.unless_always(guard);
        self.always.push(Action::Stored { variable, value, when: When::EachScan(guard) });
    }

    /// Writes the actions that are Boolean variables, now that all that is read and stored is known.
    pub fn named(&mut self, named: Vec<Named>) {
        for action in named {
            let used = self.variables.list[action.variable].used;
            let initial = self.parts[action.site.part].chart.steps[self.steps[action.step].step].initial;
            // Who reads it in the next scan would see a continuous action a scan too early.
            let early = used.read && (initial || action.qualifier.is_timed());
            self.variables.list[action.variable].used.stored |= early;
            if self.variables.list[action.variable].used.stored {
                self.named_stored(&action, initial);
            } else {
                self.named_continuous(&action);
            }
        }
    }

    fn named_continuous(&mut self, action: &Named) {
        let span = action.span;
        let sign = match action.qualifier {
            Qualifier::D => Some(" >= "),
            Qualifier::L => Some(" < "),
            _ => None,
        };
        let mut condition = self.parts[action.site.part].called;
        if let Some(sign) = sign {
            let Some(timed) = self.since(action.time, &action.site.clone(), action.step, sign, span) else { return };
            condition = Some(condition.map_or(timed, |called| self.terms.and(called, timed)));
        }
        self.step_texts[action.step].actions.push(Action::Continuous { variable: action.variable, condition });
    }

    fn named_stored(&mut self, action: &Named, initial: bool) {
        let (step, variable, span) = (action.step, action.variable, action.span);
        let (yes, no) = (self.terms.constant(true, span), self.terms.constant(false, span));
        let called = self.parts[action.site.part].called;
        let each = When::EachScan(called);
        match action.qualifier {
            Qualifier::S => self.hold(action, yes, initial),
            Qualifier::R => {
                self.hold(action, no, initial);
            }
            Qualifier::N | Qualifier::Main => {
                self.store(step, variable, yes, yes, each, initial);
                self.step_texts[step].actions.push(Action::Stored { variable, value: no, when: When::Deactivation });
            }
            Qualifier::D | Qualifier::L | Qualifier::DS => {
                let site = action.site.clone();
                let sign = if action.qualifier == Qualifier::L { " < " } else { " >= " };
                let Some(timed) = self.since(action.time, &site, step, sign, span) else { return };
                let (guard, value) = if action.qualifier == Qualifier::L { (yes, timed) } else { (timed, yes) };
                self.store(step, variable, guard, value, each, initial);
                if action.qualifier != Qualifier::DS {
                    self.step_texts[step].actions.push(Action::Stored {
                        variable,
                        value: no,
                        when: When::Deactivation,
                    });
                }
            }
            Qualifier::P | Qualifier::P1 | Qualifier::Entry if !initial => {
                // In the scan of its activation a step was not active before.
                let active = self.terms.logic(TermKind::Active(step), span);
                let value = self.terms.not(active);
                self.store(step, variable, yes, value, each, initial);
                self.step_texts[step].actions.push(Action::Stored { variable, value: no, when: When::Deactivation });
            }
            Qualifier::P | Qualifier::P1 | Qualifier::Entry => {
                let message = "a pulse of an initial step is lost";
                self.diagnostics.push(lost(span, message).note("MATIEC gives none at the start, CODESYS does"));
            }
            Qualifier::P0 | Qualifier::Exit => {
                self.step_texts[step].actions.push(Action::Stored { variable, value: yes, when: When::Deactivation });
                if self.once(format!("pulse {}", variable.index())) {
                    let old = self.terms.add(TermKind::Variable(variable), Some(Type::Bool), span);
                    self.always_stored(variable, no, old);
                }
            }
            Qualifier::SD | Qualifier::SL => self.stored_time(action),
        }
    }

    /// `S` and `R`: at the activation where nothing can come between, else in each scan.
    fn hold(&mut self, action: &Named, value: TermId, initial: bool) {
        let (step, variable) = (action.step, action.variable);
        let chart = self.parts[action.site.part].chart;
        let alone = self.parts.len() == 1 && chart.is_sequential() && !initial;
        let yes = self.terms.constant(true, action.span);
        if alone {
            self.step_texts[step].actions.push(Action::Stored { variable, value, when: When::Activation });
        } else {
            let called = self.parts[action.site.part].called;
            self.store(step, variable, yes, value, When::EachScan(called), initial);
        }
        let latch = self.variables.find(&format!("{}.set", self.variables.list[variable].path));
        if let (Some(latch), TermKind::Bool(false)) = (latch, &self.terms.terms[value].kind) {
            let no = self.terms.constant(false, action.span);
            self.step_texts[step].actions.push(Action::Stored { variable: latch, value: no, when: When::Activation });
        }
        if value != yes && !chart.is_sequential() && self.once(format!("both {}", variable.index())) {
            let name = self.variables.list[variable].path.clone();
            let message = format!("where steps set and reset `{name}` at once, the later in the chart decides");
            self.diagnostics.push(doubtful(action.span, message).note("in IEC 61131-3, R decides"));
        }
    }

    /// `SD` and `SL`: what remembers that the step was there, and its delay.
    fn stored_time(&mut self, action: &Named) {
        let (step, variable, span) = (action.step, action.variable, action.span);
        let Some(time) = action.time else {
            self.diagnostics.push(lost(span, "an action is lost: its qualifier wants a time, and it has none"));
            return;
        };
        let amount = match self.amount(time, &action.site.clone()) {
            Ok(amount) => amount,
            Err(loss) => {
                self.diagnostics.push(lost(span, format!("an action is lost: {}", loss.why)));
                return;
            }
        };
        let path = format!("{}.set", self.variables.list[variable].path);
        let latch = self.variables.helper(&path, Type::Bool, span);
        self.variables.list[latch].used.stored = true;
        self.variables.list[latch].used.read = true;
        let (yes, no) = (self.terms.constant(true, span), self.terms.constant(false, span));
        self.step_texts[step].actions.push(Action::Stored { variable: latch, value: yes, when: When::Activation });
        let operand = self.terms.add(TermKind::Variable(latch), Some(Type::Bool), span);
        let delay = TermKind::Delay { on: Some(amount), operand, off: None::<Amount> };
        let over = self.terms.logic(delay, span);
        // A delay is a condition, and what is stored is a value: a variable between them.
        let over_path = format!("{}.over", self.variables.list[variable].path);
        let name = self.variables.helper(&over_path, Type::Bool, span);
        self.variables.list[name].used.by_name = true;
        self.variables.list[name].used.read = true;
        self.always.push(Action::Continuous { variable: name, condition: Some(over) });
        let passed = self.terms.add(TermKind::Variable(name), Some(Type::Bool), span);
        if action.qualifier == Qualifier::SD {
            self.always_stored(variable, yes, passed);
        } else {
            let not = self.terms.not(passed);
            let during = self.terms.and(operand, not);
            self.step_texts[step].actions.push(Action::Stored { variable, value: yes, when: When::Activation });
            self.always_stored(variable, during, operand);
            self.always_stored(latch, no, passed);
        }
    }
}
