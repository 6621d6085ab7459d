//! Transitions \[7\] \[8\] with their conditions \[13\] to \[19\], and what is done on clearing.

use super::Symbol;
use super::action::{Block, blocks};
use super::comment::{APART, Comment};
use crate::font::{TEXT, shown, width};
use crate::picture::{Anchor, Group, Shape, Style};
use crate::rich::{Rich, Token};
use grafc_layout::Size;

/// What a transition is.
pub(crate) struct Transition<'a> {
    /// What it is called for programs.
    pub name: String,
    /// The how manieth of the chart it is, from 1.
    pub number: usize,
    pub designation: Option<&'a str>,
    pub comment: Option<&'a str>,
    pub condition: Vec<Token>,
    pub blocks: Vec<Block>,
}

/// Half the width of the bar, and its thickness.
const HALF: i32 = 12;
pub(crate) const BAR: i32 = 4;
/// From the bar to texts.
const TO_TEXT: i32 = 8;
/// The width at which conditions are broken.
const MOST: i32 = 200;

/// Draws a transition.
pub(crate) fn transition(transition: Transition<'_>) -> Symbol {
    let group = Group::new("transition").of("data-transition", transition.name);
    let mut group = group.of("data-number", transition.number.to_string()).about(transition.comment);
    let middle = BAR / 2;
    group.shapes.push(Shape::rect(-HALF, 0, 2 * HALF, BAR, Style::Bar));
    let mut size = Size { left: HALF, right: HALF, above: 8, body: BAR, below: 8 };
    if let Some(designation) = transition.designation {
        let text = format!("({})", shown(designation));
        size.left += TO_TEXT + width(&text, TEXT);
        let at = (-HALF - TO_TEXT, middle + 5);
        group.shapes.push(Shape::text(at, Anchor::End, "designation", TEXT, text));
    }
    let condition = Rich::new(transition.condition, MOST);
    let left = HALF + TO_TEXT;
    let has_actions = !transition.blocks.is_empty();
    // Over the line that leads to actions, else at the height of the bar.
    let top = if has_actions { middle - 4 - condition.height() } else { middle - condition.height() / 2 };
    group.shapes.extend(condition.shapes(left, top, "condition"));
    size.right = left + condition.width;
    size.above = size.above.max(-top);
    size.below = size.below.max(top + condition.height() - BAR);
    let comment = transition.comment.map(Comment::new);
    let mut to_comment = size.right + APART;
    if has_actions {
        let right = size.right + TO_TEXT;
        group.shapes.push(Shape::line(&[(HALF, middle), (right, middle)]));
        let placed = blocks(transition.blocks, right, middle);
        if let Some(comment) = &comment {
            to_comment = comment.beside(right, &placed);
        }
        group.shapes.extend(placed.lines);
        group.groups = placed.groups;
        size.right = right + placed.width;
        size.above = size.above.max(placed.up - middle);
        size.below = size.below.max(placed.down - (BAR - middle));
    }
    if let Some(comment) = comment {
        group.shapes.extend(comment.shapes(to_comment, middle - comment.height / 2));
        size.right = size.right.max(to_comment + comment.width);
        size.above = size.above.max(comment.height / 2);
        size.below = size.below.max((comment.height + 1) / 2);
    }
    Symbol { group, size }
}
