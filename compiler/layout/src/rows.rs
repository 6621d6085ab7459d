//! Each box one row below the lowest that leads to it.

use crate::graph::{Graph, Kind, Neighbours, Start};

/// Where several links come from a box and several lead to the other, their link needs a row of its own between two
/// lines, and one more so that steps and transitions keep taking turns.
const WITH_JOINT: i32 = 3;

/// How far below its source the target of a link has to be.
fn distance(graph: &Graph, neighbours: &Neighbours, main: Option<usize>, link: usize) -> i32 {
    let (from, to) = graph.links[link];
    let joins = neighbours.into[to].len() > 1 || main == Some(to);
    if neighbours.out[from].len() > 1 && joins { WITH_JOINT } else { 1 }
}

/// The row of each box; links that lead up are left out.
pub(crate) fn rows(graph: &Graph, neighbours: &Neighbours, up: &[bool]) -> Vec<i32> {
    let mut rows = vec![0; graph.nodes.len()];
    let main = graph.main();
    let mut waiting: Vec<usize> =
        neighbours.into.iter().map(|links| links.iter().filter(|link| !up[**link]).count()).collect();
    let sources: Vec<usize> = (0..rows.len()).filter(|node| waiting[*node] == 0).collect();
    let mut ready = sources.clone();
    while let Some(node) = ready.pop() {
        for &link in neighbours.out[node].iter().filter(|link| !up[**link]) {
            let to = graph.links[link].1;
            rows[to] = rows[to].max(rows[node] + distance(graph, neighbours, main, link));
            waiting[to] -= 1;
            if waiting[to] == 0 {
                ready.push(to);
            }
        }
    }
    // What has nothing above it stands over what it leads to, if nothing begins there; a label always.
    let floats = |node: &usize| graph.nodes[*node].start == Start::Plain || graph.nodes[*node].kind == Kind::Label;
    for node in sources.into_iter().filter(floats) {
        let above = |link: &usize| rows[graph.links[*link].1] - distance(graph, neighbours, main, *link);
        let below = neighbours.out[node].iter().filter(|link| !up[**link]);
        rows[node] = below.map(above).min().unwrap_or(0);
    }
    rows
}
