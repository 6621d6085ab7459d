//! How a name is written in a text: as it stands, or in backquotes.

use crate::token::Token;
use logos::Logos;

/// Whether only backquotes make a name of this word.
pub fn is_reserved(word: &str) -> bool {
    sole_token(word).is_some_and(Token::is_word) && word.starts_with(char::is_alphabetic)
}

/// The name or label as a text has it, in backquotes if it needs them.
pub fn written(name: &str) -> String {
    // In a forced situation, `INIT` without backquotes is no label.
    let is_plain = matches!(sole_token(name), Some(Token::Name | Token::Whole)) && name != "INIT";
    if is_plain && !name.starts_with('`') { name.to_owned() } else { format!("`{name}`") }
}

/// The token that the whole text is, if it is one.
fn sole_token(text: &str) -> Option<Token> {
    let mut tokens = Token::lexer(text);
    let token = tokens.next()?.ok()?;
    (tokens.span() == (0..text.len())).then_some(token)
}

#[cfg(test)]
mod tests {
    use super::{is_reserved, written};

    #[test]
    fn words_of_the_language_are_reserved() {
        for word in ["step", "if", "mod", "and", "AND", "OR", "XOR", "NOT", "TRUE", "FALSE"] {
            assert!(is_reserved(word), "{word}");
        }
        for word in ["Step", "And", "MOD", "IF", "at", "event", "&", "->", "steps", "3", "", " step", "step "] {
            assert!(!is_reserved(word), "{word}");
        }
    }

    #[test]
    fn what_is_no_name_by_itself_stands_in_backquotes() {
        for plain in ["a", "_1", "Größe", "12"] {
            assert_eq!(written(plain), plain);
        }
        for name in ["on", "AND", "1B1", "-S4", "=1", "a b", "it's", "INIT", "3s", "a.b", ""] {
            assert_eq!(written(name), format!("`{name}`"));
        }
    }
}
