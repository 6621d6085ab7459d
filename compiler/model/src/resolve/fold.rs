//! The value of a constant expression.
//!
//! At run time arithmetic wraps around; here, where the author wrote down a value, leaving the range is an error (E0210).

use super::types;
use crate::chart::{Arithmetic, Comparison, Expr, ExprId, ExprKind, Type, Value, VariableId};
use grafc_diagnostics::{Code, Diagnostic};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// The values of constants: few variables are.
pub type Constants = FxHashMap<VariableId, Value>;

/// The value of `root`; an error at the first part that has none. `Ok(None)` if a constant in it is faulty itself.
pub fn fold(
    pool: &IndexVec<ExprId, Expr>,
    root: ExprId,
    constants: &Constants,
    is_constant: impl Fn(VariableId) -> bool,
) -> Result<Option<Value>, Box<Diagnostic>> {
    let mut values: IndexVec<ExprId, Option<Value>> = IndexVec::with_capacity(pool.len());
    for expr in pool {
        let value = match expr.kind {
            ExprKind::Variable(id) if is_constant(id) => constants.get(&id).copied(),
            ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_) => {
                return Err(not_constant(expr, "a variable is not a constant"));
            }
            ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Delay { .. } => {
                return Err(not_constant(expr, "an edge or a delay is not a constant"));
            }
            ExprKind::Literal(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => apply(expr, |operand| values[operand])?,
        };
        values.push(value);
    }
    Ok(values[root])
}

/// The value of one expression whose operands have these; none if one of them has none, or if it is not made of
/// operands that have values: a variable, an edge, a delay.
pub fn apply(expr: &Expr, value: impl Fn(ExprId) -> Option<Value>) -> Result<Option<Value>, Box<Diagnostic>> {
    let both = |a, b| value(a).zip(value(b));
    Ok(match expr.kind {
        ExprKind::Literal(value) => Some(value),
        ExprKind::Variable(_)
        | ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::GrafcetFrozen(_)
        | ExprKind::Rise(_)
        | ExprKind::Fall(_)
        | ExprKind::Delay { .. } => None,
        ExprKind::Not(a) => value(a).map(|a| Value::Bool(!truth(a))),
        ExprKind::And(a, b) => both(a, b).map(|(a, b)| Value::Bool(truth(a) && truth(b))),
        ExprKind::Or(a, b) => both(a, b).map(|(a, b)| Value::Bool(truth(a) || truth(b))),
        ExprKind::Xor(a, b) => both(a, b).map(|(a, b)| Value::Bool(truth(a) != truth(b))),
        ExprKind::Compare(op, a, b) => both(a, b).map(|(a, b)| Value::Bool(compare(op, a, b))),
        ExprKind::Arithmetic(op, a, b) => match both(a, b) {
            Some((a, b)) => Some(arithmetic(expr, op, a, b)?),
            None => None,
        },
        ExprKind::Negate(a) => match value(a) {
            Some(Value::Real(a)) => Some(Value::Real(-a)),
            Some(a) => Some(whole(expr, -i128::from(number(a)))?),
            None => None,
        },
        ExprKind::Widen(a) => match value(a) {
            Some(Value::Int(a)) if !expr.ty.is_whole() => Some(Value::Real(a as f64)),
            same => same,
        },
    })
}

fn arithmetic(expr: &Expr, op: Arithmetic, a: Value, b: Value) -> Result<Value, Box<Diagnostic>> {
    if let (Value::Real(a), Value::Real(b)) = (a, b) {
        let exact = match op {
            Arithmetic::Add => a + b,
            Arithmetic::Subtract => a - b,
            Arithmetic::Multiply => a * b,
            Arithmetic::Divide if b == 0.0 => return Err(division_by_zero(expr)),
            Arithmetic::Divide => a / b,
            Arithmetic::Modulo => a % b,
        };
        return types::real(expr.ty, exact).map(Value::Real).ok_or_else(|| out_of_range(expr));
    }
    let (a, b) = (i128::from(number(a)), i128::from(number(b)));
    let exact = match op {
        Arithmetic::Add => a + b,
        Arithmetic::Subtract => a - b,
        Arithmetic::Multiply => a * b,
        Arithmetic::Divide | Arithmetic::Modulo if b == 0 => return Err(division_by_zero(expr)),
        Arithmetic::Divide => a / b,
        Arithmetic::Modulo => a % b,
    };
    whole(expr, exact)
}

/// A whole number or a time as its type holds it.
fn whole(expr: &Expr, value: i128) -> Result<Value, Box<Diagnostic>> {
    let (least, most) = expr.ty.whole_range().unwrap_or(types::TIME_RANGE);
    let value = i64::try_from(value).ok().filter(|v| (least..=most).contains(v)).ok_or_else(|| out_of_range(expr))?;
    Ok(if expr.ty == Type::Time { Value::Time(value) } else { Value::Int(value) })
}

fn compare(op: Comparison, a: Value, b: Value) -> bool {
    let order = match (a, b) {
        (Value::Real(a), Value::Real(b)) => a.partial_cmp(&b),
        (a, b) => Some(number(a).cmp(&number(b))),
    };
    match op {
        Comparison::Equal => order == Some(Ordering::Equal),
        Comparison::NotEqual => order != Some(Ordering::Equal),
        Comparison::Less => order == Some(Ordering::Less),
        Comparison::LessEqual => matches!(order, Some(Ordering::Less | Ordering::Equal)),
        Comparison::Greater => order == Some(Ordering::Greater),
        Comparison::GreaterEqual => matches!(order, Some(Ordering::Greater | Ordering::Equal)),
    }
}

fn truth(value: Value) -> bool {
    value == Value::Bool(true)
}

fn number(value: Value) -> i64 {
    match value {
        Value::Bool(value) => i64::from(value),
        Value::Int(value) | Value::Time(value) => value,
        Value::Real(value) => value as i64,
    }
}

fn not_constant(expr: &Expr, message: &str) -> Box<Diagnostic> {
    Box::new(
        Diagnostic::new(Code::E0208, expr.span, message)
            .note("the value of a declaration is made of literals and of constants")
            .help("write the value itself, or make a `const` of what it is made of"),
    )
}

fn division_by_zero(expr: &Expr) -> Box<Diagnostic> {
    Box::new(
        Diagnostic::new(Code::E0208, expr.span, "a division by zero has no value").help("divide by something else"),
    )
}

fn out_of_range(expr: &Expr) -> Box<Diagnostic> {
    Box::new(
        Diagnostic::new(Code::E0210, expr.span, format!("the value does not fit `{}`", types::name(expr.ty)))
            .help(types::larger(expr.ty)),
    )
}
