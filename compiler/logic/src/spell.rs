//! Conditions as the chart writes them: in words for messages, in the signs of the standard beside generated code.

use grafc_model::chart::{Arithmetic, DelayTime, ExprId, ExprKind, Value};
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
    spell(net, expr, DEEPEST, &WORDS)
}

/// A condition as a chart shows it, cut short where it is long.
pub(crate) fn in_signs(net: &Net, expr: ExprId) -> String {
    let text = spell(net, expr, DEEPEST_IN_SIGNS, &SIGNS).unwrap_or_default();
    match text.char_indices().nth(LONGEST_IN_SIGNS) {
        Some((end, _)) => format!("{}…", text[..end].trim_end()),
        None => text,
    }
}

/// A condition or a value as a chart writes it, in signs; what nests deeper than anybody writes is left out.
pub fn condition(net: &Net, expr: ExprId) -> String {
    const DEEPEST: usize = 200;
    spell(net, expr, DEEPEST, &SIGNS).unwrap_or_default()
}

/// `left` bounds the depth of the recursion.
fn spell(net: &Net, expr: ExprId, left: usize, signs: &Signs) -> Option<String> {
    let Some(left) = left.checked_sub(1) else { return signs.too_deep.map(str::to_owned) };
    let own = level(net, expr);
    let operand = |e: ExprId, least: u8| {
        let text = spell(net, e, left, signs)?;
        Some(if level(net, e) < least { format!("({text})") } else { text })
    };
    // Of the same operator again only a right operand needs parentheses, and not where that is the same.
    let chain = |a, sign, b| Some(format!("{} {sign} {}", operand(a, own)?, operand(b, own)?));
    let infix = |a, sign, b| Some(format!("{} {sign} {}", operand(a, own)?, operand(b, own + 1)?));
    match net.exprs[expr].kind {
        ExprKind::Literal(value) => Some(literal(value)),
        ExprKind::Variable(v) => Some(net.variables[v].name.to_string()),
        ExprKind::StepActive(s) => Some(format!("X{}", net.places[s].label)),
        ExprKind::StepTime(s) => Some(format!("T{}", net.places[s].label)),
        ExprKind::MacroActive(m) => Some(format!("X{}", net.macro_steps[m].label)),
        ExprKind::GrafcetActive(g) => Some(format!("X{}", net.grafcets[g].name)),
        ExprKind::GrafcetFrozen(g) => Some(format!("F{}", net.grafcets[g].name)),
        // `not a/5s` would be read in two ways (W0423).
        ExprKind::Not(a) if matches!(net.exprs[a].kind, ExprKind::Delay { .. }) => {
            Some(format!("{}{}", signs.not, operand(a, WORD)?))
        }
        ExprKind::Not(a) => Some(format!("{}{}", signs.not, operand(a, own)?)),
        ExprKind::And(a, b) => chain(a, signs.and, b),
        ExprKind::Or(a, b) => chain(a, signs.or, b),
        ExprKind::Xor(a, b) => infix(a, "xor", b),
        ExprKind::Rise(a) => Some(format!("↑{}", operand(a, WORD)?)),
        ExprKind::Fall(a) => Some(format!("↓{}", operand(a, WORD)?)),
        ExprKind::Delay { on, operand: inner, off } => {
            let on = if on.ms > 0 { format!("{}/", delay(net, on)) } else { String::new() };
            let off = if off.ms > 0 { format!("/{}", delay(net, off)) } else { String::new() };
            Some(format!("{on}{}{off}", operand(inner, WORD)?))
        }
        ExprKind::Compare(op, a, b) => Some(format!("[{} {} {}]", operand(a, SUM)?, op.sign(), operand(b, SUM)?)),
        ExprKind::Arithmetic(op, a, b) => infix(a, op.sign(), b),
        ExprKind::Negate(a) => Some(format!("-{}", operand(a, WORD)?)),
        ExprKind::Widen(a) => spell(net, a, left, signs),
    }
}

/// How tightly a sum binds: looser operators stand between parentheses where they are compared.
const SUM: u8 = 4;

/// How tightly what needs no parentheses binds.
const WORD: u8 = 8;

/// How tightly an expression binds.
fn level(net: &Net, expr: ExprId) -> u8 {
    match net.exprs[expr].kind {
        ExprKind::Or(..) => 1,
        ExprKind::Xor(..) => 2,
        ExprKind::And(..) => 3,
        ExprKind::Arithmetic(Arithmetic::Add | Arithmetic::Subtract, ..) => SUM,
        ExprKind::Arithmetic(Arithmetic::Multiply | Arithmetic::Divide | Arithmetic::Modulo, ..) => 5,
        ExprKind::Not(_) | ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Negate(_) => 6,
        ExprKind::Delay { .. } => 7,
        ExprKind::Widen(a) => level(net, a),
        ExprKind::Compare(..)
        | ExprKind::Literal(_)
        | ExprKind::Variable(_)
        | ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::GrafcetFrozen(_) => WORD,
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

#[cfg(test)]
mod tests {
    use super::*;
    use grafc_diagnostics::FileId;

    /// The condition of the one transition, as it is written in signs.
    fn signs(condition: &str) -> String {
        let text = format!(
            "input a, b, c : bool\ninput n, m : int\ninitial step 1\nstep 2\ntransition 1 -> 2 : {condition}\n"
        );
        let (tree, parsed) = grafc_syntax::parse(FileId::default(), &text);
        assert!(!parsed.has_errors(), "{parsed:?}");
        let (chart, diagnostics) = grafc_model::check(&tree, "chart");
        let net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{text}\n{diagnostics:?}")));
        let transition = net.transitions.first().expect("a transition");
        in_signs(&net, transition.condition)
    }

    /// What stands in parentheses would be read otherwise without them (`docs/language.md`, operators).
    #[test]
    fn parentheses_stand_where_they_are_needed() {
        let same = [
            "a · ¬b · c",
            "(a + b) · c",
            "a · b + c",
            "¬(a · b)",
            "↑(a + b) · ¬¬c",
            "5s/X1 · ¬(a/3s)",
            "5s/(a · b)",
            "5s/(¬a)",
            "[n = 3] · a",
            "[n + 1 < (n - m) * 2] + [-n > m]",
            "[n - (m - 1) = n - m - 1]",
        ];
        for condition in same {
            assert_eq!(signs(condition), condition);
        }
        assert_eq!(signs("a · (b · c) + ((a))"), "a · b · c + a");
    }
}
