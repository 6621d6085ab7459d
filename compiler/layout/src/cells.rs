//! The boxes with the joints that some links need, and the pieces of links between them.
//!
//! After this, of a piece that goes down either one end is where a line is joined or forked, or none.

use crate::crowd::Way;
use crate::graph::{Graph, Kind, Side, Size, Start};

/// What stands in a row: a box of the graph, a joint, or a label for a link.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell {
    pub what: What,
    pub row: i32,
    pub size: Size,
    pub start: Start,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum What {
    Node(Kind),
    /// A link passes.
    Joint,
    /// The label that stands for this link.
    Label(usize),
}

/// A piece of a link.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wire {
    pub from: usize,
    pub to: usize,
    /// Whether it takes a lane, and then whether that leads up.
    pub lane: Option<bool>,
}

/// The graph as it is drawn.
pub(crate) struct Cells {
    /// First the boxes, in order, then joints and labels.
    pub cells: Vec<Cell>,
    pub wires: Vec<Wire>,
    /// For each link its pieces, in order.
    pub pieces: Vec<Vec<usize>>,
    /// For each cell the pieces that come from it.
    pub out: Vec<Vec<usize>>,
    /// For each cell the pieces that lead to it.
    pub into: Vec<Vec<usize>>,
    /// How many rows there are; the first is 0.
    pub rows: usize,
    /// For each box, whether its double line stands right over and right under it, as a part of it, with the links coming
    /// to it and leaving it side by side.
    pub short: Vec<[bool; 2]>,
}

/// What a short double line adds to its box.
const SHORT: i32 = 10;

impl Cells {
    pub(crate) fn new(graph: &Graph, rows: Vec<i32>, ways: &[Way]) -> Cells {
        let mut cells: Vec<Cell> = Vec::with_capacity(graph.nodes.len());
        for (node, row) in graph.nodes.iter().zip(&rows) {
            cells.push(Cell { what: What::Node(node.kind), row: *row, size: node.size, start: node.start });
        }
        let (mut out, mut into) = (vec![0_usize; cells.len()], vec![0_usize; cells.len()]);
        for (&(from, to), way) in graph.links.iter().zip(ways) {
            out[from] += 1;
            into[to] += usize::from(*way != Way::Label);
        }
        let short = vec![[false; 2]; cells.len()];
        let main = graph.main();
        let mut made =
            Cells { cells, wires: Vec::new(), pieces: Vec::new(), out: vec![], into: vec![], rows: 0, short };
        for (link, (&(from, to), way)) in graph.links.iter().zip(ways).enumerate() {
            let (forks, joins) = (out[from] > 1, into[to] > 1 || main == Some(to));
            let below = made.cells[from].row + 1;
            let pieces = match *way {
                Way::Down if forks && joins => {
                    let joint = made.add(What::Joint, below, Size::default());
                    vec![made.wire(from, joint, None), made.wire(joint, to, None)]
                }
                Way::Down => vec![made.wire(from, to, None)],
                Way::Label => {
                    let label = made.add(What::Label(link), below, graph.nodes[to].label);
                    vec![made.wire(from, label, None)]
                }
                Way::Lane { up } => made.lane(from, to, up, forks, joins && graph.nodes[to].kind == Kind::Transition),
            };
            made.pieces.push(pieces);
        }
        made.finish()
    }

    /// A lane can join a single line, but no double line, and a fork is left by a piece that goes down.
    fn lane(&mut self, from: usize, to: usize, up: bool, forks: bool, joins: bool) -> Vec<usize> {
        let mut pieces = Vec::new();
        let (mut first, mut last) = (from, to);
        if forks {
            first = self.add(What::Joint, self.cells[from].row + 1, Size::default());
            pieces.push(self.wire(from, first, None));
        }
        if joins {
            last = self.add(What::Joint, self.cells[to].row - 1, Size::default());
        }
        pieces.push(self.wire(first, last, Some(up)));
        if joins {
            pieces.push(self.wire(last, to, None));
        }
        pieces
    }

    fn add(&mut self, what: What, row: i32, size: Size) -> usize {
        self.cells.push(Cell { what, row, size, start: Start::Plain });
        self.cells.len() - 1
    }

    fn wire(&mut self, from: usize, to: usize, lane: Option<bool>) -> usize {
        self.wires.push(Wire { from, to, lane });
        self.wires.len() - 1
    }

    fn finish(mut self) -> Cells {
        self.out = vec![Vec::new(); self.cells.len()];
        self.into = self.out.clone();
        for (wire, ends) in self.wires.iter().enumerate() {
            self.out[ends.from].push(wire);
            self.into[ends.to].push(wire);
        }
        let least = self.cells.iter().map(|cell| cell.row).min().unwrap_or(0);
        self.cells.iter_mut().for_each(|cell| cell.row -= least);
        self.rows = self.cells.iter().map(|cell| cell.row as usize + 1).max().unwrap_or(0);
        self
    }

    /// Draws a double line short, so that nothing can run through it.
    pub(crate) fn shorten(&mut self, node: usize, side: Side) {
        let size = &mut self.cells[node].size;
        let (place, more) = match side {
            Side::Over => (0, &mut size.above),
            Side::Under => (1, &mut size.below),
        };
        if !std::mem::replace(&mut self.short[node][place], true) {
            *more += SHORT;
        }
    }

    /// Whether a double line over or under it is short.
    pub(crate) fn is_short(&self, cell: usize, side: Side) -> bool {
        let place = match side {
            Side::Over => 0,
            Side::Under => 1,
        };
        self.short.get(cell).is_some_and(|short| short[place])
    }

    pub(crate) fn row(&self, cell: usize) -> usize {
        self.cells[cell].row as usize
    }

    /// The pieces from a cell that go down.
    pub(crate) fn down(&self, cell: usize) -> impl Iterator<Item = usize> + '_ {
        self.out[cell].iter().copied().filter(|wire| self.wires[*wire].lane.is_none())
    }

    /// Whether several pieces come from it.
    pub(crate) fn forks(&self, cell: usize) -> bool {
        self.out[cell].len() > 1
    }

    /// Whether several pieces lead to it.
    pub(crate) fn joins(&self, cell: usize) -> bool {
        self.into[cell].len() > 1
    }

    /// Whether lines are joined at it by a double line.
    pub(crate) fn is_doubled(&self, cell: usize) -> bool {
        self.cells[cell].what == What::Node(Kind::Transition)
    }
}
