//! The channels between rows: each horizontal piece gets a track; then rows and tracks get their coordinates.
//!
//! From the top: the lines that fork what comes from the row above, what leaves for a lane, what comes from a lane or is
//! joined to the row below. So of two pieces on one axis the upper one always ends above the lower one.

use crate::SPACING;
use crate::across::Across;
use crate::cells::{Cells, What};
use crate::graph::{Bar, Kind, Side};
use crate::lanes::Lanes;
use crate::ports::Ports;
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Coordinates downwards.
pub(crate) struct Down {
    /// The upper end of each cell's body.
    pub tops: Vec<i32>,
    /// For each cell from which several lines come, where they are forked.
    pub forks: FxHashMap<usize, i32>,
    /// For each lane and channel, where lines leave for it, from the left and from the right.
    pub exits: FxHashMap<(usize, usize), [i32; 2]>,
    /// For each cell where lines are joined or one comes from a lane, where they are, from the left and from the right.
    pub entries: FxHashMap<usize, [i32; 2]>,
    /// For each piece at a short double line that does not meet it straight, where it turns to it or from it.
    pub turns: FxHashMap<(usize, Side), i32>,
}

/// The height of a channel in which nothing is horizontal, and of one with a single track.
const PLAIN: i32 = 10;
const WITH_TRACK: i32 = 28;
/// Two lines on one track are so far apart.
const ALONG: i32 = 12;

#[derive(Clone, Copy)]
enum Owner {
    Fork(usize),
    /// With the part of it: what comes from the left, from the right, or both on one line.
    Exit(usize, &'static [usize]),
    Entry(usize, &'static [usize]),
    /// A piece at a short double line, and how many others are nearer to the middle of that.
    Turn(usize, Side, usize),
}

const BOTH: &[usize] = &[0, 1];
const LEFT: &[usize] = &[0];
const RIGHT: &[usize] = &[1];

struct Piece {
    owner: Owner,
    left: i32,
    right: i32,
    track: usize,
}

impl Down {
    pub(crate) fn new(cells: &Cells, lanes: &Lanes, across: &Across, ports: &Ports) -> Down {
        let mut channels: Vec<[Vec<Piece>; 3]> = (0..=cells.rows).map(|_| Default::default()).collect();
        for cell in 0..cells.cells.len() {
            let (row, x) = (cells.row(cell), across.cells[cell]);
            if cells.is_short(cell, Side::Under) {
                let ends = cells.out[cell].iter().map(|wire| (*wire, across.cells[cells.wires[*wire].to]));
                channels[row + 1][0].extend(turns(ports, x, Side::Under, ends));
            } else if cells.forks(cell) {
                let ends = cells.out[cell].iter().map(|wire| across.cells[cells.wires[*wire].to]);
                channels[row + 1][0].push(Piece::new(Owner::Fork(cell), x, ends, cells.is_doubled(cell)));
            }
            let ends = cells.into[cell].iter().map(|wire| match lanes.of[*wire] {
                Some(lane) => (*wire, across.lanes[lane]),
                None => (*wire, across.cells[cells.wires[*wire].from]),
            });
            if cells.is_short(cell, Side::Over) {
                channels[row][2].extend(turns(ports, x, Side::Over, ends));
                continue;
            }
            let ends: Vec<i32> = ends.map(|(_, end)| end).collect();
            // What comes from where lines are forked goes straight down from there.
            let from_fork = |wire: &usize| cells.wires[*wire].lane.is_none() && cells.forks(cells.wires[*wire].from);
            let comes_straight = cells.into[cell].iter().all(from_fork) || ends.iter().all(|end| *end == x);
            if cells.joins(cell) || !comes_straight {
                let is_doubled = cells.is_doubled(cell) && cells.joins(cell);
                let owner = |side| Owner::Entry(cell, side);
                channels[row][2].extend(sides(owner, x, &ends, is_doubled, !is_doubled && ends.contains(&x)));
            }
        }
        for (lane, about) in lanes.lanes.iter().enumerate() {
            let mut exits: BTreeMap<usize, Vec<i32>> = BTreeMap::new();
            for wire in &about.wires {
                let from = cells.wires[*wire].from;
                exits.entry(cells.row(from) + 1).or_default().push(across.cells[from]);
            }
            // Where the lane begins nothing comes along it.
            let begin = if about.up { about.last } else { about.first };
            for (channel, ends) in exits {
                let owner = |side| Owner::Exit(lane, side);
                channels[channel][1].extend(sides(owner, across.lanes[lane], &ends, false, channel != begin));
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
            turns: FxHashMap::default(),
        };
        let mut y = 0;
        for (channel, zones) in channels.iter().enumerate() {
            let mut before = 0;
            for (zone, count) in zones.iter().zip(tracks[channel]) {
                for piece in zone {
                    let at = y + WITH_TRACK / 2 + SPACING * (before + piece.track) as i32;
                    match piece.owner {
                        Owner::Fork(cell) => {
                            down.forks.insert(cell, at);
                        }
                        Owner::Exit(lane, sides) => {
                            let known = down.exits.entry((lane, channel)).or_insert([at; 2]);
                            sides.iter().for_each(|side| known[*side] = at);
                        }
                        Owner::Entry(cell, sides) => {
                            let known = down.entries.entry(cell).or_insert([at; 2]);
                            sides.iter().for_each(|side| known[*side] = at);
                        }
                        Owner::Turn(wire, side, _) => {
                            down.turns.insert((wire, side), at);
                        }
                    }
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

/// The horizontal pieces between lines and the ports where they meet a short double line.
fn turns(ports: &Ports, x: i32, side: Side, ends: impl Iterator<Item = (usize, i32)>) -> Vec<Piece> {
    let piece = |(wire, end): (usize, i32)| {
        let &(at, nearer) = ports.of.get(&(wire, side))?;
        let owner = Owner::Turn(wire, side, nearer);
        (x + at != end).then(|| Piece::new(owner, x + at, std::iter::once(end), false))
    };
    ends.filter_map(piece).collect()
}

/// What joins a line that goes on, from both sides: at two heights, for lines that meet from all four sides would look
/// like a crossing.
fn sides(
    owner: impl Fn(&'static [usize]) -> Owner,
    x: i32,
    ends: &[i32],
    is_doubled: bool,
    goes_on: bool,
) -> Vec<Piece> {
    let piece = |side, from: i32, to: i32| {
        let ends = ends.iter().copied().filter(|end| (from..=to).contains(end));
        Piece::new(owner(side), x, ends, is_doubled)
    };
    if goes_on && ends.iter().any(|end| *end < x) && ends.iter().any(|end| *end > x) {
        vec![piece(LEFT, i32::MIN, x), piece(RIGHT, x, i32::MAX)]
    } else {
        vec![piece(BOTH, i32::MIN, i32::MAX)]
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
/// of it; the same the other way round. What turns to a short double line goes lower the further from its middle it
/// ends, what turns from one higher.
fn pack(pieces: &mut [Piece]) -> usize {
    pieces.sort_by_key(|piece| match piece.owner {
        Owner::Exit(..) => (0, -piece.left, piece.right),
        Owner::Fork(_) | Owner::Entry(..) => (0, piece.left, piece.right),
        Owner::Turn(_, Side::Over, nearer) => (1 + nearer as i32, piece.left, piece.right),
        Owner::Turn(_, Side::Under, nearer) => (-1 - nearer as i32, piece.left, piece.right),
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
