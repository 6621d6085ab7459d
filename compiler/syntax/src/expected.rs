//! What was expected, and what was found, in words of the field.

use crate::lexer::Token;

/// Puts the parser's list of terminals into words: "an operator, `{` or the next item".
pub(crate) fn describe(previous: Token, expected: &[String]) -> String {
    let has = |terminal: &str| contains(expected, terminal);
    let mut words: Vec<&str> = Vec::new();
    let operand = has("(") && has("[");
    if has("not") {
        words.push(if has("-") { "a value" } else { "a condition" });
    } else if operand && has("duration") {
        words.push("a duration, a variable or `(`");
    } else if operand {
        words.push("a name, `(` or `[`");
    } else if has("->") && has("string") && has("name") {
        words.push("the steps before `->`");
    } else if has("force") {
        words.push("an action");
    } else if has("name") && has("whole") {
        words.push("a step label");
    } else if has("name") {
        words.push(if previous == Token::Colon { "a type" } else { "a name" });
    }
    if has("or") {
        words.push("an operator");
    }
    let before_arrow = words.first() == Some(&"the steps before `->`");
    for (terminal, word) in [
        (")", "`)`"),
        ("]", "`]`"),
        ("step", "`step`"),
        ("->", "`->`"),
        (":", "`:`"),
        (":=", "`:=`"),
        (",", "`,`"),
        ("if", "`if`"),
        ("on", "`on`"),
        ("activation", "`activation`, `deactivation` or `event`"),
        ("address", "an address such as `%IX0.0`"),
        ("at", "`at`"),
        ("{", "`{`"),
        ("}", "`}`"),
        ("string", "an attached comment"),
        ("end", "the next item"),
    ] {
        if has(terminal) && !(before_arrow && matches!(terminal, "->" | "string")) {
            words.push(word);
        }
    }
    match words.split_last() {
        None => "the next item".to_owned(),
        Some((last, [])) => (*last).to_owned(),
        Some((last, before)) => format!("{} or {last}", before.join(", ")),
    }
}

/// LALRPOP gives the terminals as the grammar writes them, quotation marks included.
pub(crate) fn contains(expected: &[String], terminal: &str) -> bool {
    expected.iter().any(|e| e.trim_matches('"') == terminal)
}

/// A cure for a slip that other languages suggest.
///
/// `item` is the word that the item begins with, `found` is `None` at the item's end.
pub(crate) fn cure(
    item: Token,
    previous: Token,
    found: Option<Token>,
    found_text: &str,
    expected: &[String],
) -> Option<String> {
    let has = |terminal: &str| contains(expected, terminal);
    // Whatever has been reduced, behind an operand `+` is possible; in arithmetic `-` is then possible as well.
    let condition = has("+") && !has("-");
    let arithmetic = has("or") && !condition;
    let clearing = item == Token::Transition && (has("}") || has(":="));
    let Some(found) = found else {
        let missing = item == Token::Transition && has(":");
        return missing.then(|| "a transition-condition that is always true is written `: 1`".to_owned());
    };
    let fixed = match (previous, found) {
        (Token::Equal, Token::Equal) => "equality is written `=`",
        (Token::Not, Token::Equal) => "\"not equal\" is written `<>`",
        (Token::And, Token::And) => "write `and`, `·` or `&` once",
        (Token::Or, Token::Or) => "write `or`, `+` or `|` once",
        (_, Token::Star) if condition => "\"and\" is written `and`, `·` or `&`; multiplication stands in brackets",
        (_, token) if condition && is_relation(token) => "a comparison stands in brackets: `[C = 3]`",
        (_, token) if arithmetic && is_relation(token) => "one of the two comparisons stands in parentheses",
        (_, Token::Minus | Token::Mod) if condition => "arithmetic stands in brackets: `[C - 1 > 3]`",
        (_, Token::Equal) if has(":=") => "an assignment is written `:=`",
        (_, Token::Minus | Token::Equal) if has("->") => "an arrow is written `->`",
        (_, Token::Arrow) if has(":") => "a transition has one `->`",
        (_, Token::Comma) if has("}") => "leave it out: actions need no separator",
        (_, Token::On) if clearing => "leave it out: the actions of a transition are done at its clearing",
        (_, Token::CloseBrace | Token::If | Token::Name) if clearing && has(":=") => {
            "a transition has assignments only; continuous actions belong to steps"
        }
        (_, Token::Force) if clearing => "forcing orders belong to steps",
        (Token::Rise | Token::Fall, _) => "put the operand of an edge in parentheses: `↑(not a)`",
        (_, Token::Slash) if condition => {
            "a time-dependent variable has at most two delays, as in `3s/a/7s`, and its operand stands in parentheses"
        }
        (_, Token::Name) if has("at") && found_text == "at" => "an address begins with `%`: `at %IX0.0`",
        (_, Token::Integer(_)) if has("whole") && !has("integer") => "a step label is a name or decimal digits",
        (_, token) if is_word(token) && has("name") => {
            return Some(format!("`{found_text}` is a word of the language; as a name it stands in backquotes"));
        }
        (_, Token::Name) => {
            let lower = found_text.to_lowercase();
            let word = lower != found_text && has(&lower);
            return word.then(|| format!("words of the language are in lower case: `{lower}`"));
        }
        _ => return None,
    };
    Some(fixed.to_owned())
}

fn is_relation(token: Token) -> bool {
    use Token::*;
    matches!(token, Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual)
}

/// Whether the token is a reserved word.
fn is_word(token: Token) -> bool {
    use Token::*;
    matches!(
        token,
        Chart
            | Input
            | Output
            | Var
            | Const
            | Grafcet
            | Expansion
            | Step
            | Transition
            | Initial
            | Activated
            | Enclosing
            | Macro
            | If
            | On
            | Force
            | True
            | False
            | And
            | Or
            | Xor
            | Not
            | Rise
            | Fall
            | Mod
    )
}

/// A word as a message shows it: the first characters of a long one, without control characters.
pub(crate) fn shorten(word: &str) -> String {
    const MOST: usize = 40;
    let mut shown: String = word.chars().take(MOST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if word.chars().nth(MOST).is_some() {
        shown.push('…');
    }
    shown
}
