//! Conditions and values.

use super::slip::{Cure, Slip, Spot};
use super::words::{FUNCTIONS, OPERATORS, UNITS, ours};
use crate::token::{Token, begins_item};
use grafc_diagnostics::{Fix, Span};

/// `/a`: the bar of a complement, laid flat.
pub(super) fn bar(slip: &Slip<'_>) -> Option<Cure> {
    let slash = slip.found().filter(|found| found.token == Token::Slash && slip.begins_operand())?;
    let operand = slip.spot(1).filter(|next| next.is_name() || next.token == Token::OpenParen)?;
    let shown = if operand.is_name() { operand.word } else { "(…)" };
    Some(Cure::write(format!("the complement is written `not {shown}`"), slash.span.to(operand.span.before()), "not "))
}

/// `==`, `&&`, `||`
pub(super) fn doubled(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    let words = match (previous.token, found.token) {
        (Token::Equal, Token::Equal) => "equality is written `=`",
        (Token::And, Token::And) => "write `and`, `·` or `&` once",
        (Token::Or, Token::Or) => "write `or`, `+` or `|` once",
        (Token::Rise, Token::Rise) | (Token::Fall, Token::Fall) => "an edge has no edge of its own",
        _ => return None,
    };
    Some(Cure::new(words).fix(Fix::certain(format!("leave out the second `{}`", found.word)).delete(found.span)))
}

/// `n = 3` outside of brackets, in any spelling.
pub(super) fn comparison(slip: &Slip<'_>) -> Option<Cure> {
    if !slip.ends_condition() {
        return None;
    }
    let (sign, length) = relation(slip)?;
    let left = Some(slip.previous()).filter(|left| left.is_operand());
    let minus = slip.token(length) == Some(Token::Minus);
    let right = slip.spot(length + isize::from(minus)).filter(|right| right.is_operand());
    let (Some(left), Some(right)) = (left, right) else {
        return Some(Cure::new("a comparison stands in brackets: `[…]`"));
    };
    let right_text = if minus { format!("-{}", right.word) } else { right.word.to_owned() };
    let whole = format!("[{} {sign} {right_text}]", left.word);
    let cure = Cure::new(format!("a comparison stands in brackets: `{whole}`"));
    let before = slip.spot(-2).is_none_or(|before| is_around(before.token));
    let after = slip.spot(length + isize::from(minus) + 1).is_none_or(|after| is_around(after.token));
    Some(match before && after {
        true => cure.fix(Fix::maybe("put the comparison in brackets").replace(left.span.to(right.span), whole)),
        false => cure,
    })
}

/// The comparison that begins here as it is written here, and how many tokens it has.
fn relation(slip: &Slip<'_>) -> Option<(&'static str, isize)> {
    let pair = if slip.touches(0) { slip.token(1) } else { None };
    Some(match (slip.token(0)?, pair) {
        (Token::Equal, Some(Token::Equal)) => ("=", 2),
        (Token::Equal, Some(Token::Greater)) => (">=", 2),
        (Token::Equal, Some(Token::Less)) => ("<=", 2),
        (Token::Not, Some(Token::Equal)) => ("<>", 2),
        (Token::Equal | Token::Assign, _) => ("=", 1),
        (Token::NotEqual, _) => ("<>", 1),
        (Token::Less, _) => ("<", 1),
        (Token::LessEqual, _) => ("<=", 1),
        (Token::Greater, _) => (">", 1),
        (Token::GreaterEqual, _) => (">=", 1),
        _ => return None,
    })
}

/// Whether a comparison beside this token is a whole operand.
fn is_around(token: Token) -> bool {
    use Token::*;
    matches!(token, Colon | If | Event | And | Or | Xor | Not | Plus | OpenParen | CloseParen | OpenBrace | CloseBrace)
        || begins_item(token)
}

/// `!=`, `=>`, `=<`, `><`, `> =` within brackets.
pub(super) fn relation_sign(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    if found.token == Token::Not && slip.ends_arithmetic() {
        let equal = slip.spot(1).filter(|next| next.token == Token::Equal)?;
        return Some(Cure::write("\"not equal\" is written `<>`", found.span.to(equal.span), "<>"));
    }
    let sign = match (previous.token, found.token) {
        (Token::Equal, Token::Greater) | (Token::Greater, Token::Equal) => ">=",
        (Token::Equal, Token::Less) | (Token::Less, Token::Equal) => "<=",
        (Token::Greater, Token::Less) | (Token::Not, Token::Equal) => "<>",
        _ => return None,
    };
    Some(Cure::write(format!("this comparison is written `{sign}`"), previous.span.to(found.span), sign))
}

/// `[a < b < c]`
pub(super) fn chain(slip: &Slip<'_>) -> Option<Cure> {
    let found = slip.found().filter(|found| found.token.is_relation() && slip.ends_arithmetic())?;
    let middle = slip.previous();
    let cure = Cure::new(format!("join two comparisons by `and`: `… and {} {} …`", middle.word, found.word));
    Some(match middle.is_operand() {
        true => {
            cure.fix(Fix::maybe("join two comparisons").replace(middle.span.behind(), format!(" and {}", middle.word)))
        }
        false => Cure::new("one of the two comparisons stands in parentheses"),
    })
}

/// `a↑`
pub(super) fn edge_behind(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    let is_edge = matches!(found.token, Token::Rise | Token::Fall) && slip.ends_operand() && previous.is_name();
    if !is_edge || slip.spot(1).is_some_and(|next| next.opens_operand() && next.token != Token::Not) {
        return None;
    }
    let blank = if found.word.starts_with(char::is_alphabetic) { " " } else { "" };
    let right = format!("{}{blank}{}", found.word, previous.word);
    let words = format!("an edge stands before its operand: `{right}`");
    Some(Cure::write(words, previous.span.to(found.span), &right))
}

/// `↑not a`, `↑3s/a`, `3s/not a`: the operand wants parentheses.
pub(super) fn bare_operand(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    let whose = match previous.token {
        Token::Rise | Token::Fall => "an edge",
        Token::Slash if slip.has("[") && !slip.has("-") => "a delay",
        _ => return None,
    };
    let last = match (found.token, slip.token(1)) {
        (Token::Not, Some(Token::Name)) => slip.spot(1)?,
        (Token::Duration, Some(Token::Slash)) if slip.token(2) == Some(Token::Name) => slip.spot(2)?,
        (Token::Not, _) => return Some(Cure::new(format!("put the operand of {whose} in parentheses: `(not …)`"))),
        _ => return None,
    };
    let right = format!("({})", slip.slice(found, last));
    let words = format!("put the operand of {whose} in parentheses: `{}{right}`", previous.word);
    let fix = Fix::certain("put the operand in parentheses").replace(found.span.before(), "(");
    Some(Cure::new(words).fix(fix.replace(last.span.behind(), ")")))
}

/// `1s/↑a`
pub(super) fn delayed_edge(slip: &Slip<'_>) -> Option<Cure> {
    let edge = slip.found().filter(|found| matches!(found.token, Token::Rise | Token::Fall))?;
    if slip.previous().token != Token::Slash {
        return None;
    }
    let operand = slip.spot(1).filter(|next| next.is_name())?;
    let time = slip.spot(-2).map_or("…", |time| time.word);
    let words = format!("an edge lasts no time, so it cannot be delayed; what it is of can: `{time}/{}`", operand.word);
    Some(Cure::guess(words, edge.span.to(operand.span), operand.word))
}

/// `3 s`
pub(super) fn gap_in_duration(slip: &Slip<'_>) -> Option<Cure> {
    let (number, unit) = (slip.previous(), slip.found()?);
    if !matches!(number.token, Token::Whole | Token::Integer | Token::Real) || !unit.is_name() {
        return None;
    }
    let right = format!("{}{}", number.word, ours(UNITS, unit.word)?);
    Some(Cure::write(format!("a duration is one word: `{right}`"), number.span.to(unit.span), &right))
}

/// `1,5s`
pub(super) fn decimal_comma(slip: &Slip<'_>) -> Option<Cure> {
    let (whole, comma) = (slip.previous(), slip.found().filter(|found| found.token == Token::Comma)?);
    let fraction = slip.spot(1).filter(|next| {
        matches!(next.token, Token::Whole | Token::Duration | Token::Real) && slip.touches(-1) && slip.touches(0)
    })?;
    let right = format!("{}.{}", whole.word, fraction.word);
    let is_number = whole.token == Token::Whole && !fraction.word.contains('.');
    is_number.then(|| Cure::write(format!("the decimal sign is a point: `{right}`"), comma.span, "."))
}

/// `=1`, as drawings have it.
pub(super) fn equals_one(slip: &Slip<'_>) -> Option<Cure> {
    let equal = slip.found().filter(|found| found.token == Token::Equal && slip.begins_operand())?;
    let number = slip.spot(1).filter(|next| next.token == Token::Whole && matches!(next.word, "0" | "1"))?;
    let words = format!("a condition that does not change is written `{}` alone", number.word);
    Some(Cure::leave_out(words, equal))
}

/// `R_TRIG(start)`, `X(1)`, `TON(a, 5s)`
pub(super) fn function(slip: &Slip<'_>) -> Option<Cure> {
    let (name, open) = (slip.previous(), slip.found()?);
    if !name.is_name() || open.token != Token::OpenParen || !slip.ends_operand() {
        return None;
    }
    let only = slip.spot(1).filter(|only| only.is_label() && slip.token(2) == Some(Token::CloseParen));
    let whole = |last: isize| slip.spot(last).map(|last| name.span.to(last.span));
    if let (Some(only), "X" | "T") = (only, name.word) {
        let right = format!("{}{}", name.word, only.word);
        return Some(Cure::write(format!("write `{right}`"), whole(2)?, &right));
    }
    if let Some(sign) = ours(FUNCTIONS, name.word) {
        return Some(match only {
            Some(only) => {
                let right = format!("{sign}{}", only.word);
                Cure::write(format!("write `{right}`"), whole(2)?, &right)
            }
            None => Cure::write(format!("write `{}(…)`", sign.trim_end()), name.span, sign),
        });
    }
    let timer = match name.word.to_uppercase().as_str() {
        "TON" => Some("before"),
        "TOF" => Some("behind"),
        _ => None,
    };
    if let Some(side) = timer {
        let words = format!("there are no timers: the time of a delay stands {side} what is delayed");
        let arguments = [slip.spot(1)?, slip.spot(2)?, slip.spot(3)?, slip.spot(4)?];
        return Some(match arguments.map(|spot| spot.token) {
            [Token::Name, Token::Comma, Token::Duration, Token::CloseParen] => {
                let (what, time) = (arguments[0].word, arguments[2].word);
                let right = if side == "before" { format!("{time}/{what}") } else { format!("{what}/{time}") };
                Cure::write(format!("{words}: `{right}`"), whole(4)?, &right)
            }
            _ => Cure::new(words),
        });
    }
    juxtaposed(slip)
}

/// `a et b`, `a And b`
pub(super) fn operator_word(slip: &Slip<'_>) -> Option<Cure> {
    let word = slip.found().filter(|found| found.is_name() && slip.ends_operand())?;
    let ours =
        ours(OPERATORS, word.word).filter(|ours| *ours != "not" && (*ours != "mod" || slip.ends_arithmetic()))?;
    Some(Cure::write(format!("write `{ours}`"), word.span, ours))
}

/// `RE a`
pub(super) fn edge_word(slip: &Slip<'_>) -> Option<Cure> {
    let (word, operand) = (slip.previous(), slip.found().filter(|found| found.is_name())?);
    let sign = ours(FUNCTIONS, word.word).filter(|sign| *sign != "not " && word.is_name() && slip.ends_operand())?;
    let right = format!("{sign}{}", operand.word);
    Some(Cure::write(format!("write `{right}`"), word.span.to(operand.span), &right))
}

/// `nicht a`
pub(super) fn negating_word(slip: &Slip<'_>) -> Option<Cure> {
    let (word, operand) = (slip.previous(), slip.found()?);
    let is_negation = word.is_name() && slip.ends_operand() && ours(OPERATORS, word.word) == Some("not");
    (is_negation && operand.opens_operand()).then(|| Cure::write("write `not`", word.span, "not"))
}

/// `after 5s`, `wait 5s`
pub(super) fn waiting_word(slip: &Slip<'_>) -> Option<Cure> {
    let (word, time) = (slip.previous(), slip.found().filter(|found| found.token == Token::Duration)?);
    if !word.is_one_of(&["after", "wait", "delay", "timer", "nach", "warte", "après", "attendre", "for", "t"]) {
        return None;
    }
    let right = format!("{}/X{}", time.word, slip.own_step()?);
    Some(Cure::guess(format!("a time is counted from something: `{right}`"), word.span.to(time.span), &right))
}

/// `X 1`
pub(super) fn gap_in_activity(slip: &Slip<'_>) -> Option<Cure> {
    let (letter, label) = (slip.previous(), slip.found().filter(|found| found.token == Token::Whole)?);
    let right = format!("{}{}", letter.word, label.word);
    let is_implicit = matches!(letter.word, "X" | "T") && slip.ends_operand();
    is_implicit.then(|| Cure::write(format!("write `{right}` in one word"), letter.span.to(label.span), &right))
}

/// `a b`
pub(super) fn juxtaposed(slip: &Slip<'_>) -> Option<Cure> {
    let (left, right) = (slip.previous(), slip.found()?);
    let is_product = slip.ends_condition() && left.closes_operand() && right.opens_operand();
    if !is_product || !slip.on_one_line(left, right) {
        return None;
    }
    let shown = |spot: Spot<'_>| if spot.is_operand() { spot.word.to_owned() } else { "…".to_owned() };
    let words = format!("write the operator, as in `{} · {}`", shown(left), shown(right));
    let gap = Span { start: left.span.end, ..right.span.before() };
    Some(Cure::guess(words, gap, " · "))
}

/// `a * b`
pub(super) fn star(slip: &Slip<'_>) -> Option<Cure> {
    let star = slip.found().filter(|found| found.token == Token::Star && slip.ends_condition())?;
    Some(Cure::guess("\"and\" is written `and`, `·` or `&`; multiplication stands in brackets", star.span, "·"))
}

/// `a - b`, `a mod b` outside of brackets.
pub(super) fn arithmetic(slip: &Slip<'_>) -> Option<Cure> {
    let is_arithmetic = matches!(slip.token(0)?, Token::Minus | Token::Mod) && slip.ends_condition();
    is_arithmetic.then(|| Cure::new("arithmetic stands in brackets, with what it is compared with: `[…]`"))
}

/// `a/b/c/d`
pub(super) fn many_delays(slip: &Slip<'_>) -> Option<Cure> {
    let is_slash = slip.token(0)? == Token::Slash && slip.ends_condition();
    is_slash.then(|| Cure::new("a delay has one time before its operand and one behind it, at most"))
}

/// `: if a`
pub(super) fn conditional_word(slip: &Slip<'_>) -> Option<Cure> {
    let word = slip.found().filter(|found| found.token == Token::If && slip.begins_operand())?;
    let gap = Span { end: slip.spot(1).map_or(word.span.end, |next| next.span.start), ..word.span };
    Some(Cure::new("leave out `if`").fix(Fix::certain("leave out `if`").delete(gap)))
}

/// `a and`, `and a`
pub(super) fn lonely_operator(slip: &Slip<'_>) -> Option<Cure> {
    if !slip.begins_operand() {
        return None;
    }
    let is_operator = |token: Token| matches!(token, Token::And | Token::Or | Token::Xor | Token::Plus);
    let previous = slip.previous();
    let lonely = match slip.found() {
        Some(found) if is_operator(found.token) => found,
        Some(found) if found.opens_operand() => return None,
        _ if is_operator(previous.token) => previous,
        _ => return None,
    };
    let words = format!("leave out `{}`, or write what it joins", lonely.word);
    Some(Cure::new(words).fix(Fix::maybe(format!("leave out `{}`", lonely.word)).delete(lonely.span)))
}

/// A parenthesis or bracket without its partner.
pub(super) fn partner(slip: &Slip<'_>) -> Option<Cure> {
    let found = slip.found();
    let missing = [(")", Token::CloseParen), ("]", Token::CloseBracket)].into_iter().find(|(sign, _)| slip.has(sign));
    if let Some((sign, _)) = missing {
        let ends = found.is_none_or(|found| {
            use Token::*;
            matches!(found.token, OpenBrace | CloseBrace | CloseParen | CloseBracket | Colon | Comma | If | On)
                || begins_item(found.token)
        });
        let place = slip.previous().span.behind();
        return ends
            .then(|| Cure::new(format!("add `{sign}`")).fix(Fix::maybe(format!("add `{sign}`")).replace(place, sign)));
    }
    let stray = found.filter(|found| matches!(found.token, Token::CloseParen | Token::CloseBracket))?;
    let words = format!("leave out `{}`, or open it before", stray.word);
    slip.ends_operand().then(|| Cure::new(words).fix(Fix::maybe("leave it out").delete(stray.span)))
}
