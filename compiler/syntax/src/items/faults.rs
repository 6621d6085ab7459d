//! Messages about an item that cannot be read.
//!
//! One mistake, one message: none where the lexer has given one already.

use super::attempt::Stop;
use super::cut::Run;
use super::reader::Reader;
use crate::expected;
use crate::habits::{self, Slip, Spot};
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
                    .also(self.place_of(stop.at), "`}` is missing before this")
                    .help("add `}`")
                    .fix(Fix::maybe("add `}`").replace(self.builder.span(previous.end, previous.end), " }"));
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
            run: run.start..run.end,
            at: stop.at,
            is_found: next.is_some() && (on_this_line || stop.at < run.end),
            expected: &stop.expected,
        };
        if let Some(cure) = habits::cure(&slip) {
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
        let next = self.lexed.lexemes.get(start + 1).map(|next| next.token);
        let spot = Spot { token: first.token, span, word: found };
        match habits::opening(found, next).filter(|_| matches!(first.token, Token::Name | Token::Force)) {
            Some(opening) => {
                fault.fixes.extend(opening.fix(spot));
                fault = fault.help(opening.words);
            }
            None => fault = fault.help("an item begins with a word such as `step`, `transition` or `input`"),
        }
        self.fault(fault);
    }
}
