//! Comments \[30\]: in quotation marks beside their element.

use super::action::Blocks;
use crate::font::{COMMENT, shown, width, wrapped};
use crate::picture::{Anchor, Shape};

/// A comment that is wider is broken at blanks.
const MOST: i32 = 150;
/// From an element to its comment.
pub(crate) const APART: i32 = 10;
/// From one of its lines to the next.
const LINE: i32 = 13;

/// A comment in lines.
pub(crate) struct Comment {
    lines: Vec<String>,
    pub width: i32,
    pub height: i32,
}

impl Comment {
    pub(crate) fn new(text: &str) -> Comment {
        Comment::no_wider(text, MOST)
    }

    pub(crate) fn no_wider(text: &str, most: i32) -> Comment {
        let text = format!("\"{}\"", shown(text));
        let lines = wrapped(&text, COMMENT, most);
        let widest = lines.iter().map(|line| width(line, COMMENT)).max().unwrap_or(0);
        Comment { width: widest, height: LINE * lines.len() as i32, lines }
    }

    /// Beside blocks that begin at `left`: right of the first row, if it is not higher than that, else right of all.
    pub(crate) fn beside(&self, left: i32, blocks: &Blocks) -> i32 {
        let (wide, high) = blocks.first;
        left + if self.height <= high { wide } else { blocks.width } + APART
    }

    /// The shapes, with the upper left corner at a place.
    pub(crate) fn shapes(&self, left: i32, top: i32) -> Vec<Shape> {
        let text = |(number, line): (usize, &String)| {
            let baseline = top + LINE * number as i32 + 10;
            Shape::text((left, baseline), Anchor::Start, "comment", COMMENT, line.clone())
        };
        self.lines.iter().enumerate().map(text).collect()
    }
}
