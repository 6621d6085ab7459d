//! What is given a place, and the places.

/// Boxes and links. Their order is that of the text; what comes first stands further left.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// The boxes.
    pub nodes: Vec<Node>,
    /// From which box to which, each pair once.
    pub links: Vec<(usize, usize)>,
}

/// A box.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// What it is.
    pub kind: Kind,
    /// Where drawing begins.
    pub start: Start,
    /// What it takes.
    pub size: Size,
    /// What a label takes that names it, where there is no room for a link to it.
    pub label: Size,
}

/// How links join at a box.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Several links are joined by a single line (selection).
    Step,
    /// Several links are joined by a double line (synchronisation).
    Transition,
    /// The text at an end of an interrupted link; it has one link at most.
    Label,
}

/// Where the walk over a graph begins, the first ones first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Start {
    /// An initial step.
    Initial,
    /// A step with an activation link, or the entry of an expansion.
    Entered,
    /// Anything else.
    Plain,
}

/// What a box takes, from its axis and from its body.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Size {
    /// From the axis to the left.
    pub left: i32,
    /// From the axis to the right.
    pub right: i32,
    /// Above the body.
    pub above: i32,
    /// Between the ends of links.
    pub body: i32,
    /// Below the body.
    pub below: i32,
}

/// A place; y leads downwards.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Point {
    /// To the right.
    pub x: i32,
    /// Downwards.
    pub y: i32,
}

/// Where everything stands.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// For each box, its axis and the upper end of its body.
    pub places: Vec<Point>,
    /// For each link, its way; without points if a label stands for it.
    pub routes: Vec<Route>,
    /// The lines that join or fork links.
    pub bars: Vec<Bar>,
    /// The labels that stand for links.
    pub labels: Vec<Label>,
    /// What all of it takes.
    pub bounds: Bounds,
}

/// The way of a link, from what it comes from.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Route {
    /// Its corners; pieces are horizontal or vertical.
    pub points: Vec<Point>,
    /// Where it has an arrow that points upwards. What links have in common bears one arrow.
    pub arrows: Vec<Point>,
}

/// A line that joins several links over a box or forks them under it.
///
/// Of a transition it is double: links end at it. Of a step it is single, and a part of the links themselves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bar {
    /// The box.
    pub node: usize,
    /// Whether it is over or under the box.
    pub side: Side,
    /// Whether it is double (synchronisation).
    pub is_double: bool,
    /// Its left end.
    pub left: i32,
    /// Its right end.
    pub right: i32,
    /// Its height; of a double line the middle between its lines, which are [`Bar::HALF`] away.
    pub y: i32,
}

impl Bar {
    /// From the middle of the double line to each of its lines.
    pub const HALF: i32 = 2;
    /// So far a double line reaches beyond the outermost link.
    pub const OVERHANG: i32 = 10;
}

/// Over or under.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Side {
    /// Joins what comes before.
    Over,
    /// Forks to what comes after.
    Under,
}

/// A label that stands for a link.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Label {
    /// The link.
    pub link: usize,
    /// Its axis and the upper end of its body.
    pub place: Point,
    /// From what it comes from to the label.
    pub route: Route,
}

/// A rectangle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Bounds {
    /// The left side.
    pub left: i32,
    /// The upper side.
    pub top: i32,
    /// The right side.
    pub right: i32,
    /// The lower side.
    pub bottom: i32,
}

impl Bounds {
    /// Makes it large enough for another one.
    pub fn include(&mut self, other: Bounds) {
        self.left = self.left.min(other.left);
        self.top = self.top.min(other.top);
        self.right = self.right.max(other.right);
        self.bottom = self.bottom.max(other.bottom);
    }

    /// From left to right.
    pub fn width(self) -> i32 {
        self.right - self.left
    }

    /// From top to bottom.
    pub fn height(self) -> i32 {
        self.bottom - self.top
    }
}

/// For each box, the links at it, in order.
pub(crate) struct Neighbours {
    /// Links that come from it.
    pub out: Vec<Vec<usize>>,
    /// Links that lead to it.
    pub into: Vec<Vec<usize>>,
}

impl Graph {
    /// The step under which the main sequence is: its column is its own, whatever leads to it.
    pub(crate) fn main(&self) -> Option<usize> {
        self.nodes.iter().position(|node| node.start == Start::Initial)
    }

    pub(crate) fn neighbours(&self) -> Neighbours {
        let (mut out, mut into) = (vec![Vec::new(); self.nodes.len()], vec![Vec::new(); self.nodes.len()]);
        for (link, &(from, to)) in self.links.iter().enumerate() {
            out[from].push(link);
            into[to].push(link);
        }
        Neighbours { out, into }
    }
}
