//! Child programs of ISaGRAF: `GSTART`, `GKILL`, `GFREEZE` and `GRST` of another program, and `GSTATUS` of it.
//!
//! A program that is commanded becomes a child grafcet of the one that commands it first; only that one may (R15). An order
//! is given once, at an event: so one that a body would give in each scan is given when its step becomes active, or when
//! its condition becomes true. With `--dialect isagraf` a program may also be the action of a step: `N` runs it, `S` starts
//! and `R` kills it.

use super::maker::{Action, Command, Event, Maker, Scope, When};
use super::outcome::{Effects, Order};
use super::resolve::{Cases, Loss, Site};
use super::terms::{StepId, TermId, TermKind};
use crate::code::tree::{Argument, ExprKind, Statement, StatementKind};
use crate::sfc::{Association, Body, Project, Qualifier, Target};
use crate::{Dialect, doubtful, lost};
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;
use rustc_hash::FxHashSet;

impl Command {
    /// The order of a call.
    pub fn of(name: &str) -> Option<Command> {
        Some(match name.to_ascii_uppercase().as_str() {
            "GSTART" => Command::Start,
            "GKILL" => Command::Kill,
            "GFREEZE" => Command::Freeze,
            "GRST" => Command::Resume,
            _ => return None,
        })
    }

    /// Its word in a chart.
    pub fn word(self) -> &'static str {
        match self {
            Command::Start => "start",
            Command::Kill => "kill",
            Command::Freeze => "freeze",
            Command::Resume => "resume",
        }
    }
}

/// The program that a call names.
pub(super) fn named<'p>(project: &'p Project, arguments: &[Argument]) -> Option<&'p str> {
    match arguments {
        [argument] => match &project.code.exprs[argument.value].kind {
            ExprKind::Path(path) => Some(path),
            _ => None,
        },
        _ => None,
    }
}

impl<'a> Maker<'a> {
    /// The children that the steps of a part command, as parts of their own; who starts a program is its father, and only
    /// where nobody does who commands it else.
    pub(super) fn find_children(&mut self, part: usize, starts: bool) {
        let (chart, scope) = (self.parts[part].chart, self.parts[part].scope.clone());
        let mut seen: FxHashSet<*const Statement> = FxHashSet::default();
        for association in chart.steps.iter().flat_map(|step| &step.actions) {
            let Some((inner, statements)) = self.statements(&scope, association) else {
                if let Some(unit) = self.program_of(&scope, association)
                    && (association.qualifier != Qualifier::R || !starts)
                {
                    self.adopt(part, unit, association.span);
                }
                continue;
            };
            let mut open = vec![(inner, statements)];
            while let Some((scope, statements)) = open.pop() {
                if !statements.first().is_some_and(|first| seen.insert(first)) {
                    continue;
                }
                for statement in statements {
                    let StatementKind::Call(name, arguments) = &statement.kind else { continue };
                    if let Some(command) = Command::of(name) {
                        if starts && command != Command::Start {
                            continue;
                        }
                        let unit = named(self.project, arguments).and_then(|name| self.program(name));
                        if let Some(unit) = unit {
                            self.adopt(part, unit, statement.span);
                        }
                    } else if let Some((scope, action)) = self.action(&scope, name)
                        && let Body::Statements(statements) = self.body(&scope, action)
                    {
                        open.push((scope, statements));
                    }
                }
            }
        }
    }

    /// The unit of a name, if it has a chart.
    fn program(&self, name: &str) -> Option<usize> {
        let unit = *self.units.get(&name.to_lowercase())?;
        self.project.units[unit].chart.is_some().then_some(unit)
    }

    /// The program that is the action of a step.
    fn program_of(&self, scope: &Scope, association: &Association) -> Option<usize> {
        let Target::Named(name) = &association.action else { return None };
        let is_variable = self.unit(scope).variables.find(name).is_some() || self.project.globals.find(name).is_some();
        let is_action = self.action(scope, name).is_some();
        if self.dialect != Dialect::Isagraf || is_variable || is_action { None } else { self.program(name) }
    }

    /// Makes a program the child of a part, unless it has a father already or commands that part.
    fn adopt(&mut self, part: usize, unit: usize, span: Span) {
        let project = self.project;
        let is_above = std::iter::successors(Some(part), |part| self.parts[*part].parent)
            .any(|part| self.parts[part].scope.unit == unit);
        let Some(chart) = &project.units[unit].chart else { return };
        if is_above || self.children.contains_key(&unit) || self.parts.len() >= super::parts::MOST_PARTS {
            return;
        }
        let name = project.units[unit].name.clone();
        self.children.insert(unit, self.parts.len());
        self.add_part(Scope { unit, prefix: format!("{name}.") }, name, chart, span);
        if let Some(child) = self.parts.last_mut() {
            child.parent = Some(part);
        }
    }

    /// The child that a name stands for where a part commands it.
    fn child(&self, part: usize, name: &str) -> Result<usize, String> {
        let unit = self.units.get(&name.to_lowercase()).copied();
        let Some(unit) = unit else { return Err(format!("there is no program `{name}` in the file")) };
        match self.children.get(&unit) {
            Some(&child) if self.parts[child].parent == Some(part) => Ok(child),
            Some(&child) => {
                let father = self.parts[child].parent.map_or("", |father| self.parts[father].name.as_str());
                Err(format!("`{name}` is a child of `{father}`, and only that commands it"))
            }
            None if self.project.units[unit].chart.is_none() => Err(format!("`{name}` has no chart")),
            None => Err(format!("`{name}` commands what would command it")),
        }
    }

    /// The order that a statement gives, if it is one.
    pub(super) fn order_of(
        &mut self,
        site: &Site,
        here: Option<TermId>,
        (name, arguments): (&str, &[Argument]),
        span: Span,
        effects: &mut Effects,
    ) -> bool {
        let Some(command) = Command::of(name) else { return false };
        let program = named(self.project, arguments);
        let text = || format!("{name}({})", program.unwrap_or("…"));
        let child = program.ok_or_else(|| "it names no program".to_string());
        let child = child.and_then(|program| self.child(site.part, program));
        match (child, here) {
            (Ok(child), Some(guard)) => effects.given.push(Order { command, child, guard, span }),
            (Ok(_), None) => effects.lose(span, "it stands under a condition that charts cannot say", text()),
            (Err(why), _) => effects.lose(span, &why, text()),
        }
        true
    }

    /// Gives the orders of bodies of a step.
    pub(super) fn give(&mut self, step: StepId, orders: Vec<Order>, when: When) {
        for Order { command, child, guard, span } in orders {
            let always = self.terms.is(guard, true);
            if self.terms.is(guard, false) {
                continue;
            }
            let name = self.parts[child].name.clone();
            let word = command.word();
            let event = match when {
                When::Activation if always => Event::Activation,
                When::Deactivation if always => Event::Deactivation,
                When::Activation | When::Deactivation => {
                    let message =
                        format!("an order to `{name}` is lost: charts give none under a condition at that event");
                    self.diagnostics.push(lost(span, message));
                    self.step_texts[step].lost.push(format!("{word} {name}"));
                    continue;
                }
                When::EachScan(_) if always => {
                    let message = format!("`{word} {name}` is given once, when its step becomes active");
                    self.diagnostics.push(doubtful(span, message).note("ISaGRAF gives it in each scan"));
                    Event::Activation
                }
                When::EachScan(called) => {
                    let message = format!("`{word} {name}` is given once, when its condition becomes true");
                    self.diagnostics.push(
                        doubtful(span, message)
                            .note("ISaGRAF gives it in each scan in which the condition is true")
                            .note("a condition that is true when the step becomes active counts from the next scan on"),
                    );
                    let guard = called.map_or(guard, |called| self.terms.and(called, guard));
                    let active = self.terms.logic(TermKind::Active(step), span);
                    let guard = self.terms.and(active, guard);
                    if self.has(guard, |kind| {
                        matches!(kind, TermKind::Rise(_) | TermKind::Fall(_) | TermKind::Delay { .. })
                    }) {
                        let message = format!(
                            "an order to `{name}` is lost: charts have no edge of what holds an edge or a delay"
                        );
                        self.diagnostics.push(lost(span, message));
                        continue;
                    }
                    Event::Edge(self.terms.logic(TermKind::Rise(guard), span))
                }
            };
            self.parts[child].ordered = true;
            self.step_texts[step].actions.push(Action::Pulse { command, child, event });
        }
    }

    /// A step whose action is a program; whether it is one.
    pub(super) fn step_program(&mut self, part: usize, step: StepId, association: &Association) -> bool {
        let (scope, span) = (self.parts[part].scope.clone(), association.span);
        let (Some(_), Target::Named(name)) = (self.program_of(&scope, association), &association.action) else {
            return false;
        };
        let child = match self.child(part, name) {
            Ok(child) => child,
            Err(why) => {
                self.diagnostics.push(lost(span, format!("the action `{name}` is lost: {why}")));
                return true;
            }
        };
        let pulse = |command| Action::Pulse { command, child, event: Event::Activation };
        let action = match association.qualifier {
            Qualifier::N => Action::Run { child },
            Qualifier::S => pulse(Command::Start),
            Qualifier::R => pulse(Command::Kill),
            Qualifier::P
            | Qualifier::P1
            | Qualifier::P0
            | Qualifier::L
            | Qualifier::D
            | Qualifier::SD
            | Qualifier::DS
            | Qualifier::SL
            | Qualifier::Main
            | Qualifier::Entry
            | Qualifier::Exit => {
                let message = format!("the action `{name}` is lost: a child program has the qualifiers N, S and R");
                self.diagnostics.push(lost(span, message));
                return true;
            }
        };
        self.parts[child].ordered = true;
        self.step_texts[step].actions.push(action);
        true
    }

    /// Says where a step that runs a child hands over to another: ISaGRAF begins the child anew, a chart leaves it alone.
    pub(super) fn tell_handovers(&mut self) {
        let runs = |maker: &Self, step: StepId| -> Vec<usize> {
            let actions = maker.step_texts[step].actions.iter();
            actions.filter_map(|action| if let Action::Run { child } = action { Some(*child) } else { None }).collect()
        };
        for part in 0..self.parts.len() {
            let (chart, first) = (self.parts[part].chart, self.parts[part].first);
            for transition in &chart.transitions {
                let of = |steps: &[usize]| -> FxHashSet<usize> {
                    steps.iter().flat_map(|step| runs(self, StepId::new(first + step))).collect()
                };
                let (before, behind) = (of(&transition.before), of(&transition.behind));
                let mut both: Vec<usize> = before.intersection(&behind).copied().collect();
                both.sort_unstable();
                for child in both {
                    let name = self.parts[child].name.clone();
                    if self.once(format!("handover {child}")) {
                        let message = format!("`{name}` goes on where a step that runs it hands over to another");
                        self.diagnostics.push(doubtful(transition.span, message).note("ISaGRAF begins it anew"));
                    }
                }
            }
        }
    }

    /// Cases of which nobody has to know that a program is never active and frozen.
    pub(super) fn apart(&mut self, cases: Cases) -> Cases {
        let apart = |(guard, value): (TermId, TermId)| {
            let TermKind::ChildActive(child) = self.terms.terms[guard].kind else { return (guard, value) };
            let frozen = self.terms.logic(TermKind::ChildFrozen(child), self.terms.terms[guard].span);
            let not = self.terms.not(frozen);
            (self.terms.and(guard, not), value)
        };
        cases.into_iter().map(apart).collect()
    }

    /// `GSTATUS(P)`: 2 while it is frozen, 1 while it is active, else 0.
    pub(super) fn status(&mut self, arguments: &[Argument], wanted: Type, span: Span) -> Result<Cases, Loss> {
        let loss = |why: String| Loss { why, span };
        let name = named(self.project, arguments).ok_or_else(|| loss("`GSTATUS` names no program".into()))?;
        let unit = self.units.get(&name.to_lowercase());
        let child = unit.and_then(|unit| self.children.get(unit)).copied();
        let child = child.ok_or_else(|| loss(format!("no chart here gives orders to `{name}`")))?;
        if !wanted.is_whole() {
            return Err(loss(format!("a number stands where `{}` is wanted", wanted.keyword())));
        }
        let frozen = self.terms.logic(TermKind::ChildFrozen(child), span);
        let active = self.terms.logic(TermKind::ChildActive(child), span);
        let any = self.terms.or(frozen, active);
        let neither = self.terms.not(any);
        let mut number = |number| self.terms.add(TermKind::Integer(number), Some(wanted), span);
        Ok(vec![(neither, number(0)), (active, number(1)), (frozen, number(2))])
    }
}
