//! Link labels \[12\]: a link that is interrupted ends in an arrow with where it goes on: `step 83`.

use super::Symbol;
use crate::font::{TEXT, width};
use crate::picture::{Anchor, Group, Shape, Style};
use grafc_layout::Size;

/// The height of the arrow.
const ARROW: i32 = 14;

/// Where a link goes on, under what it comes from.
pub(crate) fn onwards(text: &str) -> Symbol {
    let mut group = Group::new("label");
    group.shapes.push(Shape::path(&[(0, ARROW), (-5, ARROW - 10), (5, ARROW - 10)], true, Style::Filled));
    group.shapes.push(Shape::line(&[(0, 0), (0, ARROW - 4)]));
    group.shapes.push(Shape::text((11, ARROW), Anchor::Start, "label-text", TEXT, text.to_string()));
    let size = Size { left: 6, right: 11 + width(text, TEXT), above: 0, body: 0, below: ARROW + 5 };
    Symbol { group, size }
}

/// Where a link comes from, over what it leads to.
pub(crate) fn from(text: &str) -> Symbol {
    let mut group = Group::new("label");
    group.shapes.push(Shape::line(&[(0, -6), (0, ARROW)]));
    group.shapes.push(Shape::text((11, 5), Anchor::Start, "label-text", TEXT, text.to_string()));
    let size = Size { left: 4, right: 11 + width(text, TEXT), above: 8, body: ARROW, below: 0 };
    Symbol { group, size }
}

/// From one label at a step to the next.
const LINE: i32 = 18;
/// From the axis to a label right of it.
const BESIDE: i32 = 12;

/// A step with where links come to it from, right over it; other links may come down between. Like this a label takes no
/// way of its own.
pub(crate) fn entered(mut symbol: Symbol, texts: &[String], is_first: bool) -> Symbol {
    if texts.is_empty() {
        return symbol;
    }
    let mut group = Group::new("label");
    let bottom = -symbol.size.above;
    let lines = texts.len() as i32;
    for (place, text) in texts.iter().rev().enumerate() {
        let y = bottom - 10 - LINE * place as i32;
        group.shapes.push(Shape::line(&[(BESIDE, y), (0, y)]));
        group.shapes.push(Shape::text((BESIDE + 4, y + 4), Anchor::Start, "label-text", TEXT, text.clone()));
        symbol.size.right = symbol.size.right.max(BESIDE + 4 + width(text, TEXT));
    }
    let top = bottom - 10 - LINE * (lines - 1);
    // What comes from elsewhere alone has no other line down to the step.
    if is_first {
        group.shapes.push(Shape::line(&[(0, top), (0, 0)]));
    }
    symbol.size.above += LINE * lines + 6;
    symbol.group.groups.push(group);
    symbol
}
