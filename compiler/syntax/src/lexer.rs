//! Text to tokens.
//!
//! Comments are kept aside. Every fault is reported and the lexer goes on: a malformed name or number still gives
//! a token, so that the parser does not complain a second time, and wrong characters are left out.
//!
//! The patterns need no look-ahead beyond a few bytes, so the time is linear whatever the text is.

use crate::characters::{self, Run, comment_end, is_visible};
use crate::context;
use crate::faults::MOST_FAULTS;
use crate::numeral;
use crate::token::{Lexeme, Token, declares, may_end_item};
use grafc_diagnostics::{Code, Diagnostic, FileId, Fix, Span};
use logos::Logos;

/// What [`lex`] returns.
#[derive(Default)]
pub(crate) struct Lexed {
    /// The tokens, without comments.
    pub(crate) lexemes: Vec<Lexeme>,
    /// The comments.
    pub(crate) comments: Vec<Lexeme>,
    /// The faults, in order of place.
    pub(crate) faults: Vec<Diagnostic>,
    /// Places of which one message says what is wrong, and these messages.
    pub(crate) covered: Vec<(Span, Diagnostic)>,
    /// The places of all faults, also of those that are too many to be listed, in order.
    pub(crate) bad: Vec<(u32, u32)>,
}

/// A token takes so many bytes of text, blanks included, or a few more.
const BYTES: usize = 4;

/// Cuts a text into tokens.
pub(crate) fn lex(file: FileId, text: &str) -> Lexed {
    let mut out = Lexed { lexemes: Vec::with_capacity(text.len() / BYTES), ..Lexed::default() };
    let mut tokens = Token::lexer(text);
    while let Some(result) = tokens.next() {
        let range = tokens.span();
        let slice = &text[range.clone()];
        let (start, end) = (range.start as u32, range.end as u32);
        let span = Span::new(file, range.start, range.end);
        let token = match result {
            Err(()) => {
                out.wrong_characters(file, text, start, end);
                if slice == "#" {
                    if let Some(end) = comment_end(text, range.start) {
                        tokens.bump(end - range.end);
                        out.skipped(end as u32);
                    }
                }
                continue;
            }
            Ok(Token::ForeignComment) => {
                out.fault(span, foreign_comment(span, slice));
                continue;
            }
            Ok(Token::LineComment) => {
                let end = start + slice.trim_end().len() as u32;
                out.comments.push(Lexeme { token: Token::LineComment, start, end });
                continue;
            }
            Ok(Token::BlockComment) => {
                if !is_closed_comment(slice) {
                    let opening = Span::new(file, range.start, range.start + 2);
                    out.fault(span, unterminated_comment(opening));
                }
                out.comments.push(Lexeme { token: Token::BlockComment, start, end });
                continue;
            }
            Ok(Token::Name) if slice.starts_with('`') => {
                if slice.len() < 2 || !slice.ends_with('`') {
                    out.fault(
                        span,
                        Diagnostic::new(Code::E0104, span, "the name in backquotes does not end on its line")
                            .here("this backquote has no partner")
                            .help("add a backquote behind the name"),
                    );
                } else if slice.len() == 2 {
                    out.fault(
                        span,
                        Diagnostic::new(Code::E0104, span, "the name in backquotes is empty")
                            .help("write a name between the backquotes"),
                    );
                } else if let Some((at, c)) = slice.char_indices().find(|(_, c)| c.is_control()) {
                    let place = Span::new(file, range.start + at, range.start + at + c.len_utf8());
                    let message = format!("the name holds the control character U+{:04X}", u32::from(c));
                    let blank = if c == '\t' { " " } else { "" };
                    let help = if blank.is_empty() { "leave it out" } else { "write a blank" };
                    out.fault(
                        span,
                        Diagnostic::new(Code::E0104, place, message)
                            .help(help)
                            .fix(Fix::maybe(help).replace(place, blank)),
                    );
                }
                Token::Name
            }
            Ok(Token::Name) if out.lexemes.last().is_some_and(|l| l.token == Token::On) => match slice {
                "activation" => Token::Activation,
                "deactivation" => Token::Deactivation,
                "event" => Token::Event,
                _ => Token::Name,
            },
            Ok(Token::String) => {
                if slice.bytes().filter(|b| *b == b'"').count() % 2 == 1 {
                    out.fault(
                        span,
                        Diagnostic::new(Code::E0103, span, "the string does not end on its line")
                            .here("this quotation mark has no partner")
                            .help("add `\"` behind the comment")
                            .note("a quotation mark inside a string is doubled: `\"say \"\"go\"\"\"`"),
                    );
                }
                Token::String
            }
            Ok(Token::Address) => {
                if let Some(last) = out.lexemes.last_mut() {
                    if last.token == Token::Name && &text[last.start as usize..last.end as usize] == "at" {
                        last.token = Token::At;
                    }
                }
                Token::Address
            }
            Ok(Token::Numeral) => match numeral::read(slice) {
                Ok(numeral) => numeral.token(),
                Err(fault) => {
                    out.fault(span, fault.diagnostic(span, slice));
                    Token::Unreadable
                }
            },
            Ok(token) if declares(token) => {
                mark_retain(text, &mut out.lexemes);
                token
            }
            Ok(token) => token,
        };
        out.lexemes.push(Lexeme { token, start, end });
    }
    context::words(text, &mut out.lexemes);
    out
}

/// The keyword of a declaration follows: `retain` before it belongs to it, where no name is expected.
fn mark_retain(text: &str, lexemes: &mut [Lexeme]) {
    let Some((last, before)) = lexemes.split_last_mut() else { return };
    let is_retain = last.token == Token::Name && &text[last.start as usize..last.end as usize] == "retain";
    if is_retain && before.last().is_none_or(|l| may_end_item(l.token)) {
        last.token = Token::Retain;
    }
}

impl Lexed {
    fn fault(&mut self, place: Span, diagnostic: Diagnostic) {
        self.bad.push((place.start, place.end));
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(diagnostic);
        }
    }

    /// Whether the fault before offers to change this place as well: it is the second of two quotation marks.
    fn is_changed_already(&self, place: Span) -> bool {
        let fixes = self.faults.last().into_iter().flat_map(|fault| &fault.fixes);
        fixes.flat_map(|fix| &fix.edits).any(|edit| edit.span == place)
    }

    /// What is behind the last fault, up to a place, belongs to it.
    fn skipped(&mut self, end: u32) {
        if let Some(last) = self.bad.last_mut() {
            last.1 = end;
        }
    }

    /// Wrong characters in a run are one fault.
    fn wrong_characters(&mut self, file: FileId, text: &str, start: u32, end: u32) {
        let run = match self.bad.last() {
            Some(&(first, last)) if last == start => first,
            _ => {
                let span = Span::new(file, start as usize, end as usize);
                if self.is_changed_already(span) {
                    self.bad.push((start, end));
                    return;
                }
                self.fault(span, Diagnostic::new(Code::E0101, span, String::new()));
                start
            }
        };
        let at = self.bad.len() - 1;
        self.bad[at].1 = end;
        let is_it = |fault: &&mut Diagnostic| fault.primary.span.start == run && fault.code == Code::E0101;
        let Some(fault) = self.faults.last_mut().filter(is_it) else { return };
        // The headline names the first characters only, so it need not be written again for a long run.
        if end - run <= 64 || fault.message.is_empty() {
            fault.message = unexpected_characters(&text[run as usize..end as usize]);
        }
        fault.primary.span.end = end;
        if end - run <= 64 {
            let range = run as usize..end as usize;
            let cure = characters::cure(&Run { file, text, range, before: &self.lexemes });
            // What an address lacks stands before it, and `at` is none without that.
            if let Some(before) = self.lexemes.len().checked_sub(2).map(|before| self.lexemes[before])
                && &text[before.start as usize..before.end as usize] == "at"
            {
                self.bad[at].0 = before.start;
            }
            fault.help = Some(cure.words);
            fault.fixes = cure.fix.into_iter().collect();
        }
    }
}

/// Whether a comment that [`block_comment`] read has its end, and not only the end of the text.
fn is_closed_comment(comment: &str) -> bool {
    let bytes = comment.as_bytes();
    let mut depth = 0usize;
    let mut at = 0;
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"(*" => {
                depth += 1;
                at += 2;
            }
            b"*)" => {
                depth -= 1;
                at += 2;
            }
            _ => at += 1,
        }
    }
    depth == 0
}

/// `/* … */`
fn foreign_comment(span: Span, comment: &str) -> Diagnostic {
    let opening = Span { end: span.start + 2, ..span };
    let inner = &comment[2..];
    let fault = Diagnostic::new(Code::E0101, opening, "unexpected characters `/*`");
    let fault = fault.help("a comment is written `(* … *)`, or `// …` to the end of the line");
    match inner.strip_suffix("*/").filter(|inner| !inner.contains("*)") && !inner.contains("(*")) {
        Some(_) => {
            let closing = Span { start: span.end - 2, ..span };
            fault.fix(Fix::certain("write `(* … *)`").replace(opening, "(*").replace(closing, "*)"))
        }
        None => fault,
    }
}

fn unterminated_comment(opening: Span) -> Diagnostic {
    Diagnostic::new(Code::E0102, opening, "the comment is never closed")
        .here("`*)` is missing for this")
        .help("add `*)` where the comment ends")
        .note("comments nest: each `(*` needs its own `*)`")
}

fn unexpected_characters(run: &str) -> String {
    let mut characters = run.chars();
    match (characters.next(), characters.next()) {
        (Some(c), None) if c.is_control() || c.is_whitespace() || !c.is_ascii() => {
            format!("unexpected character {}(U+{:04X})", visible(c), c as u32)
        }
        (Some(c), None) => format!("unexpected character `{c}`"),
        _ => {
            let shown: String = run.chars().take(8).filter(|c| !c.is_control()).collect();
            let rest = if run.chars().nth(8).is_some() { "…" } else { "" };
            if shown.is_empty() {
                "unexpected characters".into()
            } else {
                format!("unexpected characters `{shown}{rest}`")
            }
        }
    }
}

fn visible(c: char) -> String {
    // Format characters such as U+200B would leave an empty pair of backquotes.
    if is_visible(c) { format!("`{c}` ") } else { String::new() }
}
