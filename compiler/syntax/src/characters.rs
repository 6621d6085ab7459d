//! Characters that mean nothing here: what they are called in messages, and what helps.
//!
//! Most come from other languages and from drawings; some are put there by a word processor.

use crate::faults::MOST_FAULTS;
use crate::habits::words::{OPERATORS, ours};
use crate::habits::{Cure, in_letters_of_iec, named};
use crate::token::{Lexeme, Token};
use grafc_diagnostics::{FileId, Fix, Span};
use std::ops::Range;

/// Where wrong characters stand.
pub(crate) struct Run<'t> {
    pub(crate) file: FileId,
    pub(crate) text: &'t str,
    pub(crate) range: Range<usize>,
    /// The tokens before them.
    pub(crate) before: &'t [Lexeme],
}

/// Signs with another spelling here: what is said of them, and what to write.
const SIGNS: &[(&[&str], &str, &str)] = &[
    (&[";", "；"], "leave it out: items and actions need no separator", ""),
    (&["∧", "•", "∙", "⋀"], "write `and`, `·` or `&`", "·"),
    (&["∨", "⋁"], "write `or`, `+` or `|`", "|"),
    (&["⊕", "^", "⊻"], "write `xor`", " xor "),
    (&["~", "‾", "¯", "⌐"], "write `not`, `!` or `¬`", "!"),
    (&["×"], "multiplication is written `*`", "*"),
    (&["−", "–", "—"], "the minus sign is written `-`", "-"),
    (&["÷"], "division is written `/`", "/"),
    (&["⇒", "⟶", "⟹", "➔", "➜", "➝", "⇨", "►", "▶"], "an arrow is written `->`", "->"),
    (&["⇑", "⬆", "▲"], "a rising edge is written `↑`", "↑"),
    (&["⇓", "⬇", "▼"], "a falling edge is written `↓`", "↓"),
    (&["："], "write `:`", ":"),
    (&["，"], "write `,`", ","),
    (&["（"], "write `(`", "("),
    (&["）"], "write `)`", ")"),
    (&["｛"], "write `{`", "{"),
    (&["｝"], "write `}`", "}"),
    (&["＝"], "write `=`", "="),
    (&["＋"], "write `+`", "+"),
];

/// What helps with wrong characters.
pub(crate) fn cure(run: &Run<'_>) -> Cure {
    let written = &run.text[run.range.clone()];
    if let Some((_, words, instead)) = SIGNS.iter().find(|(signs, ..)| signs.contains(&written)) {
        return Cure::write(*words, run.span(), instead);
    }
    let found = match written {
        "." => run.point(),
        "'" | "’" | "′" => run.prime(),
        "#" => Some(run.hash()),
        _ => None,
    };
    if let Some(cure) = found {
        return cure;
    }
    if is_quote(written) {
        return run.quotes();
    }
    if written.chars().all(|c| c.is_control() || !is_visible(c)) {
        return Cure::write("leave it out: it cannot be seen", run.span(), "");
    }
    run.part_of_a_name().unwrap_or_else(|| Cure::words("leave it out: it means nothing here"))
}

/// Characters that have no shape of their own.
pub(crate) fn is_visible(c: char) -> bool {
    !(c.is_control() || ('\u{200B}'..='\u{200F}').contains(&c) || ('\u{2028}'..='\u{202F}').contains(&c))
}

/// How far a comment goes that begins like those of other languages, and is none: `# …`.
pub(crate) fn comment_end(text: &str, hash: usize) -> Option<usize> {
    let line = &text[hash + 1..];
    let line = &line[..line.find('\n').unwrap_or(line.len())];
    let is_first = text[..hash].trim_end_matches([' ', '\t']).chars().next_back().is_none_or(|c| c == '\n');
    let mut words = line.split_ascii_whitespace();
    let name = words.next().unwrap_or_default();
    // `#a and #b` names local variables of STEP 7.
    let is_name = line.starts_with(|c: char| c.is_alphabetic() || c == '_') && !is_first;
    let goes_on =
        words.next().is_some_and(|next| next.starts_with(char::is_alphabetic) && ours(OPERATORS, next).is_none());
    let is_word = name.chars().all(|c| c.is_alphanumeric() || c == '_');
    (!is_name || is_word && goes_on).then(|| hash + 1 + line.trim_end().len())
}

fn is_quote(run: &str) -> bool {
    matches!(run, "“" | "”" | "„" | "«" | "»" | "'" | "‘" | "’")
}

impl<'t> Run<'t> {
    fn span(&self) -> Span {
        self.whole(self.range.clone())
    }

    fn whole(&self, range: Range<usize>) -> Span {
        Span::new(self.file, range.start, range.end)
    }

    /// The token that ends where the run begins.
    fn previous(&self) -> Option<Lexeme> {
        self.before.last().copied().filter(|lexeme| lexeme.end as usize == self.range.start)
    }

    fn word(&self, lexeme: Lexeme) -> &'t str {
        &self.text[lexeme.start as usize..lexeme.end as usize]
    }

    /// The word that begins where the run ends.
    fn next(&self) -> &'t str {
        let rest = &self.text[self.range.end..];
        &rest[..rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len())]
    }

    /// Whether the item under way declares names.
    fn is_in_declaration(&self) -> bool {
        let near = self.before.iter().rev().take(64);
        let word = near.map(|lexeme| lexeme.token).find(|token| crate::token::begins_item(*token));
        matches!(word, Some(Token::Input | Token::Output | Token::Var | Token::Const))
    }

    /// `a.b`, `X1.T`, `at IX0.0`, `.5s`
    fn point(&self) -> Option<Cure> {
        let next = self.next();
        let Some(previous) = self.previous() else {
            let right = format!("0.{next}");
            let is_number = next.starts_with(|c: char| c.is_ascii_digit());
            if is_number {
                return Some(Cure::write(format!("write `{right}`"), self.span(), "0."));
            }
            let is_between = !next.is_empty() || self.text[self.range.end..].starts_with(' ');
            return is_between.then(|| Cure::write("\"and\" is written `and`, `·` or `&`", self.span(), "·"));
        };
        let word = self.word(previous);
        let place = |to: usize| self.whole(previous.start as usize..to);
        let end = self.range.end + next.len();
        if next.is_empty() {
            return Some(Cure::write("leave it out: nothing ends an item", self.span(), ""));
        }
        let before = self.before.len().checked_sub(2).map(|at| self.word(self.before[at]));
        if before == Some("at") {
            if word.to_ascii_uppercase().starts_with("DB") {
                let words = "a data block has no address in a chart: it is one of the process image, as in `%I0.0`";
                return Some(Cure::words(words));
            }
            let address = format!("%{}.{next}", in_letters_of_iec(word));
            return Some(Cure::write(format!("an address begins with `%`: `at {address}`"), place(end), &address));
        }
        let label =
            word.strip_prefix(['X', 'S']).filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit())).unwrap_or(word);
        let implicit = match next {
            "T" | "t" => Some(format!("T{label}")),
            "X" | "x" => Some(format!("X{label}")),
            _ => None,
        };
        if let Some(right) = implicit {
            let label = if word.starts_with('S') { word } else { label };
            let right = format!("{}{label}", &right[..1]);
            return Some(Cure::guess(format!("of step `{label}` this is `{right}`"), place(end), &right));
        }
        if self.is_in_declaration() {
            return self.part_of_a_name();
        }
        let is_operand = matches!(previous.token, Token::Name | Token::CloseParen | Token::CloseBracket);
        let words = if previous.token == Token::Name {
            format!("\"and\" is written `and`, `·` or `&`: `{word} · {next}`")
        } else {
            "\"and\" is written `and`, `·` or `&`".to_owned()
        };
        is_operand.then(|| Cure::write(words, self.span(), " · "))
    }

    /// `a'`: the complement in textbooks.
    fn prime(&self) -> Option<Cure> {
        let previous = self.previous()?;
        match previous.token {
            Token::Name => {
                let right = format!("not {}", self.word(previous));
                let place = self.whole(previous.start as usize..self.range.end);
                Some(Cure::guess(format!("the complement is written `{right}`"), place, &right))
            }
            Token::CloseParen => Some(Cure::words("the complement is written `not (…)`")),
            _ => None,
        }
    }

    /// `# comment`, `#local`
    fn hash(&self) -> Cure {
        match comment_end(self.text, self.range.start) {
            Some(_) => Cure::write("a comment begins with `//`", self.span(), "//"),
            None => {
                let words = format!("names have no `#` before them: `{}`", self.next());
                Cure::write(words, self.span(), "")
            }
        }
    }

    /// Quotation marks are changed two by two.
    fn quotes(&self) -> Cure {
        let cure = Cure::words("an attached comment stands in straight quotation marks: `\"…\"`");
        let text = self.text;
        let line = text[..self.range.start].rfind('\n').map_or(0, |n| n + 1);
        let rest = text[line..].find('\n').map_or(text.len(), |n| line + n);
        let quotes = |range: Range<usize>| {
            let from = range.start;
            let marks = text[range].char_indices().map(move |(at, c)| from + at..from + at + c.len_utf8());
            marks.filter(|mark| is_quote(&text[mark.clone()])).take(MOST_FAULTS)
        };
        // The first of two opens the comment, whatever their shapes: they are not the same in all languages.
        let before = quotes(line..self.range.start);
        let (odd, last) = before.fold((false, None), |(odd, _), mark| (!odd, Some(mark)));
        let pair = match odd {
            true => last.map(|open| (open, self.range.clone())),
            false => quotes(self.range.end..rest).next().map(|close| (self.range.clone(), close)),
        };
        match pair.filter(|(open, close)| !text[open.end..close.start].contains('"')) {
            Some((open, close)) => {
                let fix = Fix::certain("write straight quotation marks").replace(self.whole(open), "\"");
                Cure { fix: Some(fix.replace(self.whole(close), "\"")), ..cure }
            }
            None => cure,
        }
    }

    /// `a$b`: with the word before and the word behind it, a name in backquotes.
    fn part_of_a_name(&self) -> Option<Cure> {
        let previous = self.previous().filter(|lexeme| matches!(lexeme.token, Token::Name | Token::Whole));
        let next = self.next();
        if previous.is_none() && next.is_empty() {
            return None;
        }
        let start = previous.map_or(self.range.start, |lexeme| lexeme.start as usize);
        // What goes on like this belongs to the name as well.
        let rest = &self.text[self.range.end..];
        let more = rest.find(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | '.' | '$' | '@' | '-')));
        let end = self.range.end + more.unwrap_or(rest.len());
        let whole = &self.text[start..end];
        (!whole.contains('`')).then(|| named(whole, self.whole(start..end)))
    }
}
