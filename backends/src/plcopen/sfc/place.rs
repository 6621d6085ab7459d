//! Columns and rows.
//!
//! Each node wants to stand below (above) the middle of its neighbours; nodes of a layer must keep their order and their
//! distance. The positions with the least sum of squared deviations are found by pooling what gets in each other's way;
//! then `straight` puts what follows each other alone into one column, and parts of the chart side by side.

use super::graph::{Graph, VertexKind};
use super::straight;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Rounds down and up; the last is down.
const ROUNDS: usize = 6;
/// A bent arc is worse than a box out of the middle.
const WEIGHT_OF_JOINT: f64 = 8.0;
/// From a layer to the first horizontal piece below it, and from one to the next.
const TO_TRACK: i64 = 10;
const TRACK: i64 = 8;
/// From one bar to the next, and the room that a bar needs at its ends.
const BAR: i64 = 18;
const BAR_END: i64 = 25;
/// From the last of these to the next layer.
const TO_LAYER: i64 = 22;
/// The margin of the sheet.
const SHEET: i64 = 20;

/// Where everything stands.
pub(super) struct Placed {
    /// The axis of each node.
    pub x: Vec<i64>,
    /// The top of each layer.
    pub y: Vec<i64>,
    /// The top of the bar above and of the bar below each node that has one.
    pub above: Vec<i64>,
    pub below: Vec<i64>,
    /// For each path, where it turns: between its nodes at these places, at this height.
    pub bends: Vec<Vec<(usize, i64)>>,
}

pub(super) fn place(graph: &Graph) -> Placed {
    let count = graph.nodes.len();
    let (x, none) = (columns(graph), vec![0; count]);
    let mut placed =
        Placed { x, y: Vec::new(), above: none.clone(), below: none, bends: vec![Vec::new(); graph.paths.len()] };
    let turning = turning(graph, &placed.x);
    let mut top = SHEET;
    for (layer, nodes) in graph.layers.iter().enumerate() {
        placed.y.push(top);
        top += nodes.iter().map(|node| graph.nodes[*node].height).max().unwrap_or(0) + TO_TRACK;
        let pieces = &turning[layer];
        let (tracks, count) = tracks(&pieces.iter().map(|piece| (piece.from, piece.to)).collect::<Vec<_>>());
        for (piece, track) in pieces.iter().zip(tracks) {
            placed.bends[piece.path].push((piece.place, top + TRACK * track));
        }
        top += TRACK * count;
        top = bars(nodes, top, &mut placed.below, |node| bar_below(graph, &placed.x, node));
        let next = graph.layers.get(layer + 1).map_or(&[][..], Vec::as_slice);
        top = bars(next, top, &mut placed.above, |node| bar_above(graph, &placed.x, node)) + TO_LAYER;
    }
    placed
}

/// The bar below a node, from left to right, if it has one: over where its paths go on.
pub(super) fn bar_below(graph: &Graph, x: &[i64], node: usize) -> Option<(i64, i64)> {
    let leaving = &graph.leaving[node];
    graph.has_bar_below(node).then(|| span(leaving.iter().map(|path| x[graph.paths[*path][1]]), x[node]))
}

/// The bar above a node, from left to right, if it has one: over where its paths arrive.
pub(super) fn bar_above(graph: &Graph, x: &[i64], node: usize) -> Option<(i64, i64)> {
    let entering = &graph.entering[node];
    let arrives = |path: &usize| {
        let nodes = &graph.paths[*path];
        x[nodes[nodes.len() - 2]]
    };
    (entering.len() > 1).then(|| span(entering.iter().map(arrives), x[node]))
}

/// From the leftmost to the rightmost.
fn span(ends: impl Iterator<Item = i64>, own: i64) -> (i64, i64) {
    ends.fold((own, own), |(left, right), end| (left.min(end), right.max(end)))
}

/// Gives the bars of some nodes heights from `top` down; what is below all of them.
fn bars(nodes: &[usize], top: i64, heights: &mut [i64], bar: impl Fn(usize) -> Option<(i64, i64)>) -> i64 {
    let bars: Vec<(usize, (i64, i64))> = nodes.iter().filter_map(|node| Some((*node, bar(*node)?))).collect();
    let spans: Vec<(i64, i64)> = bars.iter().map(|(_, (left, right))| (left - BAR_END, right + BAR_END)).collect();
    let (tracks, count) = tracks(&spans);
    for ((node, _), track) in bars.iter().zip(tracks) {
        heights[*node] = top + BAR * track;
    }
    top + BAR * count
}

fn columns(graph: &Graph) -> Vec<i64> {
    let mut above: Vec<Vec<usize>> = vec![Vec::new(); graph.nodes.len()];
    let mut below = above.clone();
    for (upper, lower) in graph.links() {
        above[lower].push(upper);
        below[upper].push(lower);
    }
    let mut x = vec![0.0; graph.nodes.len()];
    for layer in &graph.layers {
        settle(graph, layer, &mut x, &[]);
    }
    for round in 0..2 * ROUNDS + 1 {
        if round % 2 == 0 {
            graph.layers.iter().for_each(|layer| settle(graph, layer, &mut x, &above));
        } else {
            graph.layers.iter().rev().for_each(|layer| settle(graph, layer, &mut x, &below));
        }
    }
    let mut x: Vec<i64> = x.into_iter().map(|x| x.round() as i64).collect();
    straight::straighten(graph, &above, &below, &mut x);
    straight::close_gaps(graph, &mut x);
    let leftmost = graph.nodes.iter().zip(&x).map(|(node, x)| x - node.left).min().unwrap_or(0);
    x.into_iter().map(|x| x - leftmost + SHEET).collect()
}

/// Nodes that stand shoulder to shoulder.
struct Group {
    /// The sum of weighted wishes, the weight, and how many nodes.
    sum: f64,
    weight: f64,
    count: usize,
}

/// Moves the nodes of a layer to the middle of their neighbours, as far as order and distance allow.
fn settle(graph: &Graph, layer: &[usize], x: &mut [f64], neighbours: &[Vec<usize>]) {
    // Without the distances that must be kept, the positions need only ascend.
    let mut offsets = Vec::with_capacity(layer.len());
    let mut groups: Vec<Group> = Vec::new();
    let mut offset = 0;
    for (place, &node) in layer.iter().enumerate() {
        if let Some(before) = place.checked_sub(1).map(|before| layer[before]) {
            offset += graph.nodes[before].right + graph.nodes[node].left;
        }
        offsets.push(offset as f64);
        let near = neighbours.get(node).map_or(&[][..], Vec::as_slice);
        let middle = near.iter().map(|n| x[*n]).sum::<f64>() / near.len() as f64;
        let wish = if near.is_empty() { x[node] } else { middle } - offset as f64;
        let weight = if graph.nodes[node].kind == VertexKind::Joint { WEIGHT_OF_JOINT } else { 1.0 };
        let mut group = Group { sum: wish * weight, weight, count: 1 };
        while let Some(last) = groups.last().filter(|last| last.sum / last.weight >= group.sum / group.weight) {
            group.sum += last.sum;
            group.weight += last.weight;
            group.count += last.count;
            groups.pop();
        }
        groups.push(group);
    }
    let mut nodes = layer.iter().zip(offsets);
    for group in groups {
        for (&node, offset) in nodes.by_ref().take(group.count) {
            // Rounded here, the distances stay whole.
            x[node] = (group.sum / group.weight).round() + offset;
        }
    }
}

/// A horizontal piece of a path, after one of its nodes.
#[derive(Clone)]
struct Piece {
    from: i64,
    to: i64,
    path: usize,
    place: usize,
}

/// The horizontal pieces below each layer. What starts or ends at a bar starts or ends where the path goes on.
fn turning(graph: &Graph, x: &[i64]) -> Vec<Vec<Piece>> {
    let mut turning = vec![Vec::new(); graph.layers.len()];
    for (path, nodes) in graph.paths.iter().enumerate() {
        for (place, pair) in nodes.windows(2).enumerate() {
            let from_bar = place == 0 && graph.has_bar_below(pair[0]);
            let to_bar = place + 2 == nodes.len() && graph.entering[pair[1]].len() > 1;
            let (from, to) = (x[pair[0]], x[pair[1]]);
            if from != to && !from_bar && !to_bar {
                turning[graph.nodes[pair[0]].layer].push(Piece { from: from.min(to), to: from.max(to), path, place });
            }
        }
    }
    turning
}

/// Gives each interval a track on which it meets no other; how many that takes.
fn tracks(intervals: &[(i64, i64)]) -> (Vec<i64>, i64) {
    let mut order: Vec<usize> = (0..intervals.len()).collect();
    order.sort_by_key(|place| intervals[*place]);
    let mut tracks = vec![0; intervals.len()];
    let mut busy: BinaryHeap<Reverse<(i64, i64)>> = BinaryHeap::new();
    let mut count = 0;
    for place in order {
        let (from, to) = intervals[place];
        tracks[place] = match busy.peek() {
            Some(Reverse((end, track))) if *end < from => {
                let track = *track;
                busy.pop();
                track
            }
            _ => {
                count += 1;
                count - 1
            }
        };
        busy.push(Reverse((to, tracks[place])));
    }
    (tracks, count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_that_meet_get_tracks_of_their_own() {
        assert_eq!(tracks(&[]), (vec![], 0));
        assert_eq!(tracks(&[(0, 10), (11, 20), (5, 15)]), (vec![0, 0, 1], 2));
        assert_eq!(tracks(&[(10, 20), (0, 10)]), (vec![1, 0], 2));
    }
}
