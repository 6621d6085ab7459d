//! Which words an automaton has where. `automaton` begins a block where an item can begin and a name follows it, with or
//! without the step around it or a comment, up to its brace. Directly in its braces `state` begins a state and `arc` an arc,
//! where an item can begin and a label, or what else stands behind `step` and `transition`, follows. In the braces of an arc a
//! name that is not assigned to is an output.
//!
//! To what comes behind the lexer, an automaton is a grafcet of steps and transitions.

use crate::token::{Lexeme, Token, may_end_item};

/// The word that begins an automaton.
pub(crate) const AUTOMATON: &str = "automaton";

/// The automaton that is open, if one is.
#[derive(Default)]
pub(crate) struct Automaton {
    /// Its head was begun, its brace follows.
    is_begun: bool,
    /// Braces that are open in it, its own among them.
    braces: usize,
    /// The latest item directly in it is an arc.
    in_arc: bool,
}

impl Automaton {
    /// Begins one.
    pub(crate) fn begin(&mut self) {
        *self = Automaton { is_begun: true, ..Automaton::default() };
    }

    /// Whether its braces are open.
    pub(crate) fn is_open(&self) -> bool {
        self.braces > 0
    }

    /// What a name at a place is here, if it is a word or an output of an arc.
    pub(crate) fn word(&self, word: &str, lexemes: &[Lexeme], at: usize) -> Option<Token> {
        let token = |at: Option<usize>| at.and_then(|at| lexemes.get(at)).map(|lexeme| lexeme.token);
        let (last, next) = (token(at.checked_sub(1)), token(at.checked_add(1)));
        let label = matches!(next, Some(Token::Name | Token::Whole));
        let may_begin = last.is_none_or(may_end_item);
        match (word, self.braces) {
            ("state", 1) if label && (may_begin || matches!(last, Some(Token::Initial | Token::Activated))) => {
                Some(Token::Step)
            }
            ("arc", 1) if may_begin && (label || matches!(next, Some(Token::OpenParen | Token::String))) => {
                Some(Token::Transition)
            }
            (_, 2) if self.in_arc && may_begin && next != Some(Token::Assign) && last != Some(Token::AllowInside) => {
                Some(Token::OnArc)
            }
            _ => None,
        }
    }

    /// Another token was read.
    pub(crate) fn pass(&mut self, token: Token) {
        match token {
            Token::OpenBrace if self.is_begun || self.braces > 0 => {
                self.is_begun = false;
                self.braces += 1;
            }
            Token::CloseBrace => self.braces = self.braces.saturating_sub(1),
            Token::Transition => self.in_arc = true,
            Token::Step => self.in_arc = false,
            _ => {}
        }
    }
}

/// Whether `automaton` at a place begins one: what follows up to a brace is the head of a block.
pub(crate) fn begins(lexemes: &[Lexeme], at: usize) -> bool {
    // A path of names, and a comment.
    const HEAD: usize = 8;
    let may_begin = at.checked_sub(1).is_none_or(|before| may_end_item(lexemes[before].token));
    let head = lexemes[at + 1..].iter().map(|lexeme| lexeme.token).take(HEAD);
    let in_head = |token: &Token| matches!(token, Token::Name | Token::Slash | Token::String);
    let mut rest = head.clone().skip_while(in_head);
    may_begin && head.clone().next() == Some(Token::Name) && rest.next() == Some(Token::OpenBrace)
}
