//! The kinds of token, and a token in its place.
//!
//! A token is a kind and a range of bytes; its text is read back from the source, so the author's spelling is never lost.

use logos::Logos;

/// The kinds of token.
#[derive(Logos, Clone, Copy, PartialEq, Eq, Debug)]
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

    // Words only where they begin an item; elsewhere they are names. They stand here since of many tokens is asked whether
    // an item begins with them, which is one comparison if all that do are neighbours.
    /// `retain` before the keyword of a declaration
    Retain,
    /// `allow`, as an item
    Allow,
    /// `assume`, as an item
    Assume,
    /// `assert`, as an item
    Assert,
    /// `reach`, as an item
    Reach,
    /// `final`, as an item
    Final,
    /// `scenario`, as an item
    Scenario,

    #[token("if")]
    If,
    #[token("on")]
    On,
    #[token("force")]
    Force,
    #[token("true")]
    #[token("TRUE")]
    True,
    #[token("false")]
    #[token("FALSE")]
    False,
    #[token("and")]
    #[token("AND")]
    #[token("·")]
    #[token("⋅")]
    #[token("&")]
    And,
    #[token("or")]
    #[token("OR")]
    #[token("|")]
    Or,
    #[token("xor")]
    #[token("XOR")]
    Xor,
    #[token("not")]
    #[token("NOT")]
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
    /// Anything else that begins with a digit or with `T#`; the lexer makes one of the next four of it.
    #[regex(r"[0-9]([\p{L}\p{M}\p{Nd}_#]|\.[\p{L}\p{M}\p{Nd}_#])*", priority = 4)]
    #[regex(r"[0-9][0-9_]*(\.[0-9][0-9_]*)?[eE][+-][0-9_]+", priority = 6)]
    #[regex(r"([tT]|[tT][iI][mM][eE])#([\p{L}\p{M}\p{Nd}_#]|\.[\p{L}\p{M}\p{Nd}_#])*")]
    Numeral,
    /// `16#FF`, `1_000`
    Integer,
    /// `8.5`
    Real,
    /// `3s`
    Duration,
    /// A number or a duration that has been reported as malformed, or an expression that the parser gave up on.
    Unreadable,

    #[regex(r"//[^\n]*", allow_greedy = true)]
    LineComment,
    #[token("(*", block_comment)]
    BlockComment,
    /// `/* … */`, which is none of our comments, but was meant as one.
    #[token("/*", foreign_comment)]
    ForeignComment,

    // Words only where they have a meaning; elsewhere they are names.
    /// `activation` after `on`
    Activation,
    /// `deactivation` after `on`
    Deactivation,
    /// `event` after `on`
    Event,
    /// `at` before an address
    At,
    /// `allow` in the braces of a step or transition
    AllowInside,
    /// `at` of `at most one of`, in a claim
    AtMost,
    /// `most` of `at most one of`
    Most,
    /// `one` of `at most one of`
    One,
    /// `of` of `at most one of`
    Of,
    /// `after`, in a claim, and before a time in a scenario
    After,
    /// `leads` of `leads to`, in a claim
    Leads,
    /// `to` of `leads to`
    LeadsTo,
    /// `until` in a scenario
    Until,
    /// `within` before the time of `until`
    Within,
    /// `evolution` in the heading of the chart
    Evolution,
    /// `initial_actions` in the heading
    InitialActions,
    /// `bound` in the heading
    Bound,
    /// `each` of `each scan`
    Each,
    /// `scan` of `each scan`
    Scan,
    /// `child` before `grafcet`
    Child,
    /// `start`, before the grafcet of a pulse order
    Start,
    /// `kill`, before the grafcet of a pulse order
    Kill,
    /// `freeze`, before the grafcet of a pulse order
    Freeze,
    /// `resume`, before the grafcet of a pulse order
    Resume,
    /// `run`, before the grafcet that runs while the step is active
    Run,
    /// An output in the braces of `arc`
    OnArc,
    /// The end of an item; the parser puts it there.
    End,
}

/// A token and its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Lexeme {
    pub(crate) token: Token,
    pub(crate) start: u32,
    pub(crate) end: u32,
}

impl Token {
    /// Whether it is a reserved word.
    pub(crate) fn is_word(self) -> bool {
        use Token::*;
        matches!(
            self,
            Chart
                | Input
                | Output
                | Var
                | Const
                | Grafcet
                | Expansion
                | Step
                | Transition
                | Initial
                | Activated
                | Enclosing
                | Macro
                | If
                | On
                | Force
                | True
                | False
                | And
                | Or
                | Xor
                | Not
                | Rise
                | Fall
                | Mod
        )
    }

    /// Whether it compares two values.
    pub(crate) fn is_relation(self) -> bool {
        use Token::*;
        matches!(self, Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual)
    }
}

/// Whether an item begins with this word; it stands nowhere else, except for `step` behind a prefix and for the keyword of
/// a declaration behind `retain`.
pub(crate) fn begins_item(token: Token) -> bool {
    is_prefix(token) || may_stand_in_block(token) || is_top_level(token)
}

/// Whether an item, or the head of a block, may end with this token.
pub(crate) fn may_end_item(token: Token) -> bool {
    use Token::*;
    match token {
        Name | String | Address | Whole | Integer | Real | Duration | Unreadable | True | False | CloseParen
        | CloseBracket | OpenBrace | CloseBrace | Scan | OnArc => true,
        Chart | Input | Output | Var | Const | Grafcet | Expansion | Step | Transition | Initial | Activated
        | Enclosing | Macro | If | On | Force | And | Or | Xor | Not | Rise | Fall | Mod | Plus | Minus | Star
        | Slash | Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual | Assign | Colon | Comma | Arrow
        | OpenParen | OpenBracket | Numeral | LineComment | BlockComment | ForeignComment | Activation
        | Deactivation | Event | At | Retain | Allow | AllowInside | Assume | Assert | Reach | Final | AtMost
        | Most | One | Of | After | Leads | LeadsTo | Scenario | Until | Within | Evolution | InitialActions
        | Bound | Each | Child | Start | Kill | Freeze | Resume | Run | End => false,
    }
}

pub(crate) fn is_prefix(token: Token) -> bool {
    matches!(token, Token::Initial | Token::Activated | Token::Enclosing | Token::Macro)
}

pub(crate) fn may_stand_in_block(token: Token) -> bool {
    is_prefix(token)
        || is_claim(token)
        || matches!(token, Token::Step | Token::Transition | Token::Expansion | Token::Allow)
}

/// Whether it is the keyword of a claim.
pub(crate) fn is_claim(token: Token) -> bool {
    matches!(token, Token::Assume | Token::Assert | Token::Reach | Token::Final)
}

fn is_top_level(token: Token) -> bool {
    declares(token) || matches!(token, Token::Chart | Token::Retain | Token::Grafcet | Token::Child | Token::Scenario)
}

/// Whether the head of a block begins with it.
pub(crate) fn opens_block(token: Token) -> bool {
    matches!(token, Token::Grafcet | Token::Expansion | Token::Child)
}

/// Whether it is the keyword of a declaration.
pub(crate) fn declares(token: Token) -> bool {
    matches!(token, Token::Input | Token::Output | Token::Var | Token::Const)
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

/// Moves behind the `*/` of a comment of C, or to the end of the line if there is none.
fn foreign_comment(lexer: &mut logos::Lexer<'_, Token>) {
    let rest = lexer.remainder();
    let end = rest.find("*/").map(|at| at + 2).or_else(|| rest.find('\n')).unwrap_or(rest.len());
    lexer.bump(end);
}
