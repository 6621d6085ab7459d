//! Cuts the tokens into items.
//!
//! An item begins with a reserved word and ends before the next one, with its own closing brace or before that of its
//! block.

use super::balance::Balance;
use crate::token::{Lexeme, Token, begins_item, declares, is_prefix, opens_block};

/// The tokens of one item.
pub(super) struct Run {
    pub(super) start: usize,
    pub(super) end: usize,
    /// Its outermost `{` that has no `}`.
    pub(super) open: Option<usize>,
}

/// The tokens of a text, and how deep in blocks they are read.
#[derive(Clone, Copy)]
pub(super) struct Cutter<'t> {
    pub(super) text: &'t str,
    pub(super) lexemes: &'t [Lexeme],
    pub(super) balance: &'t Balance,
    /// How many blocks are open.
    pub(super) depth: usize,
}

impl Cutter<'_> {
    /// The item that begins at a token: up to the next one, to its own closing brace or to that of its block.
    pub(super) fn cut(&self, start: usize) -> Run {
        let tokens = self.lexemes;
        let mut end = start + 1;
        let first = tokens[start].token;
        if first == Token::Child && tokens.get(end).is_some_and(|l| l.token == Token::Grafcet) {
            end += 1;
        }
        if opens_block(first) {
            while let Some(lexeme) = tokens.get(end) {
                match lexeme.token {
                    Token::OpenBrace => {
                        end += 1;
                        break;
                    }
                    Token::CloseBrace => break,
                    token if begins_item(token) => break,
                    _ => end += 1,
                }
            }
            return Run { start, end, open: None };
        }
        if is_prefix(first) {
            while tokens.get(end).is_some_and(|l| is_prefix(l.token)) {
                end += 1;
            }
            if tokens.get(end).is_some_and(|l| l.token == Token::Step) {
                end += 1;
            }
        }
        if first == Token::Retain && tokens.get(end).is_some_and(|l| declares(l.token)) {
            end += 1;
        }
        // How many braces are open, and the outermost.
        let (mut depth, mut outermost) = (0_usize, None);
        while let Some(lexeme) = tokens.get(end) {
            match lexeme.token {
                Token::OpenBrace => {
                    outermost = outermost.or(Some(end));
                    depth += 1;
                }
                Token::CloseBrace if depth == 0 => break,
                Token::CloseBrace => {
                    if depth == 1 && self.closes_the_block(start, end) {
                        break;
                    }
                    depth -= 1;
                    if depth == 0 {
                        return Run { start, end: end + 1, open: None };
                    }
                }
                Token::Initial if self.is_forced_situation(end) => {}
                token if begins_item(token) => break,
                _ => {}
            }
            end += 1;
        }
        Run { start, end, open: outermost }
    }

    /// Whether this is the whole of `{initial}` behind `force G1`: a mistake, but no item.
    fn is_forced_situation(&self, at: usize) -> bool {
        let token = |at: Option<usize>| at.and_then(|at| self.lexemes.get(at)).map(|lexeme| lexeme.token);
        token(at.checked_sub(3)) == Some(Token::Force) && token(Some(at + 1)) == Some(Token::CloseBrace)
    }

    /// Whether a `}` that could close an item's braces is rather its block's: one is missing further on, and this one
    /// is indented less than the item.
    fn closes_the_block(&self, item: usize, brace: usize) -> bool {
        let is_outdented =
            match (self.indentation(self.lexemes[brace].start), self.indentation(self.lexemes[item].start)) {
                (Some(brace), Some(item)) => brace < item,
                _ => false,
            };
        is_outdented && self.balance.from(brace) < self.depth as i64 + 1
    }

    /// The white space before a token that is the first on its line.
    fn indentation(&self, start: u32) -> Option<usize> {
        let before = &self.text.as_bytes()[..start as usize];
        let blanks = before.iter().rev().take_while(|b| matches!(b, b' ' | b'\t')).count();
        match before.len().checked_sub(blanks + 1) {
            None => Some(blanks),
            Some(at) => (before[at] == b'\n').then_some(blanks),
        }
    }
}
