//! Scenarios: names and values of the chart that they test, which knows nothing of them.

use super::expressions::{Context, Need, Scratch};
use super::fold::{Constants, fold};
use super::scope::{Label, Reference, Scope};
use crate::chart::{
    Condition, ExprKind, Scenario, ScenarioExpectation, ScenarioInput, ScenarioLine, ScenarioTime, Type, Value,
    Variable, VariableId, VariableKind,
};
use crate::simulate::Probe;
use crate::symbols::{Role, Symbols, Wanted};
use crate::trace::kind_of;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_syntax::ast;
use index_vec::IndexVec;
use std::collections::BTreeMap;

/// What scenarios are resolved against.
pub struct Against<'c, 'a> {
    /// Their expressions as written.
    pub tree: &'a ast::Exprs,
    /// What names of the chart mean.
    pub scope: &'c Scope<'a>,
    /// Its variables.
    pub variables: &'c IndexVec<VariableId, Variable>,
    /// The values of its constants.
    pub constants: &'c Constants,
}

/// Resolves scenarios; what makes no sense in one is reported, and the rest of it is there.
///
/// That a scenario names something does not mean that the chart uses it.
pub fn read(
    written: &[&ast::Scenario],
    against: Against,
    symbols: &mut Symbols,
    diagnostics: &mut Diagnostics,
) -> Vec<Scenario> {
    if written.is_empty() {
        return Vec::new();
    }
    let usage = symbols.usage.clone();
    let mut reading = Reading { against, symbols, diagnostics, scratch: Scratch::default() };
    let mut known = BTreeMap::new();
    let mut all = Vec::with_capacity(written.len());
    for scenario in written {
        if let Some(first) = known.insert(&scenario.name.text, scenario.name.span) {
            let fault = format!("there are two scenarios `{}`", scenario.name.text);
            let fault = Diagnostic::new(Code::E0202, scenario.name.span, fault).also(first, "the first one");
            reading.diagnostics.push(fault.help("give it another name"));
        }
        all.push(reading.scenario(scenario));
    }
    symbols.usage = usage;
    all
}

struct Reading<'r, 'c, 'a> {
    against: Against<'c, 'a>,
    symbols: &'r mut Symbols,
    diagnostics: &'r mut Diagnostics,
    scratch: Scratch,
}

impl Reading<'_, '_, '_> {
    fn scenario(&mut self, scenario: &ast::Scenario) -> Scenario {
        // The latest time that is known for certain, and where it is.
        let mut latest = (0, scenario.name.span);
        let mut lines = Vec::with_capacity(scenario.lines.len());
        for line in &scenario.lines {
            let mut given = Vec::new();
            let when = match &line.kind {
                ast::ScenarioLineKind::At { time, is_after, given: written } => {
                    given.extend(written.iter().filter_map(|given| self.given(given)));
                    let ms = self.duration(*time);
                    let before = std::mem::replace(&mut latest.1, line.span);
                    if *is_after {
                        latest.0 += ms;
                        ScenarioTime::After(ms)
                    } else {
                        if ms < latest.0 {
                            let place = self.against.tree[*time].span;
                            let message = format!("the time goes back from {} ms to {ms} ms", latest.0);
                            let fault = Diagnostic::new(Code::E0604, place, message).also(before, "the line before");
                            self.diagnostics.push(fault.help("put lines in order of their times, or write `after`"));
                        }
                        latest.0 = latest.0.max(ms);
                        ScenarioTime::At(ms)
                    }
                }
                ast::ScenarioLineKind::Until { condition, within } => {
                    latest.1 = line.span;
                    let within = self.duration(*within);
                    match self.condition(*condition) {
                        Some(condition) => ScenarioTime::Until(condition, within),
                        None => continue,
                    }
                }
            };
            let expected = line.expected.iter().filter_map(|expected| self.expected(expected)).collect();
            lines.push(ScenarioLine { when, given, expected, span: line.span });
        }
        let expects = |line: &ast::ScenarioLine| {
            !line.expected.is_empty() || matches!(line.kind, ast::ScenarioLineKind::Until { .. })
        };
        if !scenario.lines.iter().any(expects) {
            let fault = Diagnostic::new(Code::E0610, scenario.name.span, "the scenario expects nothing");
            self.diagnostics
                .push(fault.help("write what is to be behind `->`, or what is waited for: `until … within …`"));
        }
        Scenario { name: scenario.name.text.clone(), lines, span: scenario.name.span }
    }

    fn duration(&self, id: ast::ExprId) -> i64 {
        // What cannot be read as one has been reported.
        if let ast::ExprKind::Duration(ms) = self.against.tree[id].kind { ms } else { 0 }
    }

    fn reference(&mut self, name: &ast::Name) -> Option<Reference> {
        let found = self.against.scope.reference(&name.text);
        match found {
            Some(reference) => {
                let (entity, form) = reference.entity();
                self.symbols.used(name.span, entity, form, Role::Read);
            }
            None => {
                self.symbols.missed(name.span, Wanted::Value);
                self.diagnostics.push(self.against.scope.unknown_name(&name.text, name.span));
            }
        }
        found
    }

    fn given(&mut self, given: &ast::Given) -> Option<ScenarioInput> {
        let reference = self.reference(&given.name)?;
        let what = match reference {
            Reference::Variable(id) => match self.against.variables[id].kind {
                VariableKind::Input => None,
                VariableKind::Output | VariableKind::Internal | VariableKind::Constant => {
                    Some(kind_of(&self.against.variables[id]))
                }
            },
            Reference::Activity(_) | Reference::Duration(_) | Reference::Frozen(_) => Some("what the chart comes to"),
        };
        if let Some(what) = what {
            let message = format!("`{}` is {what}, and only inputs are given", given.name.text);
            let fault = Diagnostic::new(Code::E0610, given.name.span, message);
            self.diagnostics.push(fault.help("what is expected stands behind `->`"));
            return None;
        }
        let Reference::Variable(variable) = reference else { return None };
        let value = self.value(given.value, self.against.variables[variable].ty)?;
        if let Some(span) = given.pulse.filter(|_| value != Value::Bool(true)) {
            let message = "`↑` stands behind a Boolean input that is given 1";
            self.diagnostics.push(
                Diagnostic::new(Code::E0610, span, message)
                    .help("leave it out, and give the next value in a line of its own"),
            );
            return None;
        }
        Some(ScenarioInput { variable, value, is_pulse: given.pulse.is_some() })
    }

    fn expected(&mut self, expected: &ast::Expectation) -> Option<ScenarioExpectation> {
        let probe = match self.reference(&expected.name)? {
            Reference::Variable(id) => Probe::Variable(id),
            Reference::Activity(Label::Step(id)) => Probe::Step(id),
            Reference::Activity(Label::Macro(id)) => Probe::Macro(id),
            Reference::Activity(Label::Grafcet(id)) => Probe::Grafcet(id),
            Reference::Duration(id) => Probe::Duration(id),
            Reference::Frozen(id) => Probe::Frozen(id),
        };
        let ty = match probe {
            Probe::Variable(id) => self.against.variables[id].ty,
            Probe::Step(_) | Probe::Macro(_) | Probe::Grafcet(_) | Probe::Frozen(_) => Type::Bool,
            Probe::Duration(_) => Type::Time,
        };
        let value = match expected.value {
            ast::Expected::Value(value) => self.value(value, ty)?,
            ast::Expected::True | ast::Expected::False if ty != Type::Bool => {
                let name = &expected.name.text;
                let message = format!("`{name}` is not Boolean: it is neither true nor false");
                let fault = Diagnostic::new(Code::E0610, expected.span, message);
                self.diagnostics.push(fault.help(format!("say what it is to be: `{name} = …`")));
                return None;
            }
            ast::Expected::True => Value::Bool(true),
            ast::Expected::False => Value::Bool(false),
        };
        Some(ScenarioExpectation { probe, value, span: expected.span })
    }

    /// The value of a literal.
    fn value(&mut self, written: ast::ExprId, ty: Type) -> Option<Value> {
        let mut pool = IndexVec::new();
        let need = if ty == Type::Bool { Need::Condition } else { Need::Value(ty) };
        let root = self.resolved(written, need, &mut pool)?;
        match fold(&pool, root, self.against.constants, |_| false) {
            Ok(value) => value,
            Err(fault) => {
                self.diagnostics.push(*fault);
                None
            }
        }
    }

    fn condition(&mut self, written: ast::ExprId) -> Option<Condition> {
        let mut exprs = IndexVec::new();
        let root = self.resolved(written, Need::Condition, &mut exprs)?;
        let past = exprs
            .iter()
            .find(|expr| matches!(expr.kind, ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Delay { .. }));
        if let Some(past) = past {
            let message = "`until` looks at what is after a scan, where there is no edge and no delay";
            let fault = Diagnostic::new(Code::E0610, past.span, message);
            self.diagnostics
                .push(fault.help("wait for a step or a variable, or for the duration of a step: `[T… >= …]`"));
            return None;
        }
        Some(Condition { exprs, root, span: self.against.tree[written].span })
    }

    fn resolved(
        &mut self,
        written: ast::ExprId,
        need: Need,
        pool: &mut IndexVec<crate::chart::ExprId, crate::chart::Expr>,
    ) -> Option<crate::chart::ExprId> {
        let Against { tree, scope, variables, constants } = self.against;
        let context = Context { tree, scope, variables, constants, step: None };
        context.resolve(written, need, pool, &mut self.scratch, self.symbols, self.diagnostics)
    }
}
