//! The ways of links, from all coordinates.

use crate::across::Across;
use crate::cells::{Cells, What};
use crate::channels::Down;
use crate::graph::{Bar, Bounds, Graph, Label, Layout, Point, Route, Side};
use crate::lanes::Lanes;
use crate::ports::Ports;

/// So far below its upper corner a lane has its arrow, if it is long.
const TO_ARROW: i32 = 40;
/// A lane that is longer has an arrow at its lower end, too.
const LONG: i32 = 600;

pub(crate) fn draw(graph: &Graph, cells: &Cells, lanes: &Lanes, across: &Across, ports: &Ports, down: &Down) -> Layout {
    let place = |cell: usize| Point { x: across.cells[cell], y: down.tops[cell] };
    let drawn = Drawn { cells, lanes, across, ports, down };
    let mut layout = Layout { places: (0..graph.nodes.len()).map(place).collect(), ..Layout::default() };
    for (link, pieces) in cells.pieces.iter().enumerate() {
        let mut route = Route::default();
        for &wire in pieces {
            drawn.follow(wire, &mut route);
        }
        route.points = straight(&route.points);
        let label = pieces.last().map(|wire| cells.wires[*wire].to);
        match label.map(|cell| (cell, cells.cells[cell].what)) {
            Some((cell, What::Label(_))) => {
                layout.labels.push(Label { link, place: place(cell), route });
                layout.routes.push(Route::default());
            }
            Some((_, What::Node(_) | What::Joint)) | None => layout.routes.push(route),
        }
    }
    for node in 0..graph.nodes.len() {
        let is_double = cells.is_doubled(node);
        let x = across.cells[node];
        let ends = |side: Side| -> Vec<i32> {
            match side {
                Side::Over => cells.into[node].iter().map(|wire| drawn.arrival(*wire)).collect(),
                Side::Under => cells.out[node].iter().map(|wire| across.cells[cells.wires[*wire].to]).collect(),
            }
        };
        let over = down.entries.get(&node).filter(|_| cells.joins(node)).map(|y| (Side::Over, y[0]));
        let under = down.forks.get(&node).map(|y| (Side::Under, *y));
        for (side, y) in over.into_iter().chain(under) {
            let ends = ends(side);
            let overhang = if is_double { Bar::OVERHANG } else { 0 };
            let left = ends.iter().copied().min().unwrap_or(x).min(x) - overhang;
            let right = ends.iter().copied().max().unwrap_or(x).max(x) + overhang;
            layout.bars.push(Bar { node, side, is_double, left, right, y });
        }
        for side in [Side::Over, Side::Under] {
            if let Some(&(left, right)) = ports.reach.get(&(node, side)) {
                let y = drawn.short_line(node, side);
                layout.bars.push(Bar { node, side, is_double, left: x - left, right: x + right, y });
            }
        }
    }
    layout.bounds = bounds(graph, cells, &layout);
    layout
}

struct Drawn<'a> {
    cells: &'a Cells,
    lanes: &'a Lanes,
    across: &'a Across,
    ports: &'a Ports,
    down: &'a Down,
}

impl Drawn<'_> {
    /// Where a piece arrives at what joins it.
    fn arrival(&self, wire: usize) -> i32 {
        match self.lanes.of[wire] {
            Some(lane) => self.across.lanes[lane],
            None => self.across.cells[self.cells.wires[wire].from],
        }
    }

    /// The height of a short double line: its outer line is the edge of the box.
    fn short_line(&self, cell: usize, side: Side) -> i32 {
        let (top, size) = (self.down.tops[cell], self.cells.cells[cell].size);
        match side {
            Side::Over => top - size.above + Bar::HALF,
            Side::Under => top + size.body + size.below - Bar::HALF,
        }
    }

    /// Adds the corners of a piece, those in the middle of a line included.
    fn follow(&self, wire: usize, route: &mut Route) {
        let ends = self.cells.wires[wire];
        let (from, to) = (ends.from, ends.to);
        let (x, end) = (self.across.cells[from], self.across.cells[to]);
        let bottom = self.down.tops[from] + self.cells.cells[from].size.body;
        let mut add = |x: i32, y: i32| route.points.push(Point { x, y });
        let mut at = x;
        match (self.ports.at(wire, Side::Under), self.down.forks.get(&from)) {
            (Some(port), _) => {
                add(x + port, self.short_line(from, Side::Under) + Bar::HALF);
                if let Some(&turn) = self.down.turns.get(&(wire, Side::Under)) {
                    add(x + port, turn);
                    add(end, turn);
                }
                at = end;
            }
            (None, Some(y)) if self.cells.is_doubled(from) => {
                at = end;
                add(at, y + Bar::HALF);
            }
            (None, Some(y)) => {
                add(x, bottom);
                add(x, *y);
                at = end;
                add(at, *y);
            }
            (None, None) => add(x, bottom),
        }
        let entry = self.down.entries.get(&to);
        if let (Some(lane), Some(entry)) = (self.lanes.of[wire], entry) {
            let about = &self.lanes.lanes[lane];
            let by = self.across.lanes[lane];
            let entry = entry[usize::from(by > end)];
            let exit = self.down.exits.get(&(lane, self.cells.row(from) + 1));
            let exit = exit.map_or(bottom, |exit| exit[usize::from(at > by)]);
            add(at, exit);
            add(by, exit);
            add(by, entry);
            at = by;
            let lowest = about.wires.iter().map(|wire| self.cells.row(self.cells.wires[*wire].from)).max();
            if about.up {
                // The part that all have in common has its arrow once, and the lowest part another if it is long.
                let top = if exit - entry > 3 * TO_ARROW { entry + TO_ARROW } else { (entry + exit) / 2 - 5 };
                if about.wires.first() == Some(&wire) || exit - entry <= 3 * TO_ARROW {
                    route.arrows.push(Point { x: by, y: top });
                }
                if exit - entry > LONG && lowest == Some(self.cells.row(from)) {
                    route.arrows.push(Point { x: by, y: exit - TO_ARROW });
                }
            }
        }
        let mut add = |x: i32, y: i32| route.points.push(Point { x, y });
        if let Some(port) = self.ports.at(wire, Side::Over) {
            if let Some(&turn) = self.down.turns.get(&(wire, Side::Over)) {
                add(at, turn);
                add(end + port, turn);
            }
            add(end + port, self.short_line(to, Side::Over) - Bar::HALF);
            return;
        }
        if let Some(y) = entry {
            let y = y[usize::from(at > end)];
            if self.cells.joins(to) && self.cells.is_doubled(to) {
                add(at, y - Bar::HALF);
                return;
            }
            add(at, y);
            add(end, y);
        }
        add(end, self.down.tops[to]);
    }
}

/// Without corners that are none.
fn straight(points: &[Point]) -> Vec<Point> {
    let mut out: Vec<Point> = Vec::with_capacity(points.len());
    for &point in points {
        if out.last() == Some(&point) {
            continue;
        }
        if let [.., a, b] = out[..]
            && (a.x == b.x && b.x == point.x || a.y == b.y && b.y == point.y)
        {
            out.pop();
        }
        out.push(point);
    }
    out
}

fn bounds(graph: &Graph, cells: &Cells, layout: &Layout) -> Bounds {
    let mut all: Option<Bounds> = None;
    let mut include = |other: Bounds| match &mut all {
        Some(bounds) => bounds.include(other),
        None => all = Some(other),
    };
    let boxed = |place: Point, size: crate::Size| Bounds {
        left: place.x - size.left,
        top: place.y - size.above,
        right: place.x + size.right,
        bottom: place.y + size.body + size.below,
    };
    layout.places.iter().zip(&graph.nodes).for_each(|(place, node)| include(boxed(*place, node.size)));
    for label in &layout.labels {
        include(boxed(label.place, graph.nodes[graph.links[label.link].1].label));
    }
    for point in layout.routes.iter().chain(layout.labels.iter().map(|label| &label.route)).flat_map(|r| &r.points) {
        include(Bounds { left: point.x, top: point.y, right: point.x, bottom: point.y });
    }
    layout.bars.iter().for_each(|bar| {
        include(Bounds { left: bar.left, top: bar.y - Bar::HALF, right: bar.right, bottom: bar.y + Bar::HALF })
    });
    debug_assert!(cells.cells.len() >= graph.nodes.len());
    all.unwrap_or_default()
}
