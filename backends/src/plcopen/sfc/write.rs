//! The drawing as elements, each with its place, its size and the points of its wires.

use super::graph::{Graph, ROW, TO_ACTIONS, VertexKind, block_width, comment_width, step_width};
use super::place::{Placed, bar_above, bar_below};
use super::texts::{Content, Texts};
use crate::plcopen::dialect::Dialect;
use crate::plcopen::drawing::{Point, connection, open, output, position, relative};
use crate::xml::Xml;

/// The heights of the bars of selections and of simultaneous sequences.
const SELECTION: i64 = 1;
const SIMULTANEOUS: i64 = 3;

/// Writes all elements, from the top down, each layer from the left.
pub(super) fn write(xml: &mut Xml, graph: &Graph, placed: &Placed, texts: &Texts, dialect: Dialect) {
    let sheet = Sheet::new(graph, placed, texts, dialect);
    xml.open("SFC", &[]);
    for &node in graph.layers.iter().flatten() {
        sheet.node(xml, node);
    }
    xml.close();
}

struct Sheet<'g> {
    graph: &'g Graph,
    placed: &'g Placed,
    texts: &'g Texts,
    dialect: Dialect,
    /// The local ids of each node: of a bar above it, of its own, of a bar below it.
    ids: Vec<[usize; 3]>,
    /// The first local id behind those: action blocks and actions.
    first_action: Vec<usize>,
    /// The local id of the comment on a step.
    comment: Vec<usize>,
}

/// A pin at the end of a wire: the object, and where.
struct Pin {
    object: usize,
    at: Point,
}

impl<'g> Sheet<'g> {
    fn new(graph: &'g Graph, placed: &'g Placed, texts: &'g Texts, dialect: Dialect) -> Self {
        let mut next = 0;
        let mut fresh = |count: usize| {
            next += count;
            next - count
        };
        let mut ids = vec![[0; 3]; graph.nodes.len()];
        let mut first_action = vec![0; graph.nodes.len()];
        let mut comment = vec![0; graph.nodes.len()];
        for &node in graph.layers.iter().flatten() {
            ids[node] = match graph.nodes[node].kind {
                VertexKind::Joint => [0; 3],
                VertexKind::Step { .. } | VertexKind::Transition(_) | VertexKind::Jump(_) => [
                    fresh(usize::from(graph.entering[node].len() > 1)),
                    fresh(1),
                    fresh(usize::from(graph.has_bar_below(node))),
                ],
            };
            if let VertexKind::Step { step, .. } = graph.nodes[node].kind {
                let rows = texts.actions[step].len();
                first_action[node] = fresh(if rows > 0 { rows + 1 } else { 0 });
                comment[node] = fresh(usize::from(!texts.comments[step].is_empty()));
            }
        }
        Sheet { graph, placed, texts, dialect, ids, first_action, comment }
    }

    fn x(&self, node: usize) -> i64 {
        self.placed.x[node]
    }

    fn y(&self, node: usize) -> i64 {
        self.placed.y[self.graph.nodes[node].layer]
    }

    /// The lower end of a box.
    fn bottom(&self, node: usize) -> i64 {
        self.y(node)
            + match self.graph.nodes[node].kind {
                VertexKind::Step { .. } => ROW,
                VertexKind::Transition(_) => 2,
                VertexKind::Jump(_) => 13,
                VertexKind::Joint => 0,
            }
    }

    fn node(&self, xml: &mut Xml, node: usize) {
        let entering = &self.graph.entering[node];
        if entering.len() > 1 {
            self.bar_above(xml, node);
        }
        match self.graph.nodes[node].kind {
            VertexKind::Step { step, initial } => self.step(xml, node, step, initial),
            VertexKind::Transition(transition) => self.transition(xml, node, transition),
            VertexKind::Jump(to) => self.jump(xml, node, to),
            VertexKind::Joint => {}
        }
        if self.graph.has_bar_below(node) {
            self.bar_below(xml, node);
        }
        if let VertexKind::Step { step, .. } = self.graph.nodes[node].kind {
            self.actions(xml, node, step);
            self.comment(xml, node, step);
        }
    }

    /// The comment that is attached to a step, right of all that belongs to it.
    fn comment(&self, xml: &mut Xml, node: usize, step: usize) {
        let Some(width) = comment_width(self.texts, step) else { return };
        let actions = !self.texts.actions[step].is_empty();
        let block = if actions { TO_ACTIONS + block_width(self.texts, step) } else { 0 };
        let left = self.x(node) + step_width(&self.texts.steps[step]) / 2 + block + TO_ACTIONS;
        open(xml, "comment", self.comment[node], (width, ROW), &[]);
        position(xml, (left, self.y(node)));
        xml.open("content", &[]);
        self.dialect.formatted(xml, &self.texts.comments[step]);
        xml.close();
        xml.close();
    }

    fn step(&self, xml: &mut Xml, node: usize, step: usize, initial: bool) {
        let width = step_width(&self.texts.steps[step]);
        let (id, width_text, height) = (self.ids[node][1].to_string(), width.to_string(), ROW.to_string());
        let mut attributes = vec![("localId", id.as_str()), ("name", self.texts.steps[step].as_str())];
        if initial {
            attributes.push(("initialStep", "true"));
        }
        attributes.extend([("width", width_text.as_str()), ("height", height.as_str())]);
        let corner = (self.x(node) - width / 2, self.y(node));
        xml.open("step", &attributes);
        position(xml, corner);
        self.input(xml, node, corner);
        output(xml, "connectionPointOut", Some(""), (width / 2, ROW));
        if !self.texts.actions[step].is_empty() {
            output(xml, "connectionPointOutAction", Some(""), (width, ROW / 2));
        }
        xml.close();
    }

    fn transition(&self, xml: &mut Xml, node: usize, transition: usize) {
        let corner = (self.x(node) - 10, self.y(node));
        open(xml, "transition", self.ids[node][1], (20, 2), &[]);
        position(xml, corner);
        self.input(xml, node, corner);
        output(xml, "connectionPointOut", None, (10, 2));
        xml.open("condition", &[]);
        xml.open("inline", &[("name", "")]);
        self.dialect.body(xml, "ST", &self.texts.conditions[transition]);
        xml.close();
        xml.close();
        xml.close();
    }

    fn jump(&self, xml: &mut Xml, node: usize, to: usize) {
        let corner = (self.x(node) - 6, self.y(node));
        open(xml, "jumpStep", self.ids[node][1], (12, 13), &[("targetName", &self.texts.steps[to])]);
        position(xml, corner);
        self.input(xml, node, corner);
        xml.close();
    }

    /// The input of a box: from a bar above it, from what leads to it, or from nothing.
    fn input(&self, xml: &mut Xml, node: usize, corner: Point) {
        let pin = (self.x(node), self.y(node));
        xml.open("connectionPointIn", &[]);
        relative(xml, pin, corner);
        match self.graph.entering[node][..] {
            [] => {}
            [path] => {
                let (from, mut points) = self.wire(path);
                points.push(pin);
                connection(xml, from.object, None, &points);
            }
            _ => {
                let (bar, height) = (self.ids[node][0], self.bar_height(node, true));
                connection(xml, bar, None, &[(pin.0, self.placed.above[node] + height), pin]);
            }
        }
        xml.close();
    }

    /// Where a path comes from, and its points up to the last bend.
    fn wire(&self, path: usize) -> (Pin, Vec<Point>) {
        let nodes = &self.graph.paths[path];
        let from = nodes[0];
        let pin = if self.graph.has_bar_below(from) {
            let bottom = self.placed.below[from] + self.bar_height(from, false);
            Pin { object: self.ids[from][2], at: (self.x(nodes[1]), bottom) }
        } else {
            Pin { object: self.ids[from][1], at: (self.x(from), self.bottom(from)) }
        };
        let mut points = vec![pin.at];
        for (place, y) in &self.placed.bends[path] {
            points.extend([(self.x(nodes[*place]), *y), (self.x(nodes[*place + 1]), *y)]);
        }
        (pin, points)
    }

    /// What the bar above (below) a node is, and how high.
    fn bar(&self, node: usize, above: bool) -> (&'static str, i64) {
        match (self.graph.nodes[node].kind, above) {
            (VertexKind::Transition(_), true) => ("simultaneousConvergence", SIMULTANEOUS),
            (VertexKind::Transition(_), false) => ("simultaneousDivergence", SIMULTANEOUS),
            (VertexKind::Step { .. } | VertexKind::Jump(_) | VertexKind::Joint, true) => {
                ("selectionConvergence", SELECTION)
            }
            (VertexKind::Step { .. } | VertexKind::Jump(_) | VertexKind::Joint, false) => {
                ("selectionDivergence", SELECTION)
            }
        }
    }

    fn bar_height(&self, node: usize, above: bool) -> i64 {
        self.bar(node, above).1
    }

    /// What leads to a node from several sides, as a bar above it.
    fn bar_above(&self, xml: &mut Xml, node: usize) {
        let (name, height) = self.bar(node, true);
        let top = self.placed.above[node];
        let before = |path: usize| {
            let nodes = &self.graph.paths[path];
            self.x(nodes[nodes.len() - 2])
        };
        let mut paths = self.graph.entering[node].clone();
        paths.sort_by_key(|path| before(*path));
        let (left, right) = bar_above(self.graph, &self.placed.x, node).unwrap_or_default();
        let corner = (left, top);
        open(xml, name, self.ids[node][0], (right - left, height), &[]);
        position(xml, corner);
        for path in paths {
            let pin = (before(path), top);
            let (from, mut points) = self.wire(path);
            points.push(pin);
            xml.open("connectionPointIn", &[]);
            relative(xml, pin, corner);
            connection(xml, from.object, None, &points);
            xml.close();
        }
        output(xml, "connectionPointOut", None, (self.x(node) - left, height));
        xml.close();
    }

    /// What leads from a node to several sides, as a bar below it.
    fn bar_below(&self, xml: &mut Xml, node: usize) {
        let (name, height) = self.bar(node, false);
        let top = self.placed.below[node];
        let mut ends: Vec<i64> =
            self.graph.leaving[node].iter().map(|path| self.x(self.graph.paths[*path][1])).collect();
        ends.sort_unstable();
        let (left, right) = bar_below(self.graph, &self.placed.x, node).unwrap_or_default();
        let (corner, pin) = ((left, top), (self.x(node), top));
        open(xml, name, self.ids[node][2], (right - left, height), &[]);
        position(xml, corner);
        xml.open("connectionPointIn", &[]);
        relative(xml, pin, corner);
        connection(xml, self.ids[node][1], None, &[(pin.0, self.bottom(node)), pin]);
        xml.close();
        for end in ends {
            output(xml, "connectionPointOut", Some(""), (end - left, height));
        }
        xml.close();
    }

    fn actions(&self, xml: &mut Xml, node: usize, step: usize) {
        let rows = &self.texts.actions[step];
        if rows.is_empty() {
            return;
        }
        let right = self.x(node) + step_width(&self.texts.steps[step]) / 2;
        let corner = (right + TO_ACTIONS, self.y(node));
        let pin = (corner.0, corner.1 + ROW / 2);
        let height = ROW * i64::try_from(rows.len()).unwrap_or(1);
        open(xml, "actionBlock", self.first_action[node], (block_width(self.texts, step), height), &[]);
        position(xml, corner);
        xml.open("connectionPointIn", &[]);
        relative(xml, pin, corner);
        connection(xml, self.ids[node][1], None, &[(right, pin.1), pin]);
        xml.close();
        for (place, action) in rows.iter().enumerate() {
            let id = (self.first_action[node] + 1 + place).to_string();
            xml.open("action", &[("localId", &id), ("qualifier", action.qualifier)]);
            relative(xml, (0, ROW * i64::try_from(place).unwrap_or(0)), (0, 0));
            match &action.content {
                Content::Variable(name) => xml.empty("reference", &[("name", name)]),
                Content::Statements(text) => {
                    // Of a condition an inline text has a name, here it has none.
                    xml.open("inline", &[]);
                    self.dialect.body(xml, "ST", text);
                    xml.close();
                }
            }
            xml.close();
        }
        xml.close();
    }
}
