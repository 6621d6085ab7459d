//! The steps and transitions of a grafcet or of an expansion, with places.

mod elements;
mod once;
mod parts;

pub(crate) use elements::{Element, Elements};
pub(crate) use parts::{Part, Parts};

use crate::picture::Group;
use crate::symbols::{Symbol, label, link, transition};
use grafc_layout::{Bounds, Graph, Kind, Layout, Node, Point, Size, Start};
use rustc_hash::FxHashMap;

/// A diagram around its own origin.
pub(crate) struct Diagram {
    pub groups: Vec<Group>,
    pub bounds: Bounds,
    /// Where each element stands, and what it takes.
    pub places: Vec<(Element, Bounds)>,
}

/// Where an element is that is not in this diagram, if it is in another one of the same part.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Where {
    /// Beside it, on the same page.
    Here,
    /// On the page of this number.
    Page(usize),
}

/// Tells where other elements are.
pub(crate) type Elsewhere<'a> = &'a dyn Fn(Element) -> Option<Where>;

impl Where {
    /// Behind the name of what is there.
    pub(crate) fn words(self) -> String {
        match self {
            Where::Here => String::new(),
            Where::Page(number) => format!(", page {number}"),
        }
    }
}

/// From one unconnected part to the next.
const APART: i32 = 50;
/// So much wider than high a diagram of unconnected parts may become.
const WIDE: f64 = 1.6;

/// Draws elements, and labels for the links to those that are elsewhere.
pub(crate) fn diagram(elements: &Elements<'_>, own: &[Element], elsewhere: Elsewhere<'_>) -> Diagram {
    let pieces: Vec<Diagram> =
        connected(elements, own).into_iter().map(|piece| one(elements, &piece, elsewhere)).collect();
    let sizes: Vec<Bounds> = pieces.iter().map(|piece| piece.bounds).collect();
    let places = shelves(&sizes, APART, wide(&sizes, APART, WIDE));
    // The first piece keeps its axis.
    let origin = match (sizes.first(), places.first()) {
        (Some(size), Some(place)) => Point { x: size.left - place.x, y: size.top - place.y },
        (None, _) | (_, None) => Point::default(),
    };
    let mut out = Diagram { groups: Vec::new(), bounds: Bounds::default(), places: Vec::new() };
    for (number, (piece, place)) in pieces.into_iter().zip(places).enumerate() {
        let by = Point { x: place.x - piece.bounds.left + origin.x, y: place.y - piece.bounds.top + origin.y };
        let bounds = moved(piece.bounds, by);
        if number == 0 {
            out.bounds = bounds;
        }
        out.bounds.include(bounds);
        out.places.extend(piece.places.into_iter().map(|(element, bounds)| (element, moved(bounds, by))));
        out.groups.extend(
            piece
                .groups
                .into_iter()
                .map(|group| Group { at: Point { x: group.at.x + by.x, y: group.at.y + by.y }, ..group }),
        );
    }
    out
}

pub(crate) fn moved(bounds: Bounds, by: Point) -> Bounds {
    Bounds {
        left: bounds.left + by.x,
        top: bounds.top + by.y,
        right: bounds.right + by.x,
        bottom: bounds.bottom + by.y,
    }
}

/// A width at which boxes on shelves make a sheet of about this shape.
pub(crate) fn wide(sizes: &[Bounds], apart: i32, shape: f64) -> i32 {
    let area: f64 = sizes.iter().map(|size| f64::from(size.width() + apart) * f64::from(size.height() + apart)).sum();
    let widest = sizes.iter().map(|size| size.width()).max().unwrap_or(0);
    widest.max((area * shape).sqrt() as i32)
}

/// The upper left corners of boxes on shelves of this width, from left to right and from top to bottom.
pub(crate) fn shelves(sizes: &[Bounds], apart: i32, wide: i32) -> Vec<Point> {
    let (mut x, mut y, mut high) = (0, 0, 0);
    let mut places = Vec::with_capacity(sizes.len());
    for size in sizes {
        if x > 0 && x + size.width() > wide {
            (x, y, high) = (0, y + high + apart, 0);
        }
        places.push(Point { x, y });
        x += size.width() + apart;
        high = high.max(size.height());
    }
    places
}

/// The elements in pieces that links join, each piece in order.
fn connected(elements: &Elements<'_>, own: &[Element]) -> Vec<Vec<Element>> {
    let place: FxHashMap<Element, usize> = own.iter().enumerate().map(|(place, element)| (*element, place)).collect();
    let mut root: Vec<usize> = (0..own.len()).collect();
    let find = |root: &mut Vec<usize>, mut at: usize| {
        while root[at] != at {
            root[at] = root[root[at]];
            at = root[at];
        }
        at
    };
    for (from, to) in own.iter().flat_map(|element| elements.links(*element)) {
        if let (Some(&from), Some(&to)) = (place.get(&from), place.get(&to)) {
            let (a, b) = (find(&mut root, from), find(&mut root, to));
            root[a.max(b)] = a.min(b);
        }
    }
    let mut pieces: Vec<Vec<Element>> = Vec::new();
    let mut piece_of: FxHashMap<usize, usize> = FxHashMap::default();
    for (at, element) in own.iter().enumerate() {
        let root = find(&mut root, at);
        let piece = *piece_of.entry(root).or_insert_with(|| {
            pieces.push(Vec::new());
            pieces.len() - 1
        });
        pieces[piece].push(*element);
    }
    pieces
}

/// What stands at a node of the graph.
enum What {
    Element(Element, Symbol),
    Label(Symbol),
}

/// One piece.
fn one(elements: &Elements<'_>, own: &[Element], elsewhere: Elsewhere<'_>) -> Diagram {
    let mut graph = Graph::default();
    let mut drawn: Vec<What> = Vec::new();
    let mut ends: Vec<(String, String)> = Vec::new();
    let node: FxHashMap<Element, usize> = own.iter().enumerate().map(|(place, element)| (*element, place)).collect();
    for &element in own {
        let symbol = elements.symbol(element);
        let kind = if element.is_transition() { Kind::Transition } else { Kind::Step };
        let label = label::onwards(&elements.onwards(element)).size;
        graph.nodes.push(Node { kind, start: elements.start(element), size: symbol.size, label });
        drawn.push(What::Element(element, symbol));
    }
    for (from, to) in links(elements, own, &node) {
        let mut add = |symbol: Symbol, start: Start| {
            graph.nodes.push(Node { kind: Kind::Label, start, size: symbol.size, label: Size::default() });
            drawn.push(What::Label(symbol));
            graph.nodes.len() - 1
        };
        let ends_at = match (node.get(&from), node.get(&to)) {
            (Some(&from), Some(&to)) => Some((from, to)),
            (Some(&here), None) => elsewhere(to).map(|at| {
                (here, add(label::onwards(&format!("{}{}", elements.onwards(to), at.words())), Start::Plain))
            }),
            (None, Some(&here)) => elsewhere(from).map(|at| {
                (add(label::from(&format!("from {}{}", elements.origin(from), at.words())), Start::Entered), here)
            }),
            (None, None) => None,
        };
        if let Some(pair) = ends_at {
            graph.links.push(pair);
            ends.push((elements.name(from), elements.name(to)));
        }
    }
    let layout = grafc_layout::layout(&graph);
    draw(elements, &graph, &layout, drawn, &ends)
}

/// The links of elements, those of transitions that are elsewhere included; a step names these once.
fn links(elements: &Elements<'_>, own: &[Element], node: &FxHashMap<Element, usize>) -> Vec<(Element, Element)> {
    let mut found: Vec<(Element, Element)> = own.iter().flat_map(|element| elements.links(*element)).collect();
    for &element in own {
        let others = elements.next_to(element).iter().map(|id| Element::Transition(*id));
        for other in others.filter(|other| !node.contains_key(other)) {
            found.extend(elements.links(other).filter(|(from, to)| *from == element || *to == element));
        }
    }
    let mut met = FxHashMap::default();
    found.retain(|link| met.insert(*link, ()).is_none());
    found
}

/// Links under boxes, then what stands on them.
fn draw(
    elements: &Elements<'_>,
    graph: &Graph,
    layout: &Layout,
    drawn: Vec<What>,
    ends: &[(String, String)],
) -> Diagram {
    let mut groups = Vec::new();
    let mut once = once::Drawn::default();
    for ((route, (from, to)), &(a, b)) in layout.routes.iter().zip(ends).zip(&graph.links) {
        if !route.points.is_empty() {
            let interrupted = [a, b].iter().any(|node| graph.nodes[*node].kind == Kind::Label);
            let class = class(graph, (a, b), interrupted, !route.arrows.is_empty());
            groups.push(link::link(&class, (from, to), once.rest(&route.points), &route.arrows));
        }
    }
    for placed in &layout.labels {
        let (from, to) = &ends[placed.link];
        let route = &placed.route;
        let class = class(graph, graph.links[placed.link], true, false);
        let mut group = link::link(&class, (from, to), once.rest(&route.points), &route.arrows);
        let target = graph.links[placed.link].1;
        if let What::Element(element, _) = &drawn[target] {
            let label = label::onwards(&elements.onwards(*element)).group;
            group.groups.push(Group { at: placed.place, ..label });
        }
        groups.push(group);
    }
    for bar in layout.bars.iter().filter(|bar| bar.is_double) {
        if let What::Element(element, _) = &drawn[bar.node] {
            let name = elements.name(*element);
            groups.push(link::double_line(bar, &name, layout.places[bar.node], transition::BAR));
        }
    }
    let mut places = Vec::new();
    for (what, at) in drawn.into_iter().zip(&layout.places) {
        let group = match what {
            What::Element(element, symbol) => {
                let size = symbol.size;
                let (left, right) = (at.x - size.left, at.x + size.right);
                let (top, bottom) = (at.y - size.above, at.y + size.body + size.below);
                places.push((element, Bounds { left, top, right, bottom }));
                symbol.group
            }
            What::Label(symbol) => symbol.group,
        };
        groups.push(Group { at: *at, ..group });
    }
    Diagram { groups, bounds: layout.bounds, places }
}

/// The classes of a link: where it is seen from its transition, and what is special.
fn class(graph: &Graph, (from, to): (usize, usize), is_interrupted: bool, is_up: bool) -> String {
    let is_transition = |node: usize| graph.nodes[node].kind == Kind::Transition;
    let is_step = |node: usize| graph.nodes[node].kind == Kind::Step;
    let side = if is_transition(to) || is_step(from) { "before" } else { "after" };
    let special = if is_interrupted {
        " interrupted"
    } else if is_up {
        " up"
    } else {
        ""
    };
    format!("link {side}{special}")
}
