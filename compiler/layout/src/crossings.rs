//! What a lane would cross, so that of two ways the one is taken that crosses less.
//!
//! Only so much is looked at: the way of a lane is a question of looks, and its cost must not grow with the chart.

use crate::cells::Cells;
use crate::columns::Columns;
use rustc_hash::FxHashMap;

/// A way that a lane could take.
pub(crate) struct Way {
    /// The channel between columns.
    pub channel: usize,
    /// What it crosses; a double line is worth many lines.
    pub cost: usize,
}

/// So many columns, and so many lines between rows, are looked at.
const COLUMNS: usize = 32;
const LINES: usize = 256;
/// What is not looked at, and a double line, count so much.
const MANY: usize = 24;

/// Where lines go straight down, and where others lead across.
pub(crate) struct Crossings {
    /// By column, the channels between rows that a line goes straight down.
    down: Vec<Vec<(usize, usize)>>,
    /// By column and channel, what a line that leaves for a lane leads to.
    leaving: FxHashMap<(usize, usize), usize>,
    /// By channel between rows, what forks above and joins below: from which column to which.
    across: Vec<Vec<Across>>,
}

struct Across {
    left: usize,
    right: usize,
    is_double: bool,
    forks: bool,
}

impl Crossings {
    pub(crate) fn new(cells: &Cells, columns: &Columns) -> Crossings {
        let mut down = vec![Vec::new(); columns.of.iter().max().map_or(0, |most| most + 1)];
        let mut leaving = FxHashMap::default();
        let mut across: Vec<Vec<Across>> = (0..=cells.rows).map(|_| Vec::new()).collect();
        for cell in 0..cells.cells.len() {
            let row = cells.row(cell);
            let column = columns.of[cell];
            if let Some(parent) = columns.parent[cell] {
                down[column].push((cells.row(parent) + 1, row));
            }
            if let Some(kept) = columns.kept[cell] {
                down[column].push((row + 1, kept));
            }
            for wire in cells.out[cell].iter().filter(|wire| cells.wires[**wire].lane.is_some()) {
                leaving.insert((column, row + 1), cells.wires[*wire].to);
            }
            let is_double = cells.is_doubled(cell);
            let mut add = |channel: usize, forks: bool, ends: &[usize]| {
                let left = ends.iter().copied().min().unwrap_or(column).min(column);
                let right = ends.iter().copied().max().unwrap_or(column).max(column);
                across[channel].push(Across { left, right, is_double, forks });
            };
            if cells.forks(cell) {
                let ends: Vec<usize> = cells.down(cell).map(|wire| columns.of[cells.wires[wire].to]).collect();
                add(row + 1, true, &ends);
            }
            if cells.joins(cell) {
                let straight = cells.into[cell].iter().filter(|wire| cells.wires[**wire].lane.is_none());
                let ends: Vec<usize> = straight.map(|wire| columns.of[cells.wires[*wire].from]).collect();
                add(row, false, &ends);
            }
        }
        down.iter_mut().for_each(|column| column.sort_unstable());
        Crossings { down, leaving, across }
    }

    /// The best way from a column to a box between two channels, in this channel or further out past double lines. What
    /// is shared with another link is there already.
    pub(crate) fn way(
        &self,
        to: usize,
        from: usize,
        (entry, below): (usize, usize),
        (nearest, is_left): (usize, bool),
        is_shared: bool,
    ) -> Way {
        let mut best: Option<Way> = None;
        let mut channel = nearest;
        for outwards in 0..3 {
            let (crossed, beyond) = self.along(channel, entry, below, is_left);
            let along = if is_shared { 0 } else { crossed };
            let cost = along + self.exit(to, from, below, channel) + outwards;
            if best.as_ref().is_none_or(|best| cost < best.cost) {
                best = Some(Way { channel, cost });
            }
            match beyond {
                Some(beyond) => channel = beyond,
                None => break,
            }
        }
        best.unwrap_or(Way { channel: nearest, cost: MANY })
    }

    /// What crosses a channel between columns on the way, and if double lines do the channel beyond these.
    fn along(&self, channel: usize, entry: usize, below: usize, is_left: bool) -> (usize, Option<usize>) {
        let (mut cost, mut looked_at, mut beyond) = (0, 0, None);
        let (first, last) = (entry.min(below), entry.max(below));
        for between in first + 1..=last {
            // Where a link leaves for the lane it meets only what forks above; where it ends nothing is passed.
            let passed = self.across[between].iter().filter(|across| between < last || below == last && across.forks);
            for across in passed {
                looked_at += 1;
                if across.left < channel && channel <= across.right {
                    cost += if across.is_double { MANY } else { 1 };
                    if across.is_double {
                        let next = if is_left { across.left } else { across.right + 1 };
                        beyond = Some(beyond.map_or(
                            next,
                            |known: usize| {
                                if is_left { known.min(next) } else { known.max(next) }
                            },
                        ));
                    }
                }
            }
            looked_at += 1;
            if looked_at > LINES {
                return (cost + MANY, beyond);
            }
        }
        (cost, beyond)
    }

    /// What a link crosses between its column and the channel of its lane.
    fn exit(&self, to: usize, from: usize, below: usize, channel: usize) -> usize {
        let passed = if channel <= from { channel..from } else { from + 1..channel };
        let columns = passed.len();
        let crossed = passed.take(COLUMNS).filter(|column| self.goes_down(*column, below, to)).count();
        crossed + columns.saturating_sub(COLUMNS)
    }

    /// Whether, in the channel above a row, a line goes down in a column that does not lead to the same.
    fn goes_down(&self, column: usize, channel: usize, to: usize) -> bool {
        let leaves_elsewhere = self.leaving.get(&(column, channel)).is_some_and(|other| *other != to);
        let passed = self.down.get(column).is_some_and(|passed| {
            let after = passed.partition_point(|(first, _)| *first <= channel);
            after > 0 && passed[after - 1].1 >= channel
        });
        leaves_elsewhere || passed
    }
}
