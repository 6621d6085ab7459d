//! Conditions and values as the standard writes them: `a·b`, `3s/X1`, `[C = 3]`, negation as a line over what is negated.
//!
//! The depth of an expression is its author's, so nothing recurses.

use crate::font::shown;
use crate::rich::Token;
use grafc_model::chart::{Arithmetic, Comparison, DelayTime, ExprId, ExprKind, Tables, Value, below};
use rustc_hash::FxHashMap;

/// So many lines over each other can still be told apart; further negations are written `¬( )`.
const MOST_LINES: u8 = 3;

/// Where an expression stands.
#[derive(Clone, Copy)]
struct Place {
    /// Between the brackets of a predicate.
    bracketed: bool,
    /// The lines over it, a bit each.
    over: u8,
}

enum Piece {
    Text(String, Place, bool),
    Expr(ExprId, Place),
}

/// The tokens of a condition, or of the right side of an action.
pub(crate) fn expression(chart: &Tables, root: ExprId) -> Vec<Token> {
    write(chart, root, false)
}

/// The tokens of a value, which needs no brackets.
pub(crate) fn value(chart: &Tables, root: ExprId) -> Vec<Token> {
    write(chart, root, true)
}

fn write(chart: &Tables, root: ExprId, bracketed: bool) -> Vec<Token> {
    let heights = heights(chart, root);
    let mut out: Vec<Token> = Vec::new();
    let mut open = vec![Piece::Expr(root, Place { bracketed, over: 0 })];
    while let Some(piece) = open.pop() {
        let (id, place) = match piece {
            Piece::Text(text, place, may_break) => {
                out.push(Token { text, over: place.over, may_break });
                continue;
            }
            Piece::Expr(id, place) => (id, place),
        };
        let word = |text: &str| Piece::Text(text.to_string(), place, false);
        let operand = |id: ExprId, least: u8| match level(&chart.exprs[id].kind, place.bracketed) < least {
            true => vec![word("("), Piece::Expr(id, place), word(")")],
            false => vec![Piece::Expr(id, place)],
        };
        let infix = |a: ExprId, sign: &str, b: ExprId, own: u8| {
            let sign = Piece::Text(sign.to_string(), place, true);
            [operand(a, own), vec![sign], operand(b, own)].concat_pieces()
        };
        let kind = &chart.exprs[id].kind;
        let own = level(kind, place.bracketed);
        let pieces = match *kind {
            ExprKind::Literal(value) => vec![word(&literal(value))],
            ExprKind::Variable(v) => vec![word(&shown(&chart.variables[v].name))],
            ExprKind::StepActive(s) => vec![word(&format!("X{}", shown(&chart.steps[s].label)))],
            ExprKind::StepTime(s) => vec![word(&format!("T{}", shown(&chart.steps[s].label)))],
            ExprKind::MacroActive(m) => vec![word(&format!("X{}", shown(&chart.macro_steps[m].label)))],
            ExprKind::GrafcetActive(g) => vec![word(&format!("X{}", shown(&chart.grafcets[g].name)))],
            ExprKind::GrafcetFrozen(g) => vec![word(&format!("F{}", shown(&chart.grafcets[g].name)))],
            ExprKind::Not(a) => match heights.get(&id) {
                Some(&height) => vec![Piece::Expr(a, Place { over: place.over | 1 << height, ..place })],
                None => vec![word("¬("), Piece::Expr(a, place), word(")")],
            },
            ExprKind::And(a, b) => infix(a, if place.bracketed { " and " } else { " · " }, b, own),
            ExprKind::Or(a, b) => infix(a, if place.bracketed { " or " } else { " + " }, b, own),
            ExprKind::Xor(a, b) => infix(a, if place.bracketed { " xor " } else { " ⊕ " }, b, own + 1),
            ExprKind::Rise(a) => [vec![word("↑")], operand(a, TIGHT)].concat_pieces(),
            ExprKind::Fall(a) => [vec![word("↓")], operand(a, TIGHT)].concat_pieces(),
            ExprKind::Negate(a) => [vec![word("-")], operand(a, TIGHT)].concat_pieces(),
            ExprKind::Widen(a) => vec![Piece::Expr(a, place)],
            ExprKind::Compare(sign, a, b) => {
                let inner = Place { bracketed: true, ..place };
                let sides = [
                    vec![Piece::Text("[".to_string(), place, false), Piece::Expr(a, inner)],
                    vec![Piece::Text(comparison(sign).to_string(), place, true)],
                    vec![Piece::Expr(b, inner), Piece::Text("]".to_string(), place, false)],
                ];
                let mut pieces = sides.concat_pieces();
                if place.bracketed {
                    // Within other brackets parentheses keep it apart.
                    pieces[0] = word("(");
                    pieces[4] = word(")");
                }
                pieces
            }
            ExprKind::Arithmetic(sign, a, b) => {
                // `a - b - c` is read from the left, so the right side needs parentheses where it is of the same level.
                let text = Piece::Text(arithmetic(sign).to_string(), place, true);
                [operand(a, own), vec![text], operand(b, own + 1)].concat_pieces()
            }
            ExprKind::Delay { on, operand: a, off } => {
                let mut pieces = Vec::new();
                let has = |time: DelayTime| time.ms != 0 || time.constant.is_some();
                if has(on) || !has(off) {
                    pieces.push(word(&format!("{}/", delay(chart, on))));
                }
                pieces.extend(operand(a, TIGHT));
                if has(off) {
                    pieces.push(word(&format!("/{}", delay(chart, off))));
                }
                pieces
            }
        };
        open.extend(pieces.into_iter().rev());
    }
    out
}

trait Concat {
    fn concat_pieces(self) -> Vec<Piece>;
}

impl<const N: usize> Concat for [Vec<Piece>; N] {
    fn concat_pieces(self) -> Vec<Piece> {
        self.into_iter().flatten().collect()
    }
}

/// How far each negation's line is above the text: above the lines of the negations within. Without one where there
/// would be too many.
fn heights(chart: &Tables, root: ExprId) -> FxHashMap<ExprId, u8> {
    let mut found: Vec<ExprId> = below(&chart.exprs, root).collect();
    // Operands have smaller ids.
    found.sort_unstable();
    let mut lines: FxHashMap<ExprId, u8> = FxHashMap::default();
    let mut heights = FxHashMap::default();
    for id in found {
        let kind = &chart.exprs[id].kind;
        let within = kind.operands().map(|operand| lines.get(&operand).copied().unwrap_or(0)).max().unwrap_or(0);
        let own = match kind {
            ExprKind::Not(_) if within < MOST_LINES => {
                heights.insert(id, within);
                within + 1
            }
            _ => within,
        };
        lines.insert(id, own);
    }
    heights
}

/// What binds so tightly needs no parentheses.
const TIGHT: u8 = 9;

/// How tightly an expression binds.
fn level(kind: &ExprKind, bracketed: bool) -> u8 {
    match kind {
        ExprKind::Or(..) => 1,
        ExprKind::Xor(..) => 2,
        ExprKind::And(..) => 4,
        ExprKind::Arithmetic(Arithmetic::Add | Arithmetic::Subtract, ..) => 5,
        ExprKind::Arithmetic(Arithmetic::Multiply | Arithmetic::Divide | Arithmetic::Modulo, ..) => 6,
        ExprKind::Negate(_) | ExprKind::Delay { .. } => 8,
        ExprKind::Compare(..) if bracketed => TIGHT,
        ExprKind::Compare(..)
        | ExprKind::Literal(_)
        | ExprKind::Variable(_)
        | ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::GrafcetFrozen(_)
        | ExprKind::Not(_)
        | ExprKind::Rise(_)
        | ExprKind::Fall(_)
        | ExprKind::Widen(_) => TIGHT,
    }
}

fn literal(value: Value) -> String {
    match value {
        Value::Bool(b) => u8::from(b).to_string(),
        Value::Int(n) => n.to_string(),
        Value::Real(x) => format!("{x:?}"),
        Value::Time(ms) => duration(ms),
    }
}

fn delay(chart: &Tables, delay: DelayTime) -> String {
    delay.constant.map_or_else(|| duration(delay.ms), |constant| shown(&chart.variables[constant].name))
}

/// A duration as it is written in a chart: `1min30s`, `1.5s`.
fn duration(ms: i64) -> String {
    let sign = if ms < 0 { "-" } else { "" };
    let mut rest = ms.unsigned_abs();
    let mut out = String::new();
    for (unit, size) in [("h", 3_600_000), ("min", 60_000)] {
        if rest >= size {
            out.push_str(&format!("{}{unit}", rest / size));
            rest %= size;
        }
    }
    match (rest / 1000, rest % 1000) {
        (0, 0) if out.is_empty() => return "0s".to_owned(),
        (0, 0) => {}
        (0, ms) => out.push_str(&format!("{ms}ms")),
        (s, 0) => out.push_str(&format!("{s}s")),
        (s, ms) => out.push_str(&format!("{s}.{}s", format!("{ms:03}").trim_end_matches('0'))),
    }
    format!("{sign}{out}")
}

fn comparison(sign: Comparison) -> &'static str {
    match sign {
        Comparison::Equal => " = ",
        Comparison::NotEqual => " ≠ ",
        Comparison::Less => " < ",
        Comparison::LessEqual => " ≤ ",
        Comparison::Greater => " > ",
        Comparison::GreaterEqual => " ≥ ",
    }
}

fn arithmetic(sign: Arithmetic) -> &'static str {
    match sign {
        Arithmetic::Add => " + ",
        Arithmetic::Subtract => " - ",
        Arithmetic::Multiply => " × ",
        Arithmetic::Divide => " / ",
        Arithmetic::Modulo => " mod ",
    }
}

#[cfg(test)]
mod tests {
    use super::duration;

    #[test]
    fn durations_are_written_as_by_hand() {
        let cases = [
            (0, "0s"),
            (250, "250ms"),
            (1500, "1.5s"),
            (8000, "8s"),
            (61_250, "1min1.25s"),
            (90_000, "1min30s"),
            (3_600_500, "1h500ms"),
            (-1020, "-1.02s"),
        ];
        for (ms, written) in cases {
            assert_eq!(duration(ms), written);
        }
    }
}
