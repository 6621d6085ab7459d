//! Goes through the tokens of a text.

use crate::code::source::Source;
use crate::code::token::{Keyword, Lexeme, Token, lex};
use crate::code::tree::Code;
use crate::sfc::{ByName, Unit};
use grafc_diagnostics::{Code as ErrorCode, Diagnostic, Diagnostics, FileId, Span};
use std::ops::Range;

/// A text in work.
pub struct Reader<'a> {
    file: FileId,
    text: &'a str,
    pub code: &'a mut Code,
    pub diagnostics: &'a mut Diagnostics,
    lexemes: Vec<Lexeme>,
    pub at: usize,
}

impl<'a> Reader<'a> {
    /// Begins with a text.
    pub fn new(file: FileId, text: &'a str, code: &'a mut Code, diagnostics: &'a mut Diagnostics) -> Self {
        let lexemes = lex(&Source::of_range(file, text, 0..text.len()));
        Reader { file, text, code, diagnostics, lexemes, at: 0 }
    }

    /// The token here.
    pub fn token(&self) -> Option<Token> {
        self.lexemes.get(self.at).map(|lexeme| lexeme.token)
    }

    /// Goes to the next.
    pub fn advance(&mut self) {
        self.at += 1;
    }

    /// Takes a token if it is here.
    pub fn take(&mut self, token: Token) -> bool {
        let found = self.token() == Some(token);
        self.at += usize::from(found);
        found
    }

    /// Takes a word, which in its place is a name even if it means something elsewhere.
    pub fn word(&mut self) -> Option<&'a str> {
        let lexeme = self.lexemes.get(self.at)?;
        let is_word = matches!(lexeme.token, Token::Name | Token::Integer)
            || matches!(lexeme.token, Token::Keyword(k) if !ends(k));
        self.at += usize::from(is_word);
        is_word.then(|| &self.text[lexeme.range()])
    }

    /// The place of the token here, or of the last.
    pub fn span(&self) -> Span {
        let lexeme = self.lexemes.get(self.at).or(self.lexemes.last());
        self.place(lexeme.map_or(0..0, Lexeme::range))
    }

    /// A range of the text as a place.
    pub fn place(&self, range: Range<usize>) -> Span {
        Span::new(self.file, range.start, range.end)
    }

    /// The tokens from here up to a word, which is left behind; whether it is there.
    pub fn up_to(&mut self, end: Keyword) -> (Range<usize>, bool) {
        let begin = self.at;
        let rest = &self.lexemes[begin.min(self.lexemes.len())..];
        let length = rest.iter().position(|lexeme| lexeme.token == Token::Keyword(end));
        let stop = begin + length.unwrap_or(rest.len());
        self.at = stop + usize::from(length.is_some());
        (begin..stop, length.is_some())
    }

    /// Skips what ends with a word.
    pub fn skip_to(&mut self, end: Keyword) {
        self.up_to(end);
    }

    /// The text of some tokens.
    pub fn source(&self, tokens: Range<usize>) -> Source {
        let lexemes = self.lexemes.get(tokens.start..tokens.end.min(self.lexemes.len())).unwrap_or_default();
        match (lexemes.first(), lexemes.last()) {
            (Some(first), Some(last)) => Source::of_range(self.file, self.text, first.start..last.end),
            _ => Source::empty(self.span()),
        }
    }

    /// The token at a place in the list.
    pub fn token_at(&self, at: usize) -> Option<Token> {
        self.lexemes.get(at).map(|lexeme| lexeme.token)
    }

    /// The text of the token at a place in the list.
    pub fn text_at(&self, at: usize) -> &'a str {
        self.lexemes.get(at).map_or("", |lexeme| &self.text[lexeme.range()])
    }

    /// Reports an element that cannot be.
    pub fn malformed(&mut self, span: Span, message: impl Into<String>, help: &str) {
        self.diagnostics.push(Diagnostic::new(ErrorCode::E0705, span, message).help(help));
    }

    /// The head of a unit.
    pub fn unit(&mut self) -> Option<Unit> {
        self.advance();
        let span = self.span();
        let Some(name) = self.word() else {
            self.malformed(span, "a program organisation unit has no name", "write its name behind the keyword");
            return None;
        };
        Some(Unit {
            name: name.to_string(),
            span,
            variables: ByName::default(),
            actions: ByName::default(),
            chart: None,
        })
    }
}

/// Whether a word ends an element, so that no name can be meant.
fn ends(keyword: Keyword) -> bool {
    use Keyword::{
        EndAction, EndConfiguration, EndFunction, EndFunctionBlock, EndProgram, EndStep, EndTransition, EndType,
        EndVar, From, To,
    };
    matches!(
        keyword,
        EndAction
            | EndConfiguration
            | EndFunction
            | EndFunctionBlock
            | EndProgram
            | EndStep
            | EndTransition
            | EndType
            | EndVar
            | From
            | To
    )
}
