//! Help for mistakes that other languages suggest.

use crate::expected::contains;
use crate::spelling::is_reserved;
use crate::token::{Lexeme, Token, begins_item};
use grafc_diagnostics::{FileId, Fix, Span};

/// Where an item could not be read on.
pub(crate) struct Slip<'a> {
    pub(crate) file: FileId,
    pub(crate) text: &'a str,
    pub(crate) lexemes: &'a [Lexeme],
    /// The word that the item begins with.
    pub(crate) item: Token,
    /// The token that was not expected; there is one before it.
    pub(crate) at: usize,
    /// Whether it is there, and not the item that has ended too early.
    pub(crate) is_found: bool,
    pub(crate) expected: &'a [String],
}

/// What helps.
pub(crate) struct Cure {
    pub(crate) words: String,
    /// The same as a change of the text, if it is one.
    pub(crate) fix: Option<Fix>,
}

impl Cure {
    fn new(words: impl Into<String>) -> Self {
        Cure { words: words.into(), fix: None }
    }

    fn fix(self, fix: Fix) -> Self {
        Cure { fix: Some(fix), ..self }
    }
}

/// The help for a mistake, if there is one.
pub(crate) fn of(slip: &Slip) -> Option<Cure> {
    let has = |terminal: &str| contains(slip.expected, terminal);
    // Whatever has been reduced, behind an operand `+` is possible; in arithmetic `-` is then possible as well.
    let condition = has("+") && !has("-");
    let arithmetic = has("or") && !condition;
    let clearing = slip.item == Token::Transition && (has("}") || has(":="));
    let previous = slip.lexemes[slip.at - 1];
    let before = slip.span(previous);
    if slip.item == Token::Allow && has("string") {
        return Some(Cure::new("say why the warning may be there: `allow W0409 \"interlocked by hardware\"`"));
    }
    let Some(&found) = slip.lexemes.get(slip.at).filter(|_| slip.is_found) else {
        let missing = slip.item == Token::Transition && has(":");
        return missing.then(|| {
            Cure::new("a transition-condition that is always true is written `: 1`")
                .fix(Fix::maybe("add the condition `: 1`").replace(before.behind(), " : 1"))
        });
    };
    let place = slip.span(found);
    let word = &slip.text[place.range()];
    Some(match (previous.token, found.token) {
        (Token::Equal, Token::Equal) => Cure::new("equality is written `=`").fix(leave_out(word, place)),
        (Token::Not, Token::Equal) => Cure::new("\"not equal\" is written `<>`").fix(write("<>", before.to(place))),
        (Token::And, Token::And) => Cure::new("write `and`, `·` or `&` once").fix(leave_out(word, place)),
        (Token::Or, Token::Or) => Cure::new("write `or`, `+` or `|` once").fix(leave_out(word, place)),
        (_, Token::Star) if condition => {
            Cure::new("\"and\" is written `and`, `·` or `&`; multiplication stands in brackets")
                .fix(Fix::maybe("write `·`").replace(place, "·"))
        }
        (_, token) if condition && token.is_relation() => {
            Cure { fix: in_brackets(slip), ..Cure::new("a comparison stands in brackets: `[C = 3]`") }
        }
        (_, token) if arithmetic && token.is_relation() => {
            Cure::new("one of the two comparisons stands in parentheses")
        }
        (_, Token::Minus | Token::Mod) if condition => Cure::new("arithmetic stands in brackets: `[C - 1 > 3]`"),
        (_, Token::Equal) if has(":=") => Cure::new("an assignment is written `:=`").fix(write(":=", place)),
        (_, Token::Minus | Token::Equal) if has("->") => {
            // `=>`, `- >` and `-->` are two tokens.
            let is_on_line = |next: &&Lexeme| !slip.text[found.end as usize..next.start as usize].contains('\n');
            let rest = slip.lexemes.get(slip.at + 1).filter(is_on_line);
            let rest = rest.filter(|next| matches!(next.token, Token::Greater | Token::Arrow));
            let whole = rest.map_or(place, |next| place.to(slip.span(*next)));
            Cure::new("an arrow is written `->`").fix(write("->", whole))
        }
        (_, Token::Arrow) if has(":") => Cure::new("a transition has one `->`"),
        (_, Token::Comma) if has("}") => {
            Cure::new("leave it out: actions need no separator").fix(Fix::certain("leave out `,`").delete(place))
        }
        (_, Token::On) if clearing => {
            let cure = Cure::new("leave it out: the actions of a transition are done at its clearing");
            match slip.lexemes.get(slip.at + 1).map(|next| (next.token, slip.span(*next))) {
                Some((Token::Activation | Token::Deactivation, event)) => {
                    cure.fix(Fix::maybe("leave it out").delete(place.to(event)))
                }
                Some(_) | None => cure,
            }
        }
        (_, Token::CloseBrace | Token::If | Token::Name) if clearing && has(":=") => {
            Cure::new("a transition has assignments only; continuous actions belong to steps")
        }
        (_, Token::Force) if clearing => Cure::new("forcing orders belong to steps"),
        (Token::Rise | Token::Fall, token) => {
            let cure = Cure::new("put the operand of an edge in parentheses: `↑(not a)`");
            match slip.lexemes.get(slip.at + 1).filter(|next| token == Token::Not && next.token == Token::Name) {
                Some(operand) => {
                    let fix = Fix::certain("put the operand in parentheses").replace(place.before(), "(");
                    cure.fix(fix.replace(slip.span(*operand).behind(), ")"))
                }
                None => cure,
            }
        }
        (_, Token::Slash) if condition => Cure::new(
            "a time-dependent variable has at most two delays, as in `3s/a/7s`, and its operand stands in parentheses",
        ),
        (_, Token::Name) if has("at") && word == "at" => {
            let cure = Cure::new("an address begins with `%`: `at %IX0.0`");
            match slip.lexemes.get(slip.at + 1).filter(|next| next.token == Token::Name) {
                Some(next) => cure.fix(Fix::certain("add `%`").replace(slip.span(*next).before(), "%")),
                None => cure,
            }
        }
        (_, Token::Integer) if has("whole") && !has("integer") => Cure::new("a step label is a name or decimal digits"),
        _ if is_reserved(word) && has("name") => {
            Cure::new(format!("`{word}` is a word of the language; as a name it stands in backquotes"))
                .fix(Fix::maybe("put it in backquotes").replace(place, format!("`{word}`")))
        }
        (_, Token::Name) => {
            let lower = word.to_lowercase();
            if lower == word || !has(&lower) {
                return None;
            }
            Cure::new(format!("words of the language are in lower case: `{lower}`")).fix(write(&lower, place))
        }
        _ => return None,
    })
}

/// `C = 3` in brackets, where it is just that.
fn in_brackets(slip: &Slip) -> Option<Fix> {
    let operand = |lexeme: &Lexeme| {
        matches!(lexeme.token, Token::Name | Token::Whole | Token::Integer | Token::Real | Token::Duration)
    };
    let around = |token: Token| {
        matches!(
            token,
            Token::Colon
                | Token::If
                | Token::Event
                | Token::And
                | Token::Or
                | Token::Not
                | Token::OpenParen
                | Token::CloseParen
                | Token::OpenBrace
                | Token::CloseBrace
        )
    };
    let left = slip.lexemes.get(slip.at - 1).filter(|left| operand(left))?;
    let right = slip.lexemes.get(slip.at + 1).filter(|right| operand(right))?;
    let before = slip.at.checked_sub(2).and_then(|at| slip.lexemes.get(at))?;
    let stands_alone = around(before.token)
        && slip.lexemes.get(slip.at + 2).is_none_or(|after| around(after.token) || begins_item(after.token));
    let fix = Fix::maybe("put the comparison in brackets").replace(slip.span(*left).before(), "[");
    stands_alone.then(|| fix.replace(slip.span(*right).behind(), "]"))
}

fn leave_out(word: &str, place: Span) -> Fix {
    Fix::certain(format!("leave out the second `{word}`")).delete(place)
}

fn write(word: &str, place: Span) -> Fix {
    Fix::certain(format!("write `{word}`")).replace(place, word)
}

impl Slip<'_> {
    fn span(&self, lexeme: Lexeme) -> Span {
        Span { file: self.file, start: lexeme.start, end: lexeme.end }
    }
}
