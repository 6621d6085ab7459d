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
/// The middle of the dot of an active step.
const DOT: i32 = 28;

/// Draws a step with its actions.
pub(crate) fn step(step: Step<'_>) -> Symbol {
    let label = shown(step.label);
    // The label keeps clear of the sides, and of the corners that are cut.
    let inner = match (step.is_enclosing, step.is_initial) {
        (true, true) => 22,
        (true, false) => 18,
        (false, _) => 16,
    };
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
    // In the upper half, under what is there; a dot has the lower half.
    let baseline = match (step.is_macro, step.is_initial) {
        (true, _) => 20,
        (false, true) => 17,
        (false, false) => 16,
    };
    shapes.push(Shape::text((0, baseline), Anchor::Middle, "label", LABEL, label));
    if step.is_active {
        shapes.push(Shape::Dot { at: Point { x: 0, y: DOT } });
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

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(label: &str, is_macro: bool, is_initial: bool, is_enclosing: bool) -> Symbol {
        let blocks = Vec::new();
        let is_active = true;
        step(Step { label, comment: None, is_macro, is_initial, is_enclosing, is_activated: false, is_active, blocks })
    }

    #[test]
    fn the_label_is_in_the_upper_half_and_the_dot_clear_of_it() {
        for (is_macro, is_initial) in [(false, false), (false, true), (true, false)] {
            let group = drawn("jpg", is_macro, is_initial, false).group;
            let label =
                |shape: &Shape| if let Shape::Text { at, class: "label", .. } = shape { Some(at.y) } else { None };
            let baseline = group.shapes.iter().find_map(label);
            let baseline = baseline.expect("a label");
            assert!(baseline <= STEP / 2);
            // Letters go down by three, and the dot has a radius of four.
            let dot = |shape: &Shape| if let Shape::Dot { at } = shape { Some(at.y) } else { None };
            let dot = group.shapes.iter().find_map(dot);
            assert!(dot.expect("a dot") - 4 > baseline + 3);
        }
    }

    #[test]
    fn two_digits_fit_a_square() {
        for (is_macro, is_initial, is_enclosing) in [
            (false, false, false),
            (true, false, false),
            (false, true, false),
            (false, false, true),
            (false, true, true),
        ] {
            let size = drawn("42", is_macro, is_initial, is_enclosing).size;
            assert_eq!((size.left, size.right, size.body), (STEP / 2, STEP / 2, STEP));
        }
    }
}
