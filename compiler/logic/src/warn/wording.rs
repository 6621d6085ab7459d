//! Conditions in the words of the chart, for messages.

use crate::analysis::together::Case;
use crate::report::arrow;
use grafc_model::chart::{Arithmetic, Comparison, DelayTime, ExprId, ExprKind, StepId, TransitionId, Value};
use grafc_net::Net;

/// A condition that nests deeper than this is not spelt out.
const DEEPEST: usize = 4;

/// More atoms than this are not spelt out.
const SPELT_OUT: usize = 6;

/// A case as `a` and `b` are true and `c` is false, if it can be said in a few words.
pub(super) fn case(net: &Net, case: &Case) -> Option<String> {
    if case.len() > SPELT_OUT {
        return None;
    }
    let mut sides = Vec::new();
    for value in [true, false] {
        let atoms = case.iter().filter(|(_, is)| *is == value);
        let names: Option<Vec<String>> = atoms.map(|(atom, _)| condition(net, (*atom)?)).collect();
        let names = names?;
        let verb = if names.len() == 1 { "is" } else { "are" };
        if !names.is_empty() {
            sides.push(format!("{} {verb} {value}", list(&names)));
        }
    }
    Some(sides.join(" and "))
}

/// A condition as the chart may write it, if it is short.
fn condition(net: &Net, expr: ExprId) -> Option<String> {
    match &net.exprs[expr].kind {
        ExprKind::Compare(..) => Some(format!("[{}]", spell(net, expr, DEEPEST)?)),
        _ => spell(net, expr, DEEPEST),
    }
}

/// `step `4`` or `steps `4` and `5``; of many, the first.
pub(super) fn steps(net: &Net, steps: &[StepId]) -> String {
    let names: Vec<String> = steps.iter().take(SPELT_OUT).map(|step| net.places[*step].label.to_string()).collect();
    let more = if steps.len() > SPELT_OUT { format!(" (and {} more)", steps.len() - SPELT_OUT) } else { String::new() };
    format!("step{} {}{more}", if steps.len() == 1 { "" } else { "s" }, list(&names))
}

/// Transitions one after the other, as the chart draws them; of many, the last.
pub(super) fn way(net: &Net, way: &[TransitionId]) -> String {
    let from = way.len().saturating_sub(SPELT_OUT);
    let names: Vec<String> = way[from..].iter().map(|t| format!("`{}`", arrow(net, *t))).collect();
    format!("{}{}", if from > 0 { "…, " } else { "" }, names.join(", "))
}

/// Names in backquotes, the last after `and`: `a`, `b` and `c`.
fn list(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        None => String::new(),
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
    }
}

/// `left` bounds the depth of the recursion.
fn spell(net: &Net, expr: ExprId, left: usize) -> Option<String> {
    let left = left.checked_sub(1)?;
    let operand = |e: ExprId| {
        let text = spell(net, e, left)?;
        Some(if is_compound(net, e) { format!("({text})") } else { text })
    };
    let binary = |a, sign, b| Some(format!("{} {sign} {}", operand(a)?, operand(b)?));
    match net.exprs[expr].kind {
        ExprKind::Literal(value) => Some(literal(value)),
        ExprKind::Variable(v) => Some(net.variables[v].name.to_string()),
        ExprKind::StepActive(s) => Some(format!("X{}", net.places[s].label)),
        ExprKind::StepTime(s) => Some(format!("T{}", net.places[s].label)),
        ExprKind::MacroActive(m) => Some(format!("X{}", net.macro_steps[m].label)),
        ExprKind::GrafcetActive(g) => Some(format!("X{}", net.grafcets[g].name)),
        ExprKind::Not(a) => Some(format!("not {}", operand(a)?)),
        ExprKind::And(a, b) => binary(a, "and", b),
        ExprKind::Or(a, b) => binary(a, "or", b),
        ExprKind::Xor(a, b) => binary(a, "xor", b),
        ExprKind::Rise(a) => Some(format!("↑{}", operand(a)?)),
        ExprKind::Fall(a) => Some(format!("↓{}", operand(a)?)),
        ExprKind::Delay { on, operand: inner, off } => {
            let on = if on.ms > 0 { format!("{}/", delay(net, on)) } else { String::new() };
            let off = if off.ms > 0 { format!("/{}", delay(net, off)) } else { String::new() };
            Some(format!("{on}{}{off}", operand(inner)?))
        }
        ExprKind::Compare(op, a, b) => binary(a, comparison(op), b),
        ExprKind::Arithmetic(op, a, b) => binary(a, arithmetic(op), b),
        ExprKind::Negate(a) => Some(format!("-{}", operand(a)?)),
        ExprKind::Widen(a) => spell(net, a, left),
    }
}

fn is_compound(net: &Net, expr: ExprId) -> bool {
    match net.exprs[expr].kind {
        ExprKind::Not(_)
        | ExprKind::And(..)
        | ExprKind::Or(..)
        | ExprKind::Xor(..)
        | ExprKind::Compare(..)
        | ExprKind::Arithmetic(..)
        | ExprKind::Negate(_)
        | ExprKind::Delay { .. } => true,
        ExprKind::Widen(a) => net.exprs[a].kind.operands().next().is_some(),
        ExprKind::Literal(_)
        | ExprKind::Variable(_)
        | ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::Rise(_)
        | ExprKind::Fall(_) => false,
    }
}

fn delay(net: &Net, time: DelayTime) -> String {
    match time.constant {
        Some(constant) => net.variables[constant].name.to_string(),
        None => duration(time.ms),
    }
}

fn duration(ms: i64) -> String {
    if ms % 1000 == 0 { format!("{}s", ms / 1000) } else { format!("{ms}ms") }
}

fn literal(value: Value) -> String {
    match value {
        Value::Bool(value) => value.to_string(),
        Value::Int(value) => value.to_string(),
        Value::Real(value) => format!("{value:?}"),
        Value::Time(ms) => duration(ms),
    }
}

fn comparison(op: Comparison) -> &'static str {
    match op {
        Comparison::Equal => "=",
        Comparison::NotEqual => "<>",
        Comparison::Less => "<",
        Comparison::LessEqual => "<=",
        Comparison::Greater => ">",
        Comparison::GreaterEqual => ">=",
    }
}

fn arithmetic(op: Arithmetic) -> &'static str {
    match op {
        Arithmetic::Add => "+",
        Arithmetic::Subtract => "-",
        Arithmetic::Multiply => "*",
        Arithmetic::Divide => "/",
        Arithmetic::Modulo => "mod",
    }
}
