//! Which links lead up: those that close a circle, as an evolution meets them.

use crate::graph::{Graph, Kind, Neighbours, Start};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// For each link, whether it leads up. Without these there is no circle.
///
/// Where several steps are initial, one may be met on the way from another, as in a ring with two tokens; or all of them
/// stand at the top, as where branches are joined that begin in an initial step each. What is better for the eye is
/// taken: few links up, and as few of these as can be into a synchronisation.
pub(crate) fn up_links(graph: &Graph, neighbours: &Neighbours) -> Vec<bool> {
    let one_after_another = evolve(graph, neighbours, false);
    if graph.nodes.iter().filter(|node| node.start == Start::Initial).count() < 2 {
        return one_after_another;
    }
    let side_by_side = evolve(graph, neighbours, true);
    let cost = |up: &[bool]| -> usize {
        let joins = |link: usize| is_join(graph, neighbours, graph.links[link].1);
        up.iter().enumerate().filter(|(_, up)| **up).map(|(link, _)| if joins(link) { 4 } else { 1 }).sum()
    };
    if cost(&side_by_side) < cost(&one_after_another) { side_by_side } else { one_after_another }
}

fn is_join(graph: &Graph, neighbours: &Neighbours, node: usize) -> bool {
    graph.nodes[node].kind == Kind::Transition && neighbours.into[node].len() > 1
}

/// Everything comes after what leads to it. Where that is not possible, a circle begins: at the step that a walk would
/// meet first, and at a synchronisation only where nothing else is left, for it waits for all its branches. The links
/// back to where a circle begins lead up; if all initial steps stand at the top, all links to them.
fn evolve(graph: &Graph, neighbours: &Neighbours, side_by_side: bool) -> Vec<bool> {
    let is_initial = |node: usize| graph.nodes[node].start == Start::Initial;
    let mut up: Vec<bool> = graph.links.iter().map(|&(_, to)| side_by_side && is_initial(to)).collect();
    let (place, roots) = walk(graph, neighbours, &up);
    let mut waiting: Vec<usize> =
        neighbours.into.iter().map(|links| links.iter().filter(|link| !up[**link]).count()).collect();
    let mut done = vec![false; graph.nodes.len()];
    let mut ready: Vec<usize> = (0..waiting.len()).filter(|node| waiting[*node] == 0).collect();
    let mut met = vec![false; graph.nodes.len()];
    let mut open: BinaryHeap<Reverse<(u8, usize, usize)>> = BinaryHeap::new();
    open.extend(roots.iter().map(|root| Reverse((0, place[*root], *root))));
    let begins = |node: &usize| graph.nodes[*node].start != Start::Plain;
    open.extend((0..waiting.len()).filter(begins).map(|node| Reverse((2, place[node], node))));
    loop {
        let node = match ready.pop() {
            Some(node) => node,
            None => match open.pop() {
                Some(Reverse((_, _, node))) => node,
                None => return up,
            },
        };
        if std::mem::replace(&mut done[node], true) {
            continue;
        }
        for &link in &neighbours.into[node] {
            up[link] |= !done[graph.links[link].0] || graph.links[link].0 == node;
        }
        for &link in neighbours.out[node].iter().filter(|link| !up[**link]) {
            let to = graph.links[link].1;
            waiting[to] -= 1;
            if waiting[to] == 0 {
                ready.push(to);
            } else if !std::mem::replace(&mut met[to], true) {
                let waits = is_join(graph, neighbours, to);
                open.push(Reverse((if waits { 3 } else { 0 }, place[to], to)));
                // Where drawing can begin, it does so first at what a synchronisation waits for.
                let before = neighbours.into[to].iter().map(|link| graph.links[*link].0);
                let begin = before.filter(|node| waits && !done[*node] && begins(node));
                open.extend(begin.map(|node| Reverse((1, place[node], node))));
            }
        }
    }
}

/// The place of each box in an order in which what a walk comes back from last is first, and where the walk began.
fn walk(graph: &Graph, neighbours: &Neighbours, up: &[bool]) -> (Vec<usize>, Vec<usize>) {
    let mut starts: Vec<usize> = (0..graph.nodes.len()).collect();
    starts.sort_by_key(|&node| (graph.nodes[node].start, !neighbours.into[node].is_empty()));
    let mut place = vec![0; graph.nodes.len()];
    let mut last = graph.nodes.len();
    let mut met = vec![false; graph.nodes.len()];
    let mut roots = Vec::new();
    let mut open: Vec<(usize, usize)> = Vec::new();
    for start in starts {
        if std::mem::replace(&mut met[start], true) {
            continue;
        }
        roots.push(start);
        open.push((start, 0));
        while let Some((node, next)) = open.last_mut() {
            let Some(&link) = neighbours.out[*node].get(*next) else {
                last -= 1;
                place[*node] = last;
                open.pop();
                continue;
            };
            *next += 1;
            let to = graph.links[link].1;
            if !up[link] && !std::mem::replace(&mut met[to], true) {
                open.push((to, 0));
            }
        }
    }
    (place, roots)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Node, Size};

    /// Links by the numbers of their boxes; steps first, then transitions.
    fn graph(steps: usize, initial: &[usize], transitions: &[(&[usize], &[usize])]) -> Graph {
        let mut graph = Graph::default();
        let node = |kind, start| Node { kind, start, size: Size::default(), label: Size::default() };
        for step in 0..steps {
            let start = if initial.contains(&step) { Start::Initial } else { Start::Plain };
            graph.nodes.push(node(Kind::Step, start));
        }
        for (before, after) in transitions {
            let own = graph.nodes.len();
            graph.nodes.push(node(Kind::Transition, Start::Plain));
            graph.links.extend(before.iter().map(|step| (*step, own)).chain(after.iter().map(|step| (own, *step))));
        }
        graph
    }

    fn up(graph: &Graph) -> Vec<(usize, usize)> {
        let found = up_links(graph, &graph.neighbours());
        graph.links.iter().zip(found).filter(|(_, up)| *up).map(|(link, _)| *link).collect()
    }

    #[test]
    fn a_loop_over_a_parallel_region_leads_back_to_all_its_branches() {
        // 0 -> 1, 2; 1 -> 3; 2 -> 4; 3, 4 -> 5; 5 -> 0; 5 -> 1, 2.
        let parallel: [(&[usize], &[usize]); 6] =
            [(&[0], &[1, 2]), (&[1], &[3]), (&[2], &[4]), (&[3, 4], &[5]), (&[5], &[0]), (&[5], &[1, 2])];
        assert_eq!(up(&graph(6, &[0], &parallel)), [(10, 0), (11, 1), (11, 2)]);
    }

    #[test]
    fn a_ring_has_one_link_up_and_branches_that_begin_apart_have_one_each() {
        let ring: [(&[usize], &[usize]); 3] = [(&[0], &[1]), (&[1], &[2]), (&[2], &[0])];
        assert_eq!(up(&graph(3, &[0], &ring)), [(5, 0)]);
        // With a second token in it.
        assert_eq!(up(&graph(3, &[0, 1], &ring)), [(5, 0)]);
        let joined: [(&[usize], &[usize]); 2] = [(&[0, 1], &[2]), (&[2], &[0, 1])];
        assert_eq!(up(&graph(3, &[0, 1], &joined)), [(4, 0), (4, 1)]);
    }
}
