//! Where everything stands: the places of `grafc-layout`, part by part, side by side.

use super::graph::{Graph, VertexKind};
use crate::plcopen::drawing::Point;
use grafc_layout::{Bar, Kind, Layout, Node, Route, Side, Size, Start, layout};

/// The margin of the sheet.
const SHEET: i64 = 20;
/// From one part of the chart to the next.
const APART: i64 = 40;

/// Where everything stands.
pub(super) struct Placed {
    /// The axis and the top of each node.
    pub at: Vec<Point>,
    /// The line above each node that joins what leads to it, and the line below that forks what comes from it.
    pub above: Vec<Option<Line>>,
    pub below: Vec<Option<Line>>,
    /// The points of each arc, from the box or line that it comes from to the box or line that it leads to.
    pub wires: Vec<Vec<Point>>,
    /// The nodes from the top down, those beside each other from the left.
    pub order: Vec<usize>,
}

/// A line as an object of the drawing.
#[derive(Clone, Copy)]
pub(super) struct Line {
    pub left: i64,
    pub right: i64,
    pub top: i64,
    pub height: i64,
}

/// The height of a single line; a double line is as high as its two lines are apart.
const SINGLE: i64 = 1;

/// Places everything.
pub(super) fn place(graph: &Graph) -> Placed {
    let count = graph.nodes.len();
    let mut placed = Placed {
        at: vec![(0, 0); count],
        above: vec![None; count],
        below: vec![None; count],
        wires: vec![Vec::new(); graph.arcs.len()],
        order: (0..count).collect(),
    };
    let mut left = SHEET;
    for part in parts(graph) {
        let made = layout(&part.graph);
        let by = (left - i64::from(made.bounds.left), SHEET - i64::from(made.bounds.top));
        placed.take(graph, &part, &made, by);
        left += i64::from(made.bounds.width()) + APART;
    }
    placed.order.sort_by_key(|node| {
        let (x, y) = placed.at[*node];
        (y, x, *node)
    });
    placed
}

/// What arcs connect.
struct Part {
    graph: grafc_layout::Graph,
    /// Its nodes and arcs by their numbers in the whole graph.
    nodes: Vec<usize>,
    arcs: Vec<usize>,
}

/// All parts, by their first node.
fn parts(graph: &Graph) -> Vec<Part> {
    let part_of = graph.parts();
    let mut number = vec![usize::MAX; graph.nodes.len()];
    let mut within = vec![0; graph.nodes.len()];
    let mut parts: Vec<Part> = Vec::new();
    for (node, vertex) in graph.nodes.iter().enumerate() {
        let first = part_of[node];
        if number[first] == usize::MAX {
            number[first] = parts.len();
            parts.push(Part { graph: grafc_layout::Graph::default(), nodes: Vec::new(), arcs: Vec::new() });
        }
        let part = &mut parts[number[first]];
        within[node] = part.nodes.len();
        part.nodes.push(node);
        let (kind, start) = match vertex.kind {
            VertexKind::Step { initial: true, .. } => (Kind::Step, Start::Initial),
            VertexKind::Step { initial: false, .. } => (Kind::Step, Start::Plain),
            VertexKind::Transition(_) => (Kind::Transition, Start::Plain),
            VertexKind::Jump(_) => (Kind::Label, Start::Plain),
        };
        let [left, right, body, below] = [vertex.left, vertex.right, vertex.body, vertex.height - vertex.body]
            .map(|n| i32::try_from(n).unwrap_or(i32::MAX / 1000));
        let size = Size { left, right, above: 0, body, below };
        part.graph.nodes.push(Node { kind, start, size, label: Size::default() });
    }
    for (arc, (from, to)) in graph.arcs.iter().enumerate() {
        let part = &mut parts[number[part_of[*from]]];
        part.arcs.push(arc);
        part.graph.links.push((within[*from], within[*to]));
    }
    parts
}

impl Placed {
    /// Takes over the places of a part, moved.
    fn take(&mut self, graph: &Graph, part: &Part, made: &Layout, by: Point) {
        for (node, place) in part.nodes.iter().zip(&made.places) {
            self.at[*node] = (i64::from(place.x) + by.0, i64::from(place.y) + by.1);
        }
        for bar in &made.bars {
            let node = part.nodes[bar.node];
            let line = Line::of(bar, by);
            match bar.side {
                Side::Over => self.above[node] = Some(line),
                // What comes from a step without a line of its own comes from the step itself.
                Side::Under => self.below[node] = graph.has_bar_below(node).then_some(line),
            }
        }
        for (arc, route) in part.arcs.iter().zip(&made.routes) {
            let (from, to) = graph.arcs[*arc];
            self.wires[*arc] = wire(route, by, self.below[from], self.above[to]);
        }
    }
}

impl Line {
    fn of(bar: &Bar, by: Point) -> Line {
        let half = i64::from(if bar.is_double { Bar::HALF } else { 0 });
        Line {
            left: i64::from(bar.left) + by.0,
            right: i64::from(bar.right) + by.0,
            top: i64::from(bar.y) - half + by.1,
            height: if bar.is_double { 2 * half } else { SINGLE },
        }
    }

    /// Where wires leave it downwards.
    pub fn bottom(self) -> i64 {
        self.top + self.height
    }
}

/// The points of a route between the lines at its ends, which the route runs along where they are single.
fn wire(route: &Route, by: Point, below: Option<Line>, above: Option<Line>) -> Vec<Point> {
    let mut points: Vec<Point> =
        route.points.iter().map(|point| (i64::from(point.x) + by.0, i64::from(point.y) + by.1)).collect();
    if let Some(line) = below
        && let Some(last) = points.iter().rposition(|(_, y)| *y <= line.bottom())
    {
        points.drain(..last);
        points[0].1 = line.bottom();
    }
    if let Some(line) = above
        && let Some(first) = points.iter().position(|(_, y)| *y >= line.top)
    {
        points.truncate(first + 1);
        points[first].1 = line.top;
    }
    points
}
