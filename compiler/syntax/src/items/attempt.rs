//! Runs the grammar over tokens: over one item, or over all that follow each other.

use super::cut::{Cutter, Run};
use crate::builder::{Builder, Parsed};
use crate::grammar::ItemsParser;
use crate::token::{Lexeme, Token, begins_item, may_stand_in_block, opens_block};
use lalrpop_util::ParseError;
use std::convert::Infallible;

/// Where the parser stopped.
pub(super) struct Stop {
    /// The token that it did not expect; [`Run::end`] if the item ended too early.
    pub(super) at: usize,
    pub(super) expected: Vec<String>,
}

type Spanned = (u32, Token, u32);

/// Parses the tokens of one item. A failure tells how many were read, and what was expected then.
pub(super) fn attempt(
    parser: &ItemsParser,
    builder: &mut Builder<'_>,
    lexemes: &[Lexeme],
    extra: &[Lexeme],
) -> Result<Parsed, (usize, Vec<String>)> {
    let mut read = 0usize;
    let end = extra.last().or(lexemes.last()).map_or(0, |l| l.end);
    let tokens = lexemes
        .iter()
        .chain(extra)
        .map(|l| (l.start, l.token, l.end))
        .chain(std::iter::once((end, Token::End, end)))
        .inspect(|_| read += 1);
    match parser.parse(builder, tokens).map_err(expected) {
        Ok(()) => builder.parsed.pop().ok_or((0, Vec::new())),
        Err(expected) => Err((read.saturating_sub(1).min(lexemes.len()), expected)),
    }
}

/// Parses all items that begin here and follow each other, up to one that opens a block or stands in a wrong place; what
/// they are is in `builder.parsed`. Gives back where the next token is, or the item that could not be read, and why.
///
/// This is the same as an [`attempt`] at each; it spares a parser for each.
pub(super) fn attempt_all(
    parser: &ItemsParser,
    builder: &mut Builder<'_>,
    cutter: Cutter<'_>,
    start: usize,
) -> Result<usize, (Run, Stop)> {
    let mut tokens = Tokens { cutter, run: Run { start, end: start, open: None }, next: start, ended: true };
    match parser.parse(builder, &mut tokens).map_err(expected) {
        Ok(()) => Ok(tokens.next),
        Err(expected) => {
            let at = if tokens.ended { tokens.run.end } else { tokens.next - 1 };
            Err((tokens.run, Stop { at, expected }))
        }
    }
}

/// Whether [`attempt_all`] takes the item that begins with this word.
pub(super) fn is_plain(token: Token, depth: usize) -> bool {
    begins_item(token) && token != Token::Chart && !opens_block(token) && (depth == 0 || may_stand_in_block(token))
}

/// The tokens of items, each item cut when it is reached, with its end behind it.
struct Tokens<'t> {
    cutter: Cutter<'t>,
    /// The item under way.
    run: Run,
    next: usize,
    /// Whether the end of the item has been given.
    ended: bool,
}

impl Iterator for Tokens<'_> {
    type Item = Spanned;

    fn next(&mut self) -> Option<Spanned> {
        let lexemes = self.cutter.lexemes;
        if self.ended {
            let lexeme = lexemes.get(self.next)?;
            if !is_plain(lexeme.token, self.cutter.depth) {
                return None;
            }
            self.run = self.cutter.cut(self.next);
            self.ended = false;
        } else if self.next == self.run.end {
            let end = lexemes[self.next - 1].end;
            self.ended = true;
            return Some((end, Token::End, end));
        }
        let lexeme = lexemes[self.next];
        self.next += 1;
        Some((lexeme.start, lexeme.token, lexeme.end))
    }
}

fn expected(error: ParseError<u32, Token, Infallible>) -> Vec<String> {
    match error {
        ParseError::UnrecognizedToken { expected, .. } | ParseError::UnrecognizedEof { expected, .. } => expected,
        ParseError::InvalidToken { .. } | ParseError::ExtraToken { .. } => Vec::new(),
        ParseError::User { error } => match error {},
    }
}
