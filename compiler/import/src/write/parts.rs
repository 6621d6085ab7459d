//! Which charts go into one: that of the unit, and the actions of its steps that are charts themselves.
//!
//! An action that is a chart goes on while it is called and stands still else, keeping its steps (*retained*); so its
//! transitions and actions have, as a further condition, that it is called.

use super::maker::{BlockCall, Maker, Part, PartStep, Scope, StepText};
use super::terms::{StepId, TermId};
use crate::code::tree::{Statement, StatementKind};
use crate::sfc::{Association, Body, Chart, Qualifier, Target};
use crate::{Dialect, doubtful, lost};
use grafc_diagnostics::Span;
use rustc_hash::FxHashMap;

/// The key of a part: unit, prefix, action.
type Key = (usize, String, Option<usize>);

/// How many parts one chart may have.
pub(super) const MOST_PARTS: usize = 2_000;

impl<'a> Maker<'a> {
    /// Finds all parts and their steps.
    pub fn find_parts(&mut self, unit: usize) {
        let project = self.project;
        let own = &project.units[unit];
        let mut known: FxHashMap<Key, usize> = FxHashMap::default();
        let root = Scope { unit, prefix: String::new() };
        if let Some(chart) = &own.chart {
            self.add_part(root.clone(), own.name.clone(), chart, own.span);
            known.insert((unit, String::new(), None), 0);
            self.follow(0, &mut known);
        }
        // Charts that no chart calls are called from a body that is none; charts that call each other have no beginning.
        for called_too in [false, true] {
            for (place, action) in own.actions.iter().enumerate() {
                let Body::Chart(chart) = &action.body else { continue };
                let key = (unit, String::new(), Some(place));
                if known.contains_key(&key) || !called_too && self.is_called_inside(unit, place) {
                    continue;
                }
                let message = format!("the chart `{}` is called by no chart, and goes on at all times", action.name);
                self.diagnostics.push(
                    doubtful(action.span, message)
                        .note("in the file it may be called under conditions, by statements or by another unit"),
                );
                let part = self.parts.len();
                self.add_part(root.clone(), action.name.clone(), chart, action.span);
                known.insert(key, part);
                self.follow(part, &mut known);
            }
        }
        self.called();
    }

    /// Whether a step of another chart of the unit has this action, so that it is found from there.
    fn is_called_inside(&self, unit: usize, action: usize) -> bool {
        let own = &self.project.units[unit];
        let name = &own.actions[action].name;
        let others = own.actions.iter().enumerate().filter(|(place, _)| *place != action);
        let charts = others.filter_map(|(_, action)| match &action.body {
            Body::Chart(chart) => Some(chart),
            Body::Statements(_) => None,
        });
        let mut named = charts.flat_map(|chart| &chart.steps).flat_map(|step| &step.actions);
        named.any(|association| matches!(&association.action, Target::Named(n) if n.eq_ignore_ascii_case(name)))
    }

    pub(super) fn add_part(&mut self, scope: Scope, name: String, chart: &'a Chart, span: Span) {
        let part = self.parts.len();
        let first = self.steps.len();
        for (place, step) in chart.steps.iter().enumerate() {
            let id = self.steps.push(PartStep { part, step: place });
            self.step_texts.push(StepText::default());
            self.by_name.entry((part, step.name.to_lowercase())).or_insert(id);
        }
        self.parts.push(Part {
            scope,
            name,
            chart,
            first,
            callers: Vec::new(),
            span,
            called: None,
            parent: None,
            ordered: false,
        });
    }

    /// Adds the charts that steps of a part have as actions, and those of these.
    fn follow(&mut self, first: usize, known: &mut FxHashMap<Key, usize>) {
        let mut next = first;
        while next < self.parts.len() {
            let (chart, scope) = (self.parts[next].chart, self.parts[next].scope.clone());
            for (place, step) in chart.steps.iter().enumerate() {
                let id = StepId::new(self.parts[next].first + place);
                for association in &step.actions {
                    let Target::Named(name) = &association.action else { continue };
                    let Some((inner, action)) = self.action(&scope, name) else { continue };
                    let Body::Chart(body) = self.body(&inner, action) else { continue };
                    let key = (inner.unit, inner.prefix.clone(), Some(action));
                    let part = match known.get(&key) {
                        Some(&part) => part,
                        None if self.parts.len() >= MOST_PARTS => continue,
                        None => {
                            let part = self.parts.len();
                            self.add_part(inner, name.clone(), body, association.span);
                            known.insert(key, part);
                            part
                        }
                    };
                    self.parts[part].callers.push((id, association.qualifier, association.span));
                }
            }
            self.find_children(next, true);
            next += 1;
            if next == self.parts.len() {
                (first..next).for_each(|part| self.find_children(part, false));
            }
        }
    }

    /// The parts, callers first; of charts that call each other one has to begin.
    fn in_order(&mut self) -> Vec<usize> {
        let count = self.parts.len();
        let mut waits: Vec<usize> = self.parts.iter().map(|part| part.callers.len()).collect();
        let mut calls: Vec<Vec<usize>> = vec![Vec::new(); count];
        for (part, called) in self.parts.iter().enumerate() {
            for (step, ..) in &called.callers {
                calls[self.steps[*step].part].push(part);
            }
        }
        let mut ready: Vec<usize> = (0..count).rev().filter(|&part| waits[part] == 0).collect();
        let mut order = Vec::new();
        let mut done = vec![false; count];
        let mut first = 0;
        while order.len() < count {
            let part = match ready.pop() {
                Some(part) => part,
                None => {
                    while done[first] {
                        first += 1;
                    }
                    let (name, span) = (self.parts[first].name.clone(), self.parts[first].span);
                    self.diagnostics.push(lost(span, format!("the chart `{name}` would call itself, which is lost")));
                    let steps = &self.steps;
                    self.parts[first].callers.retain(|(step, ..)| done[steps[*step].part]);
                    waits[first] = 0;
                    first
                }
            };
            if std::mem::replace(&mut done[part], true) {
                continue;
            }
            order.push(part);
            for &called in &calls[part] {
                waits[called] = waits[called].saturating_sub(1);
                if waits[called] == 0 && !done[called] {
                    ready.push(called);
                }
            }
        }
        order
    }

    /// While which steps each part goes on.
    fn called(&mut self) {
        for part in self.in_order() {
            let callers = std::mem::take(&mut self.parts[part].callers);
            if callers.is_empty() {
                continue;
            }
            let (name, span) = (self.parts[part].name.clone(), self.parts[part].span);
            let mut conditions: Vec<TermId> = Vec::new();
            for (step, qualifier, span) in &callers {
                if !matches!(qualifier, Qualifier::N | Qualifier::Main) {
                    let message =
                        format!("the chart `{name}` is called while a step is active, and not by its qualifier");
                    self.diagnostics.push(lost(*span, message));
                }
                let active = self.terms.logic(super::terms::TermKind::Active(*step), *span);
                let outer = self.parts[self.steps[*step].part].called;
                conditions.push(match outer {
                    Some(outer) => self.terms.and(outer, active),
                    None => active,
                });
            }
            self.parts[part].called = Some(self.terms.any(conditions, span));
            self.parts[part].callers = callers;
            if self.once("called charts") {
                let message = format!("the chart `{name}` keeps its steps while it is not called");
                let note = match self.dialect {
                    Dialect::Isagraf => "a child program of ISaGRAF is killed when its step ends, and begins anew",
                    Dialect::Iec | Dialect::Codesys => {
                        "so IEC 61131-3 has it; a child program of ISaGRAF would be killed when its step ends"
                    }
                };
                self.diagnostics.push(
                    doubtful(span, message)
                        .note(note)
                        .note("it goes on from the scan after that in which its step becomes active"),
                );
            }
        }
    }

    /// Notes which function blocks are called, and while what is true.
    pub fn find_calls(&mut self) {
        for part in 0..self.parts.len() {
            let (chart, scope, first) =
                (self.parts[part].chart, self.parts[part].scope.clone(), self.parts[part].first);
            self.note_calls(&scope, &chart.beside, None);
            for (place, step) in chart.steps.iter().enumerate() {
                for association in &step.actions {
                    let Some((inner, statements)) = self.statements(&scope, association) else { continue };
                    let condition = match (association.qualifier, &association.action) {
                        // What it is stored in counts, not the step that stores it.
                        (Qualifier::R, _) => continue,
                        (Qualifier::S | Qualifier::SD | Qualifier::DS | Qualifier::SL, Target::Named(name)) => {
                            if self.is_always(part, step.initial, name) {
                                None
                            } else {
                                let path = format!("{}{name}.on", inner.prefix);
                                let on = self.variables.helper(&path, grafc_syntax::ast::Type::Bool, association.span);
                                self.variables.list[on].used.read = true;
                                Some(self.terms.logic(super::terms::TermKind::Variable(on), association.span))
                            }
                        }
                        _ => {
                            let step = StepId::new(first + place);
                            Some(self.terms.logic(super::terms::TermKind::Active(step), association.span))
                        }
                    };
                    self.note_calls(&inner, statements, condition);
                }
            }
        }
    }

    /// Whether an action is done from the first scan on for ever: an initial step stores it and no step resets it.
    pub fn is_always(&self, part: usize, initial: bool, name: &str) -> bool {
        let chart = self.parts[part].chart;
        let mut associations = chart.steps.iter().flat_map(|step| &step.actions);
        initial
            && self.parts[part].called.is_none()
            && !associations.any(|association| {
                let named = matches!(&association.action, Target::Named(other) if other.eq_ignore_ascii_case(name));
                named && association.qualifier == Qualifier::R
            })
    }

    /// The statements of an association; none of those that are variables or charts.
    pub fn statements(&self, scope: &Scope, association: &'a Association) -> Option<(Scope, &'a [Statement])> {
        match &association.action {
            Target::Inline(statements) => Some((scope.clone(), statements.as_slice())),
            Target::Named(name) => {
                let (scope, action) = self.action(scope, name)?;
                match self.body(&scope, action) {
                    Body::Statements(statements) => Some((scope, statements.as_slice())),
                    Body::Chart(_) => None,
                }
            }
        }
    }

    fn note_calls(&mut self, scope: &Scope, statements: &'a [Statement], condition: Option<TermId>) {
        for statement in statements {
            let StatementKind::Call(name, arguments) = &statement.kind else { continue };
            if self.standard_block(scope, name).is_none() {
                continue;
            }
            let key = format!("{}{name}", scope.prefix).to_lowercase();
            let call = self.calls.entry(key).or_insert_with(|| BlockCall {
                scope: scope.clone(),
                arguments: arguments.clone(),
                while_true: Vec::new(),
                always: false,
                span: statement.span,
            });
            if call.span == statement.span {
                match condition {
                    Some(condition) if !call.while_true.contains(&condition) => call.while_true.push(condition),
                    Some(_) => {}
                    None => call.always = true,
                }
            } else {
                let message =
                    format!("a second call of `{name}` is lost: charts have one delay or edge for each block");
                let span = statement.span;
                if self.once(format!("second call {} {}", name, span.start)) {
                    self.diagnostics.push(lost(span, message));
                }
            }
        }
    }
}
