//! Text to tokens.
//!
//! A token is a kind and a range of bytes; its text is read back from the source, so the author's spelling is never
//! lost. Comments are kept aside. Every fault is reported and the lexer goes on: a malformed name or number still gives
//! a token, so that the parser does not complain a second time, and wrong characters are left out.
//!
//! The patterns need no look-ahead beyond a few bytes, so the time is linear whatever the text is.

use crate::numeral;
use grafc_diagnostics::{Code, Diagnostic, FileId, Span};
use logos::Logos;

/// The kinds of token.
#[derive(Logos, Clone, Copy, PartialEq, Debug)]
#[logos(skip r"[\s\u{FEFF}]+")]
pub(crate) enum Token {
    #[token("chart")]
    Chart,
    #[token("input")]
    Input,
    #[token("output")]
    Output,
    #[token("var")]
    Var,
    #[token("const")]
    Const,
    #[token("grafcet")]
    Grafcet,
    #[token("expansion")]
    Expansion,
    #[token("step")]
    Step,
    #[token("transition")]
    Transition,
    #[token("initial")]
    Initial,
    #[token("activated")]
    Activated,
    #[token("enclosing")]
    Enclosing,
    #[token("macro")]
    Macro,
    #[token("if")]
    If,
    #[token("on")]
    On,
    #[token("force")]
    Force,
    #[token("true")]
    True,
    #[token("false")]
    False,
    #[token("and")]
    #[token("·")]
    #[token("⋅")]
    #[token("&")]
    And,
    #[token("or")]
    #[token("|")]
    Or,
    #[token("xor")]
    Xor,
    #[token("not")]
    #[token("!")]
    #[token("¬")]
    Not,
    #[token("rise")]
    #[token("↑")]
    Rise,
    #[token("fall")]
    #[token("↓")]
    Fall,
    #[token("mod")]
    Mod,
    #[token("+")]
    Plus,
    #[token("-")]
    Minus,
    #[token("*")]
    Star,
    #[token("/")]
    Slash,
    #[token("=")]
    Equal,
    #[token("<>")]
    #[token("≠")]
    NotEqual,
    #[token("<")]
    Less,
    #[token("<=")]
    #[token("≤")]
    LessEqual,
    #[token(">")]
    Greater,
    #[token(">=")]
    #[token("≥")]
    GreaterEqual,
    #[token(":=")]
    Assign,
    #[token(":")]
    Colon,
    #[token(",")]
    Comma,
    #[token("->")]
    #[token("→")]
    Arrow,
    #[token("(")]
    OpenParen,
    #[token(")")]
    CloseParen,
    #[token("[")]
    OpenBracket,
    #[token("]")]
    CloseBracket,
    #[token("{")]
    OpenBrace,
    #[token("}")]
    CloseBrace,

    /// A name, in backquotes or not.
    #[regex(r"[\p{L}_][\p{L}\p{M}\p{Nd}_]*")]
    #[regex(r"`[^`\r\n]*`?")]
    Name,
    /// An attached comment; a quotation mark in it is doubled.
    #[regex("\"([^\"\r\n]|\"\")*\"?")]
    String,
    /// `%IX0.0`
    #[regex(r"%[A-Za-z0-9_.*]*")]
    Address,
    /// `3`: decimal digits alone, a step label or a number.
    #[regex(r"[0-9]+", priority = 20)]
    Whole,
    /// Anything else that begins with a digit or with `T#`; [`lex`] makes one of the next four of it.
    #[regex(r"[0-9]([\p{L}\p{M}\p{Nd}_#]|\.[\p{L}\p{M}\p{Nd}_#])*", priority = 4)]
    #[regex(r"[0-9][0-9_]*(\.[0-9][0-9_]*)?[eE][+-][0-9_]+", priority = 6)]
    #[regex(r"([tT]|[tT][iI][mM][eE])#([\p{L}\p{M}\p{Nd}_#]|\.[\p{L}\p{M}\p{Nd}_#])*")]
    Numeral,
    /// `16#FF`, `1_000`
    Integer(i64),
    /// `8.5`
    Real(f64),
    /// `3s`, in milliseconds
    Duration(i64),
    /// A number or a duration that has been reported as malformed, or an expression that the parser gave up on.
    Unreadable,

    #[regex(r"//[^\n]*", allow_greedy = true)]
    LineComment,
    #[token("(*", block_comment)]
    BlockComment,

    // Words only where they have a meaning; elsewhere they are names.
    /// `activation` after `on`
    Activation,
    /// `deactivation` after `on`
    Deactivation,
    /// `event` after `on`
    Event,
    /// `at` before an address
    At,
    /// The end of an item; the parser puts it there.
    End,
}

/// A token and its place.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Lexeme {
    pub(crate) token: Token,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

/// What [`lex`] returns.
#[derive(Default)]
pub(crate) struct Lexed {
    /// The tokens, without comments.
    pub(crate) lexemes: Vec<Lexeme>,
    /// The comments.
    pub(crate) comments: Vec<Lexeme>,
    /// The faults, in order of place.
    pub(crate) faults: Vec<Diagnostic>,
    /// The places of all faults, also of those that are too many to be listed, in order.
    pub(crate) bad: Vec<(u32, u32)>,
}

/// Beyond so many faults of one kind a text is not a chart, and the rest is not listed.
pub(crate) const MOST_FAULTS: usize = 200;

/// Cuts a text into tokens.
pub(crate) fn lex(file: FileId, text: &str) -> Lexed {
    let mut out = Lexed::default();
    let mut tokens = Token::lexer(text);
    while let Some(result) = tokens.next() {
        let range = tokens.span();
        let slice = &text[range.clone()];
        let (start, end) = (range.start as u32, range.end as u32);
        let span = Span::new(file, range.start, range.end);
        let token = match result {
            Err(()) => {
                out.wrong_characters(file, text, start, end);
                continue;
            }
            Ok(Token::LineComment) => {
                let end = start + slice.trim_end().len() as u32;
                out.comments.push(Lexeme { token: Token::LineComment, start, end });
                continue;
            }
            Ok(Token::BlockComment) => {
                if !is_closed_comment(slice) {
                    let opening = Span::new(file, range.start, range.start + 2);
                    out.fault(span, unterminated_comment(opening));
                }
                out.comments.push(Lexeme { token: Token::BlockComment, start, end });
                continue;
            }
            Ok(Token::Name) if slice.starts_with('`') => {
                if slice.len() < 2 || !slice.ends_with('`') {
                    out.fault(
                        span,
                        Diagnostic::new(Code::E0104, span, "the name in backquotes does not end on its line")
                            .here("this backquote has no partner"),
                    );
                } else if slice.len() == 2 {
                    out.fault(span, Diagnostic::new(Code::E0104, span, "the name in backquotes is empty"));
                }
                Token::Name
            }
            Ok(Token::Name) if out.lexemes.last().is_some_and(|l| l.token == Token::On) => match slice {
                "activation" => Token::Activation,
                "deactivation" => Token::Deactivation,
                "event" => Token::Event,
                _ => Token::Name,
            },
            Ok(Token::String) => {
                if slice.bytes().filter(|b| *b == b'"').count() % 2 == 1 {
                    out.fault(
                        span,
                        Diagnostic::new(Code::E0103, span, "the string does not end on its line")
                            .here("this quotation mark has no partner")
                            .note("a quotation mark inside a string is doubled: `\"say \"\"go\"\"\"`"),
                    );
                }
                Token::String
            }
            Ok(Token::Address) => {
                if let Some(last) = out.lexemes.last_mut() {
                    if last.token == Token::Name && &text[last.start as usize..last.end as usize] == "at" {
                        last.token = Token::At;
                    }
                }
                Token::Address
            }
            Ok(Token::Numeral) => match numeral::read(slice) {
                Ok(token) => token,
                Err(fault) => {
                    out.fault(span, fault.diagnostic(span, slice));
                    Token::Unreadable
                }
            },
            Ok(token) => token,
        };
        out.lexemes.push(Lexeme { token, start, end });
    }
    out
}

impl Lexed {
    fn fault(&mut self, place: Span, diagnostic: Diagnostic) {
        self.bad.push((place.start, place.end));
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(diagnostic);
        }
    }

    /// Wrong characters in a run are one fault.
    fn wrong_characters(&mut self, file: FileId, text: &str, start: u32, end: u32) {
        let run = match self.bad.last() {
            Some(&(first, last)) if last == start => first,
            _ => {
                let span = Span::new(file, start as usize, end as usize);
                self.fault(span, Diagnostic::new(Code::E0101, span, String::new()));
                start
            }
        };
        let at = self.bad.len() - 1;
        self.bad[at].1 = end;
        let Some(fault) = self.faults.last_mut().filter(|f| f.primary.span.start == run) else { return };
        // The headline names the first characters only, so it need not be written again for a long run.
        if end - run <= 64 || fault.message.is_empty() {
            fault.message = unexpected_characters(&text[run as usize..end as usize]);
        }
        fault.primary.span.end = end;
        fault.help = cure(&text[run as usize..end as usize]).map(str::to_owned);
    }
}

/// Moves behind the `*)` that closes the comment, or to the end of the text. Comments nest.
fn block_comment(lexer: &mut logos::Lexer<'_, Token>) {
    let bytes = lexer.remainder().as_bytes();
    let mut depth = 1usize;
    let mut at = 0;
    while depth > 0 && at < bytes.len() {
        match &bytes[at..bytes.len().min(at + 2)] {
            b"(*" => {
                depth += 1;
                at += 2;
            }
            b"*)" => {
                depth -= 1;
                at += 2;
            }
            _ => at += 1,
        }
    }
    lexer.bump(at);
}

/// Whether a comment that [`block_comment`] read has its end, and not only the end of the text.
fn is_closed_comment(comment: &str) -> bool {
    let bytes = comment.as_bytes();
    let mut depth = 0usize;
    let mut at = 0;
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"(*" => {
                depth += 1;
                at += 2;
            }
            b"*)" => {
                depth -= 1;
                at += 2;
            }
            _ => at += 1,
        }
    }
    depth == 0
}

fn unterminated_comment(opening: Span) -> Diagnostic {
    Diagnostic::new(Code::E0102, opening, "the comment is never closed")
        .here("`*)` is missing for this")
        .note("comments nest: each `(*` needs its own `*)`")
}

fn unexpected_characters(run: &str) -> String {
    let mut characters = run.chars();
    match (characters.next(), characters.next()) {
        (Some(c), None) if c.is_control() || c.is_whitespace() || !c.is_ascii() => {
            format!("unexpected character {}(U+{:04X})", visible(c), c as u32)
        }
        (Some(c), None) => format!("unexpected character `{c}`"),
        _ => {
            let shown: String = run.chars().take(8).filter(|c| !c.is_control()).collect();
            let rest = if run.chars().nth(8).is_some() { "…" } else { "" };
            if shown.is_empty() {
                "unexpected characters".into()
            } else {
                format!("unexpected characters `{shown}{rest}`")
            }
        }
    }
}

fn visible(c: char) -> String {
    // Format characters such as U+200B would leave an empty pair of backquotes.
    if c.is_control() || ('\u{200B}'..='\u{200F}').contains(&c) || ('\u{2028}'..='\u{202F}').contains(&c) {
        String::new()
    } else {
        format!("`{c}` ")
    }
}

fn cure(run: &str) -> Option<&'static str> {
    match run {
        ";" => Some("leave it out: items and actions need no separator"),
        "∧" | "•" | "∙" => Some("write `and`, `·` or `&`"),
        "∨" => Some("write `or`, `+` or `|`"),
        "⊕" | "^" => Some("write `xor`"),
        "~" => Some("write `not`, `!` or `¬`"),
        "“" | "”" | "„" | "«" | "»" | "'" | "‘" | "’" => {
            Some("an attached comment stands in straight quotation marks: `\"…\"`")
        }
        "×" => Some("multiplication is written `*`"),
        "−" | "–" | "—" => Some("the minus sign is written `-`"),
        "÷" => Some("division is written `/`"),
        _ => None,
    }
}
