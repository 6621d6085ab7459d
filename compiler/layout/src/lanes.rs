//! Lanes: the vertical pieces of links that do not go straight down, in channels between columns.
//!
//! Channel n is left of column n. A lane is left of the column that it leads to, or right of all that it comes from: where
//! it crosses less, and around double lines rather than through them. Links to one box from one side share a lane.

use crate::cells::Cells;
use crate::columns::Columns;
use crate::crossings::Crossings;
use rustc_hash::FxHashMap;
use std::cmp::Reverse;
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

impl Lanes {
    pub(crate) fn new(cells: &Cells, columns: &Columns) -> Lanes {
        let crossings = Crossings::new(cells, columns);
        let mut lanes: Vec<Lane> = Vec::new();
        let mut of = vec![None; cells.wires.len()];
        let mut known: FxHashMap<(usize, bool, bool), usize> = FxHashMap::default();
        for (wire, ends) in cells.wires.iter().enumerate() {
            let Some(up) = ends.lane else { continue };
            let (from, to) = (columns.of[ends.from], columns.of[ends.to]);
            let (entry, below) = (cells.row(ends.to), cells.row(ends.from) + 1);
            let is_known = |is_left: bool| known.contains_key(&(ends.to, up, is_left));
            let right = crossings.way(ends.to, from, (entry, below), (from.max(to) + 1, false), is_known(false));
            let left = up.then(|| crossings.way(ends.to, from, (entry, below), (to, true), is_known(true)));
            let left = left.filter(|left| left.cost == 0 || left.cost < right.cost);
            let (is_left, channel) = left.map_or((false, right.channel), |left| (true, left.channel));
            let lane = *known.entry((ends.to, up, is_left)).or_insert_with(|| {
                let (track, first, last) = (0, entry, entry);
                lanes.push(Lane { up, wires: Vec::new(), channel, is_left, track, first, last });
                lanes.len() - 1
            });
            of[wire] = Some(lane);
            let lane = &mut lanes[lane];
            lane.wires.push(wire);
            lane.first = lane.first.min(below);
            lane.last = lane.last.max(below);
            lane.channel = if is_left { lane.channel.min(channel) } else { lane.channel.max(channel) };
        }
        pack(&mut lanes, |lane| columns.of[cells.wires[lane.wires[0]].to]);
        Lanes { lanes, of }
    }
}

/// Gives each lane the first track that is free all along it, the shortest lanes first; of equal ones on the right the
/// one that leads furthest to the right, so that it does not cross the others.
fn pack(lanes: &mut [Lane], column: impl Fn(&Lane) -> usize) {
    let mut order: Vec<usize> = (0..lanes.len()).collect();
    order.sort_by_key(|lane| {
        let lane = &lanes[*lane];
        (lane.channel, lane.is_left, lane.last - lane.first, Reverse(column(lane)))
    });
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
