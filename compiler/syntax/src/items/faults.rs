//! What is said about an item that cannot be read.
//!
//! One mistake, one message: nothing is said where the lexer has said something already.

use super::Reader;
use super::cut::{Run, begins_item};
use crate::expected;
use crate::lexer::{MOST_FAULTS, Token};
use grafc_diagnostics::{Code, Diagnostic, Span};

/// Where the parser stopped.
pub(super) struct Stop {
    /// The token that it did not expect; [`Run::end`] if the item ended too early.
    pub(super) at: usize,
    pub(super) expected: Vec<String>,
}

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
        let found_words =
            if next.is_some() { format!("`{}`", expected::shorten(found)) } else { "the end of the text".into() };
        let expected = expected::describe(previous.token, &stop.expected);
        let mut fault = Diagnostic::new(Code::E0107, span, format!("expected {expected}, found {found_words}"));
        let found_here = next.filter(|_| on_this_line || stop.at < run.end).map(|l| l.token);
        fault.help = expected::cure(lexemes[run.start].token, previous.token, found_here, found, &stop.expected);
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
        let mut fault =
            Diagnostic::new(Code::E0107, span, format!("expected {what}, found `{}`", expected::shorten(found)));
        let lower = found.to_lowercase();
        if first.token == Token::Name && lower != found && ITEM_WORDS.contains(&lower.as_str()) {
            fault = fault.help(format!("words of the language are in lower case: `{lower}`"));
        }
        self.fault(fault);
    }

    /// Whether the lexer reported something between the token before this one and this one.
    pub(super) fn is_near_bad(&self, at: usize) -> bool {
        let lexemes = &self.lexed.lexemes;
        let from = at.checked_sub(1).map_or(0, |before| lexemes[before].start);
        let to = lexemes.get(at).map_or(self.text.len() as u32, |l| l.start);
        let bad = &self.lexed.bad;
        let first = bad.partition_point(|&(_, end)| end <= from);
        bad.get(first).is_some_and(|&(start, _)| start <= to)
    }

    pub(super) fn place_of(&self, at: usize) -> Span {
        match self.lexed.lexemes.get(at) {
            Some(lexeme) => self.builder.span(lexeme.start, lexeme.end),
            None => Span::new(self.file, self.text.len(), self.text.len()),
        }
    }

    pub(super) fn fault(&mut self, fault: Diagnostic) {
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(fault);
        } else {
            self.unlisted += 1;
        }
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
