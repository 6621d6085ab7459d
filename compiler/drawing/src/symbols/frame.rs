//! Names of grafcets \[31\], enclosures \[38\] and expansions \[42\].

use super::comment::Comment;
use crate::font::{LABEL, shown, width};
use crate::picture::{Anchor, Shape, Style};
use grafc_layout::Bounds;

/// What a diagram stands in.
#[derive(Clone, Copy)]
pub(crate) enum Frame<'a> {
    /// A grafcet of its own: the name above, at the left, with that of its parent; no name where the chart leaves it out.
    Grafcet { name: &'a str, parent: Option<&'a str>, comment: Option<&'a str> },
    /// An enclosure: the label of the enclosing step at the top, the name at the bottom, both at the left.
    Enclosure { step: &'a str, name: &'a str, comment: Option<&'a str> },
    /// The expansion of a macro-step: its name above the frame.
    Expansion { name: &'a str, comment: Option<&'a str> },
}

/// What a frame keeps from what is in it.
const PADDING: i32 = 20;
/// The height of a line with a name.
const NAME: i32 = 24;

impl Frame<'_> {
    fn texts(&self) -> (&str, Option<&str>) {
        match *self {
            Frame::Grafcet { name, comment, .. }
            | Frame::Expansion { name, comment }
            | Frame::Enclosure { name, comment, .. } => (name, comment),
        }
    }

    /// What is drawn around a diagram of this size, with what follows its name, and the size with that.
    pub(crate) fn around(&self, inner: Bounds, suffix: &str) -> (Vec<Shape>, Bounds) {
        let (name, comment) = self.texts();
        let parent = match *self {
            Frame::Grafcet { parent, .. } => parent,
            Frame::Enclosure { .. } | Frame::Expansion { .. } => None,
        };
        let of = parent.map(|parent| format!(", child of {}", shown(parent))).unwrap_or_default();
        let name = format!("{}{suffix}{of}", shown(name));
        let comment = comment.map(|comment| Comment::no_wider(comment, (inner.width() - 40).max(240)));
        let own = width(&name, LABEL);
        let beside = comment.as_ref().map_or(0, |comment| comment.width + 12);
        let high = NAME.max(comment.as_ref().map_or(0, |comment| comment.height + 6));
        let mut shapes = Vec::new();
        let title = |left: i32, top: i32| {
            let mut shapes = vec![Shape::text((left, top + 16), Anchor::Start, "name", LABEL, name.clone())];
            shapes.extend(comment.iter().flat_map(|comment| comment.shapes(left + own + 12, top + 6)));
            shapes
        };
        match *self {
            Frame::Grafcet { .. } if name.is_empty() => (shapes, inner),
            Frame::Grafcet { .. } => {
                let top = inner.top - high - 4;
                shapes.extend(title(inner.left, top));
                let right = inner.right.max(inner.left + own + beside);
                (shapes, Bounds { top, right, ..inner })
            }
            Frame::Expansion { .. } => {
                let mut frame = grown(inner, PADDING);
                let top = frame.top - high;
                shapes.extend(title(frame.left, top));
                frame.right = frame.right.max(frame.left + own + beside);
                shapes.push(Shape::Rect { bounds: frame, style: Style::Frame });
                (shapes, Bounds { top, ..frame })
            }
            Frame::Enclosure { step, .. } => {
                let step = shown(step);
                let mut frame = grown(inner, PADDING);
                frame.top -= NAME - 8;
                frame.bottom += high - 8;
                let widest = (own + beside).max(width(&step, LABEL)) + 16;
                frame.right = frame.right.max(frame.left + widest);
                shapes.push(Shape::text((frame.left + 8, frame.top + 18), Anchor::Start, "encloser", LABEL, step));
                shapes.extend(title(frame.left + 8, frame.bottom - high));
                shapes.push(Shape::Rect { bounds: frame, style: Style::Frame });
                (shapes, frame)
            }
        }
    }
}

fn grown(bounds: Bounds, by: i32) -> Bounds {
    Bounds { left: bounds.left - by, top: bounds.top - by, right: bounds.right + by, bottom: bounds.bottom + by }
}
