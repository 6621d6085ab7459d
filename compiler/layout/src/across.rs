//! Columns and lanes to coordinates.
//!
//! A sweep over rows, and the channels between them, from the top finds what stands beside what, and so how far apart the
//! two have to be. Then each is as far left as it can, the lanes that belong to what is right of them as far right.

use crate::SPACING;
use crate::cells::Cells;
use crate::columns::Columns;
use crate::graph::Side;
use crate::lanes::Lanes;
use crate::order::{Position, positions};
use crate::ports::Ports;
use std::collections::BTreeMap;

/// The coordinates.
pub(crate) struct Across {
    /// The axis of each cell.
    pub cells: Vec<i32>,
    /// Each lane.
    pub lanes: Vec<i32>,
}

/// A box keeps so far from a line that does not lead to it, and from another box.
const TO_LINE: i32 = 12;
const TO_BOX: i32 = 20;
/// The axes of branches are so far apart at least.
const TO_BRANCH: i32 = 80;

/// What a box takes from its axis to the left and to the right.
type Sides = (i32, i32);

/// What is there at a line, in order: how often, since the end of one piece may be the beginning of the next; and the box.
type Here = BTreeMap<(Position, usize), (usize, Sides)>;

/// What moves as a whole: a stem, or a lane.
struct Units {
    position: Vec<Position>,
    /// For each unit what is left of it, and how far at least.
    left: Vec<Vec<(usize, i32)>>,
}

pub(crate) fn across(cells: &Cells, columns: &Columns, lanes: &Lanes, ports: &Ports) -> Across {
    let stems = columns.stems.len();
    let position = positions(columns, lanes);
    let left = vec![Vec::new(); position.len()];
    let mut units = Units { position, left };
    let main = columns.stems.iter().position(|stem| stem.column == 0);
    for (stem, about) in columns.stems.iter().enumerate() {
        // What begins elsewhere stands beside the main sequence, not nearly over it.
        if let Some(parent) = about.parent.or(main.filter(|_| about.column > 0)) {
            units.left[stem].push((parent, TO_BRANCH));
        }
    }
    units.sweep(cells, columns, lanes, ports);
    let places = units.places(lanes, stems);
    let origin = columns.of.iter().position(|column| *column == 0).map_or(0, |cell| places[columns.stem_of[cell]]);
    Across {
        cells: columns.stem_of.iter().map(|stem| places[*stem] - origin).collect(),
        lanes: (0..lanes.lanes.len()).map(|lane| places[stems + lane] - origin).collect(),
    }
}

impl Units {
    /// Rows have odd numbers, the channels between them even ones.
    fn sweep(&mut self, cells: &Cells, columns: &Columns, lanes: &Lanes, ports: &Ports) {
        let lines = 2 * cells.rows + 1;
        let stems = columns.stems.len();
        let mut begin: Vec<Vec<usize>> = vec![Vec::new(); lines];
        let mut end: Vec<Vec<usize>> = vec![Vec::new(); lines];
        let mut boxes: Vec<Vec<(usize, Sides)>> = vec![Vec::new(); lines];
        for cell in 0..cells.cells.len() {
            let (row, unit) = (cells.row(cell), columns.stem_of[cell]);
            let top = match columns.parent[cell] {
                Some(parent) => 2 * (cells.row(parent) + 1),
                None if cells.into[cell].is_empty() => 2 * row + 1,
                None => 2 * row,
            };
            let bottom = match columns.kept[cell] {
                Some(kept) => 2 * kept,
                None if cells.out[cell].is_empty() => 2 * row + 1,
                None => 2 * (row + 1),
            };
            begin[top].push(unit);
            end[bottom].push(unit);
            let size = cells.cells[cell].size;
            let mut sides = (size.left, size.right);
            // The links that a short double line joins or forks spread in the channel beside it.
            for (side, line) in [(Side::Over, 2 * row), (Side::Under, 2 * row + 2)] {
                if let Some(&(left, right)) = ports.reach.get(&(cell, side)) {
                    sides = (sides.0.max(left), sides.1.max(right));
                    boxes[line].push((unit, (left, right)));
                }
            }
            boxes[2 * row + 1].push((unit, sides));
        }
        for (lane, about) in lanes.lanes.iter().enumerate() {
            begin[2 * about.first].push(stems + lane);
            end[2 * about.last].push(stems + lane);
        }
        let mut here = Here::new();
        for line in 0..lines {
            for &unit in &begin[line] {
                let key = (self.position[unit], unit);
                let count = &mut here.entry(key).or_insert((0, (0, 0))).0;
                *count += 1;
                if *count == 1 {
                    self.keep_apart(&here, key);
                }
            }
            let keys: Vec<_> = boxes[line].iter().map(|(unit, _)| (self.position[*unit], *unit)).collect();
            for (key, (_, sides)) in keys.iter().zip(&boxes[line]) {
                here.entry(*key).and_modify(|(_, here)| *here = (here.0.max(sides.0), here.1.max(sides.1)));
            }
            keys.iter().for_each(|key| self.keep_apart(&here, *key));
            for key in &keys {
                here.entry(*key).and_modify(|(_, here)| *here = (0, 0));
            }
            for &unit in &end[line] {
                let key = (self.position[unit], unit);
                if let Some(found) = here.get_mut(&key) {
                    found.0 -= 1;
                    if found.0 == 0 {
                        here.remove(&key);
                    }
                }
            }
        }
    }

    /// Keeps one from its neighbours.
    fn keep_apart(&mut self, here: &Here, key: (Position, usize)) {
        let own = here.get(&key).map_or((0, 0), |(_, sides)| *sides);
        if let Some(((_, left), (_, sides))) = here.range(..key).next_back() {
            self.left[key.1].push((*left, distance(sides.1, own.0)));
        }
        let mut after = here.range(key..);
        after.next();
        if let Some(((_, right), (_, sides))) = after.next() {
            self.left[*right].push((key.1, distance(own.1, sides.0)));
        }
    }

    /// As far left as it can be, and what belongs to the right of it as far right.
    fn places(&self, lanes: &Lanes, stems: usize) -> Vec<i32> {
        let mut order: Vec<usize> = (0..self.position.len()).collect();
        order.sort_by_key(|unit| (self.position[*unit], *unit));
        let mut places = vec![0; order.len()];
        for &unit in &order {
            places[unit] = self.left[unit].iter().map(|(left, apart)| places[*left] + apart).max().unwrap_or(0);
        }
        let mut room: Vec<Option<i32>> = vec![None; order.len()];
        for &unit in order.iter().rev() {
            if unit >= stems && lanes.lanes[unit - stems].is_left {
                places[unit] = room[unit].unwrap_or(places[unit]);
            }
            for (left, apart) in &self.left[unit] {
                let most = places[unit] - apart;
                room[*left] = Some(room[*left].map_or(most, |room| room.min(most)));
            }
        }
        places
    }
}

/// From axis to axis.
fn distance(left: i32, right: i32) -> i32 {
    match (left, right) {
        (0, 0) => SPACING,
        (0, side) | (side, 0) => (side + TO_LINE).max(SPACING),
        (left, right) => left + right + TO_BOX,
    }
}
