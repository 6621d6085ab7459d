//! Declarations, and names that only backquotes make names.

use super::slip::{Cure, Slip, Spot};
use super::words::{TYPES, ours};
use crate::spelling::is_reserved;
use crate::token::Token;
use grafc_diagnostics::{Fix, Span};

fn is_declaration(slip: &Slip<'_>) -> bool {
    matches!(slip.item(), Token::Input | Token::Output | Token::Var | Token::Const | Token::Retain)
}

/// The type of this name, in our words or others'.
fn type_name(spot: Spot<'_>) -> Option<&'static str> {
    let known = TYPES.iter().map(|(known, _)| *known).find(|known| *known == spot.word.to_lowercase());
    known.or_else(|| ours(TYPES, spot.word)).filter(|_| spot.is_name())
}

/// `input bool a`
pub(super) fn type_first(slip: &Slip<'_>) -> Option<Cure> {
    let (first, name) = (slip.previous(), slip.found().filter(|found| found.is_name())?);
    let known = type_name(first).filter(|_| is_declaration(slip) && slip.has(":"))?;
    if slip.token(-2) == Some(Token::Comma) || type_name(name).is_some() {
        return None;
    }
    let words = format!("the type stands behind the name: `{} : {known}`", name.word);
    let cure = Cure::new(words);
    let names = slip.from(0).take_while(|next| matches!(next.token, Token::Name | Token::Comma | Token::String));
    let last = names.take_while(|next| slip.on_one_line(first, *next)).last()?;
    let fix = Fix::certain("put the type behind the name").delete(Span { end: name.span.start, ..first.span });
    Some(cure.fix(fix.replace(last.span.behind(), format!(" : {known}"))))
}

/// `input a bool`, `input a, b = bool`
pub(super) fn colon_missing(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    if !is_declaration(slip) || !slip.has(":") || !slip.on_one_line(previous, found) {
        return None;
    }
    match found.token {
        Token::Name => {
            let is_type = type_name(found).filter(|known| *known == found.word)?;
            Some(Cure::guess(format!("a type stands behind a colon: `: {is_type}`"), found.span.before(), ": "))
        }
        Token::Equal | Token::Assign if slip.spot(1).and_then(type_name).is_some() => {
            let right = slip.spot(1).and_then(type_name)?;
            Some(Cure::write(format!("a type stands behind a colon: `: {right}`"), found.span, ":"))
        }
        Token::Equal | Token::Assign => {
            let value = slip.spot(1)?;
            let ty = match value.token {
                Token::Whole | Token::Integer => "int",
                Token::Real => "real",
                Token::Duration => "time",
                Token::True | Token::False => "bool",
                _ => return Some(Cure::new(format!("say its type as well: `{} : … := …`", previous.word))),
            };
            let right = format!("{} : {ty} := {}", previous.word, value.word);
            let place = Span { start: previous.span.end, ..found.span };
            Some(Cure::guess(format!("say its type as well: `{right}`"), place, &format!(" : {ty} :=")))
        }
        _ => None,
    }
}

/// `input a`
pub(super) fn no_type(slip: &Slip<'_>) -> Option<Cure> {
    if !is_declaration(slip) || slip.found().is_some() {
        return None;
    }
    let previous = slip.previous();
    let (missing, words) = match previous.token {
        Token::Colon => (" bool", "say its type, `bool` for what is true or false"),
        _ if slip.has(":") => (" : bool", "say its type, `: bool` for what is true or false"),
        _ => return None,
    };
    Some(Cure::new(words).fix(Fix::maybe(format!("add `{}`", missing.trim())).replace(previous.span.behind(), missing)))
}

/// `input a : bool, b : int`
pub(super) fn second_type(slip: &Slip<'_>) -> Option<Cure> {
    let comma = slip.found().filter(|found| found.token == Token::Comma && is_declaration(slip))?;
    let name = slip.spot(1).filter(|next| next.is_name())?;
    let word = slip.lexemes[slip.run.start];
    let word = &slip.text[word.start as usize..word.end as usize];
    let words = format!("what has a type of its own is declared by itself: `{word} {}`", name.word);
    let place = Span { end: name.span.start, ..comma.span };
    Some(Cure::guess(words, place, &format!("\n{word} ")))
}

/// `var n : int = 3`
pub(super) fn equals(slip: &Slip<'_>) -> Option<Cure> {
    let sign = slip.found().filter(|found| found.token == Token::Equal && is_declaration(slip) && slip.has(":="))?;
    Some(Cure::write("a value is given by `:=`", sign.span, ":="))
}

/// `input a at %IX0.0 : bool`, the order of IEC 61131-3
pub(super) fn address_first(slip: &Slip<'_>) -> Option<Cure> {
    let (name, at) = (slip.previous(), slip.found()?);
    if at.token != Token::At || !is_declaration(slip) || !slip.has(":") {
        return None;
    }
    let (address, colon) = (slip.spot(1)?, slip.spot(2).filter(|next| next.token == Token::Colon)?);
    let ty = slip.spot(3).filter(|next| next.is_name() && slip.on_one_line(name, *next))?;
    let words = format!("the address stands behind the type: `{} : {} at {}`", name.word, ty.word, address.word);
    let before = Span { start: name.span.end, end: colon.span.start, ..name.span };
    let fix = Fix::certain("put the address behind the type").replace(before, " ");
    Some(Cure::new(words).fix(fix.replace(ty.span.behind(), format!(" at {}", address.word))))
}

/// An address without its `%`, with the letters of IEC 61131-3: in German STEP 7 has `E` for `I` and `A` for `Q`.
pub(crate) fn in_letters_of_iec(word: &str) -> String {
    let mut letters = word.chars();
    let area = match letters.next() {
        Some('E') => 'I',
        Some('A') => 'Q',
        _ => return word.to_owned(),
    };
    let is_address = letters.clone().any(|c| c.is_ascii_digit());
    if is_address { format!("{area}{}", letters.as_str()) } else { word.to_owned() }
}

/// `at IX0.0`
pub(super) fn address(slip: &Slip<'_>) -> Option<Cure> {
    let at = slip.found().filter(|found| found.is_name() && slip.has("at") && found.word == "at")?;
    let next = slip.spot(1).filter(|next| next.is_name() && slip.on_one_line(at, *next))?;
    let right = format!("%{}", in_letters_of_iec(next.word));
    Some(Cure::write(format!("an address begins with `%`: `at {right}`"), next.span, &right))
}

/// `-a`: a designation has a number in it.
pub(super) fn negative(slip: &Slip<'_>) -> Option<Cure> {
    let sign = slip.found().filter(|found| found.token == Token::Minus && slip.begins_condition())?;
    let name = slip.spot(1).filter(|next| next.is_name() && !next.word.contains(|c: char| c.is_numeric()))?;
    Some(Cure::guess(format!("the opposite of a condition is `not {}`", name.word), sign.span, "not "))
}

/// `-S4`, `start-button`, `=A1+B2-S4`: designations and names with signs in them.
pub(super) fn designation(slip: &Slip<'_>) -> Option<Cure> {
    let sign = slip
        .found()
        .filter(|found| matches!(found.token, Token::Minus | Token::Equal | Token::Plus) && slip.touches(0))?;
    let is_part = |spot: Spot<'_>| {
        use Token::*;
        matches!(spot.token, Name | Whole | Integer | Real | Duration | Unreadable | Minus | Plus | Equal)
    };
    let is_name_expected = slip.has("name") && !slip.has("-") && (is_declaration(slip) || slip.begins_condition());
    let goes_on = slip.touches(-1) && slip.previous().is_name() && (is_declaration(slip) || slip.ends_condition());
    if !(is_name_expected || goes_on && sign.token == Token::Minus) || !slip.spot(1)?.is_name() {
        return None;
    }
    let first = if goes_on && !is_name_expected { slip.previous() } else { sign };
    let mut last = sign;
    for next in slip.from(1).take_while(|next| is_part(*next)) {
        if next.span.start != last.span.end {
            break;
        }
        last = next;
    }
    Some(named(slip.slice(first, last), first.span.to(last.span)))
}

/// A text that backquotes make a name.
pub(crate) fn named(text: &str, place: Span) -> Cure {
    let right = format!("`{text}`");
    let words = format!("as a name it stands in backquotes: {right}");
    Cure { fix: Some(Fix::maybe("put it in backquotes").replace(place, right)), ..Cure::new(words) }
}

/// `var retain n : int`, `var n : int retain`
pub(super) fn retain_behind(slip: &Slip<'_>) -> Option<Cure> {
    let (first, word) = (slip.first(), slip.item());
    if !matches!(word, Token::Var | Token::Output) {
        return None;
    }
    let is_retain = |spot: &Spot<'_>| spot.is_name() && spot.word.eq_ignore_ascii_case("retain");
    let words = format!("`retain` stands before `{}`: `retain {} …`", first.word, first.word);
    let right = format!("retain {}", first.word);
    let previous = slip.previous();
    if slip.has("string") && is_retain(&previous) && slip.found()?.is_name() {
        return Some(Cure::guess(words, first.span.to(previous.span), &right));
    }
    let retain = slip.found().filter(|found| is_retain(found) && slip.has("end"))?;
    let fix = Fix::maybe(format!("write `{right}`")).replace(first.span, right);
    Some(Cure::new(words).fix(fix.delete(Span { start: previous.span.end, ..retain.span })))
}

/// `input start button : bool`
pub(super) fn name_of_two_words(slip: &Slip<'_>) -> Option<Cure> {
    let (first, second) = (slip.previous(), slip.found().filter(|found| found.is_name())?);
    let is_name = (is_declaration(slip) || matches!(slip.item(), Token::Chart | Token::Grafcet)) && slip.has("string");
    if !is_name || !first.is_name() || !slip.on_one_line(first, second) {
        return None;
    }
    let last = slip.from(0).take_while(|next| next.is_name() && slip.on_one_line(second, *next)).last()?;
    let right = slip.slice(first, last).split_whitespace().collect::<Vec<_>>().join("_");
    Some(Cure::guess(format!("a name is one word: `{right}`"), first.span.to(last.span), &right))
}

/// `chart "Mixer"`
pub(super) fn title_without_name(slip: &Slip<'_>) -> Option<Cure> {
    let title = slip.found().filter(|found| found.token == Token::String && slip.item() == Token::Chart)?;
    slip.has("name").then(|| {
        Cure::guess(format!("a name stands before the title: `chart … {}`", title.word), title.span.before(), "Chart ")
    })
}

/// `16#1` as a label.
pub(super) fn number_as_label(slip: &Slip<'_>) -> Option<Cure> {
    let is_number = slip.token(0)? == Token::Integer && slip.has("whole") && !slip.has("integer");
    is_number.then(|| Cure::new("a step label is a name or decimal digits"))
}

/// `input on : bool`
pub(super) fn reserved(slip: &Slip<'_>) -> Option<Cure> {
    let word = slip.found().filter(|found| is_reserved(found.word) && slip.has("name"))?;
    let cure = named(word.word, word.span);
    Some(Cure { words: format!("`{}` is a word of the language; {}", word.word, cure.words), ..cure })
}

/// `IF`, `Activation`
pub(super) fn capitals(slip: &Slip<'_>) -> Option<Cure> {
    let word = slip.found().filter(|found| found.is_name())?;
    let lower = word.word.to_lowercase();
    let is_ours = lower != word.word && slip.has(&lower);
    is_ours.then(|| Cure::write(format!("words of the language are in lower case: `{lower}`"), word.span, &lower))
}
