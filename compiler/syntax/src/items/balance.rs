//! The balance of braces over the rest of a text, which tells whether one is missing or one too many.

use crate::token::{Lexeme, Token};

/// For each brace of a text, how many more `}` than `{` there are from it on.
pub(super) struct Balance {
    /// The place of each among the tokens, and its balance.
    braces: Vec<(u32, i32)>,
}

impl Balance {
    pub(super) fn of(lexemes: &[Lexeme]) -> Balance {
        let mut braces = Vec::new();
        let mut sum = 0_i32;
        for (at, lexeme) in lexemes.iter().enumerate().rev() {
            // A text has fewer than 2^32 bytes; one with more braces than an `i32` counts is no chart.
            sum = match lexeme.token {
                Token::CloseBrace => sum.saturating_add(1),
                Token::OpenBrace => sum.saturating_sub(1),
                _ => continue,
            };
            braces.push((at as u32, sum));
        }
        braces.reverse();
        Balance { braces }
    }

    /// The balance from a token on.
    pub(super) fn from(&self, at: usize) -> i64 {
        let next = self.braces.partition_point(|(brace, _)| (*brace as usize) < at);
        self.braces.get(next).map_or(0, |(_, balance)| i64::from(*balance))
    }
}
