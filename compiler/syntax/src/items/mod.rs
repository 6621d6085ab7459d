//! Tokens to a tree, item by item.
//!
//! Every item begins with a word that stands nowhere else, so the tokens can be cut into items before they are parsed:
//! a mistake in one item never reaches the next, and costs one message. The grammar reads what is inside an item; the
//! nesting of blocks is followed here, with a stack of our own. Where braces do not match, their balance over the rest
//! of the text tells whether one is missing or one too many.

mod attempt;
mod balance;
mod blocks;
mod cut;
mod faults;
mod reader;
mod salvage;

use self::attempt::{Stop, attempt, attempt_all, is_plain};
use self::cut::{Cutter, Run};
use self::reader::Reader;
use crate::ast;
use crate::builder::Parsed;
use crate::lexer;
use crate::pasted;
use crate::token::{Token, begins_item, may_stand_in_block};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};

/// Reads a whole text. It always gives a tree: what could not be read is left out and has been reported.
pub fn parse(file: FileId, text: &str) -> (ast::Chart, Diagnostics) {
    parse_up_to(file, text, u32::MAX as usize)
}

/// As [`parse`], for texts of at most `longest` bytes.
fn parse_up_to(file: FileId, text: &str, longest: usize) -> (ast::Chart, Diagnostics) {
    if text.len() > longest {
        let mut diagnostics = Diagnostics::new();
        let message = format!("the text is longer than {longest} bytes");
        diagnostics.push(Diagnostic::new(Code::E0109, Span::new(file, 0, 0), message));
        return (ast::Chart::default(), diagnostics);
    }
    let mut lexed = lexer::lex(file, text);
    pasted::blocks(file, text, &mut lexed);
    let mut reader = Reader::new(file, text, lexed);
    reader.read();
    reader.finish()
}

impl Reader<'_> {
    fn read(&mut self) {
        while let Some(lexeme) = self.lexed.lexemes.get(self.at) {
            match lexeme.token {
                Token::CloseBrace => self.close_brace(),
                token if is_plain(token, self.stack.len()) => self.plain_items(),
                token if begins_item(token) => self.item(),
                _ => self.junk(),
            }
        }
        if !self.stack.is_empty() {
            self.unclosed_block();
            self.close_all();
        }
    }

    /// Items that open no block, as many as follow each other.
    fn plain_items(&mut self) {
        let cutter =
            Cutter { text: self.text, lexemes: &self.lexed.lexemes, balance: &self.balance, depth: self.stack.len() };
        let outcome = attempt_all(&self.parser, &mut self.builder, cutter, self.at);
        // In place, since there are as many as the text has items.
        let parsed = std::mem::take(&mut self.builder.parsed).into_iter();
        let items: Vec<ast::Item> = parsed.filter_map(Parsed::plain).collect();
        let list = self.list();
        if list.is_empty() {
            *list = items;
        } else {
            list.extend(items);
        }
        match outcome {
            Ok(next) => self.at = next,
            Err((run, stop)) => {
                self.builder.discard_item();
                self.report(&run, &stop);
                self.faulty_item(&run, &stop);
            }
        }
        self.stray_reported = false;
    }

    fn item(&mut self) {
        let token = self.lexed.lexemes[self.at].token;
        let is_misplaced = !self.stack.is_empty() && !may_stand_in_block(token);
        if is_misplaced {
            self.misplaced(token);
        }
        let run = self.cutter().cut(self.at);
        let arena = self.builder.exprs.len();
        let lexemes = &self.lexed.lexemes[run.start..run.end];
        match attempt(&self.parser, &mut self.builder, lexemes, &[]) {
            Ok(parsed) => {
                self.add(parsed, &run);
                self.at = run.end;
            }
            Err((place, expected)) => {
                self.builder.discard(arena);
                let stop = Stop { at: run.start + place, expected };
                // Of what cannot stand here nobody asks what it is called.
                if !is_misplaced || place > 1 {
                    self.report(&run, &stop);
                }
                self.faulty_item(&run, &stop);
            }
        }
        self.stray_reported = false;
    }

    /// Keeps what can be kept of an item that could not be read.
    fn faulty_item(&mut self, run: &Run, stop: &Stop) {
        // Beyond the faults that are listed, nobody asks what can be kept.
        let kept = if self.builder.is_full() { self.nameless(run) } else { self.salvage(run, stop) };
        if let Some(parsed) = kept {
            self.add(parsed, run);
        }
        self.at = run.end;
        self.skip_partner(run);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_beyond_the_limit_is_not_read() {
        let (chart, diagnostics) = parse_up_to(FileId::new(0), "step 1", 5);
        assert!(chart.items.is_empty());
        assert_eq!(diagnostics.iter().map(|d| d.code).collect::<Vec<_>>(), [Code::E0109]);
        assert!(!parse_up_to(FileId::new(0), "step 1", 6).1.has_errors());
    }
}
