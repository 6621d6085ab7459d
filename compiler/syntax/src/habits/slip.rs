//! The place where an item could not be read on, and what is around it.

use crate::expected::contains;
use crate::token::{Lexeme, Token};
use grafc_diagnostics::{FileId, Fix, Span};
use std::ops::Range;

/// Where an item could not be read on.
pub(crate) struct Slip<'a> {
    pub(crate) file: FileId,
    pub(crate) text: &'a str,
    pub(crate) lexemes: &'a [Lexeme],
    /// The tokens of the item.
    pub(crate) run: Range<usize>,
    /// The token that was not expected; there is one before it.
    pub(crate) at: usize,
    /// Whether it is there, and not the item that has ended too early.
    pub(crate) is_found: bool,
    pub(crate) expected: &'a [String],
}

/// A token in its place.
#[derive(Clone, Copy)]
pub(crate) struct Spot<'a> {
    pub(crate) token: Token,
    pub(crate) span: Span,
    pub(crate) word: &'a str,
}

/// What helps.
pub(crate) struct Cure {
    pub(crate) words: String,
    /// The same as a change of the text, if it is one.
    pub(crate) fix: Option<Fix>,
}

impl Cure {
    pub(super) fn new(words: impl Into<String>) -> Self {
        Cure::words(words)
    }

    /// Help that is no change of the text.
    pub(crate) fn words(words: impl Into<String>) -> Self {
        Cure { words: words.into(), fix: None }
    }

    pub(super) fn fix(self, fix: Fix) -> Self {
        Cure { fix: Some(fix), ..self }
    }

    /// Another text in a place.
    pub(crate) fn write(words: impl Into<String>, place: Span, instead: &str) -> Self {
        Cure::new(words).fix(Fix::certain(title(instead)).replace(place, instead))
    }

    /// As [`Cure::write`], where it is a guess.
    pub(crate) fn guess(words: impl Into<String>, place: Span, instead: &str) -> Self {
        Cure::new(words).fix(Fix::maybe(title(instead)).replace(place, instead))
    }

    pub(crate) fn leave_out(words: impl Into<String>, spot: Spot<'_>) -> Self {
        Cure::new(words).fix(Fix::certain(format!("leave out `{}`", spot.word)).delete(spot.span))
    }
}

/// What a fix does that puts a text in a place.
fn title(instead: &str) -> String {
    match instead.trim() {
        "" => "leave it out".to_owned(),
        instead => format!("write `{instead}`"),
    }
}

impl<'a> Slip<'a> {
    /// The word that the item begins with.
    pub(super) fn item(&self) -> Token {
        self.lexemes[self.run.start].token
    }

    /// The same in its place.
    pub(super) fn first(&self) -> Spot<'a> {
        self.of(self.lexemes[self.run.start])
    }

    /// The two tokens before the item, and the word that it begins with.
    pub(super) fn before_the_item(&self) -> Option<[Spot<'a>; 3]> {
        let start = self.run.start;
        let at = |offset: usize| Some(self.of(*self.lexemes.get(start.checked_sub(offset)?)?));
        Some([at(2)?, at(1)?, at(0)?])
    }

    /// A token of the item, counted from the one that was not expected.
    pub(super) fn spot(&self, offset: isize) -> Option<Spot<'a>> {
        let index = self.at.checked_add_signed(offset)?;
        let is_within = index >= self.run.start && (index < self.run.end || offset == 0);
        if !is_within || offset >= 0 && !self.is_found {
            return None;
        }
        self.lexemes.get(index).map(|&lexeme| self.of(lexeme))
    }

    fn of(&self, lexeme: Lexeme) -> Spot<'a> {
        let span = Span { file: self.file, start: lexeme.start, end: lexeme.end };
        Spot { token: lexeme.token, span, word: &self.text[span.range()] }
    }

    pub(super) fn found(&self) -> Option<Spot<'a>> {
        self.spot(0)
    }

    pub(super) fn previous(&self) -> Spot<'a> {
        self.of(self.lexemes[self.at - 1])
    }

    pub(super) fn token(&self, offset: isize) -> Option<Token> {
        self.spot(offset).map(|spot| spot.token)
    }

    /// The tokens from an offset on.
    pub(super) fn from(&self, offset: isize) -> impl Iterator<Item = Spot<'a>> {
        (offset..).map_while(|offset| self.spot(offset))
    }

    /// The last token of the item.
    pub(super) fn last(&self) -> Spot<'a> {
        self.of(self.lexemes[self.run.end - 1])
    }

    pub(super) fn has(&self, terminal: &str) -> bool {
        contains(self.expected, terminal)
    }

    /// Whether what was read ends a condition, and an operator could follow. Whatever has been reduced, behind an
    /// operand `+` is possible; in arithmetic `-` is then possible as well.
    pub(super) fn ends_condition(&self) -> bool {
        self.has("+") && !self.has("-")
    }

    /// The same of arithmetic.
    pub(super) fn ends_arithmetic(&self) -> bool {
        self.has("or") && !self.ends_condition()
    }

    pub(super) fn ends_operand(&self) -> bool {
        self.has("or")
    }

    /// Whether a condition, or an operand of one, should begin here.
    pub(super) fn begins_condition(&self) -> bool {
        self.has("not") && !self.has("-")
    }

    /// The same of conditions and values.
    pub(super) fn begins_operand(&self) -> bool {
        self.has("not")
    }

    /// Whether nothing is between a token and the one behind it.
    pub(super) fn touches(&self, offset: isize) -> bool {
        match (self.spot(offset), self.spot(offset + 1)) {
            (Some(left), Some(right)) => left.span.end == right.span.start,
            _ => false,
        }
    }

    /// Whether two neighbours stand on one line.
    pub(super) fn on_one_line(&self, left: Spot<'_>, right: Spot<'_>) -> bool {
        !self.between(left, right).contains('\n')
    }

    pub(super) fn is_first_on_line(&self, spot: Spot<'_>) -> bool {
        let before = &self.text[..spot.span.start as usize];
        before.trim_end_matches([' ', '\t']).chars().next_back().is_none_or(|c| c == '\n')
    }

    fn between(&self, left: Spot<'_>, right: Spot<'_>) -> &'a str {
        &self.text[left.span.end.min(right.span.start) as usize..right.span.start as usize]
    }

    /// The text from one token to another.
    pub(super) fn slice(&self, from: Spot<'_>, to: Spot<'_>) -> &'a str {
        &self.text[from.span.to(to.span).range()]
    }

    /// Whether the item's braces are open here.
    pub(super) fn is_in_braces(&self) -> bool {
        self.lexemes[self.run.start..self.at].iter().any(|lexeme| lexeme.token == Token::OpenBrace)
    }

    pub(super) fn is_in_step(&self) -> bool {
        matches!(self.item(), Token::Step | Token::Initial | Token::Activated | Token::Enclosing | Token::Macro)
    }

    /// Whether an action of a step stands here.
    pub(super) fn is_in_actions(&self) -> bool {
        self.is_in_step() && self.is_in_braces()
    }

    /// Whether an assignment of a transition stands here.
    pub(super) fn is_in_clearing(&self) -> bool {
        self.item() == Token::Transition && self.is_in_braces()
    }

    /// The label of the step whose activity a time is counted from: that of the step itself, or the only one before a
    /// transition.
    pub(super) fn own_step(&self) -> Option<&'a str> {
        let read = &self.lexemes[self.run.start..self.at];
        let label = if self.is_in_step() {
            read.get(read.iter().position(|lexeme| lexeme.token == Token::Step)? + 1)?
        } else {
            let arrow = read.iter().position(|lexeme| lexeme.token == Token::Arrow)?;
            if arrow >= 2 && read[arrow - 2].token == Token::Comma {
                return None;
            }
            read.get(arrow.checked_sub(1)?)?
        };
        matches!(label.token, Token::Name | Token::Whole)
            .then(|| self.of(*label).word)
            .filter(|word| !word.starts_with('`'))
    }
}

impl Spot<'_> {
    pub(super) fn is_name(self) -> bool {
        self.token == Token::Name
    }

    pub(super) fn is_label(self) -> bool {
        matches!(self.token, Token::Name | Token::Whole)
    }

    /// Whether it is an operand by itself.
    pub(super) fn is_operand(self) -> bool {
        use Token::*;
        matches!(self.token, Name | Whole | Integer | Real | Duration | True | False)
    }

    /// Whether an operand ends with it.
    pub(super) fn closes_operand(self) -> bool {
        self.is_operand() || matches!(self.token, Token::CloseParen | Token::CloseBracket)
    }

    /// Whether an operand begins with it.
    pub(super) fn opens_operand(self) -> bool {
        use Token::*;
        self.is_operand() || matches!(self.token, OpenParen | OpenBracket | Not | Rise | Fall)
    }

    /// Whether it is one of these words, in any case.
    pub(super) fn is_one_of(self, words: &[&str]) -> bool {
        self.is_name() && words.iter().any(|word| word.to_lowercase() == self.word.to_lowercase())
    }
}
