//! Texts of the user's in comments and in strings.

use crate::comment::clean;

/// A text that is harmless inside `/* … */`.
pub(super) fn comment(text: &str) -> String {
    clean(text).replace("*/", "* /").replace("/*", "/ *")
}

/// A text as a string. What is not ASCII is written byte by byte; `??` would begin a trigraph.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for byte in text.bytes() {
        match byte {
            b'"' | b'\\' => {
                out.push('\\');
                out.push(char::from(byte));
            }
            b'?' => out.push_str("\\?"),
            b' '..=b'~' => out.push(char::from(byte)),
            _ => out.push_str(&format!("\\{byte:03o}")),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_ends_a_comment() {
        for text in ["a */ b", "/*", "*//", "/*/", "**//**", "* / / *"] {
            let shown = comment(text);
            assert!(!shown.contains("*/") && !shown.contains("/*"), "{shown}");
        }
    }

    #[test]
    fn nothing_ends_a_string() {
        assert_eq!(quoted("a\"b\\ ??/ \u{e4}1\n"), "\"a\\\"b\\\\ \\?\\?/ \\303\\2441\\012\"");
    }
}
