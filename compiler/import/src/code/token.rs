//! Words and signs of the languages of IEC 61131-3, which Structured Text, instruction lists, declarations and the
//! textual form of sequential function charts share.
//!
//! Keywords are told from names without regard to case, and only where a name has no point before it: a variable may
//! have a member that is called `step`. Comments and pragmas are no tokens.

use super::source::Source;
use logos::Logos;
use std::ops::Range;

/// A word or sign.
#[derive(Logos, Clone, Copy, PartialEq, Eq, Debug)]
#[logos(skip r"[ \t\r\n\f\u{feff}]+")]
pub enum Token {
    #[regex(r"[\p{L}_][\p{L}\p{N}_]*", priority = 3)]
    Name,
    #[regex(r"[0-9][0-9_]*", priority = 4)]
    #[regex(r"(2|8|16)#[0-9A-Fa-f_]+")]
    Integer,
    #[regex(r"[0-9][0-9_]*\.[0-9][0-9_]*([eE][+-]?[0-9]+)?")]
    #[regex(r"[0-9][0-9_]*[eE][+-]?[0-9]+")]
    Real,
    /// `T#2s`, `INT#5`, `Colour#Red`.
    #[regex(r"[\p{L}_][\p{L}\p{N}_]*#[+-]?[\p{L}\p{N}_.#]+")]
    Typed,
    #[regex(r"'([^'$\n]|\$.)*'")]
    #[regex(r#""([^"$\n]|\$.)*""#)]
    Text,
    #[regex(r"%[A-Za-z]*\*?[0-9.]*")]
    Address,
    #[token(":=")]
    Assign,
    #[token("=>")]
    Gives,
    #[token(":")]
    Colon,
    #[token(";")]
    Semicolon,
    #[token(",")]
    Comma,
    #[token("..")]
    Range,
    #[token(".")]
    Point,
    #[token("(")]
    OpenParen,
    #[token(")")]
    CloseParen,
    #[token("[")]
    OpenBracket,
    #[token("]")]
    CloseBracket,
    #[token("+")]
    Plus,
    #[token("-")]
    Minus,
    #[token("**")]
    Power,
    #[token("*")]
    Star,
    #[token("/")]
    Slash,
    #[token("=")]
    #[token("==")]
    Equal,
    #[token("<>")]
    #[token("!=")]
    NotEqual,
    #[token("<")]
    Less,
    #[token("<=")]
    LessEqual,
    #[token(">")]
    Greater,
    #[token(">=")]
    GreaterEqual,
    #[token("&")]
    Ampersand,
    #[token("^")]
    Caret,
    #[token("(*", |lex| to_end(lex, "*)"))]
    #[token("/*", |lex| to_end(lex, "*/"))]
    #[token("{", |lex| to_end(lex, "}"))]
    #[regex(r"//[^\n]*", allow_greedy = true)]
    Comment,
    And,
    Or,
    Xor,
    Not,
    Mod,
    True,
    False,
    /// A word of statements, declarations or charts.
    Keyword(Keyword),
    /// What is none of these.
    Wrong,
}

/// Words that structure a text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Keyword {
    If,
    Then,
    Elsif,
    Else,
    EndIf,
    Case,
    Of,
    EndCase,
    For,
    While,
    Repeat,
    EndFor,
    EndWhile,
    EndRepeat,
    Return,
    Exit,
    Step,
    InitialStep,
    EndStep,
    Transition,
    EndTransition,
    Action,
    EndAction,
    From,
    To,
    Program,
    EndProgram,
    FunctionBlock,
    EndFunctionBlock,
    Function,
    EndFunction,
    Type,
    EndType,
    Struct,
    EndStruct,
    Var,
    VarInput,
    VarOutput,
    VarInOut,
    VarExternal,
    VarGlobal,
    VarTemp,
    EndVar,
    At,
    Configuration,
    EndConfiguration,
}

/// The words and what they are, in capitals.
const WORDS: &[(&str, Token)] = &[
    ("AND", Token::And),
    ("AND_THEN", Token::And),
    ("OR", Token::Or),
    ("OR_ELSE", Token::Or),
    ("XOR", Token::Xor),
    ("NOT", Token::Not),
    ("MOD", Token::Mod),
    ("TRUE", Token::True),
    ("FALSE", Token::False),
    ("IF", Token::Keyword(Keyword::If)),
    ("THEN", Token::Keyword(Keyword::Then)),
    ("ELSIF", Token::Keyword(Keyword::Elsif)),
    ("ELSE", Token::Keyword(Keyword::Else)),
    ("END_IF", Token::Keyword(Keyword::EndIf)),
    ("CASE", Token::Keyword(Keyword::Case)),
    ("OF", Token::Keyword(Keyword::Of)),
    ("END_CASE", Token::Keyword(Keyword::EndCase)),
    ("FOR", Token::Keyword(Keyword::For)),
    ("WHILE", Token::Keyword(Keyword::While)),
    ("REPEAT", Token::Keyword(Keyword::Repeat)),
    ("END_FOR", Token::Keyword(Keyword::EndFor)),
    ("END_WHILE", Token::Keyword(Keyword::EndWhile)),
    ("END_REPEAT", Token::Keyword(Keyword::EndRepeat)),
    ("RETURN", Token::Keyword(Keyword::Return)),
    ("EXIT", Token::Keyword(Keyword::Exit)),
    ("STEP", Token::Keyword(Keyword::Step)),
    ("INITIAL_STEP", Token::Keyword(Keyword::InitialStep)),
    ("END_STEP", Token::Keyword(Keyword::EndStep)),
    ("TRANSITION", Token::Keyword(Keyword::Transition)),
    ("END_TRANSITION", Token::Keyword(Keyword::EndTransition)),
    ("ACTION", Token::Keyword(Keyword::Action)),
    ("END_ACTION", Token::Keyword(Keyword::EndAction)),
    ("FROM", Token::Keyword(Keyword::From)),
    ("TO", Token::Keyword(Keyword::To)),
    ("PROGRAM", Token::Keyword(Keyword::Program)),
    ("END_PROGRAM", Token::Keyword(Keyword::EndProgram)),
    ("FUNCTION_BLOCK", Token::Keyword(Keyword::FunctionBlock)),
    ("END_FUNCTION_BLOCK", Token::Keyword(Keyword::EndFunctionBlock)),
    ("FUNCTION", Token::Keyword(Keyword::Function)),
    ("END_FUNCTION", Token::Keyword(Keyword::EndFunction)),
    ("TYPE", Token::Keyword(Keyword::Type)),
    ("END_TYPE", Token::Keyword(Keyword::EndType)),
    ("STRUCT", Token::Keyword(Keyword::Struct)),
    ("END_STRUCT", Token::Keyword(Keyword::EndStruct)),
    ("VAR", Token::Keyword(Keyword::Var)),
    ("VAR_INPUT", Token::Keyword(Keyword::VarInput)),
    ("VAR_OUTPUT", Token::Keyword(Keyword::VarOutput)),
    ("VAR_IN_OUT", Token::Keyword(Keyword::VarInOut)),
    ("VAR_EXTERNAL", Token::Keyword(Keyword::VarExternal)),
    ("VAR_GLOBAL", Token::Keyword(Keyword::VarGlobal)),
    ("VAR_TEMP", Token::Keyword(Keyword::VarTemp)),
    ("VAR_STAT", Token::Keyword(Keyword::Var)),
    ("END_VAR", Token::Keyword(Keyword::EndVar)),
    ("AT", Token::Keyword(Keyword::At)),
    ("CONFIGURATION", Token::Keyword(Keyword::Configuration)),
    ("END_CONFIGURATION", Token::Keyword(Keyword::EndConfiguration)),
];

/// The longest of the words.
const LONGEST: usize = 18;

/// A token and where it stands in its text.
#[derive(Clone, Copy, Debug)]
pub struct Lexeme {
    pub token: Token,
    pub start: usize,
    pub end: usize,
}

impl Lexeme {
    /// Where it stands.
    pub fn range(&self) -> Range<usize> {
        self.start..self.end
    }
}

/// Cuts a text into tokens, comments left out.
pub fn lex(source: &Source) -> Vec<Lexeme> {
    let text = source.text.as_str();
    let mut out: Vec<Lexeme> = Vec::new();
    let mut tokens = Token::lexer(text);
    while let Some(result) = tokens.next() {
        let Range { start, end } = tokens.span();
        let token = match result {
            Ok(Token::Comment) => continue,
            Ok(Token::Name) if !out.last().is_some_and(|last| last.token == Token::Point) => word(&text[start..end]),
            Ok(token) => token,
            Err(()) => Token::Wrong,
        };
        out.push(Lexeme { token, start, end });
    }
    out
}

/// A word as a keyword, or else as a name.
fn word(text: &str) -> Token {
    if text.len() > LONGEST {
        return Token::Name;
    }
    WORDS.iter().find(|(word, _)| word.eq_ignore_ascii_case(text)).map_or(Token::Name, |(_, token)| *token)
}

/// Skips to what ends a comment, or to the end of the text.
fn to_end(lex: &mut logos::Lexer<Token>, end: &str) {
    let rest = lex.remainder();
    let length = rest.find(end).map_or(rest.len(), |at| at + end.len());
    lex.bump(length);
}

#[cfg(test)]
mod tests {
    use super::*;
    use grafc_diagnostics::FileId;

    fn tokens(text: &str) -> Vec<Token> {
        lex(&Source::of_range(FileId::default(), text, 0..text.len())).into_iter().map(|lexeme| lexeme.token).collect()
    }

    #[test]
    fn words_signs_and_literals() {
        use Token::*;
        assert_eq!(tokens("a := T#2s; (* x *) // y"), [Name, Assign, Typed, Semicolon]);
        assert_eq!(tokens("Step0.t >= T#1m_30s"), [Name, Point, Name, GreaterEqual, Typed]);
        assert_eq!(tokens("1..5 16#FF 2.5e-3 %IX0.0"), [Integer, Range, Integer, Integer, Real, Address]);
        assert_eq!(tokens("not b Or x.step"), [Not, Name, Or, Name, Point, Name]);
        assert_eq!(tokens("(* never ends"), []);
        assert_eq!(tokens("a ? b"), [Name, Wrong, Name]);
        assert_eq!(WORDS.iter().map(|(word, _)| word.len()).max(), Some(LONGEST));
    }
}
