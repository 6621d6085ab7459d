//! Columns and rows: where everything on the rungs stands.
//!
//! A rung begins with its comments. Below them the first row runs from the left rail to the right one; branches and
//! further coils stand in rows below it. Contacts take as much room as their names, which stand above them; coils stand
//! in one column. Where branches part and meet, the wires turn.

use super::rung::{BlockCall, Contact, End, Item, Rung, Sink};
use crate::comment::wrap;
use crate::plcopen::drawing::Point;

/// The left rail, and the width of rails.
pub(super) const LEFT: i64 = 20;
pub(super) const RAIL: i64 = 3;
/// Contacts and coils, and where their pins are.
pub(super) const CONTACT: Point = (21, 15);
pub(super) const PIN: i64 = 8;
/// From contact to contact, from row to row.
const COLUMN: i64 = 90;
const ROW: i64 = 40;
/// Above the first row: names; and the upper part of a block with the name of its instance.
const ABOVE: i64 = 30;
const ABOVE_BLOCK: i64 = 60;
/// The first pin of a block, and from pin to pin.
pub(super) const FIRST_PIN: i64 = 30;
pub(super) const PINS: i64 = 20;
/// Texts at the pins of blocks.
pub(super) const TEXT_HEIGHT: i64 = 18;
/// What wires need between two things; where they turn.
const GAP: i64 = 25;
pub(super) const TURN: i64 = 12;
/// The columns of a comment, the height of its lines.
const COMMENT_COLUMNS: usize = 100;
const COMMENT_LINE: i64 = 15;
/// Below a rung.
const BELOW: i64 = 25;

/// The room that a text takes.
pub(super) fn text_width(text: &str) -> i64 {
    7 * i64::try_from(text.chars().count()).unwrap_or(i64::MAX / 8)
}

/// The room of a contact or coil with its name.
fn slot(name: &str) -> i64 {
    text_width(name).max(CONTACT.0) + 4
}

/// The room of a contact and the wire behind it: as many columns as its name needs.
fn columns(name: &str) -> i64 {
    (slot(name) + TURN + COLUMN - 1) / COLUMN * COLUMN
}

/// A comment and its lines.
pub(super) struct Note {
    pub at: Point,
    pub size: Point,
    pub lines: Vec<String>,
}

/// Where the parts of a rung are.
pub(super) struct Placed {
    pub notes: Vec<Note>,
    /// The top and the height of the rails, and the height of the first row.
    pub top: i64,
    pub height: i64,
    pub row: i64,
    /// The left edges of contacts, item by item, branch by branch.
    pub contacts: Vec<Vec<Vec<i64>>>,
    /// Where branches part and where they meet, item by item.
    pub turns: Vec<(i64, i64)>,
    /// The left edges of a block and of the text behind it.
    pub block: i64,
    pub behind: i64,
}

/// All rungs and what they have in common.
pub(super) struct Layout {
    pub rungs: Vec<Placed>,
    /// The left edges of the coils and of the right rail, and where wires turn to the coils.
    pub coils: i64,
    pub right: i64,
    pub turn: i64,
}

/// The height of a row of a rung.
pub(super) fn row(placed: &Placed, row: usize) -> i64 {
    placed.row + ROW * i64::try_from(row).unwrap_or(0)
}

/// The size of a block.
pub(super) fn block_size(block: &BlockCall) -> Point {
    let pins = block.inputs.len() + 1;
    let pins = i64::try_from(pins.max(block.outputs.len())).unwrap_or(0);
    (80.max(text_width(block.kind) + 20), FIRST_PIN + PINS * pins - 10)
}

/// Places all rungs below each other.
pub(super) fn layout(rungs: &[Rung]) -> Layout {
    let mut top = 20;
    let (mut placed, mut end, mut widest_coil) = (Vec::with_capacity(rungs.len()), LEFT, 0);
    for rung in rungs {
        let (one, right, below) = place(rung, top);
        placed.push(one);
        (end, top) = (end.max(right), below);
        let coils: Vec<&str> = match &rung.end {
            End::Coils(coils) => coils.iter().map(|coil| coil.name.as_str()).collect(),
            End::Block(block) => block.outputs.iter().filter_map(|(_, sink)| coil_of(sink)).collect(),
        };
        widest_coil = coils.into_iter().map(slot).fold(widest_coil, i64::max);
    }
    let coils = end + GAP + (widest_coil - CONTACT.0) / 2;
    Layout { rungs: placed, coils, right: end + widest_coil + 2 * GAP, turn: end + GAP - TURN }
}

/// The coil at an output.
pub(super) fn coil_of(sink: &Sink) -> Option<&str> {
    match sink {
        Sink::Coil(name) => Some(name),
        Sink::Open | Sink::Rail | Sink::Variable(_) => None,
    }
}

/// The variable at an output.
pub(super) fn variable_of(sink: &Sink) -> Option<&str> {
    match sink {
        Sink::Variable(name) => Some(name),
        Sink::Open | Sink::Rail | Sink::Coil(_) => None,
    }
}

/// Places one rung; also where it ends on the right, without its coils, and what is below it.
fn place(rung: &Rung, top: i64) -> (Placed, i64, i64) {
    let (notes, top) = notes(&rung.comments, top);
    let row = top
        + match rung.end {
            End::Coils(_) => ABOVE,
            End::Block(_) => ABOVE_BLOCK,
        };
    let mut x = LEFT + RAIL + GAP;
    let (mut contacts, mut turns, mut rows) = (Vec::new(), Vec::new(), 1);
    for item in &rung.items {
        let branches: Vec<&[Contact]> = match item {
            Item::Contact(contact) => vec![std::slice::from_ref(contact)],
            Item::Group(branches) => branches.iter().map(Vec::as_slice).collect(),
        };
        let (lefts, ends): (Vec<_>, Vec<_>) = branches.iter().map(|branch| series(branch, x)).unzip();
        let end = ends.into_iter().max().unwrap_or(x);
        contacts.push(lefts);
        turns.push((x, end));
        rows = rows.max(branches.len());
        x = end;
    }
    let (mut block, mut behind) = (0, 0);
    let mut height = ROW * i64::try_from(rows).unwrap_or(0);
    match &rung.end {
        End::Coils(coils) => height = height.max(ROW * i64::try_from(coils.len()).unwrap_or(0)),
        End::Block(end) => {
            block = x + end.inputs.iter().map(|(_, text)| text_width(text) + 10 + GAP).max().unwrap_or(0);
            let size = block_size(end);
            behind = block + size.0 + GAP;
            x = behind
                + end.outputs.iter().filter_map(|(_, sink)| variable_of(sink)).map(text_width).max().unwrap_or(0);
            height = height.max(size.1 - FIRST_PIN + PINS);
        }
    }
    let height = row - top + height - ROW / 2;
    let placed = Placed { notes, top, height, row, contacts, turns, block, behind };
    (placed, x, top + height + BELOW)
}

/// Contacts in a row from `x` on: their left edges, and where the next may begin.
fn series(contacts: &[Contact], mut x: i64) -> (Vec<i64>, i64) {
    let mut lefts = Vec::with_capacity(contacts.len());
    for contact in contacts {
        let room = columns(&contact.name);
        lefts.push(x + (room - CONTACT.0) / 2);
        x += room;
    }
    (lefts, x)
}

/// Comments below each other from `top` on, and what is below them.
fn notes(comments: &[String], mut top: i64) -> (Vec<Note>, i64) {
    let mut notes = Vec::new();
    for comment in comments {
        let lines = wrap(comment, COMMENT_COLUMNS);
        let width = lines.iter().map(|line| text_width(line)).max().unwrap_or(0) + 20;
        let height = COMMENT_LINE * i64::try_from(lines.len()).unwrap_or(0) + 10;
        notes.push(Note { at: (LEFT, top), size: (width, height), lines });
        top += height + 5;
    }
    (notes, top)
}
