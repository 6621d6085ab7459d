//! Words that are words of the language in some places only, and names in all others, so that a chart that uses them as
//! names stays correct.
//!
//! `allow` begins an item where a name follows it: outside of the braces of steps and transitions no two names follow
//! each other. In these braces two names are two actions, but no string follows a name there, so `allow W0409 "reason"`
//! cannot be anything else.

use crate::token::{Lexeme, Token, begins_item, may_end_item};

/// Finds the words among the names.
pub(crate) fn words(text: &str, lexemes: &mut [Lexeme]) {
    let mut braces = Braces::default();
    for at in 0..lexemes.len() {
        let (before, rest) = lexemes.split_at_mut(at);
        let Some((lexeme, after)) = rest.split_first_mut() else { break };
        if lexeme.token == Token::Name && &text[lexeme.start as usize..lexeme.end as usize] == "allow" {
            let follows = |n: usize, token: Token| after.get(n).is_some_and(|next| next.token == token);
            let with_reason = follows(0, Token::Name)
                && (follows(1, Token::String) || follows(1, Token::Name) && follows(2, Token::String));
            let may_begin = before.last().is_none_or(|last| may_end_item(last.token));
            if braces.of_items > 0 && with_reason {
                lexeme.token = Token::AllowInside;
            } else if braces.of_items == 0 && follows(0, Token::Name) && may_begin {
                lexeme.token = Token::Allow;
            }
        }
        braces.pass(lexeme.token);
    }
}

/// The braces that are open.
#[derive(Default)]
pub(crate) struct Braces {
    /// The head of a grafcet or an expansion was read, its brace follows.
    in_head_of_block: bool,
    /// Those of steps, transitions and forced situations.
    pub(crate) of_items: usize,
}

impl Braces {
    pub(crate) fn pass(&mut self, token: Token) {
        match token {
            Token::Grafcet | Token::Expansion => *self = Braces { in_head_of_block: true, of_items: 0 },
            Token::OpenBrace if self.in_head_of_block => self.in_head_of_block = false,
            Token::OpenBrace => self.of_items += 1,
            // That of a block, if no other is open.
            Token::CloseBrace => self.of_items = self.of_items.saturating_sub(1),
            // No item begins within the braces of another: one is missing.
            token if begins_item(token) => *self = Braces::default(),
            _ => {}
        }
    }
}
