//! Where an item should begin.

use super::slip::{Cure, Slip, Spot};
use super::words::{ITEMS, TYPES, ours};
use crate::spelling::distance;
use crate::token::{Token, begins_item};
use grafc_diagnostics::Fix;

/// The words that begin an item, as they are written.
pub(crate) const WORDS: [&str; 17] = [
    "chart",
    "input",
    "output",
    "var",
    "const",
    "grafcet",
    "expansion",
    "step",
    "transition",
    "initial",
    "activated",
    "enclosing",
    "macro",
    "assume",
    "assert",
    "reach",
    "final",
];

/// What a word seems to be that stands where an item could begin.
pub(crate) struct Opening {
    pub(crate) words: String,
    /// What to write in its place.
    pub(crate) instead: Option<String>,
}

impl Opening {
    /// The same as a change of the text.
    pub(crate) fn fix(&self, spot: Spot<'_>) -> Option<Fix> {
        let instead = self.instead.as_ref()?;
        Some(match instead.is_empty() {
            true => Fix::maybe(format!("leave out `{}`", spot.word)).delete(spot.span),
            false => Fix::maybe(format!("write `{instead}`")).replace(spot.span, instead),
        })
    }
}

/// The item that was meant by a word, if it can be told. `next` is what stands behind it.
pub(crate) fn opening(word: &str, next: Option<Token>) -> Option<Opening> {
    let lower = word.to_lowercase();
    let is_ours = WORDS.contains(&lower.as_str());
    if is_ours && lower != word {
        let words = format!("words of the language are in lower case: `{lower}`");
        return Some(Opening { words, instead: Some(lower) });
    }
    // `initial` begins a step by itself only if `step` follows.
    let stands_before_step = next == Some(Token::Step);
    let found = match ours(ITEMS, word) {
        Some("initial") if !stands_before_step => Some("initial step"),
        found => found,
    };
    if let Some(found) = found {
        return Some(Opening { words: format!("did you mean `{found}`?"), instead: Some(found.to_owned()) });
    }
    if matches!(lower.as_str(), "retain" | "var_retain") {
        let words = "`retain` stands before `var` or `output`: `retain var …`".to_owned();
        return Some(Opening { words, instead: Some("retain var".to_owned()) });
    }
    let reach = if lower.chars().count() < 5 { 1 } else { 2 };
    let near = WORDS.iter().filter_map(|ours| Some((distance(&lower, ours, reach)?, *ours)));
    if let Some((_, near)) = near.min_by_key(|(distance, _)| *distance) {
        return Some(Opening { words: format!("did you mean `{near}`?"), instead: Some(near.to_owned()) });
    }
    if lower == "end" || lower.starts_with("end_") {
        return Some(Opening { words: "leave it out: nothing ends an item".to_owned(), instead: Some(String::new()) });
    }
    let is_type = TYPES.iter().any(|(known, _)| *known == lower) || ours(TYPES, word).is_some();
    let words = match lower.as_str() {
        _ if is_type => "a declaration begins with a word such as `input`, and its type comes last",
        "force" | "forcing" => "an order stands in the braces of a step: `{ force … }`",
        "goto" | "jump" | "link" => "an arc to a step is a transition: `transition … -> … : …`",
        "action" | "actions" => "actions stand in the braces of their step: `step … { … }`",
        "child" => "say whose child the grafcet is: `child grafcet P of MAIN { … }`",
        "scenario" => "a scenario has a text: `scenario \"one batch\" { … }`",
        "allow" => "name a code, and give the reason: `allow W0409 \"interlocked by hardware\"`",
        _ => return None,
    };
    Some(Opening { words: words.to_owned(), instead: None })
}

/// `transtion 1 -> 2 : a` behind another item.
pub(super) fn misspelt(slip: &Slip<'_>) -> Option<Cure> {
    let is_word = |found: &Spot<'_>| found.is_name() || found.token == Token::Force;
    let word = slip.found().filter(|found| is_word(found) && slip.is_first_on_line(*found))?;
    let next = slip.lexemes.get(slip.at + 1).map(|next| next.token);
    let opening = opening(word.word, next)?;
    Some(Cure { fix: opening.fix(word), words: opening.words })
}

/// Another line where the item has ended: nothing that could be meant.
pub(super) fn no_item(slip: &Slip<'_>) -> Option<Cure> {
    let word = slip.found().filter(|found| slip.is_first_on_line(*found) && slip.has("end"))?;
    (!begins_item(word.token)).then(|| Cure::new("an item begins with a word such as `step`, `transition` or `input`"))
}

/// `initial 1`, `macro M1`
pub(super) fn step_missing(slip: &Slip<'_>) -> Option<Cure> {
    let (previous, label) = (slip.previous(), slip.found().filter(|found| found.is_label() && slip.has("step"))?);
    let right = format!("{} step {}", previous.word, label.word);
    Some(Cure::guess(format!("write `{right}`"), label.span.before(), "step "))
}

/// `step initial 1`
pub(super) fn mark_behind_step(slip: &Slip<'_>) -> Option<Cure> {
    let (step, mark) = (slip.previous(), slip.found()?);
    let is_mark = matches!(mark.token, Token::Initial | Token::Activated | Token::Enclosing | Token::Macro);
    if step.token != Token::Step || !is_mark {
        return None;
    }
    let right = format!("{} step", mark.word);
    let words = format!("`{}` stands before `step`: `{right} …`", mark.word);
    Some(Cure::guess(words, step.span.to(mark.span), &right))
}

/// `step 1, 2`
pub(super) fn several_steps(slip: &Slip<'_>) -> Option<Cure> {
    let comma =
        slip.found().filter(|found| found.token == Token::Comma && slip.is_in_step() && !slip.is_in_braces())?;
    let label = slip.spot(1).filter(|next| next.is_label())?;
    let words = format!("each step is an item of its own: `step {}`", label.word);
    Some(Cure::guess(words, comma.span.to(label.span), &format!("\nstep {}", label.word)))
}

/// `chart My chart`
pub(super) fn name_of_the_chart(slip: &Slip<'_>) -> Option<Cure> {
    let [begin, first, word] = slip.before_the_item()?;
    let is_name = word.token == Token::Chart && begin.token == Token::Chart && first.is_name();
    if !is_name || slip.previous().span != word.span || !slip.on_one_line(first, word) {
        return None;
    }
    Some(Cure::new(format!("a name of several words stands in backquotes: `{} {}`", first.word, word.word)))
}

/// `assert: not X1`
pub(super) fn colon_behind_the_word(slip: &Slip<'_>) -> Option<Cure> {
    let colon = slip.found().filter(|found| found.token == Token::Colon)?;
    matches!(slip.previous().token, Token::Assume | Token::Assert | Token::Reach)
        .then(|| Cure::leave_out("leave out `:`", colon))
}

/// `assert X1 leads X2`
pub(super) fn leads_without_to(slip: &Slip<'_>) -> Option<Cure> {
    let word = slip.found().filter(|found| found.is_one_of(&["leads", "lead", "leadsto", "leads_to"]))?;
    (slip.item() == Token::Assert && slip.ends_condition())
        .then(|| Cure::write("write `leads to`", word.span, "leads to"))
}

/// `allow W0409`
pub(super) fn reason_missing(slip: &Slip<'_>) -> Option<Cure> {
    let is_allowance = slip.item() == Token::Allow || slip.token(-2) == Some(Token::AllowInside);
    let shown = slip.previous().word;
    (is_allowance && slip.has("string"))
        .then(|| Cure::new(format!("say why the warning may be there: `{shown} \"…\"`")))
}

/// `grafcet G1` without braces.
pub(super) fn block_without_braces(slip: &Slip<'_>) -> Option<Cure> {
    let is_head = matches!(slip.item(), Token::Grafcet | Token::Expansion) && slip.has("{");
    let head = &slip.text[slip.lexemes[slip.run.start].start as usize..slip.previous().span.end as usize];
    is_head.then(|| Cure::new(format!("what belongs to it stands in braces: `{head} {{ … }}`")))
}
