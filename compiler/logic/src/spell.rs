//! Conditions as the chart writes them: in words for messages, in the signs of the standard beside generated code.

use grafc_model::chart::{DelayTime, ExprId, ExprKind, Value};
use grafc_net::Net;

/// A condition that nests deeper than this is not spelt out.
const DEEPEST: usize = 4;

/// Of one in signs, what nests deeper than this is left out.
const DEEPEST_IN_SIGNS: usize = 9;

/// The most characters of a condition in signs.
const LONGEST_IN_SIGNS: usize = 60;

/// How conditions are written.
struct Signs {
    not: &'static str,
    and: &'static str,
    or: &'static str,
    /// Instead of what nests too deep; else nothing is written at all.
    too_deep: Option<&'static str>,
}

/// The words of messages.
const WORDS: Signs = Signs { not: "not ", and: "and", or: "or", too_deep: None };

/// The signs of the standard.
const SIGNS: Signs = Signs { not: "¬", and: "·", or: "+", too_deep: Some("…") };

/// A condition as the chart may write it, if it is short.
pub(crate) fn in_words(net: &Net, expr: ExprId) -> Option<String> {
    bracketed(net, expr, DEEPEST, &WORDS)
}

/// A condition as a chart shows it, cut short where it is long.
pub(crate) fn in_signs(net: &Net, expr: ExprId) -> String {
    let text = bracketed(net, expr, DEEPEST_IN_SIGNS, &SIGNS).unwrap_or_default();
    match text.char_indices().nth(LONGEST_IN_SIGNS) {
        Some((end, _)) => format!("{}…", text[..end].trim_end()),
        None => text,
    }
}

fn bracketed(net: &Net, expr: ExprId, deepest: usize, signs: &Signs) -> Option<String> {
    match &net.exprs[expr].kind {
        ExprKind::Compare(..) => Some(format!("[{}]", spell(net, expr, deepest, signs)?)),
        _ => spell(net, expr, deepest, signs),
    }
}

/// `left` bounds the depth of the recursion.
fn spell(net: &Net, expr: ExprId, left: usize, signs: &Signs) -> Option<String> {
    let Some(left) = left.checked_sub(1) else { return signs.too_deep.map(str::to_owned) };
    let operand = |e: ExprId| {
        let text = spell(net, e, left, signs)?;
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
        ExprKind::Not(a) => Some(format!("{}{}", signs.not, operand(a)?)),
        ExprKind::And(a, b) => binary(a, signs.and, b),
        ExprKind::Or(a, b) => binary(a, signs.or, b),
        ExprKind::Xor(a, b) => binary(a, "xor", b),
        ExprKind::Rise(a) => Some(format!("↑{}", operand(a)?)),
        ExprKind::Fall(a) => Some(format!("↓{}", operand(a)?)),
        ExprKind::Delay { on, operand: inner, off } => {
            let on = if on.ms > 0 { format!("{}/", delay(net, on)) } else { String::new() };
            let off = if off.ms > 0 { format!("/{}", delay(net, off)) } else { String::new() };
            Some(format!("{on}{}{off}", operand(inner)?))
        }
        ExprKind::Compare(op, a, b) => binary(a, op.sign(), b),
        ExprKind::Arithmetic(op, a, b) => binary(a, op.sign(), b),
        ExprKind::Negate(a) => Some(format!("-{}", operand(a)?)),
        ExprKind::Widen(a) => spell(net, a, left, signs),
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
