//! What is left of what: stems and lanes in one order.

use crate::columns::Columns;
use crate::lanes::Lanes;

/// The order from left to right: columns and the channels between, within a channel the lanes.
pub(crate) type Position = (usize, usize);

/// The places of stems in this order, then those of lanes.
pub(crate) fn positions(columns: &Columns, lanes: &Lanes) -> Vec<Position> {
    let mut position: Vec<Position> = columns.stems.iter().map(|stem| (2 * stem.column + 1, 0)).collect();
    // Those that belong to the left come first, the nearest one first; of the others the nearest comes last.
    let most = lanes.lanes.iter().map(|lane| lane.track).max().unwrap_or(0) + 1;
    position.extend(lanes.lanes.iter().map(|lane| {
        let place = if lane.is_left { 2 * most - lane.track } else { lane.track };
        (2 * lane.channel, place)
    }));
    position
}
