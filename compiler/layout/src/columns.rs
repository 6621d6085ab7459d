//! Columns.
//!
//! A walk down the links makes a tree: the first branch stays in the column of what it comes from, so that a sequence is
//! straight; each other one takes the first column that is free in all rows of what follows. A column is kept where
//! nothing stands but a line.

use crate::cells::{Cells, What};
use crate::graph::{Kind, Start};
use crate::max_tree::MaxTree;
use rustc_hash::FxHashMap;

/// The columns, and what stands straight under each other in them.
pub(crate) struct Columns {
    /// The column of each cell.
    pub of: Vec<usize>,
    /// The stem of each cell.
    pub stem_of: Vec<usize>,
    /// The stems.
    pub stems: Vec<Stem>,
    /// For each cell, the one that it hangs from.
    pub parent: Vec<Option<usize>>,
    /// For each cell whose line goes on straight down to where it is joined, the row of that.
    pub kept: Vec<Option<usize>>,
}

/// Branches of one stem that stand in one column have one axis.
pub(crate) struct Stem {
    pub column: usize,
    pub parent: Option<usize>,
}

/// The cells as a tree.
struct Tree {
    /// Each before what hangs from it.
    order: Vec<usize>,
    parent: Vec<Option<usize>>,
    is_first: Vec<bool>,
    kept: Vec<Option<usize>>,
}

impl Columns {
    pub(crate) fn new(cells: &Cells) -> Columns {
        let tree = Tree::new(cells);
        let mut bottom: Vec<usize> = (0..cells.cells.len()).map(|cell| cells.row(cell)).collect();
        for &cell in tree.order.iter().rev() {
            bottom[cell] = bottom[cell].max(tree.kept[cell].unwrap_or(0));
            if let Some(parent) = tree.parent[cell] {
                bottom[parent] = bottom[parent].max(bottom[cell]);
            }
        }
        let mut taken = MaxTree::new(cells.rows);
        let mut columns = Columns {
            of: vec![0; cells.cells.len()],
            stem_of: vec![0; cells.cells.len()],
            stems: Vec::new(),
            parent: tree.parent,
            kept: tree.kept,
        };
        let mut stems: FxHashMap<(Option<usize>, usize), usize> = FxHashMap::default();
        for &cell in &tree.order {
            let (parent, row) = (columns.parent[cell], cells.row(cell));
            let above = parent.filter(|_| tree.is_first[cell]);
            // In the row of what it comes from there is its line.
            let top = parent.map_or(row, |parent| cells.row(parent) + usize::from(above.is_some()));
            let (column, stem) = match above {
                Some(above) => (columns.of[above], columns.stem_of[above]),
                None => {
                    let column = (taken.max(top, bottom[cell]) + 1) as usize;
                    let from = parent.map(|parent| columns.stem_of[parent]);
                    let stem = *stems.entry((from, column)).or_insert_with(|| {
                        columns.stems.push(Stem { column, parent: from });
                        columns.stems.len() - 1
                    });
                    (column, stem)
                }
            };
            (columns.of[cell], columns.stem_of[cell]) = (column, stem);
            taken.raise(top, columns.kept[cell].unwrap_or(row), column as i32);
        }
        columns
    }
}

impl Tree {
    fn new(cells: &Cells) -> Tree {
        let count = cells.cells.len();
        let mut tree = Tree {
            order: Vec::with_capacity(count),
            parent: vec![None; count],
            is_first: vec![false; count],
            kept: vec![None; count],
        };
        let is_source = |cell: &usize| cells.into[*cell].iter().all(|wire| cells.wires[*wire].lane.is_some());
        // The main sequence is that of the first initial step, whatever else leads to it.
        let main = (0..count).find(|cell| cells.cells[*cell].start == Start::Initial);
        let mut starts: Vec<usize> = (0..count).filter(|cell| is_source(cell) || main == Some(*cell)).collect();
        starts.sort_by_key(|cell| (cells.cells[*cell].start, *cell));
        let mut met = vec![false; count];
        let mut open: Vec<(usize, Option<usize>)> = starts.into_iter().rev().map(|cell| (cell, None)).collect();
        while let Some((cell, parent)) = open.pop() {
            if std::mem::replace(&mut met[cell], true) {
                // Another branch leads there: the line goes straight down to it.
                if let Some(parent) = parent {
                    tree.kept[parent] = Some(cells.row(cell));
                }
                continue;
            }
            if let Some(parent) = parent {
                tree.parent[cell] = Some(parent);
                tree.is_first[cell] = tree.order.last() == Some(&parent);
            }
            tree.order.push(cell);
            let mut below: Vec<usize> = cells.down(cell).map(|wire| cells.wires[wire].to).collect();
            // Of branches that lead to what stands already the one that ends first is inside.
            let met_row = |next: usize| {
                let after = cells.down(next).map(|wire| cells.wires[wire].to);
                after.map(|after| if met[after] { cells.row(after) } else { 0 }).max().unwrap_or(0)
            };
            below.sort_by_key(|next| (rank(cells, *next), met_row(*next)));
            open.extend(below.into_iter().rev().map(|next| (next, Some(cell))));
        }
        tree
    }
}

/// What goes on stands straight below, what leaves or comes later beside it.
fn rank(cells: &Cells, cell: usize) -> u32 {
    let row = cells.row(cell);
    let below = cells.down(cell).map(|wire| cells.wires[wire].to);
    let goes_on = below.map(|next| match cells.cells[next].what {
        What::Label(_) => 3,
        What::Node(_) | What::Joint if cells.row(next) == row + 1 => 0,
        What::Node(_) | What::Joint => 1,
    });
    match (goes_on.min(), cells.cells[cell].what) {
        (_, What::Label(_)) => 3,
        (_, What::Node(Kind::Step)) => 0,
        (Some(rank), _) => rank,
        (None, _) if cells.out[cell].is_empty() => 2,
        (None, _) => 3,
    }
}
