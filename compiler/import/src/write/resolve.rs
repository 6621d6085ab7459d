//! Expressions of the file as terms of the chart, with what was assigned before put in place; names are found in `meaning`,
//! types in `typed`.
//!
//! A value may differ from case to case, after `IF a THEN n := 1; END_IF`; a Boolean is then one formula, a number is
//! several, each with its guard. The walk has its own stack.

use super::maker::{Maker, Scope};
use super::terms::{TermId, TermKind, VarId};
use crate::code::tree::{Direction, ExprId, ExprKind, Operator};
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;
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
pub(super) const MOST_CASES: usize = 16;

/// Where an expression stands.
#[derive(Clone)]
pub struct Site {
    pub scope: Scope,
    pub part: usize,
    /// A step of which it is known whether it is active.
    pub own: Option<(super::terms::StepId, bool)>,
}

impl Maker<'_> {
    /// A condition.
    pub fn condition(&mut self, id: ExprId, site: &Site, environment: &Environment) -> Result<TermId, Loss> {
        let cases = self.value(id, Type::Bool, site, environment)?;
        Ok(self.merged(cases))
    }

    /// The cases of a value of some type.
    pub fn value(&mut self, root: ExprId, ty: Type, site: &Site, environment: &Environment) -> Result<Cases, Loss> {
        let project = self.project;
        let code = &project.code;
        enum Task {
            Enter(ExprId, Type),
            Leave(ExprId, Type),
        }
        let mut tasks = vec![Task::Enter(root, ty)];
        let mut done: Vec<Cases> = Vec::new();
        // Networks share what is wired to several inputs; it is made once.
        let mut known: FxHashMap<(ExprId, Type), Cases> = FxHashMap::default();
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
                            self.type_of_either(*a, *b, site).unwrap_or(Type::Dint)
                        }
                        ExprKind::Not(_) | ExprKind::Edge(..) => Type::Bool,
                        ExprKind::Binary(operator, ..) if operator.is_logic() => Type::Bool,
                        _ => wanted,
                    };
                    let is_logic = matches!(&expr.kind, ExprKind::Not(_) | ExprKind::Edge(..) | ExprKind::Bool(_))
                        || matches!(&expr.kind, ExprKind::Binary(o, ..) if o.is_logic() || o.compares());
                    if is_logic && wanted != Type::Bool {
                        return Err(Loss {
                            why: format!("a Boolean stands where `{}` is wanted", wanted.keyword()),
                            span: expr.span,
                        });
                    }
                    tasks.push(Task::Leave(id, wanted));
                    if let ExprKind::Call(name, arguments) = &expr.kind {
                        if name.eq_ignore_ascii_case("GSTATUS") {
                            tasks.pop();
                            done.push(self.status(arguments, wanted, expr.span)?);
                            continue;
                        }
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
        wanted: Type,
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
            ExprKind::Integer(number @ (0 | 1)) if wanted == Type::Bool => TermKind::Bool(*number == 1),
            ExprKind::Integer(number) if wanted.is_whole() => TermKind::Integer(*number),
            ExprKind::Integer(number) if matches!(wanted, Type::Real | Type::Lreal) => {
                TermKind::Real(format!("{number}.0"))
            }
            ExprKind::Integer(_) => return loss(format!("a number stands where `{}` is wanted", wanted.keyword())),
            ExprKind::Real(number) if matches!(wanted, Type::Real | Type::Lreal) => TermKind::Real(number.clone()),
            ExprKind::Real(_) => return loss(format!("a fraction stands where `{}` is wanted", wanted.keyword())),
            ExprKind::Duration(ms) if wanted == Type::Time => TermKind::Duration(*ms),
            // Times multiplied by numbers.
            ExprKind::Duration(_) => return loss(format!("a time stands where `{}` is wanted", wanted.keyword())),
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

    fn pair(&mut self, operator: Operator, wanted: Type, left: Cases, right: Cases, span: Span) -> Result<Cases, Loss> {
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
        // One of the cases applies, so what differs is what is not equal.
        if operator == Operator::NotEqual && left.len() * right.len() > 1 {
            let equal = self.pair(Operator::Equal, wanted, left, right, span)?;
            let equal = self.merged(equal);
            let differ = self.terms.not(equal);
            return Ok(self.certain(differ));
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
                    if wanted == Type::Bool {
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
        if self.terms.terms[a].ty == Some(Type::Bool) || self.terms.terms[b].ty == Some(Type::Bool) {
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
        if let (TermKind::Integer(one), TermKind::Integer(two)) = (&self.terms.terms[a].kind, &self.terms.terms[b].kind)
        {
            let holds = match operator {
                Operator::Equal => one == two,
                Operator::NotEqual => one != two,
                Operator::Less => one < two,
                Operator::LessEqual => one <= two,
                Operator::Greater => one > two,
                _ => one >= two,
            };
            return Ok(self.terms.constant(holds, span));
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
}
