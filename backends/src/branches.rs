//! An `If`, branch by branch, as languages with a word before each have it.

use crate::writer::Writer;
use grafc_formula::FormulaId;
use grafc_logic::scan::{Statement, is_empty, origin_of, origin_of_end};

/// What stands before and behind the branches.
pub(crate) struct Words {
    /// Before the first condition.
    pub first: &'static str,
    /// Before each other one.
    pub next: &'static str,
    /// Before what is done otherwise.
    pub otherwise: &'static str,
    /// Behind all.
    pub end: &'static str,
}

/// Writes conditions by `head`, after a word, and bodies by `block`.
pub(crate) fn write_branches(
    out: &mut Writer,
    words: Words,
    (branches, otherwise): (&[(FormulaId, Vec<Statement>)], &[Statement]),
    head: impl Fn(&mut Writer, &str, FormulaId),
    block: impl Fn(&mut Writer, &[Statement]),
) {
    if branches.is_empty() {
        return block(out, otherwise);
    }
    for (place, (condition, body)) in branches.iter().enumerate() {
        let outer = out.inner_origin(origin_of(body));
        head(out, if place == 0 { words.first } else { words.next }, *condition);
        out.enter();
        block(out, body);
        out.leave();
        out.origin(outer);
    }
    if !is_empty(otherwise) {
        let outer = out.inner_origin(origin_of(otherwise));
        out.open(words.otherwise);
        block(out, otherwise);
        out.leave();
        out.origin(outer);
    }
    let outer = out.inner_origin(origin_of_end(branches, otherwise));
    out.line(words.end);
    out.origin(outer);
}
