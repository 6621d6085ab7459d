//! The steps and transitions of a grafcet or of an expansion, with places.

mod connected;
mod elements;
mod once;
mod outside;
mod parts;

pub(crate) use elements::{Element, Elements};
pub(crate) use outside::{Elsewhere, Where};
pub(crate) use parts::{Part, Parts};

use crate::picture::Group;
use crate::symbols::{Symbol, label, link, transition};
use grafc_layout::{Bounds, Graph, Kind, Layout, Node, Point, Size, Start};
use rustc_hash::FxHashMap;

/// A diagram around its own origin.
pub(crate) struct Diagram {
    pub groups: Vec<Group>,
    pub bounds: Bounds,
    /// Where each element stands.
    pub places: Vec<Place>,
}

/// Where an element stands, and what it takes.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    pub element: Element,
    /// The axis that what follows it straight has as well.
    pub axis: i32,
    pub bounds: Bounds,
}

/// From one unconnected part to the next.
const APART: i32 = 50;
/// So much wider than high a diagram of unconnected parts may become.
const WIDE: f64 = 1.6;

/// Draws elements, and labels for the links to those that are elsewhere.
pub(crate) fn diagram(elements: &Elements<'_>, own: &[Element], elsewhere: Elsewhere<'_>) -> Diagram {
    let pieces: Vec<Diagram> =
        connected::connected(elements, own).into_iter().map(|piece| one(elements, &piece, elsewhere)).collect();
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
        let moved_place = |place: Place| Place { axis: place.axis + by.x, bounds: moved(place.bounds, by), ..place };
        out.places.extend(piece.places.into_iter().map(moved_place));
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

/// What stands at a node of the graph.
enum What {
    Element(Element, Symbol),
    /// A label, also where a part of a double line is drawn whose transition is elsewhere; then of that.
    Label(Symbol, Option<Element>),
}

/// A graph with what is drawn at its nodes, and for each link what it stands for.
#[derive(Default)]
struct Drawn {
    graph: Graph,
    what: Vec<What>,
    ends: Vec<Vec<(Element, Element)>>,
}

impl Drawn {
    fn label(&mut self, symbol: Symbol, kind: Kind, start: Start, of: Option<Element>) -> usize {
        self.graph.nodes.push(Node { kind, start, size: symbol.size, label: Size::default() });
        self.what.push(What::Label(symbol, of));
        self.graph.nodes.len() - 1
    }

    fn link(&mut self, pair: (usize, usize), ends: Vec<(Element, Element)>) {
        self.graph.links.push(pair);
        self.ends.push(ends);
    }
}

/// One piece.
fn one(elements: &Elements<'_>, own: &[Element], elsewhere: Elsewhere<'_>) -> Diagram {
    let mut drawn = Drawn::default();
    let node: FxHashMap<Element, usize> = own.iter().enumerate().map(|(place, element)| (*element, place)).collect();
    let links = links(elements, own, &node);
    let entries = outside::entries(elements, &links, &node, elsewhere);
    for &element in own {
        let mut symbol = elements.symbol(element);
        if let Some(entry) = entries.get(&element) {
            symbol = label::entered(symbol, &entry.texts, entry.is_first);
        }
        let kind = if element.is_transition() { Kind::Transition } else { Kind::Step };
        let label = label::onwards(&elements.onwards(element)).size;
        drawn.graph.nodes.push(Node { kind, start: elements.start(element), size: symbol.size, label });
        drawn.what.push(What::Element(element, symbol));
    }
    for (pair, to_outside) in outside::together(&links, &node, elsewhere) {
        let first = to_outside[0];
        match pair {
            outside::Ends::Both(from, to) => drawn.link((from, to), to_outside),
            outside::Ends::OfTransition { here, at, comes } => {
                // The links of one double line to one page are one.
                let others: Vec<Element> =
                    to_outside.iter().map(|(from, to)| if comes { *from } else { *to }).collect();
                let text = format!("{}{}", outside::group_name(elements, &others), at.words());
                if comes {
                    let symbol = label::from(&format!("from {text}"));
                    let label = drawn.label(symbol, Kind::Label, Start::Plain, None);
                    drawn.link((label, here), to_outside);
                } else {
                    let label = drawn.label(label::onwards(&text), Kind::Label, Start::Plain, None);
                    drawn.link((here, label), to_outside);
                }
            }
            outside::Ends::OfSteps { at, comes: true } => {
                // Of a double line that is elsewhere its part is drawn here; a single step has a label.
                if to_outside.len() > 1 {
                    let text = format!("from {}{}", elements.origin(first.0), at.words());
                    let symbol = label::from(&text);
                    let part = drawn.label(symbol, Kind::Transition, Start::Entered, Some(first.0));
                    to_outside.iter().for_each(|link| drawn.link((part, node[&link.1]), vec![*link]));
                }
            }
            outside::Ends::OfSteps { at, comes: false } => {
                let text = format!("{}{}", elements.onwards(first.1), at.words());
                let (kind, of) = match to_outside.len() {
                    1 => (Kind::Label, None),
                    _ => (Kind::Transition, Some(first.1)),
                };
                let part = drawn.label(label::onwards(&text), kind, Start::Plain, of);
                to_outside.iter().for_each(|link| drawn.link((node[&link.0], part), vec![*link]));
            }
        }
    }
    let layout = grafc_layout::layout(&drawn.graph);
    draw(elements, drawn, &layout)
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
fn draw(elements: &Elements<'_>, drawn: Drawn, layout: &Layout) -> Diagram {
    let Drawn { graph, what: drawn, ends } = drawn;
    let mut groups = Vec::new();
    let mut once = once::Drawn::default();
    let is_label = |node: usize| matches!(drawn[node], What::Label(..));
    let name = |(from, to): (Element, Element)| (elements.name(from), elements.name(to));
    for ((route, ends), &(a, b)) in layout.routes.iter().zip(&ends).zip(&graph.links) {
        if route.points.is_empty() {
            continue;
        }
        let mut arrows = route.arrows.as_slice();
        for &(from, to) in ends {
            let class = class(to, is_label(a) || is_label(b), !route.arrows.is_empty());
            let (from, to) = name((from, to));
            groups.push(link::link(&class, (&from, &to), once.rest(&route.points), arrows));
            arrows = &[];
        }
    }
    for placed in &layout.labels {
        let Some(&link) = ends[placed.link].first() else { continue };
        let route = &placed.route;
        let (from, to) = name(link);
        let class = class(link.1, true, false);
        let mut group = link::link(&class, (&from, &to), once.rest(&route.points), &route.arrows);
        let target = graph.links[placed.link].1;
        if let What::Element(element, _) = &drawn[target] {
            let label = label::onwards(&elements.onwards(*element)).group;
            group.groups.push(Group { at: placed.place, ..label });
        }
        groups.push(group);
    }
    for bar in layout.bars.iter().filter(|bar| bar.is_double) {
        if let What::Element(element, _) | What::Label(_, Some(element)) = &drawn[bar.node] {
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
                places.push(Place { element, axis: at.x, bounds: Bounds { left, top, right, bottom } });
                symbol.group
            }
            What::Label(symbol, _) => symbol.group,
        };
        groups.push(Group { at: *at, ..group });
    }
    Diagram { groups, bounds: layout.bounds, places }
}

/// The classes of a link: where it is seen from its transition, and what is special.
fn class(to: Element, is_interrupted: bool, is_up: bool) -> String {
    let side = if to.is_transition() { "before" } else { "after" };
    let special = if is_interrupted {
        " interrupted"
    } else if is_up {
        " up"
    } else {
        ""
    };
    format!("link {side}{special}")
}
