//! Messages about an item that cannot be read.
//!
//! One mistake, one message: none where the lexer has given one already.

use super::attempt::Stop;
use super::cut::Run;
use super::reader::Reader;
use crate::cure::{self, Slip};
use crate::expected;
use crate::shown::shorten;
use crate::token::{Token, begins_item};
use grafc_diagnostics::{Code, Diagnostic, Fix};

impl Reader<'_> {
    /// Reports why an item could not be read, unless a fault has been reported at that very place.
    pub(super) fn report(&mut self, run: &Run, stop: &Stop) {
        if self.is_near_bad(stop.at) || self.doubtful.take() == Some(run.start) {
            return;
        }
        let lexemes = &self.lexed.lexemes;
        let previous = lexemes[stop.at - 1];
        let next = lexemes.get(stop.at);
        let found = next.map_or("", |l| &self.text[l.start as usize..l.end as usize]);
        let can_close = expected::contains(&stop.expected, "}");
        if let (true, true, Some(open)) = (stop.at == run.end, can_close, run.open) {
            let open = lexemes[open];
            let fault =
                Diagnostic::new(Code::E0107, self.builder.span(open.start, open.end), "this `{` is never closed")
                    .also(self.place_of(stop.at), "`}` is missing before this");
            return self.fault(fault);
        }
        // What is missing at the end of a line is shown there, and not at the item that follows.
        let gap = &self.text[previous.end as usize..next.map_or(self.text.len(), |l| l.start as usize)];
        let on_this_line = next.is_some() && !gap.contains('\n');
        let span = if on_this_line || stop.at < run.end {
            self.place_of(stop.at)
        } else {
            self.builder.span(previous.end, previous.end)
        };
        if on_this_line && stop.at == run.end {
            self.doubtful = Some(run.end);
        }
        let found_words = if next.is_some() { format!("`{}`", shorten(found)) } else { "the end of the text".into() };
        let expected = expected::describe(previous.token, &stop.expected);
        let mut fault = Diagnostic::new(Code::E0107, span, format!("expected {expected}, found {found_words}"));
        let slip = Slip {
            file: self.file,
            text: self.text,
            lexemes,
            item: lexemes[run.start].token,
            at: stop.at,
            is_found: next.is_some() && (on_this_line || stop.at < run.end),
            expected: &stop.expected,
        };
        if let Some(cure) = cure::of(&slip) {
            fault = fault.help(cure.words);
            fault.fixes.extend(cure.fix);
        }
        self.fault(fault);
    }

    /// Tokens that belong to no item.
    pub(super) fn junk(&mut self) {
        let start = self.at;
        let mut depth = 0usize;
        while let Some(lexeme) = self.lexed.lexemes.get(self.at) {
            match lexeme.token {
                Token::OpenBrace => depth += 1,
                Token::CloseBrace if depth == 0 => break,
                Token::CloseBrace => depth -= 1,
                token if begins_item(token) => break,
                _ => {}
            }
            self.at += 1;
        }
        if self.is_near_bad(start) {
            return;
        }
        let first = self.lexed.lexemes[start];
        let span = self.builder.span(first.start, first.end);
        let what = if self.stack.is_empty() {
            "an item such as `input`, `step` or `transition`"
        } else {
            "`step`, `transition` or `}`"
        };
        let found = &self.text[span.range()];
        let mut fault = Diagnostic::new(Code::E0107, span, format!("expected {what}, found `{}`", shorten(found)));
        let lower = found.to_lowercase();
        if first.token == Token::Name && lower == "retain" {
            fault = fault.help("`retain` stands before `var` or `output`: `retain var n : int`");
        } else if first.token == Token::Name && lower != found && ITEM_WORDS.contains(&lower.as_str()) {
            let fix = Fix::certain(format!("write `{lower}`")).replace(span, lower.as_str());
            fault = fault.help(format!("words of the language are in lower case: `{lower}`")).fix(fix);
        }
        self.fault(fault);
    }
}

/// The words that begin an item, as they are written.
const ITEM_WORDS: [&str; 13] = [
    "chart",
    "input",
    "output",
    "var",
    "const",
    "grafcet",
    "expansion",
    "step",
    "transition",
    "initial",
    "activated",
    "enclosing",
    "macro",
];
