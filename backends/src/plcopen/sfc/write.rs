//! The drawing as elements, each with its place, its size and the points of its wires.

use super::graph::{BAR, Graph, JUMP, ROW, TO_ACTIONS, VertexKind, block_width, comment_width, step_width};
use super::place::{Line, Placed};
use crate::plcopen::dialect::Dialect;
use crate::plcopen::drawing::{Point, connection, open, output, position, relative};
use crate::sequence::texts::{Content, Texts};
use crate::xml::Xml;

/// Writes all elements, from the top down, those beside each other from the left.
pub(super) fn write(xml: &mut Xml, graph: &Graph, placed: &Placed, texts: &Texts, dialect: Dialect) {
    let sheet = Sheet::new(graph, placed, texts, dialect);
    xml.open("SFC", &[]);
    for &node in &placed.order {
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
        for &node in &placed.order {
            let (above, below) = (placed.above[node].is_some(), placed.below[node].is_some());
            ids[node] = [fresh(usize::from(above)), fresh(1), fresh(usize::from(below))];
            if let VertexKind::Step { step, .. } = graph.nodes[node].kind {
                let rows = texts.actions[step].len();
                first_action[node] = fresh(if rows > 0 { rows + 1 } else { 0 });
                comment[node] = fresh(usize::from(!texts.comments[step].is_empty()));
            }
        }
        Sheet { graph, placed, texts, dialect, ids, first_action, comment }
    }

    fn x(&self, node: usize) -> i64 {
        self.placed.at[node].0
    }

    fn y(&self, node: usize) -> i64 {
        self.placed.at[node].1
    }

    /// The lower end of a box.
    fn bottom(&self, node: usize) -> i64 {
        self.y(node)
            + match self.graph.nodes[node].kind {
                VertexKind::Step { .. } => ROW,
                VertexKind::Transition(_) => BAR,
                VertexKind::Jump(_) => JUMP,
            }
    }

    fn node(&self, xml: &mut Xml, node: usize) {
        if let Some(line) = self.placed.above[node] {
            self.bar_above(xml, node, line);
        }
        match self.graph.nodes[node].kind {
            VertexKind::Step { step, initial } => self.step(xml, node, step, initial),
            VertexKind::Transition(transition) => self.transition(xml, node, transition),
            VertexKind::Jump(to) => self.jump(xml, node, to),
        }
        if let Some(line) = self.placed.below[node] {
            self.bar_below(xml, node, line);
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
        open(xml, "transition", self.ids[node][1], (20, BAR), &[]);
        position(xml, corner);
        self.input(xml, node, corner);
        output(xml, "connectionPointOut", None, (10, BAR));
        xml.open("condition", &[]);
        xml.open("inline", &[("name", "")]);
        self.dialect.body(xml, "ST", &self.texts.conditions[transition]);
        xml.close();
        xml.close();
        xml.close();
    }

    fn jump(&self, xml: &mut Xml, node: usize, to: usize) {
        let corner = (self.x(node) - 6, self.y(node));
        open(xml, "jumpStep", self.ids[node][1], (12, JUMP), &[("targetName", &self.texts.steps[to])]);
        position(xml, corner);
        self.input(xml, node, corner);
        xml.close();
    }

    /// The input of a box: from a bar above it, from what leads to it, or from nothing.
    fn input(&self, xml: &mut Xml, node: usize, corner: Point) {
        let pin = (self.x(node), self.y(node));
        xml.open("connectionPointIn", &[]);
        relative(xml, pin, corner);
        match (self.placed.above[node], self.graph.entering[node].first()) {
            (Some(line), _) => connection(xml, self.ids[node][0], None, &[(pin.0, line.bottom()), pin]),
            (None, Some(arc)) => connection(xml, self.source(*arc), None, &self.placed.wires[*arc]),
            (None, None) => {}
        }
        xml.close();
    }

    /// What an arc comes from: the line below a node, or the node itself.
    fn source(&self, arc: usize) -> usize {
        let from = self.graph.arcs[arc].0;
        self.ids[from][if self.placed.below[from].is_some() { 2 } else { 1 }]
    }

    /// What leads to a node from several sides, as a bar above it.
    fn bar_above(&self, xml: &mut Xml, node: usize, line: Line) {
        let name = match self.graph.nodes[node].kind {
            VertexKind::Transition(_) => "simultaneousConvergence",
            VertexKind::Step { .. } | VertexKind::Jump(_) => "selectionConvergence",
        };
        let corner = (line.left, line.top);
        open(xml, name, self.ids[node][0], (line.right - line.left, line.height), &[]);
        position(xml, corner);
        let pin = |arc: &usize| self.placed.wires[*arc].last().copied().unwrap_or(corner);
        let mut arcs = self.graph.entering[node].clone();
        arcs.sort_by_key(pin);
        for arc in arcs {
            xml.open("connectionPointIn", &[]);
            relative(xml, pin(&arc), corner);
            connection(xml, self.source(arc), None, &self.placed.wires[arc]);
            xml.close();
        }
        output(xml, "connectionPointOut", None, (self.x(node) - line.left, line.height));
        xml.close();
    }

    /// What leads from a node to several sides, as a bar below it.
    fn bar_below(&self, xml: &mut Xml, node: usize, line: Line) {
        let name = match self.graph.nodes[node].kind {
            VertexKind::Transition(_) => "simultaneousDivergence",
            VertexKind::Step { .. } | VertexKind::Jump(_) => "selectionDivergence",
        };
        let start = |arc: &usize| self.placed.wires[*arc].first().map_or(line.left, |point| point.0);
        let mut ends: Vec<i64> = self.graph.leaving[node].iter().map(start).collect();
        ends.sort_unstable();
        let (corner, pin) = ((line.left, line.top), (self.x(node), line.top));
        open(xml, name, self.ids[node][2], (line.right - line.left, line.height), &[]);
        position(xml, corner);
        xml.open("connectionPointIn", &[]);
        relative(xml, pin, corner);
        connection(xml, self.ids[node][1], None, &[(pin.0, self.bottom(node)), pin]);
        xml.close();
        for end in ends {
            output(xml, "connectionPointOut", Some(""), (end - line.left, line.height));
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
            let mut attributes = vec![("localId", id.as_str()), ("qualifier", action.qualifier.name())];
            attributes.extend(action.qualifier.time().map(|time| ("duration", time)));
            xml.open("action", &attributes);
            relative(xml, (0, ROW * i64::try_from(place).unwrap_or(0)), (0, 0));
            match &action.content {
                Content::Variable(name) => xml.empty("reference", &[("name", name)]),
                Content::Computed(statement) | Content::Stored(statement) => {
                    // Of a condition an inline text has a name, here it has none.
                    xml.open("inline", &[]);
                    self.dialect.body(xml, "ST", &statement.flat);
                    xml.close();
                }
            }
            xml.close();
        }
        xml.close();
    }
}
