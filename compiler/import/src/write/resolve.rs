//! Expressions of the file as terms of the chart: names found, types joined, and what was assigned before put in place.
//!
//! A value may differ from case to case, after `IF a THEN n := 1; END_IF`; a Boolean is then one formula, a number is
//! several, each with its guard. The walk has its own stack.

use super::maker::{Maker, Scope};
use super::terms::{TermId, TermKind, Ty, VarId};
use super::variables::elementary;
use crate::code::tree::{Direction, ExprId, ExprKind, Operator};
use grafc_diagnostics::Span;
use rustc_hash::FxHashMap;

/// Values, each with the guard under which it is taken. The guards exclude each other.
pub type Cases = Vec<(TermId, TermId)>;

/// What variables have been assigned, in which cases; else they are what they were.
pub type Environment = FxHashMap<VarId, Cases>;

/// Why something cannot be said, and where.
pub struct Loss {
    pub why: String,
    pub span: Span,
}

/// How many cases a value may have.
const MOST_CASES: usize = 16;

/// How many parts of a comparison are looked at for a type.
const PARTS: usize = 64;

/// Where an expression stands.
#[derive(Clone)]
pub struct Site {
    pub scope: Scope,
    pub part: usize,
    /// A step of which it is known whether it is active.
    pub own: Option<(super::terms::StepId, bool)>,
}

/// What a path means.
enum Meaning {
    Term(TermId),
    Variable(VarId),
}

impl Maker<'_> {
    /// A condition.
    pub fn condition(&mut self, id: ExprId, site: &Site, environment: &Environment) -> Result<TermId, Loss> {
        let cases = self.value(id, Ty::Bool, site, environment)?;
        Ok(self.merged(cases))
    }

    /// The cases of a value of some type.
    pub fn value(&mut self, root: ExprId, ty: Ty, site: &Site, environment: &Environment) -> Result<Cases, Loss> {
        let project = self.project;
        let code = &project.code;
        enum Task {
            Enter(ExprId, Ty),
            Leave(ExprId, Ty),
        }
        let mut tasks = vec![Task::Enter(root, ty)];
        let mut done: Vec<Cases> = Vec::new();
        // Networks share what is wired to several inputs; it is made once.
        let mut known: FxHashMap<(ExprId, Ty), Cases> = FxHashMap::default();
        while let Some(task) = tasks.pop() {
            match task {
                Task::Enter(id, wanted) => {
                    if let Some(cases) = known.get(&(id, wanted)) {
                        done.push(cases.clone());
                        continue;
                    }
                    let expr = &code.exprs[id];
                    let inner = match &expr.kind {
                        ExprKind::Binary(operator, a, b) if operator.compares() => {
                            self.type_of_either(*a, *b, site).unwrap_or(Ty::Dint)
                        }
                        ExprKind::Not(_) | ExprKind::Edge(..) => Ty::Bool,
                        ExprKind::Binary(operator, ..) if operator.is_logic() => Ty::Bool,
                        _ => wanted,
                    };
                    let is_logic = matches!(&expr.kind, ExprKind::Not(_) | ExprKind::Edge(..) | ExprKind::Bool(_))
                        || matches!(&expr.kind, ExprKind::Binary(o, ..) if o.is_logic() || o.compares());
                    if is_logic && wanted != Ty::Bool {
                        return Err(Loss {
                            why: format!("a Boolean stands where `{}` is wanted", wanted.word()),
                            span: expr.span,
                        });
                    }
                    tasks.push(Task::Leave(id, wanted));
                    if let ExprKind::Call(name, arguments) = &expr.kind {
                        let operand = self.conversion(name, arguments.as_slice(), wanted, expr.span)?;
                        tasks.push(Task::Enter(operand.0, operand.1));
                        continue;
                    }
                    tasks.extend(code.operands(id).into_iter().rev().map(|operand| Task::Enter(operand, inner)));
                }
                Task::Leave(id, wanted) => {
                    let count = match &code.exprs[id].kind {
                        ExprKind::Call(..) => 1,
                        _ => code.operands(id).len(),
                    };
                    let operands = done.split_off(done.len() - count);
                    let cases = self.made(id, wanted, operands, site, environment)?;
                    if count > 0 {
                        known.insert((id, wanted), cases.clone());
                    }
                    done.push(cases);
                }
            }
        }
        Ok(done.pop().unwrap_or_default())
    }

    /// One formula of all cases of a Boolean.
    pub fn merged(&mut self, cases: Cases) -> TermId {
        if let [(_, value)] = cases.as_slice()
            && self.terms.is(cases[0].0, true)
        {
            return *value;
        }
        let span = cases.first().map_or_else(|| self.parts[0].span, |(_, value)| self.terms.terms[*value].span);
        let products: Vec<TermId> = cases.into_iter().map(|(guard, value)| self.terms.and(guard, value)).collect();
        self.terms.any(products, span)
    }

    fn made(
        &mut self,
        id: ExprId,
        wanted: Ty,
        mut operands: Vec<Cases>,
        site: &Site,
        environment: &Environment,
    ) -> Result<Cases, Loss> {
        let project = self.project;
        let expr = &project.code.exprs[id];
        let span = expr.span;
        let loss = |why: String| Err(Loss { why, span });
        let kind = match &expr.kind {
            ExprKind::Bool(value) => TermKind::Bool(*value),
            // `x := 1` sets a Boolean.
            ExprKind::Integer(number @ (0 | 1)) if wanted == Ty::Bool => TermKind::Bool(*number == 1),
            ExprKind::Integer(number) if wanted.is_whole() => TermKind::Integer(*number),
            ExprKind::Integer(number) if matches!(wanted, Ty::Real | Ty::Lreal) => {
                TermKind::Real(format!("{number}.0"))
            }
            ExprKind::Integer(_) => return loss(format!("a number stands where `{}` is wanted", wanted.word())),
            ExprKind::Real(number) if matches!(wanted, Ty::Real | Ty::Lreal) => TermKind::Real(number.clone()),
            ExprKind::Real(_) => return loss(format!("a fraction stands where `{}` is wanted", wanted.word())),
            ExprKind::Duration(ms) if wanted == Ty::Time => TermKind::Duration(*ms),
            // Times multiplied by numbers.
            ExprKind::Duration(_) => return loss(format!("a time stands where `{}` is wanted", wanted.word())),
            ExprKind::Path(path) => return self.path(path, wanted, span, site, environment),
            ExprKind::Call(..) => return Ok(operands.pop().unwrap_or_default()),
            ExprKind::Unknown(why) => return loss(why.clone()),
            ExprKind::Not(_) => {
                let operand = operands.pop().map(|cases| self.merged(cases));
                let Some(operand) = operand else { return loss("nothing is negated".into()) };
                let not = self.terms.not(operand);
                return Ok(self.certain(not));
            }
            ExprKind::Edge(direction, _) => {
                let operand = operands.pop().map(|cases| self.merged(cases));
                let Some(operand) = operand else { return loss("there is no operand".into()) };
                if self
                    .has(operand, |kind| matches!(kind, TermKind::Rise(_) | TermKind::Fall(_) | TermKind::Delay { .. }))
                {
                    return loss("charts have no edge of what holds an edge or a delay".into());
                }
                match direction {
                    Direction::Rise => TermKind::Rise(operand),
                    Direction::Fall => TermKind::Fall(operand),
                }
            }
            ExprKind::Negate(_) => {
                let cases = operands.pop().unwrap_or_default();
                let negated = cases
                    .into_iter()
                    .map(|(guard, value)| (guard, self.terms.add(TermKind::Negate(value), Some(wanted), span)));
                return Ok(negated.collect());
            }
            ExprKind::Binary(operator, ..) => {
                let (Some(right), Some(left)) = (operands.pop(), operands.pop()) else {
                    return loss("an operand is missing".into());
                };
                return self.pair(*operator, wanted, left, right, span);
            }
        };
        let ty = Some(wanted);
        let term = self.terms.add(kind, ty, span);
        Ok(self.certain(term))
    }

    /// A value in every case.
    pub fn certain(&mut self, value: TermId) -> Cases {
        let span = self.terms.terms[value].span;
        vec![(self.terms.constant(true, span), value)]
    }

    /// Whether a term has a part of some kind.
    pub fn has(&self, id: TermId, wanted: impl Fn(&TermKind) -> bool) -> bool {
        let mut found = false;
        let all = self.terms.parts(id, 10_000, |term| found |= wanted(&term.kind));
        found || !all
    }

    fn pair(&mut self, operator: Operator, wanted: Ty, left: Cases, right: Cases, span: Span) -> Result<Cases, Loss> {
        if operator.is_logic() {
            let (a, b) = (self.merged(left), self.merged(right));
            let term = match operator {
                Operator::And => self.terms.and(a, b),
                Operator::Or => self.terms.or(a, b),
                _ => self.terms.logic(TermKind::Xor(a, b), span),
            };
            return Ok(self.certain(term));
        }
        if left.len() * right.len() > MOST_CASES {
            return Err(Loss { why: "its value depends on too many cases".into(), span });
        }
        let mut cases = Vec::new();
        for &(one, a) in &left {
            for &(two, b) in &right {
                let guard = self.terms.and(one, two);
                let value = if operator.compares() {
                    self.comparison(operator, a, b, span)?
                } else {
                    let sign = match operator {
                        Operator::Add => " + ",
                        Operator::Subtract => " - ",
                        Operator::Multiply => " * ",
                        Operator::Divide => " / ",
                        _ => " mod ",
                    };
                    if wanted == Ty::Bool {
                        return Err(Loss { why: "a number stands where a condition is wanted".into(), span });
                    }
                    self.terms.add(TermKind::Pair(sign, a, b), Some(wanted), span)
                };
                cases.push((guard, value));
            }
        }
        if operator.compares() {
            let value = self.merged(cases);
            return Ok(self.certain(value));
        }
        Ok(cases)
    }

    /// A comparison; Booleans are compared by logic.
    fn comparison(&mut self, operator: Operator, a: TermId, b: TermId, span: Span) -> Result<TermId, Loss> {
        if self.terms.terms[a].ty == Some(Ty::Bool) || self.terms.terms[b].ty == Some(Ty::Bool) {
            let is_equal = match operator {
                Operator::Equal => true,
                Operator::NotEqual => false,
                _ => return Err(Loss { why: "Booleans have no order".into(), span }),
            };
            for (constant, other) in [(a, b), (b, a)] {
                if let TermKind::Bool(value) = self.terms.terms[constant].kind {
                    return Ok(if value == is_equal { other } else { self.terms.not(other) });
                }
            }
            let differ = self.terms.logic(TermKind::Xor(a, b), span);
            return Ok(if is_equal { self.terms.not(differ) } else { differ });
        }
        let sign = match operator {
            Operator::Equal => " = ",
            Operator::NotEqual => " <> ",
            Operator::Less => " < ",
            Operator::LessEqual => " <= ",
            Operator::Greater => " > ",
            _ => " >= ",
        };
        Ok(self.terms.logic(TermKind::Pair(sign, a, b), span))
    }

    /// A variable as it is at this place, a step's flag, a named number.
    fn path(
        &mut self,
        path: &str,
        wanted: Ty,
        span: Span,
        site: &Site,
        environment: &Environment,
    ) -> Result<Cases, Loss> {
        let meaning = self.meaning(path, Some(wanted), span, site)?;
        let id = match meaning {
            Meaning::Term(term) => {
                let ty = self.terms.terms[term].ty;
                if ty.is_some_and(|ty| !ty.widens_to(wanted)) {
                    return Err(Loss { why: format!("`{path}` is not of type `{}`", wanted.word()), span });
                }
                return Ok(self.certain(term));
            }
            Meaning::Variable(id) => id,
        };
        let ty = self.variables.list[id].ty;
        if !ty.widens_to(wanted) {
            let why = format!("`{path}` is of type `{}`, and `{}` is wanted", ty.word(), wanted.word());
            return Err(Loss { why, span });
        }
        self.variables.list[id].used.read = true;
        let old = self.terms.add(TermKind::Variable(id), Some(ty), span);
        let Some(cases) = environment.get(&id) else { return Ok(self.certain(old)) };
        let mut cases = cases.clone();
        if let Some(here) = self.here {
            let possible = cases.into_iter().filter_map(|(guard, value)| Some((self.terms.under(guard, here)?, value)));
            cases = possible.collect();
        }
        let guards: Vec<TermId> = cases.iter().map(|(guard, _)| *guard).collect();
        if !guards.iter().any(|&guard| self.terms.is(guard, true)) {
            let any = self.terms.any(guards, span);
            let rest = self.terms.not(any);
            if !self.terms.is(rest, false) {
                cases.push((rest, old));
            }
        }
        if cases.len() > MOST_CASES {
            return Err(Loss { why: "its value depends on too many cases".into(), span });
        }
        if ty == Ty::Bool {
            let merged = self.merged(cases);
            return Ok(self.certain(merged));
        }
        Ok(cases)
    }

    /// The variable that is set by a path.
    pub fn target(&mut self, path: &str, ty: Option<Ty>, span: Span, site: &Site) -> Result<VarId, Loss> {
        match self.meaning(path, ty, span, site)? {
            Meaning::Variable(id) => Ok(id),
            Meaning::Term(_) => Err(Loss { why: format!("`{path}` is no variable that can be set"), span }),
        }
    }

    fn meaning(&mut self, path: &str, wanted: Option<Ty>, span: Span, site: &Site) -> Result<Meaning, Loss> {
        if path.contains('?') || path.contains('^') {
            return Err(Loss {
                why: format!("`{path}`: charts have no pointers, nor arrays whose place is computed"),
                span,
            });
        }
        if let Some(term) = self.flag(path, span, site)? {
            return Ok(Meaning::Term(term));
        }
        if let Some(term) = self.block_output(path, span, site)? {
            return Ok(Meaning::Term(term));
        }
        if let Some(id) = self.variables.find(&format!("{}{path}", site.scope.prefix)) {
            return Ok(Meaning::Variable(id));
        }
        if let Some(found) = self.declared(path, span, site)? {
            return Ok(Meaning::Variable(found));
        }
        let lower = path.to_lowercase();
        if let Some(&number) = self.constants.get(&lower) {
            return Ok(Meaning::Term(self.terms.add(TermKind::Integer(number), None, span)));
        }
        if let Some(id) = self.variables.find(path) {
            return Ok(Meaning::Variable(id));
        }
        let id = self.variables.assumed(path, wanted.unwrap_or(Ty::Bool), span);
        Ok(Meaning::Variable(id))
    }

    /// `Step.X` and `Step.T`, in the spellings of several tools.
    fn flag(&mut self, path: &str, span: Span, site: &Site) -> Result<Option<TermId>, Loss> {
        let Some((name, flag)) = path.split_once('.') else { return Ok(None) };
        let flag = flag.trim_start_matches('_').to_ascii_lowercase();
        if !matches!(flag.as_str(), "x" | "t") {
            return Ok(None);
        }
        let unit = self.unit(&site.scope);
        let name = match name.get(..2) {
            Some(head) if self.dialect == crate::Dialect::Isagraf && head.eq_ignore_ascii_case("GS") => {
                if self.step(site.part, name).is_some() { name } else { &name[2..] }
            }
            _ => name,
        };
        let Some(step) = self.step(site.part, name) else { return Ok(None) };
        if unit.variables.iter().any(|variable| variable.name.eq_ignore_ascii_case(name)) {
            return Ok(None);
        }
        Ok(Some(match (flag.as_str(), site.own) {
            ("x", Some((own, active))) if own == step => self.terms.constant(active, span),
            ("x", _) => self.terms.logic(TermKind::Active(step), span),
            _ => self.terms.add(TermKind::Time(step), Some(Ty::Time), span),
        }))
    }

    /// A variable that the unit or the file declares, or a member of one.
    fn declared(&mut self, path: &str, span: Span, site: &Site) -> Result<Option<VarId>, Loss> {
        let project = self.project;
        let unit = self.unit(&site.scope);
        let global = |name: &str| project.globals.iter().find(|variable| variable.name.eq_ignore_ascii_case(name));
        let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
        let first = first.split('[').next().unwrap_or(first);
        let (variable, rest, key) =
            if let Some(own) = unit.variables.iter().find(|v| v.name.eq_ignore_ascii_case(first)) {
                (own, rest, format!("{}{path}", site.scope.prefix))
            } else if let Some(own) = global(path) {
                (own, None, path.to_string())
            } else if let Some(own) = global(first) {
                (own, rest, path.to_string())
            } else if let Some((list, inner)) = rest.and_then(|rest| {
                let (name, inner) = rest.split_once('.').map_or((rest, None), |(name, inner)| (name, Some(inner)));
                global(&format!("{first}.{name}")).map(|variable| (variable, inner))
            }) {
                (list, inner, path.to_string())
            } else if let (Some(&other), Some(rest)) = (self.units.get(&first.to_lowercase()), rest) {
                let name = rest.split(['.', '[']).next().unwrap_or(rest);
                match project.units[other].variables.iter().find(|v| v.name.eq_ignore_ascii_case(name)) {
                    Some(variable) => (variable, rest.split_once('.').map(|(_, rest)| rest), path.to_string()),
                    None => return Ok(None),
                }
            } else {
                return Ok(None);
            };
        if let Some(id) = self.variables.find(&key) {
            return Ok(Some(id));
        }
        let ty = self.member_type(&variable.ty, rest);
        let ty = match elementary(&ty) {
            Some(ty) => ty,
            None if self.project.enumerations.iter().any(|e| e.name.eq_ignore_ascii_case(&ty)) => Ty::Int,
            None if ty.is_empty() => return Ok(None),
            None => {
                let why = format!("`{path}` is of the type `{ty}`, which charts do not have");
                return Err(Loss { why, span });
            }
        };
        let id = self.variables.declared(&key, ty, variable);
        if rest.is_some() || path.contains('[') {
            // What is said of the whole is not said of a part.
            let part = &mut self.variables.list[id];
            (part.initial, part.address, part.comment) = (None, None, None);
        }
        Ok(Some(id))
    }

    /// The type of a member of something, as far as types of the file tell; an empty one if they do not.
    fn member_type(&self, ty: &str, rest: Option<&str>) -> String {
        let project = self.project;
        let element = |ty: &str| ty.strip_prefix("ARRAY OF ").unwrap_or(ty).to_string();
        let mut ty = element(ty);
        for segment in rest.into_iter().flat_map(|rest| rest.split('.')) {
            let name = segment.split('[').next().unwrap_or(segment);
            let structure = project.structures.iter().find(|s| s.name.eq_ignore_ascii_case(&ty)).map(|s| &s.members);
            let unit = self.units.get(&ty.to_lowercase()).map(|&unit| &project.units[unit].variables);
            let member = structure.or(unit).and_then(|list| list.iter().find(|m| m.name.eq_ignore_ascii_case(name)));
            let Some(member) = member else { return String::new() };
            ty = element(&member.ty);
        }
        ty
    }

    /// The type of what one of two operands certainly is.
    fn type_of_either(&self, a: ExprId, b: ExprId, site: &Site) -> Option<Ty> {
        let code = &self.project.code;
        let mut stack = vec![b, a];
        let mut found: Option<Ty> = None;
        for _ in 0..PARTS {
            let Some(id) = stack.pop() else { break };
            let ty = match &code.exprs[id].kind {
                ExprKind::Bool(_) | ExprKind::Not(_) | ExprKind::Edge(..) => Some(Ty::Bool),
                ExprKind::Binary(operator, ..) if operator.is_logic() || operator.compares() => Some(Ty::Bool),
                ExprKind::Real(_) => Some(Ty::Lreal),
                ExprKind::Duration(_) => Some(Ty::Time),
                ExprKind::Path(path) => self.type_of_path(path, site),
                ExprKind::Call(name, _) => {
                    name.rsplit_once("_TO_").or(name.rsplit_once("_to_")).and_then(|(_, to)| elementary(to))
                }
                ExprKind::Integer(_) | ExprKind::Unknown(_) => None,
                ExprKind::Negate(_) | ExprKind::Binary(..) => {
                    stack.extend(code.operands(id).into_iter().rev());
                    None
                }
            };
            found = match (found, ty) {
                (Some(before), Some(ty)) if before.widens_to(ty) => Some(ty),
                (Some(before), _) => Some(before),
                (None, ty) => ty,
            };
        }
        // A literal with a fraction takes the type of what it meets.
        found
    }

    /// The type of a value by its form, if that tells.
    pub fn type_of_value(&self, id: ExprId, site: &Site) -> Option<Ty> {
        self.type_of_either(id, id, site)
    }

    /// The type of what a `CASE` chooses by.
    pub fn type_of_selector(&self, id: ExprId, site: &Site) -> Ty {
        self.type_of_value(id, site).filter(|ty| ty.is_whole()).unwrap_or(Ty::Dint)
    }

    fn type_of_path(&self, path: &str, site: &Site) -> Option<Ty> {
        let known = self.variables.find(&format!("{}{path}", site.scope.prefix)).or_else(|| self.variables.find(path));
        if let Some(id) = known {
            return Some(self.variables.list[id].ty);
        }
        let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
        if let Some(rest) = rest
            && self.step(site.part, first).is_some()
        {
            return match rest.trim_start_matches('_').to_ascii_lowercase().as_str() {
                "x" => Some(Ty::Bool),
                "t" => Some(Ty::Time),
                _ => None,
            };
        }
        let first = first.split('[').next().unwrap_or(first);
        let unit = self.unit(&site.scope);
        let globals = &self.project.globals;
        let variable = unit
            .variables
            .iter()
            .find(|v| v.name.eq_ignore_ascii_case(first))
            .map(|variable| (variable, rest))
            .or_else(|| globals.iter().find(|v| v.name.eq_ignore_ascii_case(path)).map(|variable| (variable, None)))
            .or_else(|| globals.iter().find(|v| v.name.eq_ignore_ascii_case(first)).map(|variable| (variable, rest)));
        let (variable, rest) = variable?;
        let ty = self.member_type(&variable.ty, rest);
        match elementary(&ty) {
            Some(ty) => Some(ty),
            None if self.project.enumerations.iter().any(|e| e.name.eq_ignore_ascii_case(&ty)) => Some(Ty::Int),
            None => None,
        }
    }

    /// The operand of a conversion that loses nothing, with the type that it has.
    fn conversion(
        &self,
        name: &str,
        arguments: &[crate::code::tree::Argument],
        wanted: Ty,
        span: Span,
    ) -> Result<(ExprId, Ty), Loss> {
        let upper = name.to_ascii_uppercase();
        let from_to = upper.split_once("_TO_").map(|(from, to)| (elementary(from), elementary(to)));
        let [argument] = arguments else {
            return Err(Loss { why: format!("charts do not have the function `{name}`"), span });
        };
        match from_to {
            Some((Some(from), Some(to))) if from.widens_to(to) && to.widens_to(wanted) => Ok((argument.value, from)),
            // A literal is of any type that holds it.
            Some((Some(from), Some(to)))
                if to.is_whole()
                    && from.is_whole()
                    && wanted.is_whole()
                    && matches!(self.project.code.exprs[argument.value].kind, ExprKind::Integer(_)) =>
            {
                Ok((argument.value, wanted))
            }
            Some(_) => Err(Loss { why: format!("charts do not convert as `{name}` does"), span }),
            None => Err(Loss { why: format!("charts do not have the function `{name}`"), span }),
        }
    }
}
