//! A box and the only one after it stand in one column; parts of the chart stand side by side without a gap.

use super::graph::Graph;
use rustc_hash::FxHashSet;
use std::collections::{BTreeMap, VecDeque};

/// Puts each box and its only successor, if that has no other predecessor, into one column.
///
/// Such a row of boxes moves as one: as far left as it was on average, unless what stands left of it in some layer needs the
/// room. Rows that are left of each other in turns are not moved.
pub(super) fn straighten(graph: &Graph, above: &[Vec<usize>], below: &[Vec<usize>], x: &mut [i64]) {
    let mut row: Vec<usize> = (0..graph.nodes.len()).collect();
    for layer in &graph.layers {
        for node in layer {
            if let [upper] = above[*node][..]
                && below[upper].len() == 1
            {
                row[*node] = row[upper];
            }
        }
    }
    for _ in 0..2 {
        let stuck = align(graph, &row, x);
        if stuck.is_empty() {
            return;
        }
        // Rows that cannot be put in order fall apart.
        (0..row.len())
            .filter(|node| stuck.contains(&row[*node]))
            .collect::<Vec<_>>()
            .into_iter()
            .for_each(|n| row[n] = n);
    }
}

/// Moves all rows; those that are left of each other in turns are given back, and nothing is moved.
fn align(graph: &Graph, row: &[usize], x: &mut [i64]) -> FxHashSet<usize> {
    let count = graph.nodes.len();
    let (mut sum, mut size) = (vec![0_i64; count], vec![0_i64; count]);
    for node in 0..count {
        sum[row[node]] += x[node];
        size[row[node]] += 1;
    }
    // What stands right of each row, and how far away it must be.
    let mut right: Vec<Vec<(usize, i64)>> = vec![Vec::new(); count];
    let mut waiting = vec![0_usize; count];
    for layer in &graph.layers {
        for pair in layer.windows(2) {
            let (a, b) = (row[pair[0]], row[pair[1]]);
            right[a].push((b, graph.nodes[pair[0]].right + graph.nodes[pair[1]].left));
            waiting[b] += 1;
        }
    }
    let is_row = |node: &usize| row[*node] == *node;
    let mut ready: VecDeque<usize> = (0..count).filter(|node| is_row(node) && waiting[*node] == 0).collect();
    let mut least = vec![i64::MIN; count];
    let mut at = vec![None; count];
    while let Some(now) = ready.pop_front() {
        let column = (sum[now] / size[now].max(1)).max(least[now]);
        at[now] = Some(column);
        for (next, distance) in &right[now] {
            least[*next] = least[*next].max(column + distance);
            waiting[*next] -= 1;
            if waiting[*next] == 0 {
                ready.push_back(*next);
            }
        }
    }
    let stuck: FxHashSet<usize> = (0..count).filter(|node| is_row(node) && at[*node].is_none()).collect();
    if stuck.is_empty() {
        (0..count).for_each(|node| x[node] = at[row[node]].unwrap_or(x[node]));
    }
    stuck
}

/// Moves each part of the chart to the left, up to the parts before it.
pub(super) fn close_gaps(graph: &Graph, x: &mut [i64]) {
    let part = graph.parts();
    let mut nodes: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    (0..graph.nodes.len()).for_each(|node| nodes.entry(part[node]).or_default().push(node));
    // What is taken of each layer.
    let mut taken: Vec<Option<i64>> = vec![None; graph.layers.len()];
    for nodes in nodes.values() {
        let room = |node: &usize| {
            // Bars lie between two layers, and are as wide as the wider one.
            let layer = graph.nodes[*node].layer;
            let near = taken.iter().take(layer + 2).skip(layer.saturating_sub(1));
            near.flatten().max().map_or(i64::MAX, |end| x[*node] - graph.nodes[*node].left - end)
        };
        let left = nodes.iter().map(|node| x[*node] - graph.nodes[*node].left).min().unwrap_or(0);
        let room = nodes.iter().map(room).min().unwrap_or(i64::MAX);
        // A part that meets no other in any layer still comes after them.
        let shift = if room == i64::MAX { taken.iter().flatten().max().map_or(0, |end| left - end) } else { room };
        for node in nodes {
            x[*node] -= shift;
            let end = x[*node] + graph.nodes[*node].right;
            let taken = &mut taken[graph.nodes[*node].layer];
            *taken = Some(taken.map_or(end, |known| known.max(end)));
        }
    }
}
