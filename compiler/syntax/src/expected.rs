//! What was expected, and what was found, in words of the field.

use crate::token::Token;

/// Puts the parser's list of terminals into words: "an operator, `{` or the next item".
pub(crate) fn describe(previous: Token, expected: &[String]) -> String {
    let has = |terminal: &str| contains(expected, terminal);
    if has("string") && expected.iter().all(|e| matches!(e.trim_matches('"'), "string" | "name")) {
        return "a reason in quotation marks".to_owned();
    }
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
        ("string", if has("at most") { "a text in quotation marks" } else { "an attached comment" }),
        ("evolution", "`evolution`, `initial_actions`, `bound`"),
        ("each", "`each scan`"),
        ("scan", "`scan`"),
        ("until", "`until`"),
        ("within", "`within`"),
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
