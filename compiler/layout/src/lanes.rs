//! Lanes: the vertical pieces of links that do not go straight down, in channels between columns.
//!
//! Channel n is left of column n. What returns from the last column in use takes the channel left of the column that it
//! returns to; what returns while others go on takes the one right of itself, so that it crosses nothing. Links to one
//! box from one side share a lane.

use crate::cells::Cells;
use crate::columns::Columns;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// One lane, with all links that share it.
pub(crate) struct Lane {
    pub up: bool,
    /// The pieces that take it, in order of the text.
    pub wires: Vec<usize>,
    /// The channel between columns.
    pub channel: usize,
    /// Whether it belongs to what is right of it, and so lies as near to that as it can.
    pub is_left: bool,
    /// Its place among the lanes of its channel that belong to the same side; 0 is nearest to what it belongs to.
    pub track: usize,
    /// The first and last channel between rows that it meets.
    pub first: usize,
    pub last: usize,
}

pub(crate) struct Lanes {
    pub lanes: Vec<Lane>,
    /// The lane of each piece that takes one.
    pub of: Vec<Option<usize>>,
}

/// So many columns are looked at to find out whether the way to the left is free.
const LOOKED_AT: usize = 32;

impl Lanes {
    pub(crate) fn new(cells: &Cells, columns: &Columns) -> Lanes {
        let passed = Passed::new(cells, columns);
        let mut lanes: Vec<Lane> = Vec::new();
        let mut of = vec![None; cells.wires.len()];
        let mut known: FxHashMap<(usize, bool, bool), usize> = FxHashMap::default();
        for (wire, ends) in cells.wires.iter().enumerate() {
            let Some(up) = ends.lane else { continue };
            let (from, to) = (columns.of[ends.from], columns.of[ends.to]);
            let below = cells.row(ends.from) + 1;
            let is_left = up
                && (from <= to
                    || from - to <= LOOKED_AT && !(to..from).any(|column| passed.at(column, below, ends.to)));
            let entry = cells.row(ends.to);
            let lane = *known.entry((ends.to, up, is_left)).or_insert_with(|| {
                let (channel, track, first, last) = (to, 0, entry, entry);
                lanes.push(Lane { up, wires: Vec::new(), channel, is_left, track, first, last });
                lanes.len() - 1
            });
            of[wire] = Some(lane);
            let lane = &mut lanes[lane];
            lane.wires.push(wire);
            lane.first = lane.first.min(below);
            lane.last = lane.last.max(below);
            if !is_left {
                lane.channel = lane.channel.max(from + 1);
            }
        }
        pack(&mut lanes);
        Lanes { lanes, of }
    }
}

/// Gives each lane the first track that is free all along it, the shortest lanes first.
fn pack(lanes: &mut [Lane]) {
    let mut order: Vec<usize> = (0..lanes.len()).collect();
    order.sort_by_key(|lane| (lanes[*lane].channel, lanes[*lane].is_left, lanes[*lane].last - lanes[*lane].first));
    // For the channel at hand: the lanes of each track, from first to last.
    let mut tracks: Vec<BTreeMap<usize, usize>> = Vec::new();
    let mut at = None;
    for lane in order {
        let here = (lanes[lane].channel, lanes[lane].is_left);
        if at != Some(here) {
            at = Some(here);
            tracks.clear();
        }
        let (first, last) = (lanes[lane].first, lanes[lane].last);
        let is_free = |track: &BTreeMap<usize, usize>| {
            track.range(..=last).next_back().is_none_or(|(_, other_last)| *other_last < first)
        };
        let track = tracks.iter().position(is_free).unwrap_or_else(|| {
            tracks.push(BTreeMap::new());
            tracks.len() - 1
        });
        tracks[track].insert(first, last);
        lanes[lane].track = track;
    }
}

/// Where lines go straight down, by column, and where others leave for a lane.
struct Passed {
    down: Vec<Vec<(usize, usize)>>,
    /// By column and channel, what is led to.
    leaving: FxHashMap<(usize, usize), usize>,
}

impl Passed {
    fn new(cells: &Cells, columns: &Columns) -> Passed {
        let mut down = vec![Vec::new(); columns.of.iter().max().map_or(0, |most| most + 1)];
        let mut leaving = FxHashMap::default();
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
        }
        down.iter_mut().for_each(|column| column.sort_unstable());
        Passed { down, leaving }
    }

    /// Whether, in the channel above a row, a line goes down in a column that does not lead to the same.
    fn at(&self, column: usize, channel: usize, to: usize) -> bool {
        let passed = &self.down[column];
        let after = passed.partition_point(|(first, _)| *first <= channel);
        let leaves_elsewhere = self.leaving.get(&(column, channel)).is_some_and(|other| *other != to);
        leaves_elsewhere || after > 0 && passed[after - 1].1 >= channel
    }
}
