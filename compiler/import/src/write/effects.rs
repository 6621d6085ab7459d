//! What a body of statements does, as assignments that are done at once.
//!
//! Statements are done one after the other, and what is assigned is read by those behind; in a chart all right sides see
//! the values of before. So each variable keeps the cases in which it has been assigned, under the conditions that stood
//! around the assignment, and where it is read they are put in its place. What cannot be said is lost alone; what stands
//! under a condition that cannot be said is lost with it.

use super::blocks::BlockUse;
use super::maker::Maker;
use super::outcome::Effects;
use super::resolve::{Cases, Environment, Loss, Site};
use super::terms::{TermId, TermKind, VarId};
use crate::code::tree::{Argument, ExprId, ExprKind, Statement, StatementKind};
use crate::sfc::Body;
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;
use rustc_hash::FxHashMap;

/// How deep actions may call each other.
const DEPTH: usize = 16;

/// How many statements a step may do, calls of actions written out.
const MOST_STATEMENTS: usize = 20_000;

/// A body, under which condition it is done, and where its names are looked up.
pub struct Done<'a> {
    pub site: Site,
    pub guard: TermId,
    pub statements: &'a [Statement],
}

/// An `IF` or a `CASE` that is open.
struct Frame {
    /// The condition around it; none if it cannot be said.
    around: Option<TermId>,
    /// Whether one of the branches before was taken; none if that cannot be said.
    taken: Option<TermId>,
    /// The conditions of the branches of an `IF` that are to come, in order, the last first.
    branches: Vec<Option<TermId>>,
    /// What a `CASE` chooses by.
    selector: Option<Cases>,
}

/// Statements in work.
struct Run<'a> {
    site: Site,
    statements: &'a [Statement],
    at: usize,
    frames: Vec<Frame>,
    /// The condition here; none if it cannot be said.
    here: Option<TermId>,
    /// The branches of each `IF`.
    branches: FxHashMap<usize, Vec<ExprId>>,
}

impl<'a> Run<'a> {
    fn new(site: Site, statements: &'a [Statement], here: Option<TermId>) -> Self {
        let mut branches: FxHashMap<usize, Vec<ExprId>> = FxHashMap::default();
        let mut open: Vec<Option<usize>> = Vec::new();
        for (place, statement) in statements.iter().enumerate() {
            match statement.kind {
                StatementKind::If(_) => open.push(Some(place)),
                StatementKind::Case(_) => open.push(None),
                StatementKind::EndIf | StatementKind::EndCase => {
                    open.pop();
                }
                StatementKind::Elsif(condition) => {
                    if let Some(Some(begin)) = open.last() {
                        branches.entry(*begin).or_default().push(condition);
                    }
                }
                StatementKind::Assign { .. }
                | StatementKind::Call(..)
                | StatementKind::Else
                | StatementKind::Label(_)
                | StatementKind::Lost { .. } => {}
            }
        }
        Run { site, statements, at: 0, frames: Vec::new(), here, branches }
    }
}

impl<'a> Maker<'a> {
    /// What bodies do, one after the other.
    pub fn effects(&mut self, bodies: Vec<Done<'a>>) -> Effects {
        let effects = self.one_after_the_other(bodies);
        self.delays_called.clear();
        effects
    }

    fn one_after_the_other(&mut self, bodies: Vec<Done<'a>>) -> Effects {
        let mut effects = Effects::default();
        let mut left = MOST_STATEMENTS;
        for body in bodies {
            let mut stack = vec![Run::new(body.site, body.statements, Some(body.guard))];
            while let Some(run) = stack.last_mut() {
                let Some(statement) = run.statements.get(run.at) else {
                    stack.pop();
                    continue;
                };
                run.at += 1;
                let Some(rest) = left.checked_sub(1) else {
                    effects.lose(statement.span, "a step does too much", String::new());
                    return effects;
                };
                left = rest;
                if let StatementKind::Call(name, arguments) = &statement.kind {
                    let (site, here) = (run.site.clone(), run.here);
                    let inner = self.called_action(&site, name, arguments);
                    if let Some((_, inner)) = &inner
                        && (stack.len() >= DEPTH || stack.iter().any(|run| std::ptr::eq(run.statements, *inner)))
                    {
                        effects.lose(statement.span, "actions call each other without end", format!("{name}()"));
                        continue;
                    }
                    if let Some(inner) = inner {
                        stack.push(Run::new(Site { scope: inner.0, ..site }, inner.1, here));
                        continue;
                    }
                    if !self.order_of(&site, here, (name, arguments), statement.span, &mut effects) {
                        self.call(&site, here, name, arguments, statement.span, &mut effects);
                    }
                    continue;
                }
                self.statement(run, statement, &mut effects);
            }
        }
        effects
    }

    /// The statements of an action that is called as a statement.
    fn called_action(
        &self,
        site: &Site,
        name: &str,
        arguments: &[Argument],
    ) -> Option<(super::maker::Scope, &'a [Statement])> {
        if !arguments.is_empty() {
            return None;
        }
        let (scope, action) = self.action(&site.scope, name)?;
        match self.body(&scope, action) {
            Body::Statements(statements) => Some((scope, statements.as_slice())),
            Body::Chart(_) => None,
        }
    }

    fn statement(&mut self, run: &mut Run<'a>, statement: &'a Statement, effects: &mut Effects) {
        let span = statement.span;
        match &statement.kind {
            StatementKind::Assign { target, value } => {
                self.assign(&run.site, run.here, target, *value, span, effects);
            }
            StatementKind::If(condition) => {
                let mut branches = vec![*condition];
                branches.extend(run.branches.remove(&(run.at - 1)).unwrap_or_default());
                let mut known: Vec<Option<TermId>> = Vec::new();
                self.here = run.here;
                for condition in branches {
                    known.push(self.guard(condition, &run.site, effects));
                }
                self.here = None;
                known.reverse();
                let around = run.here;
                let none = self.terms.constant(false, span);
                run.frames.push(Frame { around, taken: Some(none), branches: known, selector: None });
                self.branch(run);
            }
            StatementKind::Elsif(_) => self.branch(run),
            StatementKind::Case(selector) => {
                let site = run.site.clone();
                let ty = self.type_of_selector(*selector, &site);
                self.here = run.here;
                let chosen = self.value(*selector, ty, &site, &effects.environment);
                self.here = None;
                let selector = match chosen {
                    Ok(cases) => Some(cases),
                    Err(loss) => {
                        effects.lose_loss(loss, "a `CASE`");
                        None
                    }
                };
                let none = self.terms.constant(false, span);
                let taken = selector.is_some().then_some(none);
                run.frames.push(Frame { around: run.here, taken, branches: Vec::new(), selector });
                run.here = Some(none);
            }
            StatementKind::Label(values) => self.label(run, values, span),
            StatementKind::Else => {
                let Some(frame) = run.frames.last() else { return };
                run.here = match (frame.around, frame.taken) {
                    (Some(around), Some(taken)) => {
                        let not = self.terms.not(taken);
                        Some(self.terms.and(around, not))
                    }
                    _ => None,
                };
            }
            StatementKind::EndIf | StatementKind::EndCase => {
                if let Some(frame) = run.frames.pop() {
                    run.here = frame.around;
                }
            }
            StatementKind::Lost { why, text } => effects.lose(span, why, text.clone()),
            StatementKind::Call(..) => {}
        }
    }

    /// A condition of a branch; none if it cannot be said.
    fn guard(&mut self, condition: ExprId, site: &Site, effects: &mut Effects) -> Option<TermId> {
        match self.condition(condition, site, &effects.environment) {
            Ok(condition) => Some(condition),
            Err(loss) => {
                effects.lose_loss(loss, "a condition");
                None
            }
        }
    }

    /// The next branch of an `IF`.
    fn branch(&mut self, run: &mut Run<'a>) {
        let Some(frame) = run.frames.last_mut() else { return };
        let condition = frame.branches.pop().flatten();
        run.here = match (frame.around, frame.taken, condition) {
            (Some(around), Some(taken), Some(condition)) => {
                // What excludes the branches before by its form needs no negation of them.
                let own = if self.terms.exclude(taken, condition) {
                    condition
                } else {
                    let not = self.terms.not(taken);
                    self.terms.and(not, condition)
                };
                Some(self.terms.and(around, own))
            }
            _ => None,
        };
        frame.taken = match (frame.taken, condition) {
            (Some(taken), Some(condition)) => Some(self.terms.or(taken, condition)),
            _ => None,
        };
    }

    fn label(&mut self, run: &mut Run<'a>, values: &[(ExprId, ExprId)], span: Span) {
        let site = run.site.clone();
        let Some(frame) = run.frames.last_mut() else { return };
        let (Some(selector), Some(taken), Some(around)) = (frame.selector.clone(), frame.taken, frame.around) else {
            run.here = None;
            return;
        };
        let mut condition = Some(self.terms.constant(false, span));
        for &(from, to) in values {
            let mut range = Vec::new();
            for (guard, chosen) in &selector {
                let ty = self.terms.terms[*chosen].ty.unwrap_or(Type::Dint);
                let none = Environment::default();
                let ends = [from, to]
                    .map(|end| self.value(end, ty, &site, &none).ok().and_then(|cases| cases.first().copied()));
                let [Some((_, from_value)), Some((_, to_value))] = ends else {
                    condition = None;
                    break;
                };
                let inside = if from == to {
                    self.terms.logic(TermKind::Pair(" = ", *chosen, from_value), span)
                } else {
                    let least = self.terms.logic(TermKind::Pair(" >= ", *chosen, from_value), span);
                    let most = self.terms.logic(TermKind::Pair(" <= ", *chosen, to_value), span);
                    self.terms.and(least, most)
                };
                range.push(self.terms.and(*guard, inside));
            }
            let any = self.terms.any(range, span);
            condition = condition.map(|before| self.terms.or(before, any));
        }
        let Some(frame) = run.frames.last_mut() else { return };
        let Some(condition) = condition else {
            (run.here, frame.taken) = (None, None);
            return;
        };
        let not = self.terms.not(taken);
        // Labels of numbers exclude each other by themselves.
        let own = if selector.len() == 1 { condition } else { self.terms.and(not, condition) };
        run.here = Some(self.terms.and(around, own));
        frame.taken = Some(self.terms.or(taken, condition));
    }

    fn assign(
        &mut self,
        site: &Site,
        here: Option<TermId>,
        target: &str,
        value: ExprId,
        span: Span,
        effects: &mut Effects,
    ) {
        let text = || format!("{target} := …");
        let Some(here) = here else {
            return effects.lose(span, "it stands under a condition that charts cannot say", text());
        };
        if self.terms.is(here, false) {
            return;
        }
        let ty = self.type_of_value(value, site);
        let variable = match self.target(target, ty, span, site) {
            Ok(variable) => variable,
            Err(loss) => return effects.lose(span, &loss.why, text()),
        };
        let ty = self.variables.list[variable].ty;
        self.here = Some(here);
        let cases = self.value(value, ty, site, &effects.environment);
        self.here = None;
        let cases = cases.map(|cases| self.apart(cases));
        match cases {
            Ok(cases) => self.set(variable, here, cases, effects),
            Err(loss) => effects.lose(span, &loss.why, text()),
        }
    }

    /// Sets a variable under a condition.
    pub fn set(&mut self, variable: VarId, here: TermId, cases: Cases, effects: &mut Effects) {
        self.variables.list[variable].used.stored = true;
        let new: Cases = cases.into_iter().map(|(guard, value)| (self.terms.and(here, guard), value)).collect();
        let Some(before) = effects.environment.remove(&variable) else {
            effects.order.push(variable);
            effects.environment.insert(variable, new);
            return;
        };
        let mut all: Cases = Vec::new();
        for (guard, value) in before {
            // What is left of the condition where the guard holds; nothing if the assignment before stands alone.
            let guard = match self.terms.under(here, guard) {
                None => guard,
                Some(rest) => {
                    let not = self.terms.not(rest);
                    self.terms.and(guard, not)
                }
            };
            if !self.terms.is(guard, false) {
                all.push((guard, value));
            }
        }
        all.extend(new);
        effects.environment.insert(variable, all);
    }

    fn call(
        &mut self,
        site: &Site,
        here: Option<TermId>,
        name: &str,
        arguments: &'a [Argument],
        span: Span,
        effects: &mut Effects,
    ) {
        let Some(here) = here else {
            return effects.lose(span, "it stands under a condition that charts cannot say", format!("{name}(…)"));
        };
        match self.standard_block(&site.scope, name) {
            Some(block) => {
                let usage = BlockUse { block, site, here, name, arguments, span };
                if let Err(loss) = self.step_block(&usage, effects) {
                    effects.lose(span, &loss.why, format!("{name}(…)"));
                }
            }
            None => effects.lose(span, &self.why_no_call(site, name), format!("{name}(…)")),
        }
        // What its outputs are given to.
        for argument in arguments.iter().filter(|argument| argument.gives) {
            let (Some(pin), ExprKind::Path(target)) = (&argument.name, &self.project.code.exprs[argument.value].kind)
            else {
                continue;
            };
            let output = format!("{name}.{pin}");
            let given = match self.block_output(&output, span, site) {
                Ok(Some(term)) => Ok(self.certain(term)),
                Ok(None) => Err(Loss { why: format!("charts do not know the output `{output}`"), span }),
                Err(loss) => Err(loss),
            };
            match given.and_then(|cases| {
                let ty = cases.first().and_then(|(_, value)| self.terms.terms[*value].ty);
                Ok((self.target(target, ty, span, site)?, cases))
            }) {
                Ok((variable, cases)) => self.set(variable, here, cases, effects),
                Err(loss) => effects.lose(span, &loss.why, format!("{name}({pin} => {target})")),
            }
        }
    }

    /// Why a call cannot be said.
    fn why_no_call(&self, site: &Site, name: &str) -> String {
        let unit = self.unit(&site.scope);
        let ty = unit.variables.find(name).map(|v| v.ty.as_str());
        match ty {
            Some(ty) if self.units.contains_key(&ty.to_lowercase()) => {
                format!("`{name}` is a block of the type `{ty}`, which is imported by itself")
            }
            Some(ty) => format!("`{name}` is a block of the type `{ty}`, which charts do not have"),
            None => format!("charts cannot call `{name}`"),
        }
    }
}
