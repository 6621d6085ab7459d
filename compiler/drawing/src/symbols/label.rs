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
