//! What stands in the braces of a step, or should.

use super::slip::{Cure, Slip, Spot};
use super::words::{EVENTS, Qualifier, ours, qualified, qualifier};
use crate::spelling::distance;
use crate::token::Token;
use grafc_diagnostics::{Fix, Span};

/// `V, W`
pub(super) fn comma(slip: &Slip<'_>) -> Option<Cure> {
    let comma = slip.found().filter(|found| found.token == Token::Comma && slip.has("}"))?;
    Some(Cure::leave_out("leave out `,`: actions need no separator", comma))
}

/// `S: K`, `S, K`
pub(super) fn qualifier_before_colon(slip: &Slip<'_>) -> Option<Cure> {
    let (word, colon) = (slip.previous(), slip.found()?);
    let target = slip.spot(1).filter(|next| next.is_name())?;
    let is_split = matches!(colon.token, Token::Colon | Token::Comma) && slip.is_in_actions() && word.is_name();
    let found = qualifier(word.word).filter(|_| is_split && (colon.token == Token::Colon || slip.has(":=")))?;
    Some(in_our_words(slip, found, target, None, word.span.to(target.span)))
}

/// `D 5s K`
pub(super) fn qualifier_with_time(slip: &Slip<'_>) -> Option<Cure> {
    let (word, time) = (slip.previous(), slip.found().filter(|found| found.token == Token::Duration)?);
    let found = qualifier(word.word).filter(|_| word.is_name() && slip.is_in_actions())?;
    let skipped = isize::from(matches!(slip.token(1), Some(Token::Colon | Token::Comma)));
    let target = slip.spot(1 + skipped).filter(|next| next.is_name())?;
    Some(in_our_words(slip, found, target, Some(time.word), word.span.to(target.span)))
}

/// `K(S)`, `K(D, 5s)`
pub(super) fn qualifier_behind(slip: &Slip<'_>) -> Option<Cure> {
    let (target, open) = (slip.previous(), slip.found()?);
    if !slip.is_in_actions() || !target.is_name() || open.token != Token::OpenParen {
        return None;
    }
    let found = slip.spot(1).filter(|word| word.is_name()).and_then(|word| qualifier(word.word))?;
    let (time, last) = match slip.token(2)? {
        Token::CloseParen => (None, 2),
        Token::Comma => (slip.spot(3).filter(|time| time.token == Token::Duration), 4),
        _ => return None,
    };
    let last = slip.spot(last).filter(|last| last.token == Token::CloseParen)?;
    Some(in_our_words(slip, found, target, time.map(|time| time.word), target.span.to(last.span)))
}

fn in_our_words(slip: &Slip<'_>, found: Qualifier, target: Spot<'_>, time: Option<&str>, whole: Span) -> Cure {
    let step = slip.own_step().unwrap_or_default();
    match qualified(found, target.word, time, step) {
        Some(right) => Cure::guess(format!("there are no qualifiers: write `{right}`"), whole, &right),
        None => Cure::new(without_qualifier(found, target.word)),
    }
}

/// Help for a qualifier that has no spelling here without more.
fn without_qualifier(found: Qualifier, target: &str) -> String {
    match found {
        Qualifier::LastPulse => format!("there are no qualifiers: write `{target} := … on deactivation`"),
        Qualifier::Continuous
        | Qualifier::Set
        | Qualifier::Reset
        | Qualifier::Delayed
        | Qualifier::Limited
        | Qualifier::DelayedSet
        | Qualifier::Pulse
        | Qualifier::StoredTime => format!("there are no qualifiers: write `{target} := … on activation`"),
    }
}

/// `run P on activation`
pub(super) fn run_at_an_event(slip: &Slip<'_>) -> Option<Cure> {
    slip.found().filter(|found| found.token == Token::On && slip.is_in_actions())?;
    let is_run = slip.spot(-2).is_some_and(|word| word.word == "run") && slip.previous().is_name();
    let event = slip.spot(1).filter(|event| matches!(event.token, Token::Activation | Token::Deactivation))?;
    let words = "`run` starts with the step and kills with it: leave out when";
    is_run.then(|| {
        Cure::new(words).fix(Fix::certain("leave it out").delete(slip.previous().span.behind().to(event.span)))
    })
}

/// `K on activation`
pub(super) fn value_missing(slip: &Slip<'_>) -> Option<Cure> {
    let (target, on) = (slip.previous(), slip.found().filter(|found| found.token == Token::On)?);
    if !slip.is_in_actions() || !target.is_name() || !slip.has(":=") {
        return None;
    }
    let event = slip
        .spot(1)
        .filter(|event| matches!(event.token, Token::Activation | Token::Deactivation | Token::Event | Token::Name));
    Some(match event {
        Some(event) => Cure::guess(
            format!("say which value it gets: `{} := 1 {}`", target.word, slip.slice(on, event)),
            target.span.behind(),
            " := 1",
        ),
        None => {
            Cure::leave_out(format!("an output that is true while its step is active is written `{}`", target.word), on)
        }
    })
}

/// `on entry`, `on ↑a`
pub(super) fn event(slip: &Slip<'_>) -> Option<Cure> {
    let (on, found) = (slip.previous(), slip.found()?);
    if on.token != Token::On {
        return None;
    }
    if let Some(ours) = ours(EVENTS, found.word).filter(|_| found.is_name()) {
        return Some(Cure::write(format!("write `on {ours}`"), found.span, ours));
    }
    if found.is_name() {
        let near =
            ["activation", "deactivation", "event"].into_iter().find(|word| distance(found.word, word, 2).is_some());
        if let Some(near) = near {
            return Some(Cure::guess(format!("did you mean `{near}`?"), found.span, near));
        }
    }
    let words = format!("an assignment at an event is written `on event {}`", found.word);
    found.opens_operand().then(|| Cure::guess(words, found.span.before(), "event "))
}

/// `V := 1 if a`
pub(super) fn assignment_with_condition(slip: &Slip<'_>) -> Option<Cure> {
    let word = slip.found().filter(|found| found.token == Token::If && slip.has("on") && slip.ends_arithmetic())?;
    let operand = slip.spot(1)?;
    let cure = Cure::new(format!("an assignment is done at an event: `on event ↑{}`", operand.word));
    Some(match operand.is_name() {
        true => cure
            .fix(Fix::maybe("write `on event ↑`").replace(Span { end: operand.span.start, ..word.span }, "on event ↑")),
        false => Cure::new("an assignment is done at an event: `on event …`"),
    })
}

/// `if a then K`
pub(super) fn condition_before(slip: &Slip<'_>) -> Option<Cure> {
    let word = slip.found().filter(|found| found.token == Token::If && slip.is_in_actions() && slip.has("force"))?;
    let tokens: Vec<Spot<'_>> = slip.from(1).collect();
    let then = tokens.iter().position(|next| next.is_one_of(&["then", "dann", "alors", "do"]));
    let plain = Cure::new("the condition stands behind the output: `… if …`");
    let Some((then, target)) = then.and_then(|then| Some((then, tokens.get(then + 1)?))) else { return Some(plain) };
    if then == 0 || !target.is_name() {
        return Some(plain);
    }
    let condition = slip.slice(tokens[0], tokens[then - 1]);
    let value = tokens.get(then + 3).filter(|_| tokens[then + 2].token == Token::Assign);
    let plain = match value {
        Some(value) => Cure::new(format!("write `{} := {} on event ↑({condition})`", target.word, value.word)),
        None => plain,
    };
    let (right, last, next) = match value {
        Some(value) => (format!("{} := {} on event ↑({condition})", target.word, value.word), value, then + 4),
        None => (format!("{} if {condition}", target.word), target, then + 2),
    };
    let end = tokens.get(next).filter(|end| end.is_one_of(&["end_if", "endif", "fin_si"]));
    let is_whole = tokens.get(next + usize::from(end.is_some())).is_some_and(|next| next.token == Token::CloseBrace);
    let whole = word.span.to(end.unwrap_or(last).span);
    Some(if is_whole { Cure::guess(format!("write `{right}`"), whole, &right) } else { plain })
}

/// `↑K := 1`, as drawings have it.
pub(super) fn arrow_before(slip: &Slip<'_>) -> Option<Cure> {
    let arrow = slip.found().filter(|found| matches!(found.token, Token::Rise | Token::Fall))?;
    let target = slip.spot(1).filter(|target| target.is_name() && slip.is_in_actions() && slip.has("force"))?;
    let event = if arrow.token == Token::Rise { "activation" } else { "deactivation" };
    let place = Span { end: target.span.start, ..arrow.span };
    let fix = Fix::maybe("say when").delete(place);
    Some(match slip.token(2) {
        Some(Token::Assign) => {
            let (value, is_whole) = value(slip, 3)?;
            let cure = Cure::new(format!("write `{} := {} on {event}`", target.word, slip.slice(value.0, value.1)));
            if is_whole { cure.fix(fix.replace(value.1.span.behind(), format!(" on {event}"))) } else { cure }
        }
        _ => {
            let right = format!("{} := 1 on {event}", target.word);
            Cure::guess(format!("write `{right}`"), arrow.span.to(target.span), &right)
        }
    })
}

/// `n++`, `n--`, `n += 1`
pub(super) fn change(slip: &Slip<'_>) -> Option<Cure> {
    let (target, sign) = (slip.previous(), slip.found()?);
    if !slip.is_in_braces() || !target.is_name() || !slip.has(":=") {
        return None;
    }
    let operator = match sign.token {
        Token::Plus | Token::Minus | Token::Star | Token::Slash => sign.word,
        _ => return None,
    };
    let (value, last) = match slip.token(1)? {
        token if token == sign.token && slip.touches(0) => ("1", slip.spot(1)?),
        Token::Equal if slip.touches(0) => {
            let value = slip.spot(2).filter(|value| value.is_operand())?;
            (value.word, value)
        }
        _ => return None,
    };
    let assignment = format!("{0} := {0} {operator} {value}", target.word);
    let has_event =
        slip.from(1).find(|next| next.span.start >= last.span.end).is_some_and(|next| next.token == Token::On);
    let right = with_event(slip, &assignment, has_event);
    Some(Cure::guess(format!("write `{right}`"), target.span.to(last.span), &right))
}

/// `K = 1`
pub(super) fn equals(slip: &Slip<'_>) -> Option<Cure> {
    let (target, sign) = (slip.previous(), slip.found()?);
    if sign.token != Token::Equal || !slip.has(":=") {
        return None;
    }
    let words = "an assignment is written `:=`";
    if !slip.is_in_braces() || !target.is_name() {
        return Some(Cure::write(words, sign.span, ":="));
    }
    let doubled = isize::from(slip.token(1) == Some(Token::Equal));
    let ((from, to), is_whole) = value(slip, 1 + doubled)?;
    let has_event =
        slip.from(1).find(|next| next.span.start >= to.span.end).is_some_and(|next| next.token == Token::On);
    let right = with_event(slip, &format!("{} := {}", target.word, slip.slice(from, to)), has_event);
    let whole = target.span.to(to.span);
    Some(if is_whole { Cure::guess(format!("write `{right}`"), whole, &right) } else { Cure::new(words) })
}

/// An assignment of a step says when it is done; that of a transition is done at its clearing.
fn with_event(slip: &Slip<'_>, assignment: &str, has_event: bool) -> String {
    if has_event || slip.is_in_clearing() { assignment.to_owned() } else { format!("{assignment} on activation") }
}

/// The value that begins at a token: where it goes to, and whether it surely ends there.
fn value<'a>(slip: &Slip<'a>, from: isize) -> Option<((Spot<'a>, Spot<'a>), bool)> {
    let first = slip.spot(from)?;
    let is_part = |spot: &Spot<'_>| {
        use Token::*;
        spot.closes_operand()
            || spot.opens_operand()
            || matches!(spot.token, Plus | Minus | Star | Slash | Mod | And | Or | Xor)
    };
    // Two operands beside each other are the end of a value and the beginning of an action.
    let mut last = first;
    for spot in slip.from(from + 1).take_while(is_part) {
        if last.closes_operand() && spot.is_operand() {
            break;
        }
        last = spot;
    }
    Some(((first, last), last.closes_operand()))
}

/// `F/G1{1}`, `F/G1:{1}`
pub(super) fn order_of_the_standard(slip: &Slip<'_>) -> Option<Cure> {
    let (letter, slash) = (slip.previous(), slip.found().filter(|found| found.token == Token::Slash)?);
    let grafcet = slip.spot(1).filter(|next| next.is_name() && slip.is_in_actions() && letter.word == "F")?;
    let fix = Fix::certain("write `force`").replace(letter.span.to(slash.span), "force ");
    let fix = match slip.spot(2).filter(|colon| colon.token == Token::Colon) {
        Some(colon) => fix.delete(colon.span),
        None => fix,
    };
    Some(Cure::new(format!("an order is written `force {}{{…}}`", grafcet.word)).fix(fix))
}

/// `G1{1}`, `force G1:{1}`, `force G1(1)`, `force G1`
pub(super) fn order(slip: &Slip<'_>) -> Option<Cure> {
    let (grafcet, found) = (slip.previous(), slip.found()?);
    if !slip.is_in_actions() || !grafcet.is_name() {
        return None;
    }
    let is_order = slip.token(-2) == Some(Token::Force);
    let name = grafcet.word;
    match found.token {
        Token::OpenBrace => {
            let word = slip.spot(-2).filter(|word| word.is_name() && is_nearly_force(word.word));
            let place = word.map_or(grafcet.span.before(), |word| Span { end: grafcet.span.start, ..word.span });
            Some(Cure::guess(format!("an order is written `force {name}{{…}}`"), place, "force "))
        }
        Token::Colon if is_order => Some(Cure::leave_out("leave out `:`", found)),
        Token::OpenParen if is_order => {
            let close = slip.from(1).find(|next| next.token == Token::CloseParen)?;
            let fix = Fix::certain("write braces").replace(found.span, "{").replace(close.span, "}");
            Some(Cure::new(format!("the situation of an order stands in braces: `force {name}{{…}}`")).fix(fix))
        }
        Token::CloseBrace if is_order => {
            Some(Cure::guess(format!("say which situation: `force {name}{{INIT}}`"), grafcet.span.behind(), "{INIT}"))
        }
        _ => None,
    }
}

fn is_nearly_force(word: &str) -> bool {
    ["force", "forcing", "forçage"].iter().any(|near| distance(&word.to_lowercase(), near, 1).is_some())
}

/// `force G1{initial}`
pub(super) fn initial_situation(slip: &Slip<'_>) -> Option<Cure> {
    let found = slip.found().filter(|found| found.token == Token::Initial)?;
    let is_order = slip.token(-3) == Some(Token::Force) && slip.previous().token == Token::OpenBrace;
    is_order.then(|| Cure::write("the initial situation is written `INIT`", found.span, "INIT"))
}

/// `step 1: V`, `step 1 [V]`, `step 1 V`, `step 1 waiting { V }`
pub(super) fn braces(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, found) = (slip.previous(), slip.found()?);
    if !slip.is_in_step() || slip.is_in_braces() || !slip.has("{") || !slip.on_one_line(previous, found) {
        return None;
    }
    if found.is_name() && slip.has("string") && slip.token(1) == Some(Token::OpenBrace) {
        let words = format!("an attached comment stands in quotation marks: `\"{}\"`", found.word);
        let fix =
            Fix::maybe("write quotation marks").replace(found.span.before(), "\"").replace(found.span.behind(), "\"");
        return Some(Cure::new(words).fix(fix));
    }
    let last = slip.last();
    let (open, close) = match found.token {
        Token::Colon | Token::Arrow | Token::Slash if slip.spot(1)?.is_name() => {
            (Span { start: previous.span.end, ..found.span }, last.span.behind())
        }
        Token::OpenBracket if last.token == Token::CloseBracket => (found.span, last.span),
        Token::OpenParen if last.token == Token::CloseParen => (found.span, last.span),
        Token::Name => (found.span.before(), last.span.behind()),
        _ => return None,
    };
    let shown = match found.token {
        Token::Name => found,
        _ => slip.spot(1)?,
    };
    let open_text = match found.token {
        Token::Name => "{ ",
        Token::OpenBracket | Token::OpenParen => "{",
        _ => " {",
    };
    // Its `}` may be there, and have lost its partner.
    let is_closed = slip.lexemes.get(slip.run.end).is_some_and(|next| next.token == Token::CloseBrace)
        && !slip.text[last.span.end as usize..slip.lexemes[slip.run.end].start as usize].contains('\n');
    let close_text = match close.start == close.end {
        true if is_closed => "",
        true => " }",
        false => "}",
    };
    let fix = Fix::maybe("write braces").replace(open, open_text).replace(close, close_text);
    let cure = Cure::new(format!("actions stand in braces: `{{ {} … }}`", shown.word));
    Some(if slip.on_one_line(found, last) { cure.fix(fix) } else { cure })
}
