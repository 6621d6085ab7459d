//! What is kept of an item that cannot be read.
//!
//! The part before the mistake is often an item by itself. Keeping it spares the author messages about steps and names
//! that are there.

use super::attempt::{Stop, attempt};
use super::cut::Run;
use super::reader::Reader;
use crate::ast;
use crate::automaton::AUTOMATON;
use crate::builder::Parsed;
use crate::token::{Lexeme, Token};

impl Reader<'_> {
    /// What can be kept of an item that has a fault: the part before it, with an unreadable condition if need be.
    pub(super) fn salvage(&mut self, run: &Run, stop: &Stop) -> Option<Parsed> {
        let find = |token: Token| {
            let lexemes = &self.lexed.lexemes[run.start..stop.at];
            lexemes.iter().position(|l| l.token == token).map(|at| run.start + at)
        };
        let first = self.lexed.lexemes[run.start].token;
        let here = self.lexed.lexemes[stop.at - 1].end;
        let synthetic = |token| Lexeme { token, start: here, end: here };
        let mut tries: Vec<(usize, Vec<Lexeme>)> = Vec::new();
        match first {
            Token::Grafcet | Token::Expansion | Token::Child => {
                // Its items follow if it has a brace, or if there is a brace that closes it.
                let has_brace = self.lexed.lexemes[run.end - 1].token == Token::OpenBrace;
                if !has_brace && self.balance(run.end) <= self.stack.len() as i64 {
                    return None;
                }
                tries.push((stop.at, vec![synthetic(Token::OpenBrace)]));
            }
            Token::Transition => {
                tries.extend(find(Token::OpenBrace).map(|at| (at, Vec::new())));
                tries.extend(find(Token::Colon).map(|at| (at + 1, vec![synthetic(Token::Unreadable)])));
            }
            // A constant keeps a value, if one is written that cannot be read.
            Token::Const if find(Token::Assign).is_some() || self.token_at(stop.at) == Some(Token::Equal) => {
                tries.extend(find(Token::Assign).map(|at| (at + 1, vec![synthetic(Token::Unreadable)])));
                tries.push((stop.at, vec![synthetic(Token::Assign), synthetic(Token::Unreadable)]));
                tries.push((stop.at, Vec::new()));
            }
            _ => {
                tries.extend(find(Token::OpenBrace).map(|at| (at, Vec::new())));
                tries.extend(find(Token::Assign).map(|at| (at, Vec::new())));
                tries.extend(find(Token::At).map(|at| (at, Vec::new())));
                tries.push((stop.at, Vec::new()));
            }
        }
        let arena = self.builder.exprs.len();
        self.builder.is_silent = true;
        let kept = tries.into_iter().find_map(|(end, extra)| {
            let lexemes = &self.lexed.lexemes[run.start..end];
            let parsed = attempt(&self.parser, &mut self.builder, lexemes, &extra).ok();
            if parsed.is_none() {
                self.builder.discard(arena);
            }
            parsed
        });
        self.builder.is_silent = false;
        kept.or_else(|| self.nameless(run))
    }

    fn token_at(&self, at: usize) -> Option<Token> {
        self.lexed.lexemes.get(at).map(|lexeme| lexeme.token)
    }

    /// A block whose head could not be read still has items.
    pub(super) fn nameless(&self, run: &Run) -> Option<Parsed> {
        let head = self.lexed.lexemes[run.start];
        let span = self.builder.span(head.start, head.end);
        let name = ast::Name { text: "".into(), quoted: false, span };
        match head.token {
            Token::Grafcet | Token::Child => {
                let automaton = self.builder.slice(head.start, head.end) == AUTOMATON;
                let (path, items) = (Vec::new(), Vec::new());
                let grafcet = ast::Grafcet { automaton, path, name, parent: None, comment: None, items, span };
                Some(Parsed::Grafcet(Box::new(grafcet)))
            }
            Token::Expansion => {
                let expansion = ast::Expansion { macro_step: name, comment: None, items: Vec::new(), span };
                Some(Parsed::Expansion(Box::new(expansion)))
            }
            _ => None,
        }
    }

    /// After a faulty item: leaves out a `}` whose `{` was forgotten.
    pub(super) fn skip_partner(&mut self, run: &Run) {
        let lexemes = &self.lexed.lexemes;
        let next_closes = lexemes.get(run.end).is_some_and(|l| l.token == Token::CloseBrace);
        let has_brace = lexemes[run.start..run.end].iter().any(|l| l.token == Token::OpenBrace);
        if next_closes && !has_brace && self.balance(run.end) > self.stack.len() as i64 {
            self.at = run.end + 1;
        }
    }
}
