//! Tokens to a tree, item by item.
//!
//! Every item begins with a word that stands nowhere else, so the tokens can be cut into items before they are parsed:
//! a mistake in one item never reaches the next, and costs one message. The grammar reads what is inside an item; the
//! nesting of blocks is followed here, with a stack of our own. Where braces do not match, their balance over the rest
//! of the text tells whether one is missing or one too many.

use crate::ast::{self, Item};
use crate::builder::{Builder, Parsed};
use crate::expected;
use crate::grammar::ItemParser;
use crate::lexer::{self, Lexed, Lexeme, MOST_FAULTS, Token};
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

/// The tokens of one item.
struct Run {
    start: usize,
    end: usize,
    /// Its outermost `{` that has no `}`.
    open: Option<usize>,
}

/// Where the parser stopped.
struct Stop {
    /// The token that it did not expect; [`Run::end`] if the item ended too early.
    at: usize,
    expected: Vec<String>,
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
                if let Some(parsed) = self.salvage(&run, &stop) {
                    self.builder.faults.clear();
                    self.add(parsed, &run, is_first);
                }
                self.at = run.end;
                self.skip_partner(&run);
            }
        }
        self.stray_reported = false;
    }

    /// The item that begins here: up to the next one, to its own closing brace or to that of its block.
    fn cut(&self) -> Run {
        let tokens = &self.lexed.lexemes;
        let start = self.at;
        let mut end = start + 1;
        let first = tokens[start].token;
        if matches!(first, Token::Grafcet | Token::Expansion) {
            while let Some(lexeme) = tokens.get(end) {
                match lexeme.token {
                    Token::OpenBrace => {
                        end += 1;
                        break;
                    }
                    Token::CloseBrace => break,
                    token if begins_item(token) => break,
                    _ => end += 1,
                }
            }
            return Run { start, end, open: None };
        }
        if is_prefix(first) {
            while tokens.get(end).is_some_and(|l| is_prefix(l.token)) {
                end += 1;
            }
            if tokens.get(end).is_some_and(|l| l.token == Token::Step) {
                end += 1;
            }
        }
        let mut open = Vec::new();
        while let Some(lexeme) = tokens.get(end) {
            match lexeme.token {
                Token::OpenBrace => open.push(end),
                Token::CloseBrace if open.is_empty() => break,
                Token::CloseBrace => {
                    if open.len() == 1 && self.closes_the_block(start, end) {
                        break;
                    }
                    open.pop();
                    if open.is_empty() {
                        return Run { start, end: end + 1, open: None };
                    }
                }
                token if begins_item(token) => break,
                _ => {}
            }
            end += 1;
        }
        Run { start, end, open: open.first().copied() }
    }

    /// Whether a `}` that could close an item's braces is rather its block's: one is missing further on, and this one
    /// is indented less than the item.
    fn closes_the_block(&self, item: usize, brace: usize) -> bool {
        let outstanding = self.stack.len() as i64 + 1;
        let lexemes = &self.lexed.lexemes;
        self.balance[brace] < outstanding
            && match (self.indentation(lexemes[item].start), self.indentation(lexemes[brace].start)) {
                (Some(item), Some(brace)) => brace < item,
                _ => false,
            }
    }

    /// The white space before a token that is the first on its line.
    fn indentation(&self, start: u32) -> Option<usize> {
        let before = &self.text.as_bytes()[..start as usize];
        let blanks = before.iter().rev().take_while(|b| matches!(b, b' ' | b'\t')).count();
        match before.len().checked_sub(blanks + 1) {
            None => Some(blanks),
            Some(at) => (before[at] == b'\n').then_some(blanks),
        }
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

    /// What can be kept of an item that has a fault: the part before it, with an unreadable condition if need be.
    fn salvage(&mut self, run: &Run, stop: &Stop) -> Option<Parsed> {
        let find = |token: Token| {
            let lexemes = &self.lexed.lexemes[run.start..stop.at];
            lexemes.iter().position(|l| l.token == token).map(|at| run.start + at)
        };
        let first = self.lexed.lexemes[run.start].token;
        let here = self.lexed.lexemes[stop.at - 1].end;
        let synthetic = |token| Lexeme { token, start: here, end: here };
        let mut tries: Vec<(usize, Option<Lexeme>)> = Vec::new();
        match first {
            Token::Grafcet | Token::Expansion => {
                // Its items follow if it has a brace, or if there is a brace that closes it.
                let has_brace = self.lexed.lexemes[run.end - 1].token == Token::OpenBrace;
                if !has_brace && self.balance[run.end] <= self.stack.len() as i64 {
                    return None;
                }
                tries.push((stop.at, Some(synthetic(Token::OpenBrace))));
            }
            Token::Transition => {
                tries.extend(find(Token::OpenBrace).map(|at| (at, None)));
                tries.extend(find(Token::Colon).map(|at| (at + 1, Some(synthetic(Token::Unreadable)))));
            }
            _ => {
                tries.extend(find(Token::OpenBrace).map(|at| (at, None)));
                tries.extend(find(Token::Assign).map(|at| (at, None)));
                tries.extend(find(Token::At).map(|at| (at, None)));
                tries.push((stop.at, None));
            }
        }
        let arena = self.builder.exprs.len();
        for (end, extra) in tries {
            let extra: Vec<Lexeme> = extra.into_iter().collect();
            match attempt(&self.parser, &mut self.builder, &self.lexed.lexemes[run.start..end], &extra) {
                Ok(parsed) => return Some(parsed),
                Err(_) => self.builder.exprs.truncate(arena),
            }
        }
        self.nameless(run)
    }

    /// A block whose head could not be read still has items.
    fn nameless(&self, run: &Run) -> Option<Parsed> {
        let head = self.lexed.lexemes[run.start];
        let span = self.builder.span(head.start, head.end);
        let name = ast::Name { text: String::new(), quoted: false, span };
        match head.token {
            Token::Grafcet => {
                Some(Parsed::Grafcet(ast::Grafcet { path: Vec::new(), name, comment: None, items: Vec::new(), span }))
            }
            Token::Expansion => {
                Some(Parsed::Expansion(ast::Expansion { macro_step: name, comment: None, items: Vec::new(), span }))
            }
            _ => None,
        }
    }

    /// After a faulty item: leaves out a `}` whose `{` was forgotten.
    fn skip_partner(&mut self, run: &Run) {
        let lexemes = &self.lexed.lexemes;
        let next_closes = lexemes.get(run.end).is_some_and(|l| l.token == Token::CloseBrace);
        let has_brace = lexemes[run.start..run.end].iter().any(|l| l.token == Token::OpenBrace);
        if next_closes && !has_brace && self.balance[run.end] > self.stack.len() as i64 {
            self.at = run.end + 1;
        }
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

    // ---- Faults ----

    /// Tokens that belong to no item.
    fn junk(&mut self) {
        let start = self.at;
        let mut depth = 0usize;
        while let Some(lexeme) = self.lexed.lexemes.get(self.at) {
            match lexeme.token {
                Token::OpenBrace => depth += 1,
                Token::CloseBrace if depth == 0 => break,
                Token::CloseBrace => depth -= 1,
                token if begins_item(token) => break,
                _ => {}
            }
            self.at += 1;
        }
        if self.is_near_bad(start) {
            return;
        }
        let first = self.lexed.lexemes[start];
        let span = self.builder.span(first.start, first.end);
        let what = if self.stack.is_empty() {
            "an item such as `input`, `step` or `transition`"
        } else {
            "`step`, `transition` or `}`"
        };
        let found = &self.text[span.range()];
        let mut fault =
            Diagnostic::new(Code::E0107, span, format!("expected {what}, found `{}`", expected::shorten(found)));
        let lower = found.to_lowercase();
        if first.token == Token::Name && lower != found && ITEM_WORDS.contains(&lower.as_str()) {
            fault = fault.help(format!("words of the language are in lower case: `{lower}`"));
        }
        self.fault(fault);
    }

    /// Reports why an item could not be read, unless a fault has been reported at that very place.
    fn report(&mut self, run: &Run, stop: &Stop) {
        if self.is_near_bad(stop.at) || self.doubtful.take() == Some(run.start) {
            return;
        }
        let lexemes = &self.lexed.lexemes;
        let previous = lexemes[stop.at - 1];
        let next = lexemes.get(stop.at);
        let found = next.map_or("", |l| &self.text[l.start as usize..l.end as usize]);
        let can_close = expected::contains(&stop.expected, "}");
        if let (true, true, Some(open)) = (stop.at == run.end, can_close, run.open) {
            let open = lexemes[open];
            let fault =
                Diagnostic::new(Code::E0107, self.builder.span(open.start, open.end), "this `{` is never closed")
                    .also(self.place_of(stop.at), "`}` is missing before this");
            return self.fault(fault);
        }
        // What is missing at the end of a line is shown there, and not at the item that follows.
        let gap = &self.text[previous.end as usize..next.map_or(self.text.len(), |l| l.start as usize)];
        let on_this_line = next.is_some() && !gap.contains('\n');
        let span = if on_this_line || stop.at < run.end {
            self.place_of(stop.at)
        } else {
            self.builder.span(previous.end, previous.end)
        };
        if on_this_line && stop.at == run.end {
            self.doubtful = Some(run.end);
        }
        let found_words =
            if next.is_some() { format!("`{}`", expected::shorten(found)) } else { "the end of the text".into() };
        let expected = expected::describe(previous.token, &stop.expected);
        let mut fault = Diagnostic::new(Code::E0107, span, format!("expected {expected}, found {found_words}"));
        let found_here = next.filter(|_| on_this_line || stop.at < run.end).map(|l| l.token);
        fault.help = expected::cure(lexemes[run.start].token, previous.token, found_here, found, &stop.expected);
        self.fault(fault);
    }

    /// Whether the lexer reported something between the token before this one and this one.
    fn is_near_bad(&self, at: usize) -> bool {
        let lexemes = &self.lexed.lexemes;
        let from = at.checked_sub(1).map_or(0, |before| lexemes[before].start);
        let to = lexemes.get(at).map_or(self.text.len() as u32, |l| l.start);
        let bad = &self.lexed.bad;
        let first = bad.partition_point(|&(_, end)| end <= from);
        bad.get(first).is_some_and(|&(start, _)| start <= to)
    }

    fn place_of(&self, at: usize) -> Span {
        match self.lexed.lexemes.get(at) {
            Some(lexeme) => self.builder.span(lexeme.start, lexeme.end),
            None => Span::new(self.file, self.text.len(), self.text.len()),
        }
    }

    fn fault(&mut self, fault: Diagnostic) {
        if self.faults.len() < MOST_FAULTS {
            self.faults.push(fault);
        } else {
            self.unlisted += 1;
        }
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

/// The words that begin an item, as they are written.
const ITEM_WORDS: [&str; 13] = [
    "chart",
    "input",
    "output",
    "var",
    "const",
    "grafcet",
    "expansion",
    "step",
    "transition",
    "initial",
    "activated",
    "enclosing",
    "macro",
];

/// Whether an item begins with this word; it stands nowhere else, except for `step` behind a prefix.
pub(crate) fn begins_item(token: Token) -> bool {
    is_prefix(token) || may_stand_in_block(token) || is_top_level(token)
}

pub(crate) fn is_prefix(token: Token) -> bool {
    matches!(token, Token::Initial | Token::Activated | Token::Enclosing | Token::Macro)
}

fn may_stand_in_block(token: Token) -> bool {
    is_prefix(token) || matches!(token, Token::Step | Token::Transition | Token::Expansion)
}

fn is_top_level(token: Token) -> bool {
    matches!(token, Token::Chart | Token::Input | Token::Output | Token::Var | Token::Const | Token::Grafcet)
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
