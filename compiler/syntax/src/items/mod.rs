//! Tokens to a tree, item by item.
//!
//! Every item begins with a word that stands nowhere else, so the tokens can be cut into items before they are parsed:
//! a mistake in one item never reaches the next, and costs one message. The grammar reads what is inside an item; the
//! nesting of blocks is followed here, with a stack of our own. Where braces do not match, their balance over the rest
//! of the text tells whether one is missing or one too many.

mod cut;
mod faults;
mod salvage;

pub(crate) use cut::{begins_item, is_prefix};

use self::cut::{Run, may_stand_in_block};
use self::faults::Stop;
use crate::ast::{self, Item};
use crate::builder::{Builder, Parsed};
use crate::expected;
use crate::grammar::ItemParser;
use crate::lexer::{self, Lexed, Lexeme, Token};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use lalrpop_util::ParseError;

/// Expansions within expansions beyond this depth are reported. Nobody draws so many, and a tree of bounded depth can be
/// walked and dropped by recursion.
const DEEPEST: usize = 64;

/// Reads a whole text. It always gives a tree: what could not be read is left out and has been reported.
pub fn parse(file: FileId, text: &str) -> (ast::Chart, Diagnostics) {
    parse_up_to(file, text, u32::MAX as usize)
}

/// As [`parse`], for texts of at most `longest` bytes.
fn parse_up_to(file: FileId, text: &str, longest: usize) -> (ast::Chart, Diagnostics) {
    if text.len() > longest {
        let mut diagnostics = Diagnostics::new();
        let message = format!("the text is longer than {longest} bytes");
        diagnostics.push(Diagnostic::new(Code::E0109, Span::new(file, 0, 0), message));
        return (ast::Chart::default(), diagnostics);
    }
    let mut reader = Reader::new(file, text, lexer::lex(file, text));
    reader.read();
    reader.finish()
}

/// An open block.
struct Frame {
    block: Block,
    /// Its `{`, or its head if that is missing.
    opened: Span,
    /// Whether a misplaced declaration in it has been reported.
    reported: bool,
}

enum Block {
    Grafcet(ast::Grafcet),
    Expansion(ast::Expansion),
}

impl Block {
    fn items(&mut self) -> &mut Vec<Item> {
        match self {
            Block::Grafcet(grafcet) => &mut grafcet.items,
            Block::Expansion(expansion) => &mut expansion.items,
        }
    }

    fn title(&self) -> String {
        let (word, name) = match self {
            Block::Grafcet(grafcet) => ("grafcet", &grafcet.name),
            Block::Expansion(expansion) => ("expansion", &expansion.macro_step),
        };
        if name.text.is_empty() { format!("`{word}`") } else { format!("`{word} {}`", expected::shorten(&name.text)) }
    }
}

struct Reader<'text> {
    file: FileId,
    text: &'text str,
    lexed: Lexed,
    /// For each token, how many more `}` than `{` there are from it on.
    balance: Vec<i64>,
    builder: Builder<'text>,
    parser: ItemParser,
    at: usize,
    heading: Option<ast::Heading>,
    items: Vec<Item>,
    stack: Vec<Frame>,
    faults: Vec<Diagnostic>,
    unlisted: usize,
    /// A reserved word was found where a name belongs: the item that it seems to begin is not one.
    doubtful: Option<usize>,
    /// A `}` too many has been reported, and nothing was read since.
    stray_reported: bool,
}

impl<'text> Reader<'text> {
    fn new(file: FileId, text: &'text str, lexed: Lexed) -> Self {
        let mut balance = vec![0; lexed.lexemes.len() + 1];
        for (at, lexeme) in lexed.lexemes.iter().enumerate().rev() {
            balance[at] = balance[at + 1]
                + match lexeme.token {
                    Token::CloseBrace => 1,
                    Token::OpenBrace => -1,
                    _ => 0,
                };
        }
        Reader {
            file,
            text,
            lexed,
            balance,
            builder: Builder::new(file, text),
            parser: ItemParser::new(),
            at: 0,
            heading: None,
            items: Vec::new(),
            stack: Vec::new(),
            faults: Vec::new(),
            unlisted: 0,
            doubtful: None,
            stray_reported: false,
        }
    }

    fn read(&mut self) {
        while let Some(lexeme) = self.lexed.lexemes.get(self.at) {
            match lexeme.token {
                Token::CloseBrace => self.close_brace(),
                token if begins_item(token) => self.item(),
                _ => self.junk(),
            }
        }
        if !self.stack.is_empty() {
            self.unclosed_block();
            self.close_all();
        }
    }

    fn finish(mut self) -> (ast::Chart, Diagnostics) {
        let mut diagnostics = Diagnostics::new();
        if self.unlisted > 0 {
            if let Some(last) = self.faults.last_mut() {
                last.notes.push(format!("there are {} more syntax errors", self.unlisted));
            }
        }
        for fault in self.lexed.faults.drain(..).chain(self.faults.drain(..)) {
            diagnostics.push(fault);
        }
        diagnostics.sort_by_place();
        let comments = self.lexed.comments.iter().map(|c| ast::Comment { span: self.builder.span(c.start, c.end) });
        let chart = ast::Chart {
            heading: self.heading,
            items: self.items,
            comments: comments.collect(),
            exprs: self.builder.exprs,
            span: Span::new(self.file, 0, self.text.len()),
            is_whole: !diagnostics.has_errors(),
        };
        (chart, diagnostics)
    }

    // ---- Items ----

    fn item(&mut self) {
        let token = self.lexed.lexemes[self.at].token;
        if !self.stack.is_empty() && !may_stand_in_block(token) {
            self.misplaced(token);
        }
        let run = self.cut();
        let is_first = run.start == 0;
        let arena = self.builder.exprs.len();
        let lexemes = &self.lexed.lexemes[run.start..run.end];
        match attempt(&self.parser, &mut self.builder, lexemes, &[]) {
            Ok(parsed) => {
                let found = std::mem::take(&mut self.builder.faults);
                for fault in found {
                    self.fault(fault);
                }
                self.add(parsed, &run, is_first);
                self.at = run.end;
            }
            Err((place, expected)) => {
                let stop = Stop { at: run.start + place, expected };
                self.builder.exprs.truncate(arena);
                self.builder.faults.clear();
                self.report(&run, &stop);
                // Beyond the faults that are listed, nobody asks what can be kept.
                let kept = if self.unlisted == 0 { self.salvage(&run, &stop) } else { self.nameless(&run) };
                if let Some(parsed) = kept {
                    self.builder.faults.clear();
                    self.add(parsed, &run, is_first);
                }
                self.at = run.end;
                self.skip_partner(&run);
            }
        }
        self.stray_reported = false;
    }

    fn add(&mut self, parsed: Parsed, run: &Run, is_first: bool) {
        let brace = self.lexed.lexemes[run.end - 1];
        let opened = self.builder.span(brace.start, brace.end);
        let block = match parsed {
            Parsed::Heading(heading) => {
                if !is_first {
                    let mut fault =
                        Diagnostic::new(Code::E0107, heading.span, "the heading of the chart is not its first item");
                    if let Some(first) = &self.heading {
                        fault = fault.also(first.span, "there is one already");
                    }
                    self.fault(fault);
                }
                self.heading.get_or_insert(heading);
                return;
            }
            Parsed::Item(item @ Item::Declaration(_)) => return self.items.push(item),
            Parsed::Item(item) => return self.stack.last_mut().map_or(&mut self.items, |f| f.block.items()).push(item),
            Parsed::Grafcet(grafcet) => Block::Grafcet(grafcet),
            Parsed::Expansion(expansion) => Block::Expansion(expansion),
        };
        if self.stack.len() == DEEPEST {
            let message = format!("blocks are nested deeper than {DEEPEST} levels");
            self.fault(
                Diagnostic::new(Code::E0107, opened, message).help("an expansion may stand outside of the others"),
            );
        }
        self.stack.push(Frame { block, opened, reported: false });
    }

    // ---- Blocks ----

    fn close_brace(&mut self) {
        let brace = self.lexed.lexemes[self.at];
        let next = self.lexed.lexemes.get(self.at + 1).map(|l| l.token);
        let too_many = self.balance[self.at] > self.stack.len() as i64;
        // A step behind the brace of the only open block shows that the block goes on.
        let goes_on =
            self.stack.len() == 1 && next.is_some_and(|t| is_prefix(t) || matches!(t, Token::Step | Token::Transition));
        if self.stack.is_empty() || (too_many && goes_on) {
            if !self.stray_reported && !self.is_near_bad(self.at) {
                let span = self.builder.span(brace.start, brace.end);
                self.fault(Diagnostic::new(Code::E0107, span, "expected an item, found a `}` that closes nothing"));
            }
            self.stray_reported = true;
        } else {
            self.close(brace.end);
        }
        self.at += 1;
    }

    fn close(&mut self, end: u32) {
        let Some(frame) = self.stack.pop() else { return };
        let depth = self.stack.len();
        match frame.block {
            Block::Grafcet(mut grafcet) => {
                grafcet.span.end = end.max(grafcet.span.end);
                self.items.push(Item::Grafcet(grafcet));
            }
            Block::Expansion(mut expansion) => {
                expansion.span.end = end.max(expansion.span.end);
                let list = match self.stack.last_mut() {
                    Some(parent) if depth < DEEPEST => parent.block.items(),
                    _ => &mut self.items,
                };
                list.push(Item::Expansion(expansion));
            }
        }
    }

    fn close_all(&mut self) {
        let end = self.at.checked_sub(1).map_or(0, |at| self.lexed.lexemes[at].end);
        while !self.stack.is_empty() {
            self.close(end);
        }
    }

    /// A grafcet, a declaration or a heading within a block: either the block was not closed, or it is in a wrong place.
    fn misplaced(&mut self, token: Token) {
        if self.balance[self.at] < self.stack.len() as i64 {
            self.unclosed_block();
            self.close_all();
            return;
        }
        let lexeme = self.lexed.lexemes[self.at];
        let span = self.builder.span(lexeme.start, lexeme.end);
        let Some(frame) = self.stack.last_mut() else { return };
        let inside = frame.block.title();
        let word = &self.text[span.range()];
        let fault = Diagnostic::new(Code::E0107, span, format!("`{word}` cannot stand inside {inside}"))
            .also(frame.opened, format!("{inside} begins here"));
        if token == Token::Grafcet {
            self.fault(fault.help("an enclosure stands outside and names its enclosing step: `grafcet X9/G4 { … }`"));
        } else if !std::mem::replace(&mut frame.reported, true) {
            self.fault(fault.help("declarations stand outside of all braces"));
        }
    }

    fn unclosed_block(&mut self) {
        if self.is_near_bad(self.at) {
            return;
        }
        let Some(frame) = self.stack.last() else { return };
        let fault =
            Diagnostic::new(Code::E0107, frame.opened, format!("the `{{` of {} is never closed", frame.block.title()))
                .also(self.place_of(self.at), "`}` is missing before this");
        self.fault(fault);
    }
}

/// Parses the tokens of one item. A failure tells how many were read, and what was expected then.
fn attempt(
    parser: &ItemParser,
    builder: &mut Builder<'_>,
    lexemes: &[Lexeme],
    extra: &[Lexeme],
) -> Result<Parsed, (usize, Vec<String>)> {
    let mut read = 0usize;
    let end = extra.last().or(lexemes.last()).map_or(0, |l| l.end);
    let tokens = lexemes
        .iter()
        .chain(extra)
        .map(|l| (l.start, l.token, l.end))
        .chain(std::iter::once((end, Token::End, end)))
        .inspect(|_| read += 1);
    let result = parser.parse(builder, tokens);
    match result {
        Ok(parsed) => Ok(parsed),
        Err(ParseError::UnrecognizedToken { expected, .. } | ParseError::UnrecognizedEof { expected, .. }) => {
            Err((read.saturating_sub(1).min(lexemes.len()), expected))
        }
        Err(ParseError::InvalidToken { .. } | ParseError::ExtraToken { .. }) => Err((lexemes.len(), Vec::new())),
        Err(ParseError::User { error }) => match error {},
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_beyond_the_limit_is_not_read() {
        let (chart, diagnostics) = parse_up_to(FileId(0), "step 1", 5);
        assert!(chart.items.is_empty());
        assert_eq!(diagnostics.iter().map(|d| d.code).collect::<Vec<_>>(), [Code::E0109]);
        assert!(!parse_up_to(FileId(0), "step 1", 6).1.has_errors());
    }
}
