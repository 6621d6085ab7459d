//! The canonical text of a chart.
//!
//! It is made from the tokens and the comments of the text, not from the tree: so the author's spellings of operators,
//! numbers and durations stay, and no comment can be lost. The tree only tells where actions begin.
//!
//! One item a line, two spaces an indentation, single blanks, at most one blank line between items; nothing is aligned,
//! because one long name would then touch every line of a difference. What is left to the author: blank lines, whether
//! the actions of a step stand on its line or on their own, and line breaks after commas and at the operators of a
//! condition.

use crate::ast::{Chart, Item};
use crate::lexer;
use crate::token::{Lexeme, Token, begins_item, is_prefix, opens_block};
use ecow::EcoString;
use grafc_diagnostics::FileId;
use std::collections::HashSet;

/// The actions of a step stand on its line up to this width.
const WIDTH: usize = 100;

/// The canonical text of a chart that was parsed from `text` without errors.
///
/// Formatting the result again changes nothing, and it is read as the [same](crate::same()) chart.
pub fn format(text: &str, chart: &Chart) -> String {
    let lexed = lexer::lex(chart.span.file, text);
    if !lexed.faults.is_empty() {
        return text.to_owned();
    }
    let mut formatter = Formatter {
        text,
        pieces: without_empty_braces(pieces(text, &lexed.lexemes, &lexed.comments)),
        actions: action_starts(chart),
        out: String::with_capacity(text.len()),
        level: 0,
    };
    formatter.chart();
    if text.contains("\r\n") { formatter.out.replace('\n', "\r\n") } else { formatter.out }
}

/// A condition on one line and without its comments, with the blanks of the canonical text.
pub(crate) fn on_one_line(text: &str) -> EcoString {
    let mut line = EcoString::new();
    let mut state = State::default();
    let mut before: Option<Lexeme> = None;
    let slice = |lexeme: Lexeme| &text[lexeme.start as usize..lexeme.end as usize];
    for lexeme in lexer::lex(FileId::default(), text).lexemes {
        let blanks = before.map_or(0, |before| state.blanks(slice(before), before.token, lexeme.token));
        line.extend(std::iter::repeat_n(' ', blanks));
        line.push_str(slice(lexeme));
        state.advance(lexeme.token, false);
        before = Some(lexeme);
    }
    line
}

/// A token or a comment.
#[derive(Clone, Copy)]
struct Piece {
    lexeme: Lexeme,
    /// Line ends between the piece before and this one.
    breaks: usize,
}

impl Piece {
    fn is_comment(self) -> bool {
        matches!(self.lexeme.token, Token::LineComment | Token::BlockComment)
    }
}

/// Tokens and comments in the order of the text.
fn pieces(text: &str, lexemes: &[Lexeme], comments: &[Lexeme]) -> Vec<Piece> {
    let mut all: Vec<Lexeme> = lexemes.iter().chain(comments).copied().collect();
    all.sort_by_key(|l| l.start);
    let mut before = 0;
    all.into_iter()
        .map(|lexeme| {
            let gap = &text.as_bytes()[before as usize..lexeme.start as usize];
            before = lexeme.end;
            Piece { lexeme, breaks: gap.iter().filter(|b| **b == b'\n').count() }
        })
        .collect()
}

/// Leaves out the braces of steps and transitions that hold nothing: they say nothing. They go before anything is laid
/// out, so that a comment beside them stands where it would without them.
fn without_empty_braces(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut kept: Vec<Piece> = Vec::with_capacity(pieces.len());
    let (mut in_head_of_block, mut forcing) = (false, false);
    let mut gap = 0;
    let mut pieces = pieces.into_iter().peekable();
    while let Some(mut piece) = pieces.next() {
        let token = piece.lexeme.token;
        piece.breaks += std::mem::take(&mut gap);
        if token == Token::OpenBrace && !in_head_of_block && !forcing {
            if let Some(close) = pieces.next_if(|p| p.lexeme.token == Token::CloseBrace) {
                gap = piece.breaks + close.breaks;
                continue;
            }
        }
        match token {
            Token::Grafcet | Token::Expansion => in_head_of_block = true,
            Token::Force => forcing = true,
            Token::OpenBrace | Token::CloseBrace => (in_head_of_block, forcing) = (false, false),
            _ => {}
        }
        kept.push(piece);
    }
    kept
}

/// Where the actions of steps and transitions begin, and the lines of scenarios.
fn action_starts(chart: &Chart) -> HashSet<u32> {
    let mut starts = HashSet::new();
    let mut lists = vec![&chart.items];
    while let Some(items) = lists.pop() {
        for item in items {
            match item {
                Item::Declaration(_) | Item::Allow(_) | Item::Claim(_) => {}
                Item::Scenario(scenario) => starts.extend(scenario.lines.iter().map(|line| line.span.start)),
                Item::Grafcet(grafcet) => lists.push(&grafcet.items),
                Item::Expansion(expansion) => lists.push(&expansion.items),
                Item::Step(step) => {
                    starts.extend(step.actions.iter().map(|a| a.span.start));
                    starts.extend(step.allows.iter().map(|a| a.span.start));
                }
                Item::Transition(transition) => {
                    starts.extend(transition.actions().iter().map(|a| a.span.start));
                    starts.extend(transition.pulses().iter().map(|pulse| pulse.span.start));
                    starts.extend(transition.outputs().iter().map(|output| output.span.start));
                    starts.extend(transition.allows().iter().map(|a| a.span.start));
                }
            }
        }
    }
    starts
}

struct Formatter<'text> {
    text: &'text str,
    pieces: Vec<Piece>,
    actions: HashSet<u32>,
    out: String,
    /// Open blocks.
    level: usize,
}

impl Formatter<'_> {
    fn chart(&mut self) {
        let mut at = 0;
        let mut block_begins = true;
        while at < self.pieces.len() {
            let piece = self.pieces[at];
            let token = piece.lexeme.token;
            if piece.is_comment() && piece.breaks == 0 && at > 0 {
                self.out.push(' ');
                self.write(piece);
                at += 1;
                continue;
            }
            if at > 0 {
                self.out.push('\n');
            }
            if token == Token::CloseBrace {
                self.level = self.level.saturating_sub(1);
            } else if piece.breaks > 1 && !block_begins {
                self.out.push('\n');
            }
            block_begins = false;
            self.indent(2 * self.level);
            if piece.is_comment() || !begins_item(token) {
                self.write(piece);
                at += 1;
                continue;
            }
            let end = self.item_end(at);
            let item = self.item(at, end);
            self.out.push_str(&item);
            if opens_block(token) {
                self.level += 1;
                block_begins = true;
            }
            at = end;
        }
        if !self.out.is_empty() {
            self.out.push('\n');
        }
    }

    /// One past the last token of an item; of a block, of its head.
    fn item_end(&self, start: usize) -> usize {
        let head = opens_block(self.pieces[start].lexeme.token);
        let mut end = start + 1;
        let mut depth = 0usize;
        let first = self.pieces[start].lexeme.token;
        let mut only_prefixes = is_prefix(first) || matches!(first, Token::Retain | Token::Child);
        for (at, piece) in self.pieces.iter().enumerate().skip(start + 1) {
            match piece.lexeme.token {
                Token::LineComment | Token::BlockComment => continue,
                Token::OpenBrace if head => return at + 1,
                Token::OpenBrace => depth += 1,
                Token::CloseBrace if depth == 0 => break,
                Token::CloseBrace => depth -= 1,
                token if begins_item(token) && !only_prefixes => break,
                token => only_prefixes &= is_prefix(token),
            }
            end = at + 1;
        }
        end
    }

    fn item(&self, start: usize, end: usize) -> String {
        let mut pieces = self.pieces[start..end].to_vec();
        sort_prefixes(&mut pieces);
        if self.wants_lines(&pieces) {
            return self.lay_out(&pieces, true);
        }
        let line = self.lay_out(&pieces, false);
        let indentation = 2 * self.level;
        let is_block = opens_block(pieces[0].lexeme.token);
        let has_actions = !is_block && pieces.last().is_some_and(|p| p.lexeme.token == Token::CloseBrace);
        if has_actions && line.lines().any(|l| indentation + l.chars().count() > WIDTH) {
            return self.lay_out(&pieces, true);
        }
        line
    }

    /// Whether the author put the actions on lines of their own, or a comment makes it necessary.
    fn wants_lines(&self, pieces: &[Piece]) -> bool {
        if opens_block(pieces[0].lexeme.token) {
            return false;
        }
        let Some(open) = pieces.iter().position(|p| p.lexeme.token == Token::OpenBrace) else { return false };
        let inside = &pieces[open + 1..];
        let empty = inside.first().is_none_or(|p| p.lexeme.token == Token::CloseBrace);
        let broken = inside.first().is_some_and(|p| p.breaks > 0)
            || inside.windows(2).any(|p| p[1].breaks > 0 && may_break(p[0].lexeme.token, p[1].lexeme.token));
        let commented = |p: &Piece| p.lexeme.token == Token::LineComment || (p.is_comment() && p.breaks > 0);
        !empty && (broken || inside.iter().any(commented))
    }

    fn lay_out(&self, pieces: &[Piece], lines: bool) -> String {
        let base = 2 * self.level;
        let mut out = String::new();
        let mut state = State::default();
        let mut previous: Option<Piece> = None;
        let mut must_break = false;
        let following = following_tokens(pieces);
        let mut at = 0;
        while at < pieces.len() {
            let piece = pieces[at];
            let token = piece.lexeme.token;
            // What decides the indentation: the token that this piece is, or that the comment stands before.
            let next = following[at];
            let starts_action = next.is_some_and(|l| self.actions.contains(&l.start));
            let closes = state.braces == 1 && next.is_some_and(|l| l.token == Token::CloseBrace);
            let indentation = match (lines && state.braces > 0, starts_action, closes) {
                (true, _, true) => base + if piece.is_comment() { 2 } else { 0 },
                (true, true, _) => base + 2,
                (true, false, false) => base + 6,
                (false, _, _) => base + 4,
            };
            if let Some(before) = previous {
                let own_line = lines && state.braces > 0 && (closes || starts_action);
                let breaks = must_break
                    || if piece.is_comment() {
                        piece.breaks > 0
                    } else {
                        own_line || (piece.breaks > 0 && may_break(before.lexeme.token, token))
                    };
                if breaks {
                    let blank = own_line && piece.breaks > 1 && before.lexeme.token != Token::OpenBrace;
                    out.push_str(if blank && (piece.is_comment() || !closes) { "\n\n" } else { "\n" });
                    out.extend(std::iter::repeat_n(' ', indentation));
                } else {
                    let blanks = if piece.is_comment() || before.is_comment() {
                        1
                    } else if starts_action && state.braces > 0 && before.lexeme.token != Token::OpenBrace {
                        3
                    } else {
                        state.blanks(self.slice(before), before.lexeme.token, token)
                    };
                    out.extend(std::iter::repeat_n(' ', blanks));
                }
            }
            out.push_str(&self.written(piece));
            must_break = token == Token::LineComment
                || (token == Token::BlockComment
                    && piece.breaks > 0
                    && pieces.get(at + 1).is_some_and(|p| p.breaks > 0));
            if !piece.is_comment() {
                state.advance(token, starts_action);
            }
            previous = Some(piece);
            at += 1;
        }
        out
    }

    fn slice(&self, piece: Piece) -> &str {
        &self.text[piece.lexeme.start as usize..piece.lexeme.end as usize]
    }

    fn written(&self, piece: Piece) -> String {
        self.slice(piece).replace("\r\n", "\n")
    }

    fn write(&mut self, piece: Piece) {
        let written = self.written(piece);
        self.out.push_str(&written);
    }

    fn indent(&mut self, blanks: usize) {
        self.out.extend(std::iter::repeat_n(' ', blanks));
    }
}

/// For each piece, itself or the first token behind it.
fn following_tokens(pieces: &[Piece]) -> Vec<Option<Lexeme>> {
    let mut following = vec![None; pieces.len()];
    let mut next = None;
    for (at, piece) in pieces.iter().enumerate().rev() {
        if !piece.is_comment() {
            next = Some(piece.lexeme);
        }
        following[at] = next;
    }
    following
}

/// `initial`, then `activated`, then the kind, as the standard's designations have them.
fn sort_prefixes(pieces: &mut [Piece]) {
    let count = pieces.iter().take_while(|p| is_prefix(p.lexeme.token)).count();
    if pieces.get(count).is_none_or(|p| p.is_comment()) {
        return;
    }
    pieces[..count].sort_by_key(|p| match p.lexeme.token {
        Token::Initial => 0,
        Token::Activated => 1,
        _ => 2,
    });
}

/// Where a line break of the author is kept.
fn may_break(before: Token, token: Token) -> bool {
    let operator = |t| matches!(t, Token::And | Token::Or | Token::Xor | Token::Plus);
    before == Token::Comma || operator(before) || operator(token)
}

/// What the blanks around a token depend on.
#[derive(Default)]
struct State {
    /// Open braces: 1 among actions, 2 in a forced situation.
    braces: usize,
    brackets: usize,
    /// Behind `:=`.
    value: bool,
    /// A forced grafcet was named, its braces follow.
    forcing: bool,
    /// The last token was an operator with one operand.
    unary: bool,
    /// The last token ended an operand.
    operand: bool,
}

impl State {
    fn blanks(&self, before_text: &str, before: Token, token: Token) -> usize {
        let tight_situation = |brace: Token, depth| {
            (token == brace && self.braces == depth && self.forcing) || (before == brace && self.braces == 2)
        };
        if matches!(before, Token::OpenParen | Token::OpenBracket)
            || matches!(token, Token::CloseParen | Token::CloseBracket | Token::Comma)
            || tight_situation(Token::OpenBrace, 1)
            || (token == Token::CloseBrace && self.braces == 2)
        {
            return 0;
        }
        // Outside of arithmetic a slash makes a delay or a path, which the standard writes without blanks.
        if (token == Token::Slash || before == Token::Slash) && !self.value && self.brackets == 0 {
            return 0;
        }
        // `↑a`, `!a` and `-a`, but `rise a` and `not a`.
        let is_word = before_text.starts_with(|c: char| c.is_alphabetic());
        usize::from(!self.unary || is_word)
    }

    fn advance(&mut self, token: Token, starts_action: bool) {
        if starts_action {
            self.value = false;
        }
        self.unary = match token {
            // Behind a value it is the mark of a pulse.
            Token::Rise => !self.operand,
            Token::Not | Token::Fall => true,
            Token::Minus => !self.operand,
            _ => false,
        };
        self.operand = ends_operand(token);
        match token {
            Token::Assign => self.value = true,
            Token::On | Token::Each => self.value = false,
            Token::Force => self.forcing = true,
            Token::OpenBracket => self.brackets += 1,
            Token::CloseBracket => self.brackets = self.brackets.saturating_sub(1),
            Token::OpenBrace => self.braces += 1,
            Token::CloseBrace => {
                self.braces = self.braces.saturating_sub(1);
                self.forcing = false;
            }
            _ => {}
        }
    }
}

/// Whether a minus behind this token subtracts.
fn ends_operand(token: Token) -> bool {
    use Token::*;
    matches!(token, Name | Whole | Integer | Real | Duration | True | False | CloseParen | CloseBracket)
}
