//! A text of Rust as its tokens, and the function that each is in: what stays when code is reformatted.

/// A token, and where it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Token<'s> {
    /// What it is: a word, a number, a literal, or one character.
    pub text: &'s str,
    /// Where it begins.
    pub start: usize,
    /// The innermost function around it.
    pub function: Option<&'s str>,
}

impl Token<'_> {
    /// Where it ends.
    pub fn end(&self) -> usize {
        self.start + self.text.len()
    }

    /// Whether it is a word that is no keyword and begins as names of variables do.
    fn is_name(&self) -> bool {
        const KEYWORDS: [&str; 24] = [
            "as", "break", "const", "continue", "crate", "else", "false", "fn", "for", "if", "impl", "in", "let",
            "loop", "match", "move", "mut", "ref", "return", "self", "super", "true", "while", "where",
        ];
        self.text.starts_with(|c: char| c.is_ascii_lowercase()) && !KEYWORDS.contains(&self.text)
    }
}

/// Whether a token can be the name of a local variable: no field, no function, no part of a path.
pub(super) fn is_local(tokens: &[Token], index: usize) -> bool {
    let at = |index: Option<usize>| index.and_then(|index| tokens.get(index)).map_or("", |token| token.text);
    let (before, next) = (at(index.checked_sub(1)), at(Some(index + 1)));
    let is_field = before == "." && at(index.checked_sub(2)) != ".";
    let in_path = before == ":" && at(index.checked_sub(2)) == ":" || next == ":" && at(Some(index + 2)) == ":";
    tokens[index].is_name() && !is_field && !in_path && next != "(" && next != "!"
}

/// The tokens of a text, without comments and without commas that only end a list, which rustfmt writes and takes away.
pub(super) fn tokens(source: &str) -> Vec<Token<'_>> {
    let mut tokens: Vec<Token> = Vec::new();
    let mut functions = Functions::default();
    let mut start = 0;
    while let Some(rest) = source.get(start..).filter(|rest| !rest.is_empty()) {
        let length = length(rest);
        let text = &rest[..length];
        let is_code = !text.starts_with(char::is_whitespace) && !text.starts_with("//") && !text.starts_with("/*");
        if is_code {
            if matches!(text, ")" | "]" | "}") && tokens.last().is_some_and(|last| last.text == ",") {
                tokens.pop();
            }
            functions.hear(text);
            tokens.push(Token { text, start, function: functions.innermost() });
        }
        start += length;
    }
    tokens
}

/// The functions around what is being read.
#[derive(Default)]
struct Functions<'s> {
    /// Of each open brace the function whose body it opens.
    open: Vec<Option<&'s str>>,
    /// The name behind the last `fn`, until its body begins.
    named: Option<&'s str>,
    after_fn: bool,
}

impl<'s> Functions<'s> {
    fn hear(&mut self, text: &'s str) {
        if std::mem::replace(&mut self.after_fn, text == "fn") && text != "(" {
            self.named = Some(text);
        }
        match text {
            "{" => self.open.push(self.named.take()),
            "}" => drop(self.open.pop()),
            _ => {}
        }
    }

    fn innermost(&self) -> Option<&'s str> {
        self.open.iter().rev().find_map(|function| *function)
    }
}

/// The length of the token, the comment or the white space with which a text begins; the text is not empty.
fn length(text: &str) -> usize {
    let run = |is: fn(char) -> bool| text.find(|c| !is(c)).unwrap_or(text.len());
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let first = text.chars().next().unwrap_or_default();
    if first.is_whitespace() {
        run(char::is_whitespace)
    } else if text.starts_with("//") {
        run(|c| c != '\n')
    } else if text.starts_with("/*") {
        text.find("*/").map_or(text.len(), |end| end + 2)
    } else if let Some(hashes) = raw(text) {
        let end = format!("\"{}", "#".repeat(hashes));
        let open = text.find('"').unwrap_or_default() + 1;
        text[open..].find(&end).map_or(text.len(), |at| open + at + end.len())
    } else if first == '"' || text.starts_with("b\"") {
        let open = usize::from(first == 'b') + 1;
        quoted(text, open, '"').unwrap_or(text.len())
    } else if is_word(first) {
        run(|c| c.is_alphanumeric() || c == '_')
    } else if first == '\'' {
        // A character, or else the mark of a lifetime or a label.
        match text[1..].chars().next() {
            Some('\\') => quoted(text, 1, '\'').unwrap_or(text.len()),
            Some(c) if text[1 + c.len_utf8()..].starts_with('\'') => c.len_utf8() + 2,
            _ => 1,
        }
    } else {
        first.len_utf8()
    }
}

/// The number of hashes of a raw string with which a text begins.
fn raw(text: &str) -> Option<usize> {
    let after = text.strip_prefix("br").or_else(|| text.strip_prefix('r'))?;
    let hashes = after.len() - after.trim_start_matches('#').len();
    after[hashes..].starts_with('"').then_some(hashes)
}

/// The end of a literal whose contents begin at a place.
fn quoted(text: &str, open: usize, mark: char) -> Option<usize> {
    let mut escaped = false;
    for (at, c) in text[open..].char_indices() {
        if !escaped && c == mark {
            return Some(open + at + c.len_utf8());
        }
        escaped = !escaped && c == '\\';
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(source: &str) -> Vec<&str> {
        tokens(source).iter().map(|token| token.text).collect()
    }

    #[test]
    fn layout_and_comments_are_nothing() {
        let short = "f(a, &b)[0] // at the end\n";
        let long = "f(\n    a, /* the, */\n    &b,\n)[0]";
        assert_eq!(texts(short), ["f", "(", "a", ",", "&", "b", ")", "[", "0", "]"]);
        assert_eq!(texts(long), texts(short));
    }

    #[test]
    fn literals_are_one_token() {
        let source = r##"["a \" { b", r#"c " { d"#, 'e', '\'', '{', b"{"]"##;
        let literals = ["\"a \\\" { b\"", "r#\"c \" { d\"#", "'e'", "'\\''", "'{'", "b\"{\""];
        let found: Vec<&str> = texts(source).into_iter().filter(|text| text.len() > 1).collect();
        assert_eq!(found, literals);
        assert_eq!(texts("&'l str"), ["&", "'", "l", "str"]);
    }

    #[test]
    fn functions_are_known_by_name() {
        let source = "impl A { fn one(x: fn(u8)) -> u8 { if a { b } c } } fn two() { d } const E: u8 = e;";
        let found = tokens(source);
        let of = |text: &str| found.iter().rev().find(|token| token.text == text).and_then(|token| token.function);
        assert_eq!([of("b"), of("c"), of("d"), of("e")], [Some("one"), Some("one"), Some("two"), None]);
    }

    #[test]
    fn locals_are_neither_fields_nor_functions() {
        let source = "self.places[step].mark(a::b, ..count, C)";
        let found = tokens(source);
        let locals = (0..found.len()).filter(|index| is_local(&found, *index)).map(|index| found[index].text);
        assert_eq!(locals.collect::<Vec<_>>(), ["step", "count"]);
    }
}
