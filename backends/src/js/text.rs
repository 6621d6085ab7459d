//! Texts of the user's in comments, strings and names of properties.
//!
//! A module may stand inside of a page, so that `</script>`, `<!--` and `<script` must not come about anywhere in it; and
//! what is read must be what is there, so that marks which reorder or hide text are escaped or left out.

use crate::comment::{clean, is_invisible};
use ecow::{EcoString, eco_format};
use std::fmt::Write as _;

/// A text inside of a comment of any kind: on one line, without an end of a comment, and with nothing that a page would
/// take for a tag.
pub(super) fn comment(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in clean(text).chars() {
        let apart = match out.chars().next_back() {
            Some('<') => c == '/' || c == '!' || c.is_ascii_alphabetic(),
            Some('*') => c == '/',
            Some('-') => c == '>' && out.ends_with("--"),
            Some('/') => c == '*',
            _ => false,
        };
        if apart {
            out.push(' ');
        }
        out.push(c);
    }
    out
}

/// A text as a string.
pub(super) fn quoted(text: &str) -> EcoString {
    let mut out = EcoString::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            '\n' => out.push_str("\\n"),
            '<' => out.push_str("\\x3C"),
            _ if c.is_control() || is_invisible(c) || (c.is_whitespace() && c != ' ') => {
                let mut units = [0; 2];
                for unit in c.encode_utf16(&mut units) {
                    let _ = write!(out, "\\u{unit:04X}");
                }
            }
            _ => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A property of an object.
pub(super) fn member(object: &str, name: &str) -> EcoString {
    if is_word(name) { eco_format!("{object}.{name}") } else { eco_format!("{object}[{}]", quoted(name)) }
}

/// The name of a property where an object is written. One that is called like the prototype is none for all that.
pub(super) fn key(name: &str) -> EcoString {
    if name == "__proto__" {
        "[\"__proto__\"]".into()
    } else if is_word(name) {
        name.into()
    } else {
        quoted(name)
    }
}

/// The same where a type is written.
pub(super) fn type_key(name: &str) -> EcoString {
    if is_word(name) { name.into() } else { quoted(name) }
}

/// Whether a name can stand for itself, reserved or not: letters that every version of Unicode has as such.
fn is_word(name: &str) -> bool {
    let letter = |c: char| match c {
        '_' | '$' => true,
        '\u{C0}'..='\u{24F}' | '\u{388}'..='\u{3FF}' | '\u{400}'..='\u{481}' | '\u{48A}'..='\u{52F}' => {
            c.is_alphabetic()
        }
        _ => c.is_ascii_alphabetic(),
    };
    let mut chars = name.chars();
    chars.next().is_some_and(letter) && chars.all(|c| letter(c) || c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_breaks_out() {
        assert_eq!(quoted("a\"b\\c"), r#""a\"b\\c""#);
        assert_eq!(quoted("</script>\u{2028}\u{202E}"), r#""\x3C/script>\u2028\u202E""#);
        assert_eq!(comment("x */ y </script> <!-- /* -->"), "x * / y < /script> < !-- / * -- >");
        assert_eq!(comment("a\nb\u{2028}c < d"), "a b c < d");
    }

    #[test]
    fn names_stay_as_they_are() {
        assert_eq!(member("m", "X1"), "m.X1");
        assert_eq!(member("inputs", "Tür"), "inputs.Tür");
        assert_eq!(member("m", "Xfill tank"), "m[\"Xfill tank\"]");
        assert_eq!(member("outputs", "class"), "outputs.class");
        assert_eq!(key("__proto__"), "[\"__proto__\"]");
        assert_eq!(key("1a"), "\"1a\"");
    }
}
