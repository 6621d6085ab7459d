//! Which words a scenario has where: `until`, and `after` before a time, begin a line, except where a name must stand. Behind
//! `until` all is a condition, up to `within` before a time.

use crate::token::{Token, begins_item, may_end_item};

/// The scenario that is open, if one is.
#[derive(Default)]
pub(crate) struct Scenario {
    /// `scenario` was read, and its braces are not closed.
    is_begun: bool,
    /// Braces that are open in it.
    braces: usize,
    /// Whether what comes is a condition that is waited for.
    in_condition: bool,
}

impl Scenario {
    /// Whether its braces are open.
    pub(crate) fn is_open(&self) -> bool {
        self.braces > 0
    }

    /// What a name between these tokens is here, if it is a word.
    pub(crate) fn word(&self, word: &str, last: Option<Token>, next: Option<Token>) -> Option<Token> {
        let name_follows = matches!(last, Some(Token::Comma | Token::Arrow | Token::Not));
        match word {
            "within" if self.in_condition => {
                let ends = last.is_some_and(may_end_item);
                (ends && next == Some(Token::Duration)).then_some(Token::Within)
            }
            "until" if !self.in_condition && !name_follows => (next != Some(Token::Equal)).then_some(Token::Until),
            "after" if !self.in_condition && !name_follows => (next == Some(Token::Duration)).then_some(Token::After),
            _ => None,
        }
    }

    /// Another token was read.
    pub(crate) fn pass(&mut self, token: Token) {
        match token {
            Token::Scenario => *self = Scenario { is_begun: true, ..Scenario::default() },
            _ if !self.is_begun => {}
            Token::OpenBrace => self.braces += 1,
            Token::CloseBrace => {
                self.braces = self.braces.saturating_sub(1);
                if self.braces == 0 {
                    *self = Scenario::default();
                }
            }
            Token::Until => self.in_condition = true,
            Token::Within => self.in_condition = false,
            // No item begins within the braces of another: one is missing.
            token if begins_item(token) => *self = Scenario::default(),
            _ => {}
        }
    }
}
