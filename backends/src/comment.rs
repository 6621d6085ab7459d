//! The user's texts inside `(* … *)`.
//!
//! IEC 61131-3 edition 2 knows only flat comments. Nothing in a text may end one, open another, look like a pragma or
//! change how the rest of the line is shown. (A `$` escapes only in strings; every comment ends in a blank of ours.)

/// The text on one line: runs of blanks, line breaks and control characters become one blank; `(*` and `*)` are drawn
/// apart; braces, which hold pragmas, become brackets.
pub fn clean(text: &str) -> String {
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-' | b'>' | b',' | b':' | b'.');
    let mut words = text.as_bytes().split(|byte| *byte == b' ');
    if words.all(|word| !word.is_empty() && word.iter().copied().all(is_plain)) {
        return text.to_owned();
    }
    let mut out = String::with_capacity(text.len());
    let mut blank = false;
    for c in text.chars() {
        let c = match c {
            '{' => '[',
            '}' => ']',
            c => c,
        };
        if c.is_whitespace() || c.is_control() || is_invisible(c) {
            blank = true;
            continue;
        }
        let apart = matches!((out.chars().next_back(), c), (Some('('), '*') | (Some('*'), ')'));
        if (blank || apart) && !out.is_empty() {
            out.push(' ');
        }
        blank = false;
        out.push(c);
    }
    out
}

/// What stands beside a declaration: the chart's name if it had to be changed, and the attached comment.
pub(crate) fn remark(original: &str, given: &str, comment: Option<&str>) -> Option<String> {
    let comment = comment.map(clean).filter(|text| !text.is_empty());
    if original == given {
        return comment;
    }
    let original = clean(original);
    Some(match comment {
        Some(comment) => format!("`{original}`: {comment}"),
        None => format!("`{original}`"),
    })
}

/// Marks that reorder or hide text: what is read must be what is there.
pub(crate) fn is_invisible(c: char) -> bool {
    matches!(c, '\u{AD}' | '\u{61C}' | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{206F}' | '\u{FEFF}')
}

/// A cleaned text in lines of at most `width` characters, broken at blanks where there are any.
pub fn wrap(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines = Vec::new();
    let (mut line, mut length) = (String::new(), 0);
    for word in text.split_ascii_whitespace() {
        let count = word.chars().count();
        if length > 0 && length + 1 + count > width {
            lines.push(std::mem::take(&mut line));
            length = 0;
        }
        if length > 0 {
            line.push(' ');
            length += 1;
        }
        for c in word.chars() {
            // A piece that ends in `(` or `*` may be cut there: a line break parts what a blank would.
            if length == width {
                lines.push(std::mem::take(&mut line));
                length = 0;
            }
            line.push(c);
            length += 1;
        }
    }
    if length > 0 {
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_ends_a_comment() {
        for (text, expected) in [
            ("a *) b", "a * ) b"),
            ("(*)", "( * )"),
            ("{(*}*)", "[( *]* )"),
            ("**)", "** )"),
            ("two\r\nlines\u{85}\u{2028}more\0", "two lines more"),
            ("{attribute 'hide'}", "[attribute 'hide']"),
            ("$", "$"),
            ("  a \t b  ", "a b"),
            ("(\u{202E}*", "( *"),
            ("*\u{200B})", "* )"),
        ] {
            assert_eq!(clean(text), expected, "{text:?}");
        }
    }

    #[test]
    fn wrapped() {
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("abcdefgh ij", 3), ["abc", "def", "gh", "ij"]);
        assert_eq!(wrap("", 3), [""; 0]);
    }
}
