//! The channels between rows: each horizontal piece gets a track; then rows and tracks get their coordinates.
//!
//! From the top: the lines that fork what comes from the row above, what leaves for a lane, what comes from a lane or is
//! joined to the row below. So of two pieces on one axis the upper one always ends above the lower one.

use crate::SPACING;
use crate::across::Across;
use crate::cells::{Cells, What};
use crate::graph::{Bar, Kind};
use crate::lanes::Lanes;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Coordinates downwards.
pub(crate) struct Down {
    /// The upper end of each cell's body.
    pub tops: Vec<i32>,
    /// For each cell from which several lines come, where they are forked.
    pub forks: FxHashMap<usize, i32>,
    /// For each lane and channel, where lines leave for it.
    pub exits: FxHashMap<(usize, usize), i32>,
    /// For each cell where lines are joined or one comes from a lane, where they are.
    pub entries: FxHashMap<usize, i32>,
}

/// The height of a channel in which nothing is horizontal, and of one with a single track.
const PLAIN: i32 = 10;
const WITH_TRACK: i32 = 28;
/// Two lines on one track are so far apart.
const ALONG: i32 = 12;

#[derive(Clone, Copy)]
enum Owner {
    Fork(usize),
    Exit(usize),
    Entry(usize),
}

struct Piece {
    owner: Owner,
    left: i32,
    right: i32,
    track: usize,
}

impl Down {
    pub(crate) fn new(cells: &Cells, lanes: &Lanes, across: &Across) -> Down {
        let mut channels: Vec<[Vec<Piece>; 3]> = (0..=cells.rows).map(|_| Default::default()).collect();
        for cell in 0..cells.cells.len() {
            let (row, x) = (cells.row(cell), across.cells[cell]);
            if cells.forks(cell) {
                let ends = cells.out[cell].iter().map(|wire| across.cells[cells.wires[*wire].to]);
                channels[row + 1][0].push(Piece::new(Owner::Fork(cell), x, ends, cells.is_doubled(cell)));
            }
            let comes_by_lane = cells.into[cell].iter().any(|wire| cells.wires[*wire].lane.is_some());
            if cells.joins(cell) || comes_by_lane {
                let ends = cells.into[cell].iter().map(|wire| match lanes.of[*wire] {
                    Some(lane) => across.lanes[lane],
                    None => across.cells[cells.wires[*wire].from],
                });
                let is_doubled = cells.is_doubled(cell) && cells.joins(cell);
                channels[row][2].push(Piece::new(Owner::Entry(cell), x, ends, is_doubled));
            }
        }
        for (lane, about) in lanes.lanes.iter().enumerate() {
            let mut exits: BTreeMap<usize, Vec<i32>> = BTreeMap::new();
            for wire in &about.wires {
                let from = cells.wires[*wire].from;
                exits.entry(cells.row(from) + 1).or_default().push(across.cells[from]);
            }
            for (channel, ends) in exits {
                let piece = Piece::new(Owner::Exit(lane), across.lanes[lane], ends.into_iter(), false);
                channels[channel][1].push(piece);
            }
        }
        let tracks: Vec<[usize; 3]> =
            channels.iter_mut().map(|zones| zones.each_mut().map(|zone| pack(zone))).collect();
        let rows = Rows::new(cells);
        let mut down = Down {
            tops: vec![0; cells.cells.len()],
            forks: FxHashMap::default(),
            exits: FxHashMap::default(),
            entries: FxHashMap::default(),
        };
        let mut y = 0;
        for (channel, zones) in channels.iter().enumerate() {
            let mut before = 0;
            for (zone, count) in zones.iter().zip(tracks[channel]) {
                for piece in zone {
                    let at = y + WITH_TRACK / 2 + SPACING * (before + piece.track) as i32;
                    match piece.owner {
                        Owner::Fork(cell) => down.forks.insert(cell, at),
                        Owner::Exit(lane) => down.exits.insert((lane, channel), at),
                        Owner::Entry(cell) => down.entries.insert(cell, at),
                    };
                }
                before += count;
            }
            y += if before == 0 { PLAIN } else { WITH_TRACK + SPACING * (before as i32 - 1) };
            if let Some(row) = rows.0.get(channel) {
                row.cells.iter().for_each(|cell| down.tops[*cell] = y + row.above);
                y += row.above + row.body + row.below;
            }
        }
        down
    }
}

impl Piece {
    fn new(owner: Owner, x: i32, others: impl Iterator<Item = i32>, is_doubled: bool) -> Piece {
        let (mut left, mut right) = (x, x);
        for other in others {
            left = left.min(other);
            right = right.max(other);
        }
        let overhang = if is_doubled { Bar::OVERHANG } else { 0 };
        Piece { owner, left: left - overhang, right: right + overhang, track: 0 }
    }
}

/// Gives each piece of a zone the first track on which it meets no other; gives back how many tracks there are.
///
/// What leaves to the right goes highest where it comes from the far right, so that it does not cross what leaves left
/// of it; the same the other way round.
fn pack(pieces: &mut [Piece]) -> usize {
    pieces.sort_by_key(|piece| match piece.owner {
        Owner::Exit(_) => (-piece.left, piece.right),
        Owner::Fork(_) | Owner::Entry(_) => (piece.left, piece.right),
    });
    let mut tracks: Vec<BTreeMap<i32, i32>> = Vec::new();
    for piece in pieces {
        let is_free = |track: &BTreeMap<i32, i32>| {
            track.range(..piece.right + ALONG).next_back().is_none_or(|(_, right)| right + ALONG <= piece.left)
        };
        piece.track = tracks.iter().position(is_free).unwrap_or_else(|| {
            tracks.push(BTreeMap::new());
            tracks.len() - 1
        });
        tracks[piece.track].insert(piece.left, piece.right);
    }
    tracks.len()
}

/// What a row holds and how high it is.
#[derive(Clone, Default)]
struct Row {
    cells: Vec<usize>,
    above: i32,
    body: i32,
    below: i32,
}

struct Rows(Vec<Row>);

impl Rows {
    fn new(cells: &Cells) -> Rows {
        let mut rows = vec![Row::default(); cells.rows];
        for (place, cell) in cells.cells.iter().enumerate() {
            let row = &mut rows[cell.row as usize];
            row.cells.push(place);
            row.above = row.above.max(cell.size.above);
        }
        for cell in &cells.cells {
            let row = &mut rows[cell.row as usize];
            let is_box = matches!(cell.what, What::Node(Kind::Step | Kind::Transition | Kind::Label) | What::Label(_));
            row.body = row.body.max(if is_box { cell.size.body } else { 0 });
            row.below = row.below.max(cell.size.body + cell.size.below - row.body);
        }
        // The bodies of a row begin at one height; what is below is counted from there.
        for row in &mut rows {
            let deepest = row.cells.iter().map(|cell| cells.cells[*cell].size).map(|size| size.body + size.below);
            row.below = (deepest.max().unwrap_or(0) - row.body).max(0);
        }
        Rows(rows)
    }
}
