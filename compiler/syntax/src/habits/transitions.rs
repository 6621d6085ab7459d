//! The head of a transition, and what it does at its clearing.

use super::slip::{Cure, Slip, Spot};
use crate::token::Token;
use grafc_diagnostics::{Fix, Span};

const TO: [&str; 9] = ["to", "then", "nach", "bis", "zu", "à", "a", "vers", "goto"];
const FROM: [&str; 6] = ["from", "von", "de", "depuis", "between", "desde"];
const WHEN: [&str; 9] = ["if", "when", "on", "with", "wenn", "bei", "si", "quand", "cond"];

/// Whether the steps of a transition are read here.
fn is_before_arrow(slip: &Slip<'_>) -> bool {
    slip.item() == Token::Transition && slip.has("->")
}

/// `transition t2: 2 -> 3`, `transition t2 2 -> 3`
pub(super) fn designation(slip: &Slip<'_>) -> Option<Cure> {
    let (name, found) = (slip.previous(), slip.found()?);
    if !is_before_arrow(slip)
        || slip.token(-2) != Some(Token::Transition)
        || !name.is_label()
        || FROM.contains(&name.word)
    {
        return None;
    }
    let last = match found.token {
        Token::Colon => found,
        Token::Name | Token::Whole if name.is_name() && slip.token(1) == Some(Token::Arrow) => name,
        _ => return None,
    };
    let right = format!("({})", name.word);
    let words = format!("the designation of a transition stands in parentheses: `{right}`");
    Some(Cure::write(words, name.span.to(last.span), &right))
}

/// `=>`, `- >`, `-->`, `>`: an arrow of several tokens, or half of one.
pub(super) fn arrow(slip: &Slip<'_>) -> Option<Cure> {
    let found = slip.found().filter(|found| {
        slip.has("->") && matches!(found.token, Token::Minus | Token::Equal | Token::Greater | Token::GreaterEqual)
    })?;
    let last = slip
        .from(1)
        .take_while(|next| matches!(next.token, Token::Greater | Token::Arrow | Token::Minus | Token::Equal))
        .take_while(|next| slip.on_one_line(found, *next))
        .last()
        .unwrap_or(found);
    Some(Cure::write("an arrow is written `->`", found.span.to(last.span), "->"))
}

/// `transition 1 to 2`, `transition from 1 to 2`
pub(super) fn words_for_the_arrow(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    if !is_before_arrow(slip) {
        return None;
    }
    if found.is_one_of(&TO) {
        return Some(Cure::write("an arrow is written `->`", found.span, "->"));
    }
    if !previous.is_one_of(&FROM) || !found.is_label() {
        return None;
    }
    let fix = Fix::certain("write `->`").delete(Span { end: found.span.start, ..previous.span });
    let to = slip.from(1).take_while(|next| next.token != Token::Colon).find(|next| next.is_one_of(&TO));
    Some(match to {
        Some(to) => Cure::new(format!("write `{} -> …`", found.word)).fix(fix.replace(to.span, "->")),
        None => Cure::new(format!("leave out `{}`", previous.word)).fix(fix),
    })
}

/// `transition 1 2 -> 3`, `transition 1 and 2 -> 3`
pub(super) fn synchronisation(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    if slip.item() != Token::Transition || !slip.has(",") || !previous.is_label() || slip.is_in_braces() {
        return None;
    }
    let next = slip.spot(1);
    match found.token {
        Token::Name | Token::Whole if slip.on_one_line(previous, found) && !found.is_one_of(&WHEN) => {
            if slip.has("->") && next.is_some_and(|next| next.token == Token::Colon) {
                let words = format!("an arrow leads from one to the other: `{} -> {}`", previous.word, found.word);
                return Some(Cure::guess(words, previous.span.behind(), " ->"));
            }
            let is_label = next.is_some_and(|next| matches!(next.token, Token::Arrow | Token::Colon | Token::Comma));
            let words = format!("steps are separated by commas: `{}, {}`", previous.word, found.word);
            is_label.then(|| Cure::guess(words, previous.span.behind(), ","))
        }
        Token::And | Token::Plus | Token::Or => {
            let words = format!("steps are separated by commas: `{}, {}`", previous.word, next?.word);
            let place = Span { start: previous.span.end, ..found.span };
            next?.is_label().then(|| Cure::guess(words, place, ","))
        }
        _ => None,
    }
}

/// `transition (1) -> (2)`
pub(super) fn step_in_parentheses(slip: &Slip<'_>) -> Option<Cure> {
    let open = slip.found().filter(|found| found.token == Token::OpenParen)?;
    let label = slip.spot(1).filter(|label| label.is_label() && slip.token(2) == Some(Token::CloseParen))?;
    let expects_label = slip.item() == Token::Transition && slip.has("whole") && !slip.has("not");
    let close = slip.spot(2)?;
    expects_label.then(|| {
        let words = format!("a step is named by its label alone: `{}`", label.word);
        Cure::guess(words, open.span.to(close.span), label.word)
    })
}

/// `transition 1 -> 2 := a`, `transition 1 -> 2 when a`, `transition 1 -> 2 [a]`
pub(super) fn colon(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    if slip.item() != Token::Transition || !slip.has(":") || slip.is_in_braces() || !slip.on_one_line(previous, found) {
        return None;
    }
    let words = "the transition-condition stands behind `:`";
    Some(match found.token {
        Token::Assign | Token::Equal | Token::Or | Token::Slash => Cure::write(words, found.span, ":"),
        Token::If | Token::On => Cure::write(words, found.span, ":"),
        Token::Name if found.is_one_of(&WHEN) => Cure::write(words, found.span, ":"),
        Token::Arrow => Cure::new("a transition has one `->`"),
        _ if found.opens_operand() => Cure::guess(words, found.span.before(), ": "),
        _ => return None,
    })
}

/// `transition 1 -> 2`, `transition 1 -> 2 :`
pub(super) fn no_condition(slip: &Slip<'_>) -> Option<Cure> {
    if slip.item() != Token::Transition || slip.is_in_braces() {
        return None;
    }
    let previous = slip.previous();
    let ends = slip.found().is_none_or(|found| found.token == Token::OpenBrace);
    let (missing, words) = match previous.token {
        Token::Colon if slip.begins_condition() => (" 1", "a transition-condition that is always true is written `1`"),
        _ if slip.has(":") => (" : 1", "a transition-condition that is always true is written `: 1`"),
        _ => return None,
    };
    let fix = Fix::maybe(format!("add `{}`", missing.trim())).replace(previous.span.behind(), missing);
    ends.then(|| Cure::new(words).fix(fix))
}

/// `{ n := 1 on activation }`, `{ V }`, `{ force G1{} }` at a transition.
pub(super) fn clearing(slip: &Slip<'_>) -> Option<Cure> {
    let found = slip.found().filter(|_| slip.is_in_clearing() && (slip.has("}") || slip.has(":=")))?;
    let target = slip.previous().word;
    Some(match found.token {
        Token::On => {
            let last = slip.spot(1).filter(|next| matches!(next.token, Token::Activation | Token::Deactivation));
            let place = found.span.to(last.map_or(found.span, |last: Spot<'_>| last.span));
            let cure = Cure::new(format!(
                "leave out `{}`: a transition does this at its clearing",
                last.map_or(found.word, |last| slip.slice(found, last))
            ));
            if last.is_some() { cure.fix(Fix::maybe("leave it out").delete(place)) } else { cure }
        }
        Token::CloseBrace | Token::If | Token::Name if slip.has(":=") && !slip.has("-") => {
            Cure::new(format!("what goes on while a step is active belongs to the step: `{{ {target} }}`"))
        }
        Token::Force => Cure::new("forcing orders belong to steps: `{ force … }`"),
        _ => return None,
    })
}
