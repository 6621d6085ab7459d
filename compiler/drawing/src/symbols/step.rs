//! Steps \[1\] to \[6\]: plain, initial, enclosing, macro, active, and with an activation link \[41\].

use super::action::{Block, blocks};
use super::comment::{APART, Comment};
use super::{STEP, Symbol};
use crate::font::{LABEL, shown, width};
use crate::picture::{Anchor, Group, Shape, Style};
use grafc_layout::{Point, Size};

/// What a step is.
pub(crate) struct Step<'a> {
    pub label: &'a str,
    pub comment: Option<&'a str>,
    pub is_macro: bool,
    pub is_initial: bool,
    pub is_enclosing: bool,
    pub is_activated: bool,
    pub is_active: bool,
    pub blocks: Vec<Block>,
}

/// From a step to its actions.
const TO_ACTIONS: i32 = 20;
/// From the outer square of an initial step to the inner one.
const DOUBLED: i32 = 4;

/// Draws a step with its actions.
pub(crate) fn step(step: Step<'_>) -> Symbol {
    let label = shown(step.label);
    let inner = if step.is_enclosing { 30 } else { 16 };
    let half = ((width(&label, LABEL) + inner + 1) / 2).max(STEP / 2);
    let mut class = "step".to_string();
    let kinds = [
        (step.is_initial, " initial"),
        (step.is_macro, " macro"),
        (step.is_enclosing, " enclosing"),
        (step.is_activated, " activated"),
        (step.is_active, " active"),
    ];
    kinds.iter().filter(|(is, _)| *is).for_each(|(_, word)| class.push_str(word));
    let mut group = Group::new(&class).of("data-step", step.label).about(step.comment);
    let shapes = &mut group.shapes;
    shapes.push(Shape::rect(-half, 0, 2 * half, STEP, Style::Box));
    let inset = if step.is_initial { DOUBLED } else { 0 };
    if step.is_initial {
        shapes.push(Shape::rect(inset - half, inset, 2 * (half - inset), STEP - 2 * inset, Style::Box));
    }
    if step.is_enclosing {
        let (left, right, top, bottom) = (inset - half, half - inset, inset, STEP - inset);
        let cut = 9;
        let corners = [
            [(left, top + cut), (left + cut, top)],
            [(right - cut, top), (right, top + cut)],
            [(right, bottom - cut), (right - cut, bottom)],
            [(left + cut, bottom), (left, bottom - cut)],
        ];
        let lines = corners.map(|corner| corner.map(|(x, y)| Point { x, y }).to_vec()).to_vec();
        shapes.push(Shape::Path { lines, closed: false, style: Style::Line });
    }
    if step.is_macro {
        for y in [6, STEP - 6] {
            shapes.push(Shape::line(&[(-half, y), (half, y)]));
        }
    }
    let baseline = if step.is_initial || step.is_macro { 23 } else { 21 };
    shapes.push(Shape::text((0, baseline), Anchor::Middle, "label", LABEL, label));
    if step.is_active {
        shapes.push(Shape::Dot { at: Point { x: 0, y: baseline + 6 } });
    }
    let mut size = Size { left: half, right: half, above: 0, body: STEP, below: 0 };
    if step.is_activated {
        shapes.push(Shape::text((-half - 5, STEP / 2 + 8), Anchor::End, "link-mark", 20, "*".to_string()));
        size.left += 16;
    }
    let middle = STEP / 2;
    let comment = step.comment.map(Comment::new);
    let mut to_comment = half + APART;
    if !step.blocks.is_empty() {
        shapes.push(Shape::line(&[(half, middle), (half + TO_ACTIONS, middle)]));
        let placed = blocks(step.blocks, half + TO_ACTIONS, middle);
        if let Some(comment) = &comment {
            to_comment = comment.beside(half + TO_ACTIONS, &placed);
        }
        shapes.extend(placed.lines);
        group.groups = placed.groups;
        size.right += TO_ACTIONS + placed.width;
        size.above = size.above.max(placed.up - middle);
        size.below = size.below.max(placed.down - (STEP - middle));
    }
    if let Some(comment) = comment {
        group.shapes.extend(comment.shapes(to_comment, middle - comment.height / 2));
        size.right = size.right.max(to_comment + comment.width);
        size.above = size.above.max(comment.height / 2 - middle);
        size.below = size.below.max((comment.height + 1) / 2 - (STEP - middle));
    }
    Symbol { group, size }
}
