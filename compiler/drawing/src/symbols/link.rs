//! Links \[10\] \[11\] and the double lines of synchronisation \[9\].

use crate::picture::{Group, Shape, Style};
use grafc_layout::{Bar, Point, Side};

/// Half the width of an arrow head.
const HALF: i32 = 5;

/// A link from one element to another, with the classes that tell what it is and what of it is drawn.
pub(crate) fn link(class: &str, ends: (&str, &str), lines: Vec<Vec<Point>>, arrows: &[Point]) -> Group {
    let mut group = Group::new(class).of("data-from", ends.0).of("data-to", ends.1);
    if !lines.is_empty() {
        group.shapes.push(Shape::Path { lines, closed: false, style: Style::Line });
    }
    for Point { x, y } in arrows {
        let head = [(*x, *y), (x - HALF, y + 2 * HALF), (x + HALF, y + 2 * HALF)];
        group.shapes.push(Shape::path(&head, true, Style::Filled));
    }
    group
}

/// A double line, and the line from it to the bar of its transition.
pub(crate) fn double_line(bar: &Bar, transition: &str, place: Point, thickness: i32) -> Group {
    let class = match bar.side {
        Side::Over => "sync join",
        Side::Under => "sync fork",
    };
    let mut group = Group::new(class).of("data-transition", transition);
    let line = |y: i32| vec![Point { x: bar.left, y }, Point { x: bar.right, y }];
    let lines = vec![line(bar.y - Bar::HALF), line(bar.y + Bar::HALF)];
    group.shapes.push(Shape::Path { lines, closed: false, style: Style::Line });
    let stub = match bar.side {
        Side::Over => [(place.x, bar.y + Bar::HALF), (place.x, place.y)],
        Side::Under => [(place.x, place.y + thickness), (place.x, bar.y - Bar::HALF)],
    };
    group.shapes.push(Shape::line(&stub));
    group
}
