//! Lines of text: indentation, blank lines, comments.

use crate::comment::wrap;
use crate::lines::{Lines, Trace};
use grafc_logic::scan::Origin;

/// No line of ours is longer, if it can be broken at all, except where the indentation leaves too little.
const WIDTH: usize = 100;
/// So much room is left behind any indentation: states nest as deep as enclosures do.
const LEAST_ROOM: usize = 60;
/// A line may be so much longer with the comment at its end.
const ROOM_FOR_COMMENT: usize = 10;
/// Remarks of neighbouring lines start in one column, unless they leave less room than this.
const LEAST_ROOM_FOR_REMARK: usize = 40;
/// Comments begin at one of these columns: so one more line, a little longer than the others, moves none of them.
const COLUMNS: usize = 4;

/// Where comments begin behind texts of so many columns.
pub(crate) fn column_of(longest: usize) -> usize {
    longest.next_multiple_of(COLUMNS)
}

/// One level of indentation.
pub(crate) const STEP: usize = 4;

/// What stands around comments.
#[derive(Debug)]
pub(crate) struct Comments {
    /// Before the first line.
    first: &'static str,
    /// Before each further line.
    next: &'static str,
    /// Behind the last line.
    end: &'static str,
}

/// Comments of IEC 61131-3.
pub(crate) const IEC: Comments = Comments { first: "(* ", next: "   ", end: " *)" };

/// Comments of C.
pub(crate) const C: Comments = Comments { first: "/* ", next: "   ", end: " */" };

/// Comments of SCL.
pub(crate) const SCL: Comments = Comments { first: "// ", next: "// ", end: "" };

/// Comments of STL.
pub(crate) const STL: Comments = Comments { first: "// ", next: "// ", end: "" };

/// Comments of Rust.
pub(crate) const RUST: Comments = Comments { first: "// ", next: "// ", end: "" };

/// Comments of JavaScript.
pub(crate) const JS: Comments = Comments { first: "// ", next: "// ", end: "" };

/// A growing text.
pub(crate) struct Writer {
    out: String,
    comments: &'static Comments,
    indent: usize,
    /// A blank line is due before the next line.
    blank: bool,
    /// Nothing stands in the block yet: a blank line would look odd.
    fresh: bool,
    /// Notes which lines come from what, if somebody asks.
    trace: Option<Box<Trace>>,
}

impl Writer {
    /// No text yet.
    pub fn new(comments: &'static Comments) -> Self {
        Writer { out: String::new(), comments, indent: 0, blank: false, fresh: true, trace: None }
    }

    /// Makes room for so much text: what grows by doubling is copied again and again.
    pub fn with_room(mut self, bytes: usize) -> Self {
        self.out.reserve(bytes);
        self
    }

    /// Notes from here on which lines come from what, if that is wanted.
    pub fn traced(mut self, wanted: bool) -> Self {
        self.trace = wanted.then(Box::default);
        self
    }

    /// Whether it notes which lines come from what.
    pub fn is_traced(&self) -> bool {
        self.trace.is_some()
    }

    /// What comes now, and what came until now.
    pub fn origin(&mut self, origin: Origin) -> Origin {
        self.trace.as_mut().map_or(Origin::Chart, |trace| trace.set(origin))
    }

    /// Something inside of what comes until now, which is returned: the chart as a whole is no news.
    pub fn inner_origin(&mut self, origin: Origin) -> Origin {
        let outer = self.origin(origin);
        self.origin(origin.or(outer));
        outer
    }

    /// What else comes until another origin is set.
    pub fn also(&mut self, origin: Origin) {
        if let Some(trace) = &mut self.trace {
            trace.also(origin);
        }
    }

    /// The text.
    pub fn finish(self) -> String {
        self.out
    }

    /// The text, and which lines of it come from what.
    pub fn finish_traced(self) -> (String, Lines) {
        (self.out, self.trace.map(|trace| trace.finish()).unwrap_or_default())
    }

    /// What is written so far.
    pub fn written(&self) -> &str {
        &self.out
    }

    /// How long the text is, in bytes.
    pub fn len(&self) -> usize {
        self.out.len()
    }

    /// The columns that the indentation takes.
    pub fn indent(&self) -> usize {
        self.indent
    }

    /// The last column that a line here takes, if it can be broken at all.
    pub fn width(&self) -> usize {
        WIDTH.max(self.indent + LEAST_ROOM)
    }

    /// The last column at which the remarks of neighbouring lines start together.
    pub fn furthest_remark(&self) -> usize {
        self.width() - LEAST_ROOM_FOR_REMARK
    }

    /// Whether a clean comment fits behind a line that ends at `column`.
    pub fn fits_behind(&self, column: usize, comment: &str) -> bool {
        column + 8 + comment.chars().count() <= self.width() + ROOM_FOR_COMMENT
    }

    /// A blank line before what comes next, unless a block starts there.
    pub fn blank(&mut self) {
        self.blank = true;
    }

    /// Starts a line; the text follows by [`Writer::text`].
    pub fn start(&mut self) {
        self.blank_line();
        self.blanks(self.indent);
    }

    fn blanks(&mut self, mut count: usize) {
        const BLANKS: &str = "                                ";
        while count > 0 {
            let some = count.min(BLANKS.len());
            self.out.push_str(&BLANKS[..some]);
            count -= some;
        }
    }

    /// Text within a line.
    pub fn text(&mut self, text: &str) {
        self.out.push_str(text);
    }

    /// Ends a line.
    pub fn end(&mut self) {
        self.out.push('\n');
        if let Some(trace) = &mut self.trace {
            trace.complete(&self.out);
        }
    }

    /// The blank line that is due.
    fn blank_line(&mut self) {
        if self.blank && !self.fresh {
            self.out.push('\n');
            if let Some(trace) = &mut self.trace {
                trace.skip(&self.out);
            }
        }
        self.blank = false;
        self.fresh = false;
    }

    /// A whole line.
    pub fn line(&mut self, text: &str) {
        self.start();
        self.text(text);
        self.end();
    }

    /// A line that opens a block.
    pub fn open(&mut self, text: &str) {
        self.line(text);
        self.enter();
    }

    /// A text that is written apart, as deep inside.
    pub fn apart(&self) -> Writer {
        Writer { indent: self.indent, ..Writer::new(self.comments) }.traced(self.is_traced())
    }

    /// A block that was written apart.
    pub fn append(&mut self, block: Writer) {
        if block.out.is_empty() {
            return;
        }
        self.blank_line();
        self.out.push_str(&block.out);
        if let (Some(trace), Some(inner)) = (&mut self.trace, block.trace) {
            trace.append(*inner, &self.out);
        }
    }

    /// What follows is one level deeper.
    pub fn enter(&mut self) {
        self.indent += STEP;
        self.fresh = true;
    }

    /// What follows is one level higher.
    pub fn leave(&mut self) {
        self.indent = self.indent.saturating_sub(STEP);
        self.blank = false;
        self.fresh = false;
    }

    /// The line that closes a block.
    pub fn close(&mut self, text: &str) {
        self.leave();
        self.line(text);
    }

    /// A comment on lines of its own; nothing if the text, which is clean, is empty.
    pub fn comment(&mut self, text: &str) {
        if !text.is_empty() {
            self.block_comment([text.to_owned()]);
        }
    }

    /// One comment of several clean texts, each on lines of its own.
    pub fn block_comment(&mut self, texts: impl IntoIterator<Item = String>) {
        let width = self.width() - self.indent - 6;
        let mut lines = texts.into_iter().flat_map(|text| wrap(&text, width)).peekable();
        let mut first = true;
        while let Some(line) = lines.next() {
            self.start();
            self.text(if first { self.comments.first } else { self.comments.next });
            self.text(&line);
            if lines.peek().is_none() {
                self.text(self.comments.end);
            }
            self.end();
            first = false;
        }
    }

    /// A comment at the end of a line whose text takes `length` columns, at `column` or further right.
    pub fn trailing_comment(&mut self, length: usize, column: usize, text: &str) {
        self.blanks(column.max(length).saturating_sub(length) + 2);
        self.text(self.comments.first);
        self.text(text);
        self.text(self.comments.end);
    }
}
