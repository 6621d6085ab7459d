//! Actions \[20\] to \[29\], and those on clearing (4.7.4): rectangles, and what tells when they are done.

use crate::picture::{Group, Shape, Style};
use crate::rich::{Rich, Token};
use grafc_layout::Point;

/// When an action is done.
#[derive(Clone, Debug)]
pub(crate) enum When {
    /// Always while the step is active, or while a condition holds.
    While(Option<Vec<Token>>),
    /// The step is activated: an arrow upwards beside the left side.
    Activation,
    /// The step is deactivated: an arrow downwards.
    Deactivation,
    /// An event occurs: it stands above, with an arrow.
    Event(Vec<Token>),
    /// The transition is cleared: an oblique arrow within the left side.
    Clearing,
}

/// A rectangle with what belongs to it.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    text: Rich,
    above: Option<Rich>,
    kind: Kind,
    /// The class and data of its group.
    group: Group,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Plain,
    Rising,
    Falling,
    Event,
    Clearing,
    /// With a doubled outline.
    Order,
}

/// A rectangle with one line of text is so high.
pub(crate) const HEIGHT: i32 = 26;
/// The width at which texts are broken.
const MOST: i32 = 220;
/// From the rectangle up to its condition, and how far a line leads there.
const TICK: i32 = 8;
/// From the left side to the arrow beside it, and how much that is shorter at both ends: those of rectangles that touch
/// stay apart.
const TO_SHAFT: i32 = 6;
const SHORTER: i32 = 3;
/// From a side to the text.
const PADDING: i32 = 8;

impl Block {
    /// An action.
    pub(crate) fn action(text: Vec<Token>, when: When, group: Group) -> Block {
        let (kind, above) = match when {
            When::While(condition) => (Kind::Plain, condition),
            When::Activation => (Kind::Rising, None),
            When::Deactivation => (Kind::Falling, None),
            When::Event(event) => (Kind::Event, Some(event)),
            When::Clearing => (Kind::Clearing, None),
        };
        let above = above.map(|tokens| Rich::new(tokens, MOST));
        Block { text: Rich::new(text, MOST), above, kind, group }
    }

    /// A forcing order.
    pub(crate) fn order(text: Vec<Token>, group: Group) -> Block {
        Block { text: Rich::new(text, MOST), above: None, kind: Kind::Order, group }
    }

    /// What the text keeps from the left side.
    fn inset(&self) -> i32 {
        match self.kind {
            Kind::Plain | Kind::Event | Kind::Rising | Kind::Falling => PADDING,
            Kind::Clearing => PADDING + 14,
            Kind::Order => PADDING + 3,
        }
    }

    fn rectangle(&self) -> i32 {
        let right = if self.kind == Kind::Order { PADDING + 3 } else { PADDING };
        (self.inset() + self.text.width + right).max(HEIGHT)
    }

    /// The width of everything; the arrow at the left side reaches out of the rectangle.
    pub(crate) fn width(&self) -> i32 {
        self.rectangle().max(self.above.as_ref().map_or(0, |above| above.width + 16))
    }

    /// What stands above the rectangle.
    pub(crate) fn above(&self) -> i32 {
        self.above.as_ref().map_or(0, |above| above.height() + TICK + 2)
    }

    /// The height of the rectangle.
    pub(crate) fn height(&self) -> i32 {
        HEIGHT.max(self.text.height() + 11)
    }

    /// Whether nothing stands out of the rectangle, so that another one can touch it.
    fn is_closed(&self) -> bool {
        self.above.is_none()
    }

    /// The group, with the upper left corner of the rectangle at a place.
    pub(crate) fn place(self, left: i32, top: i32) -> Group {
        let (wide, high) = (self.rectangle(), self.height());
        let mut shapes = vec![Shape::rect(0, 0, wide, high, Style::Box)];
        match self.kind {
            Kind::Plain => {}
            Kind::Order => shapes.push(Shape::rect(3, 3, wide - 6, high - 6, Style::Box)),
            Kind::Rising => shapes.extend(arrow(&[(-TO_SHAFT, high - SHORTER), (-TO_SHAFT, SHORTER)], 4)),
            Kind::Falling => shapes.extend(arrow(&[(-TO_SHAFT, SHORTER), (-TO_SHAFT, high - SHORTER)], 4)),
            Kind::Event => shapes.extend(arrow(&[(PADDING + 2, -TICK - 2), (PADDING + 2, 0)], 4)),
            Kind::Clearing => shapes.extend(arrow(&[(4, high / 2 + 8), (16, high / 2 - 8)], 5)),
        }
        if let Some(above) = &self.above {
            if self.kind == Kind::Plain {
                shapes.push(Shape::line(&[(PADDING + 2, 0), (PADDING + 2, -TICK)]));
            }
            shapes.extend(above.shapes(5, -self.above(), "condition"));
        }
        shapes.extend(self.text.shapes(self.inset(), (high - self.text.height()) / 2, "text"));
        Group { at: Point { x: left, y: top }, shapes, ..self.group }
    }
}

/// A line that ends in a filled head.
pub(crate) fn arrow(points: &[(i32, i32); 2], half: i32) -> [Shape; 2] {
    let [(x0, y0), (x1, y1)] = *points;
    let length = f64::from((x1 - x0).pow(2) + (y1 - y0).pow(2)).sqrt();
    let (dx, dy) = (f64::from(x1 - x0) / length, f64::from(y1 - y0) / length);
    let long = f64::from(half) * 2.0;
    let corner = |side: f64| {
        let x = f64::from(x1) - dx * long - dy * f64::from(half) * side * 0.8;
        let y = f64::from(y1) - dy * long + dx * f64::from(half) * side * 0.8;
        (x.round() as i32, y.round() as i32)
    };
    let head = [(x1, y1), corner(1.0), corner(-1.0)];
    [Shape::line(points), Shape::path(&head, true, Style::Filled)]
}

/// Blocks right of a step or transition: side by side where they are few and short, else under each other.
pub(crate) struct Blocks {
    pub groups: Vec<Group>,
    /// Lines that join them.
    pub lines: Vec<Shape>,
    pub width: i32,
    /// What the first row takes, and how high its rectangles are: beside it there is room.
    pub first: (i32, i32),
    /// From the middle of the first rectangle upwards and downwards.
    pub up: i32,
    pub down: i32,
}

/// So wide are actions side by side at most.
const SIDE_BY_SIDE: i32 = 190;
/// Between two rectangles of which the lower one has something above.
const APART: i32 = 4;

/// Places blocks with the left side at `left` and the middle of the first rectangle at `middle`.
pub(crate) fn blocks(blocks: Vec<Block>, left: i32, middle: i32) -> Blocks {
    let mut out = Blocks { groups: Vec::new(), lines: Vec::new(), width: 0, first: (0, HEIGHT), up: 0, down: 0 };
    let total: i32 = blocks.iter().map(Block::width).sum();
    let fits =
        total <= SIDE_BY_SIDE && blocks.iter().all(|block| block.height() == HEIGHT && block.kind != Kind::Rising);
    let fits = fits && blocks.iter().all(|block| block.kind != Kind::Falling && block.width() == block.rectangle());
    if fits {
        for block in blocks {
            out.up = out.up.max(HEIGHT / 2 + block.above());
            out.down = HEIGHT / 2;
            let wide = block.width();
            out.groups.push(block.place(left + out.width, middle - HEIGHT / 2));
            out.width += wide;
            out.first.0 = out.width;
        }
        return out;
    }
    let mut at = None;
    for block in blocks {
        let (wide, high, above) = (block.width(), block.height(), block.above());
        let top = match at {
            None => {
                out.up = high / 2 + above;
                out.first = (block.rectangle(), high);
                middle - high / 2
            }
            Some(bottom) if block.is_closed() => bottom,
            Some(bottom) => {
                let top = bottom + APART + above;
                out.lines.push(Shape::line(&[(left, bottom), (left, top)]));
                top
            }
        };
        at = Some(top + high);
        out.down = top + high - middle;
        out.width = out.width.max(wide);
        out.groups.push(block.place(left, top));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_of_stacked_actions_are_two() {
        let action = |when| Block::action(vec![Token::plain("C := 1")], when, Group::default());
        let placed = blocks(vec![action(When::Activation), action(When::Deactivation)], 0, 13);
        let shafts: Vec<(i32, i32, i32)> = placed
            .groups
            .iter()
            .flat_map(|group| group.shapes.iter().map(move |shape| (group.at.y, shape)))
            .filter_map(|(top, shape)| {
                let Shape::Path { lines, closed: false, .. } = shape else { return None };
                let (a, b) = (lines[0][0], lines[0][1]);
                Some((a.x, top + a.y.min(b.y), top + a.y.max(b.y)))
            })
            .collect();
        let [(x, _, bottom), (other_x, top, _)] = shafts[..] else { panic!("two shafts: {shafts:?}") };
        // Not on the edge of a rectangle, and apart from each other.
        assert!(x <= -4 && other_x == x);
        assert!(top - bottom >= 4, "{shafts:?}");
    }
}
