//! What a drawing is made of.

use grafc_layout::{Bounds, Point};

/// One sheet.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    /// What it is of.
    pub title: String,
    /// One sentence about it.
    pub description: String,
    /// What it takes.
    pub bounds: Bounds,
    /// What is on it.
    pub groups: Vec<Group>,
    /// How some of it looks, beyond how everything does.
    pub look: &'static str,
}

/// Shapes that belong to one element of the chart.
#[derive(Clone, Debug, Default)]
pub struct Group {
    /// What it is, in words apart from each other by blanks: `step initial`.
    pub class: String,
    /// Of what: `data-step` and its label, …
    pub data: Vec<(&'static str, String)>,
    /// The comment.
    pub title: Option<String>,
    /// Where its own origin is.
    pub at: Point,
    /// What it looks like.
    pub shapes: Vec<Shape>,
    /// What belongs to it.
    pub groups: Vec<Group>,
}

impl Group {
    /// A group of a class.
    pub(crate) fn new(class: &str) -> Group {
        Group { class: class.to_string(), ..Group::default() }
    }

    /// With what it is of.
    pub(crate) fn of(mut self, name: &'static str, value: impl Into<String>) -> Group {
        self.data.push((name, value.into()));
        self
    }

    /// With the comment.
    pub(crate) fn about(mut self, comment: Option<&str>) -> Group {
        self.title = comment.map(str::to_string);
        self
    }
}

/// How a line or an area looks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Style {
    /// The outline of a box.
    Box,
    /// A line.
    Line,
    /// A thick bar.
    Bar,
    /// A filled area.
    Filled,
    /// The frame around a diagram.
    Frame,
}

/// Which end of a text its place is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Anchor {
    /// The left end.
    Start,
    /// The middle.
    Middle,
    /// The right end.
    End,
}

/// A line, an area or a text.
#[derive(Clone, PartialEq, Debug)]
pub enum Shape {
    /// A rectangle.
    Rect {
        /// Its place and size.
        bounds: Bounds,
        /// How it looks.
        style: Style,
    },
    /// Straight pieces, closed or not.
    Path {
        /// Where each piece ends; several lines in one shape.
        lines: Vec<Vec<Point>>,
        /// Whether each is closed.
        closed: bool,
        /// How it looks.
        style: Style,
    },
    /// The mark of an active step.
    Dot {
        /// Its middle.
        at: Point,
    },
    /// A text in one line.
    Text {
        /// Where its baseline begins, has its middle, or ends.
        at: Point,
        /// Which of these.
        anchor: Anchor,
        /// Its class: `label`, `condition`, …
        class: &'static str,
        /// The size of its letters.
        size: i32,
        /// What it says.
        text: String,
    },
}

impl Shape {
    /// A rectangle of a box.
    pub(crate) fn rect(left: i32, top: i32, width: i32, height: i32, style: Style) -> Shape {
        Shape::Rect { bounds: Bounds { left, top, right: left + width, bottom: top + height }, style }
    }

    /// One line through points.
    pub(crate) fn line(points: &[(i32, i32)]) -> Shape {
        Shape::path(points, false, Style::Line)
    }

    /// Pieces through points.
    pub(crate) fn path(points: &[(i32, i32)], closed: bool, style: Style) -> Shape {
        let points = points.iter().map(|&(x, y)| Point { x, y }).collect();
        Shape::Path { lines: vec![points], closed, style }
    }

    /// A text.
    pub(crate) fn text(at: (i32, i32), anchor: Anchor, class: &'static str, size: i32, text: String) -> Shape {
        Shape::Text { at: Point { x: at.0, y: at.1 }, anchor, class, size, text }
    }
}
