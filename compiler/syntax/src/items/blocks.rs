//! Blocks: grafcets and expansions, their braces, and what does not belong into them.

use super::cut::Run;
use super::reader::{BlockItem, Frame, Reader};
use crate::ast::Item;
use crate::builder::Parsed;
use crate::token::{Token, is_prefix};
use grafc_diagnostics::{Code, Diagnostic, Fix, Span};

/// Expansions within expansions beyond this depth are reported. Nobody draws so many, and a tree of bounded depth can be
/// walked and dropped by recursion.
const DEEPEST: usize = 64;

impl Reader<'_> {
    /// Puts what an item turned out to be where it belongs.
    pub(super) fn add(&mut self, parsed: Parsed, run: &Run) {
        let brace = self.lexed.lexemes[run.end - 1];
        let opened = self.builder.span(brace.start, brace.end);
        let block = match parsed {
            Parsed::Heading(heading) => {
                if run.start != 0 {
                    let mut fault =
                        Diagnostic::new(Code::E0107, heading.span, "the heading of the chart is not its first item");
                    fault = match &self.heading {
                        Some(first) => fault
                            .also(first.span, "there is one already")
                            .help("leave it out")
                            .fix(Fix::maybe("leave it out").delete(heading.span)),
                        None => fault.help("move it to the beginning of the text"),
                    };
                    self.fault(fault);
                }
                self.heading.get_or_insert(heading);
                return;
            }
            Parsed::Item(item @ Item::Declaration(_)) => return self.items.push(item),
            Parsed::Item(item) => return self.list().push(item),
            Parsed::Grafcet(grafcet) => BlockItem::Grafcet(grafcet),
            Parsed::Expansion(expansion) => BlockItem::Expansion(expansion),
        };
        if self.stack.len() == DEEPEST {
            let message = format!("blocks are nested deeper than {DEEPEST} levels");
            self.fault(
                Diagnostic::new(Code::E0107, opened, message).help("an expansion may stand outside of the others"),
            );
        }
        self.stack.push(Frame { block, opened, reported: false });
    }

    /// The items of the innermost open block, or of the file.
    pub(super) fn list(&mut self) -> &mut Vec<Item> {
        self.stack.last_mut().map_or(&mut self.items, |frame| frame.block.items())
    }

    pub(super) fn close_brace(&mut self) {
        let brace = self.lexed.lexemes[self.at];
        let next = self.lexed.lexemes.get(self.at + 1).map(|l| l.token);
        let too_many = self.balance(self.at) > self.stack.len() as i64;
        // A step behind the brace of the only open block shows that the block goes on.
        let goes_on =
            self.stack.len() == 1 && next.is_some_and(|t| is_prefix(t) || matches!(t, Token::Step | Token::Transition));
        if self.stack.is_empty() || (too_many && goes_on) {
            if !self.stray_reported && !self.is_near_bad(self.at) {
                let span = self.builder.span(brace.start, brace.end);
                self.fault(
                    Diagnostic::new(Code::E0107, span, "expected an item, found a `}` without its `{`")
                        .help("leave out `}`")
                        .fix(Fix::maybe("leave out `}`").delete(span.to(self.last_brace_of_row()))),
                );
            }
            self.stray_reported = true;
        } else {
            self.close(brace.end);
        }
        self.at += 1;
    }

    /// Outside of all blocks, each `}` behind one too many is too many as well.
    fn last_brace_of_row(&self) -> Span {
        let braces = self.lexed.lexemes[self.at..].iter().take_while(|lexeme| lexeme.token == Token::CloseBrace);
        let most = if self.stack.is_empty() { usize::MAX } else { 1 };
        braces.take(most).last().map_or(self.end_before(), |brace| self.builder.span(brace.start, brace.end))
    }

    fn close(&mut self, end: u32) {
        let Some(frame) = self.stack.pop() else { return };
        let depth = self.stack.len();
        match frame.block {
            BlockItem::Grafcet(mut grafcet) => {
                grafcet.span.end = end.max(grafcet.span.end);
                self.items.push(Item::Grafcet(grafcet));
            }
            BlockItem::Expansion(mut expansion) => {
                expansion.span.end = end.max(expansion.span.end);
                let list = match self.stack.last_mut() {
                    Some(parent) if depth < DEEPEST => parent.block.items(),
                    _ => &mut self.items,
                };
                list.push(Item::Expansion(expansion));
            }
        }
    }

    pub(super) fn close_all(&mut self) {
        let end = self.at.checked_sub(1).map_or(0, |at| self.lexed.lexemes[at].end);
        while !self.stack.is_empty() {
            self.close(end);
        }
    }

    /// A grafcet, a declaration or a heading within a block: either the block was not closed, or it is in a wrong place.
    pub(super) fn misplaced(&mut self, token: Token) {
        if self.balance(self.at) < self.stack.len() as i64 {
            self.unclosed_block();
            self.close_all();
            return;
        }
        let lexeme = self.lexed.lexemes[self.at];
        let span = self.builder.span(lexeme.start, lexeme.end);
        let Some(frame) = self.stack.last_mut() else { return };
        let inside = frame.block.title();
        let word = &self.text[span.range()];
        let fault = Diagnostic::new(Code::E0107, span, format!("`{word}` cannot stand inside {inside}"))
            .also(frame.opened, format!("{inside} begins here"));
        if matches!(token, Token::Grafcet | Token::Child) {
            self.fault(fault.help("an enclosure stands outside and names its enclosing step: `grafcet X9/G4 { … }`"));
        } else if token == Token::Scenario {
            self.fault(fault.help("a scenario stands outside of all braces"));
        } else if !std::mem::replace(&mut frame.reported, true) {
            self.fault(fault.help("declarations stand outside of all braces"));
        }
    }

    /// Behind the last token that was read.
    fn end_before(&self) -> Span {
        let end = self.at.checked_sub(1).map_or(0, |before| self.lexed.lexemes[before].end);
        self.builder.span(end, end)
    }

    pub(super) fn unclosed_block(&mut self) {
        if self.is_near_bad(self.at) {
            return;
        }
        let Some(frame) = self.stack.last() else { return };
        let fault =
            Diagnostic::new(Code::E0107, frame.opened, format!("the `{{` of {} is never closed", frame.block.title()))
                .also(self.place_of(self.at), "`}` is missing before this")
                .help("add `}`")
                .fix(Fix::maybe("add `}`").replace(self.end_before(), "\n}"));
        self.fault(fault);
    }
}
