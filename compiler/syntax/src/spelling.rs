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

/// Insertions, deletions, substitutions and swaps of neighbours that lead from one text to another, if at most `reach`.
pub fn distance(a: &str, b: &str, reach: usize) -> Option<usize> {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    if a.len().abs_diff(b.len()) > reach {
        return None;
    }
    let mut before: Vec<usize> = Vec::new();
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let substituted = above[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = substituted.min(above[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(before[j - 2] + 1);
            }
            row.push(best);
        }
        if row.iter().all(|&d| d > reach) {
            return None;
        }
        before = std::mem::replace(&mut above, row);
    }
    above.last().copied().filter(|&d| d <= reach)
}

#[cfg(test)]
mod tests {
    use super::{distance, is_reserved, written};

    #[test]
    fn slips_of_the_finger_are_counted() {
        assert_eq!(distance("transtion", "transition", 2), Some(1));
        assert_eq!(distance("stpe", "step", 1), Some(1));
        assert_eq!(distance("step", "step", 0), Some(0));
        assert_eq!(distance("motor", "valve", 2), None);
        assert_eq!(distance("", "ab", 2), Some(2));
    }

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
