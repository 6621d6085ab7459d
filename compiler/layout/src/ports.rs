//! Where links meet a short double line: side by side, those from the left at the left.
//!
//! What stands right under or over goes straight on.

use crate::SPACING;
use crate::cells::Cells;
use crate::columns::Columns;
use crate::graph::{Bar, Side};
use crate::lanes::Lanes;
use crate::order::positions;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// The ends of links at short double lines.
pub(crate) struct Ports {
    /// For each piece and side of a short double line, how far right of the axis it meets it, and how many others of its
    /// side do nearer to the axis.
    pub of: FxHashMap<(usize, Side), (i32, usize)>,
    /// For each box and side, how far the double line reaches from the axis to the left and to the right.
    pub reach: FxHashMap<(usize, Side), (i32, i32)>,
}

impl Ports {
    pub(crate) fn new(cells: &Cells, columns: &Columns, lanes: &Lanes) -> Ports {
        let mut ports = Ports { of: FxHashMap::default(), reach: FxHashMap::default() };
        let position = positions(columns, lanes);
        for cell in 0..cells.short.len() {
            for side in [Side::Over, Side::Under].into_iter().filter(|side| cells.is_short(cell, *side)) {
                let wires = match side {
                    Side::Over => &cells.into[cell],
                    Side::Under => &cells.out[cell],
                };
                // A double line is met by pieces that go down, never by a lane.
                let other = |wire: usize| match side {
                    Side::Over => columns.stem_of[cells.wires[wire].from],
                    Side::Under => columns.stem_of[cells.wires[wire].to],
                };
                let mut ends: Vec<_> = wires.iter().map(|wire| (position[other(*wire)], other(*wire), *wire)).collect();
                ends.sort_unstable();
                let own = (position[columns.stem_of[cell]], columns.stem_of[cell]);
                let beside =
                    |order: Ordering| ends.iter().filter(|end| (end.0, end.1).cmp(&own) == order).count() as i32;
                let (left, straight) = (beside(Ordering::Less), beside(Ordering::Equal));
                // Without one in the middle, two stand around it.
                let half = if straight == 0 && left > 0 && left < ends.len() as i32 { SPACING / 2 } else { 0 };
                let (mut reach_left, mut reach_right) = (0, 0);
                for (place, (_, _, wire)) in ends.iter().enumerate() {
                    let place = place as i32 - left;
                    let (at, nearer) = match place {
                        ..0 => (place * SPACING + half, -place - 1),
                        _ if straight > 0 => (place * SPACING, place - 1),
                        _ if left == 0 => ((place + 1) * SPACING, place),
                        _ => (place * SPACING + half, place),
                    };
                    (reach_left, reach_right) = (reach_left.max(-at), reach_right.max(at));
                    ports.of.insert((*wire, side), (at, nearer.max(0) as usize));
                }
                ports.reach.insert((cell, side), (reach_left + Bar::OVERHANG, reach_right + Bar::OVERHANG));
            }
        }
        ports
    }

    /// Where a piece meets a double line that is short; else on the axis of what is at its other end.
    pub(crate) fn at(&self, wire: usize, side: Side) -> Option<i32> {
        self.of.get(&(wire, side)).map(|(at, _)| *at)
    }
}
