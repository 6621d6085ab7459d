//! A text under way: its tokens, the tree so far, and the blocks that are open.

use super::balance::Balance;
use super::cut::Cutter;
use crate::ast::{self, Item};
use crate::builder::Builder;
use crate::grammar::ItemsParser;
use crate::lexer::Lexed;
use crate::pasted::is_in;
use crate::repeated;
use crate::shown::shorten;
use grafc_diagnostics::{Diagnostic, Diagnostics, FileId, Span};

/// An open block.
pub(super) struct Frame {
    pub(super) block: BlockItem,
    /// Its `{`, or its head if that is missing.
    pub(super) opened: Span,
    /// Whether a misplaced declaration in it has been reported.
    pub(super) reported: bool,
}

pub(super) enum BlockItem {
    Grafcet(Box<ast::Grafcet>),
    Expansion(Box<ast::Expansion>),
}

impl BlockItem {
    pub(super) fn items(&mut self) -> &mut Vec<Item> {
        match self {
            BlockItem::Grafcet(grafcet) => &mut grafcet.items,
            BlockItem::Expansion(expansion) => &mut expansion.items,
        }
    }

    pub(super) fn title(&self) -> String {
        let (word, name) = match self {
            BlockItem::Grafcet(grafcet) => ("grafcet", &grafcet.name),
            BlockItem::Expansion(expansion) => ("expansion", &expansion.macro_step),
        };
        if name.text.is_empty() { format!("`{word}`") } else { format!("`{word} {}`", shorten(&name.text)) }
    }
}

pub(super) struct Reader<'text> {
    pub(super) file: FileId,
    pub(super) text: &'text str,
    pub(super) lexed: Lexed,
    pub(super) balance: Balance,
    pub(super) builder: Builder<'text>,
    pub(super) parser: ItemsParser,
    pub(super) at: usize,
    pub(super) heading: Option<Box<ast::Heading>>,
    pub(super) items: Vec<Item>,
    pub(super) stack: Vec<Frame>,
    /// A reserved word was found where a name belongs: the item that it seems to begin is not one.
    pub(super) doubtful: Option<usize>,
    /// A `}` too many has been reported, and nothing was read since.
    pub(super) stray_reported: bool,
}

impl<'text> Reader<'text> {
    pub(super) fn new(file: FileId, text: &'text str, lexed: Lexed) -> Self {
        Reader {
            file,
            text,
            balance: Balance::of(&lexed.lexemes),
            lexed,
            builder: Builder::new(file, text),
            parser: ItemsParser::new(),
            at: 0,
            heading: None,
            items: Vec::new(),
            stack: Vec::new(),
            doubtful: None,
            stray_reported: false,
        }
    }

    pub(super) fn finish(mut self) -> (ast::Chart, Diagnostics) {
        let mut diagnostics = Diagnostics::new();
        let (covered, said): (Vec<_>, Vec<_>) =
            self.lexed.covered.drain(..).map(|(at, said)| ((at.start, at.end), said)).unzip();
        let faults = self.lexed.faults.drain(..).chain(self.builder.listed());
        for fault in faults.filter(|fault| !is_in(&covered, fault.primary.span.start)).chain(said) {
            diagnostics.push(fault);
        }
        diagnostics.sort_by_place();
        let diagnostics = repeated::joined(self.text, diagnostics);
        // The tree stays for a while, and what was doubled last is half empty.
        self.items.shrink_to_fit();
        self.builder.exprs.shrink_to_fit();
        let comments = self.lexed.comments.iter().map(|c| ast::Comment { span: self.builder.span(c.start, c.end) });
        let chart = ast::Chart {
            heading: self.heading.map(|heading| *heading),
            items: self.items,
            comments: comments.collect(),
            exprs: self.builder.exprs,
            span: Span::new(self.file, 0, self.text.len()),
            is_whole: !diagnostics.has_errors(),
        };
        (chart, diagnostics)
    }

    pub(super) fn cutter(&self) -> Cutter<'_> {
        Cutter { text: self.text, lexemes: &self.lexed.lexemes, balance: &self.balance, depth: self.stack.len() }
    }

    /// The balance of braces from a token on.
    pub(super) fn balance(&self, at: usize) -> i64 {
        self.balance.from(at)
    }

    /// Whether the lexer reported something between the token before this one and this one.
    pub(super) fn is_near_bad(&self, at: usize) -> bool {
        let lexemes = &self.lexed.lexemes;
        let from = at.checked_sub(1).map_or(0, |before| lexemes[before].start);
        let to = lexemes.get(at).map_or(self.text.len() as u32, |l| l.start);
        let bad = &self.lexed.bad;
        let first = bad.partition_point(|&(_, end)| end <= from);
        bad.get(first).is_some_and(|&(start, _)| start <= to)
    }

    pub(super) fn place_of(&self, at: usize) -> Span {
        match self.lexed.lexemes.get(at) {
            Some(lexeme) => self.builder.span(lexeme.start, lexeme.end),
            None => Span::new(self.file, self.text.len(), self.text.len()),
        }
    }

    pub(super) fn fault(&mut self, fault: Diagnostic) {
        self.builder.list(fault);
    }
}
