//! Which links lead up: those that close a circle, as a walk meets them that begins where an evolution begins.

use crate::graph::{Graph, Kind, Neighbours, Start};

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    Open,
    Done,
}

/// For each link, whether it leads up. Without these there is no circle.
///
/// Where several steps are initial, one may be met on the way from another, as in a ring with two tokens; or all of them
/// stand at the top, as where branches are joined that begin in an initial step each. What is better for the eye is
/// taken: few links up, and as few of these as can be into a synchronisation.
pub(crate) fn up_links(graph: &Graph, neighbours: &Neighbours) -> Vec<bool> {
    let one_after_another = walk(graph, neighbours, false);
    if graph.nodes.iter().filter(|node| node.start == Start::Initial).count() < 2 {
        return one_after_another;
    }
    let side_by_side = walk(graph, neighbours, true);
    let joins = |link: usize| {
        let to = graph.links[link].1;
        graph.nodes[to].kind == Kind::Transition && neighbours.into[to].len() > 1
    };
    let cost = |up: &[bool]| -> usize {
        up.iter().enumerate().filter(|(_, up)| **up).map(|(link, _)| if joins(link) { 4 } else { 1 }).sum()
    };
    if cost(&side_by_side) < cost(&one_after_another) { side_by_side } else { one_after_another }
}

/// A walk; if all initial steps stand at the top, links to them lead up.
fn walk(graph: &Graph, neighbours: &Neighbours, side_by_side: bool) -> Vec<bool> {
    let mut up = vec![false; graph.links.len()];
    let mut states = vec![State::New; graph.nodes.len()];
    let mut starts: Vec<usize> = (0..graph.nodes.len()).collect();
    starts.sort_by_key(|&node| (graph.nodes[node].start, !neighbours.into[node].is_empty()));
    let mut open: Vec<(usize, usize)> = Vec::new();
    for start in starts {
        if states[start] == State::New {
            states[start] = State::Open;
            open.push((start, 0));
        }
        while let Some((node, next)) = open.last_mut() {
            let Some(&link) = neighbours.out[*node].get(*next) else {
                states[*node] = State::Done;
                open.pop();
                continue;
            };
            *next += 1;
            let to = graph.links[link].1;
            if side_by_side && graph.nodes[to].start == Start::Initial {
                up[link] = true;
                continue;
            }
            match states[to] {
                State::New => {
                    states[to] = State::Open;
                    open.push((to, 0));
                }
                State::Open => up[link] = true,
                State::Done => {}
            }
        }
    }
    up
}
