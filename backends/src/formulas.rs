//! Formulas as expressions of some language, on one line: what all notations share.
//!
//! A [`Notation`] says what a formula looks like and where parentheses stand. The widths of all formulas are known
//! beforehand, so that each is written once, flat or broken into lines. Recursion is as deep as a formula, which [`crate::limits`]
//! bounds.

use crate::writer::Writer;
use ecow::EcoString;
use grafc_formula::FormulaId;
use std::borrow::Cow;

/// How a language spells formulas.
pub(crate) trait Notation {
    /// What parentheses depend on.
    type Level: Copy;

    /// So many operands stand below each other; more of them in groups in parentheses.
    const LONGEST_CHAIN: usize = usize::MAX;

    /// What a formula looks like.
    fn shape(&self, id: FormulaId) -> Shape<'_, Self::Level>;

    /// Whether an operand of that level needs parentheses at that place of its parent.
    fn needs_parentheses(&self, parent: Self::Level, place: usize, operand: Self::Level) -> bool;
}

/// What a formula looks like.
pub(crate) struct Shape<'p, Level> {
    pub level: Level,
    pub arrangement: Arrangement<'p>,
}

/// How texts and operands make up a formula.
pub(crate) enum Arrangement<'p> {
    /// A text that holds together.
    Atom(EcoString),
    /// The name of a variable, or what is written in its place.
    Name(&'p str),
    /// A word before an operand, which is at place 1.
    Prefix(&'static str, FormulaId),
    /// Texts and operands, as in a call.
    Pieces(Vec<Piece>),
    /// Operands with a word between them.
    Infix(&'static str, Cow<'p, [FormulaId]>),
}

pub(crate) enum Piece {
    /// A text between operands.
    Text(EcoString),
    /// An operand that the texts around it enclose.
    Enclosed(FormulaId),
    /// An operand at a place, in parentheses if need be.
    Operand(usize, FormulaId),
}

/// The formulas of one program in a notation.
pub(crate) struct Formulas<N, Level> {
    pub notation: N,
    /// The columns that each formula takes on one line.
    widths: Vec<u32>,
    levels: Vec<Level>,
}

impl<N: Notation> Formulas<N, N::Level> {
    /// Measures all formulas; operands come before operators.
    pub fn new(notation: N, ids: impl Iterator<Item = FormulaId>) -> Self {
        let count = ids.size_hint().0;
        let mut this = Formulas { notation, widths: Vec::with_capacity(count), levels: Vec::with_capacity(count) };
        for id in ids {
            let (width, level) = this.measure(id);
            this.widths.push(width.try_into().unwrap_or(u32::MAX));
            this.levels.push(level);
        }
        this
    }

    /// The columns that a formula takes on one line.
    pub fn width(&self, id: FormulaId) -> usize {
        self.widths[id.index()] as usize
    }

    /// What parentheses around a formula depend on.
    pub fn level(&self, id: FormulaId) -> N::Level {
        self.levels[id.index()]
    }

    /// Whether a formula stands in parentheses.
    pub fn needs_parentheses(&self, parent: N::Level, place: usize, id: FormulaId) -> bool {
        self.notation.needs_parentheses(parent, place, self.level(id))
    }

    fn measure(&self, id: FormulaId) -> (usize, N::Level) {
        let shape = self.notation.shape(id);
        let operand = |place: usize, id: FormulaId| {
            self.width(id).saturating_add(if self.needs_parentheses(shape.level, place, id) { 2 } else { 0 })
        };
        let width = match &shape.arrangement {
            Arrangement::Atom(text) => text.len(),
            Arrangement::Name(text) => text.len(),
            Arrangement::Prefix(word, id) => operand(1, *id).saturating_add(word.len()),
            Arrangement::Pieces(pieces) => pieces.iter().fold(0, |sum: usize, piece| {
                sum.saturating_add(match piece {
                    Piece::Text(text) => text.len(),
                    Piece::Enclosed(id) => self.width(*id),
                    Piece::Operand(place, id) => operand(*place, *id),
                })
            }),
            Arrangement::Infix(operator, operands) => {
                let gaps = (operands.len().saturating_sub(1)) * (operator.len() + 2);
                operands.iter().enumerate().fold(gaps, |sum, (place, id)| sum.saturating_add(operand(place, *id)))
            }
        };
        (width, shape.level)
    }

    /// Writes a formula on the current line.
    pub fn flat(&self, out: &mut Writer, id: FormulaId) {
        let shape = self.notation.shape(id);
        match &shape.arrangement {
            Arrangement::Atom(text) => out.text(text),
            Arrangement::Name(text) => out.text(text),
            Arrangement::Prefix(word, operand) => {
                out.text(word);
                self.operand(out, shape.level, 1, *operand);
            }
            Arrangement::Pieces(pieces) => {
                for piece in pieces {
                    match piece {
                        Piece::Text(text) => out.text(text),
                        Piece::Enclosed(id) => self.flat(out, *id),
                        Piece::Operand(place, id) => self.operand(out, shape.level, *place, *id),
                    }
                }
            }
            Arrangement::Infix(operator, operands) => {
                for (place, operand) in operands.iter().enumerate() {
                    if place > 0 {
                        out.text(" ");
                        out.text(operator);
                        out.text(" ");
                    }
                    self.operand(out, shape.level, place, *operand);
                }
            }
        }
    }

    /// Writes an operand on the current line, in parentheses if need be.
    pub fn operand(&self, out: &mut Writer, parent: N::Level, place: usize, id: FormulaId) {
        let wrap = self.needs_parentheses(parent, place, id);
        out.text(if wrap { "(" } else { "" });
        self.flat(out, id);
        out.text(if wrap { ")" } else { "" });
    }

    /// Writes a formula on lines of its own, `tail` behind the last.
    pub fn lines(&self, out: &mut Writer, id: FormulaId, tail: &str) {
        let shape = self.notation.shape(id);
        match &shape.arrangement {
            Arrangement::Infix(operator, operands) if out.indent() + self.width(id) + tail.len() > out.width() => {
                self.chain(out, shape.level, operator, operands, tail);
            }
            Arrangement::Prefix(word, operand) if out.indent() + self.width(id) + tail.len() > out.width() => {
                self.term(out, shape.level, 1, word, *operand, tail);
            }
            Arrangement::Atom(_)
            | Arrangement::Name(_)
            | Arrangement::Prefix(..)
            | Arrangement::Pieces(..)
            | Arrangement::Infix(..) => {
                out.start();
                self.flat(out, id);
                out.text(tail);
                out.end();
            }
        }
    }

    /// A term a line, each line but the first led by the operator; very many terms in groups.
    fn chain(&self, out: &mut Writer, level: N::Level, operator: &str, operands: &[FormulaId], tail: &str) {
        let lead = format!("{operator} ");
        let tail_of = |last: bool| if last { tail } else { "" };
        if operands.len() <= N::LONGEST_CHAIN {
            for (place, operand) in operands.iter().enumerate() {
                let lead = if place == 0 { "" } else { &lead };
                self.term(out, level, place, lead, *operand, tail_of(place + 1 == operands.len()));
            }
            return;
        }
        let mut size = N::LONGEST_CHAIN;
        while operands.len() > size * N::LONGEST_CHAIN {
            size *= N::LONGEST_CHAIN;
        }
        let count = operands.len().div_ceil(size);
        for (place, group) in operands.chunks(size).enumerate() {
            let lead = if place == 0 { "" } else { &lead };
            out.open(&format!("{lead}("));
            self.chain(out, level, operator, group, "");
            out.close(&format!("){}", tail_of(place + 1 == count)));
        }
    }

    /// One operand on lines of its own.
    fn term(&self, out: &mut Writer, parent: N::Level, place: usize, lead: &str, id: FormulaId, tail: &str) {
        let wrap = self.needs_parentheses(parent, place, id);
        if out.indent() + lead.len() + self.width(id) + 2 + tail.len() > out.width() {
            if wrap {
                out.open(&format!("{lead}("));
                self.lines(out, id, "");
                return out.close(&format!("){tail}"));
            }
            let shape = self.notation.shape(id);
            if let Arrangement::Prefix(word, operand) = shape.arrangement {
                return self.term(out, shape.level, 1, &format!("{lead}{word}"), operand, tail);
            }
        }
        out.start();
        out.text(lead);
        self.operand(out, parent, place, id);
        out.text(tail);
        out.end();
    }
}
