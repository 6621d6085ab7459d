//! The order within each layer: by the barycentre of the neighbours, from the top down and back up, as long as it pays.

use super::graph::Graph;
use rustc_hash::FxHashMap;

/// More rounds are seldom of use.
const ROUNDS: usize = 8;

/// Orders the nodes of each layer; of all orders met, the first with the fewest crossings stays.
pub(super) fn reduce_crossings(graph: &mut Graph) {
    let mut above: Vec<Vec<usize>> = vec![Vec::new(); graph.nodes.len()];
    let mut below = above.clone();
    for (upper, lower) in graph.links() {
        above[lower].push(upper);
        below[upper].push(lower);
    }
    let texts = TextOrder::new(graph, &above);
    graph.layers.iter_mut().for_each(|layer| texts.by_part(layer));
    let mut best = (crossings(&graph.layers, &below), graph.layers.clone());
    let mut layers = graph.layers.clone();
    for _ in 0..ROUNDS {
        if best.0 == 0 {
            break;
        }
        for layer in 1..layers.len() {
            sort(&mut layers, layer, layer - 1, &above);
            texts.restore(&mut layers[layer]);
        }
        for layer in (1..layers.len()).rev() {
            sort(&mut layers, layer - 1, layer, &below);
            texts.restore(&mut layers[layer - 1]);
        }
        let count = crossings(&layers, &below);
        if count < best.0 {
            best = (count, layers.clone());
        }
    }
    graph.layers = best.1;
}

/// The order of the text, which goes before the number of crossings.
struct TextOrder {
    /// The place of each node as a search in the order of the text meets it.
    met: Vec<usize>,
    /// What alone leads to each node, if one does: the branches of a divergence have it in common.
    parent: Vec<Option<usize>>,
    /// The part of the chart that each node belongs to, by order: parts without a way between them.
    part: Vec<usize>,
}

impl TextOrder {
    fn new(graph: &Graph, above: &[Vec<usize>]) -> Self {
        let mut met = vec![0; graph.nodes.len()];
        graph.layers.iter().flat_map(|layer| layer.iter().enumerate()).for_each(|(place, node)| met[*node] = place);
        let alone = |above: &Vec<usize>| if let [only] = above[..] { Some(only) } else { None };
        TextOrder { met, parent: above.iter().map(alone).collect(), part: graph.parts() }
    }

    /// Parts side by side, the branches of each divergence in the order of the text, in the places that they have.
    fn restore(&self, layer: &mut [usize]) {
        self.by_part(layer);
        let mut siblings: FxHashMap<usize, Vec<usize>> = FxHashMap::default();
        for (place, node) in layer.iter().enumerate() {
            if let Some(parent) = self.parent[*node] {
                siblings.entry(parent).or_default().push(place);
            }
        }
        for places in siblings.values().filter(|places| places.len() > 1) {
            let mut nodes: Vec<usize> = places.iter().map(|place| layer[*place]).collect();
            nodes.sort_by_key(|node| self.met[*node]);
            places.iter().zip(nodes).for_each(|(place, node)| layer[*place] = node);
        }
    }

    fn by_part(&self, layer: &mut [usize]) {
        layer.sort_by_key(|node| self.part[*node]);
    }
}

/// Sorts a layer by the middle of each node's neighbours in another; nodes without any keep their place.
fn sort(layers: &mut [Vec<usize>], layer: usize, by: usize, neighbours: &[Vec<usize>]) {
    let places = places(&layers[by]);
    let mut keyed: Vec<(f64, usize)> = Vec::with_capacity(layers[layer].len());
    for (place, &node) in layers[layer].iter().enumerate() {
        let sum: f64 = neighbours[node].iter().map(|n| places.get(n).copied().unwrap_or_default() as f64).sum();
        let count = neighbours[node].len();
        keyed.push((if count == 0 { place as f64 } else { sum / count as f64 }, node));
    }
    keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
    layers[layer] = keyed.into_iter().map(|(_, node)| node).collect();
}

fn places(layer: &[usize]) -> rustc_hash::FxHashMap<usize, usize> {
    layer.iter().enumerate().map(|(place, node)| (*node, place)).collect()
}

/// How many links cross: pairs in the wrong order, counted with a Fenwick tree.
fn crossings(layers: &[Vec<usize>], below: &[Vec<usize>]) -> usize {
    let mut count = 0;
    for pair in layers.windows(2) {
        let places = places(&pair[1]);
        let mut tree = vec![0_usize; pair[1].len() + 1];
        let mut seen = 0;
        for node in &pair[0] {
            let mut ends: Vec<usize> = below[*node].iter().filter_map(|n| places.get(n).copied()).collect();
            ends.sort_unstable();
            for &end in &ends {
                // Those that end further right than this one.
                let (mut at, mut not_right) = (end + 1, 0);
                while at > 0 {
                    not_right += tree[at];
                    at &= at - 1;
                }
                count += seen - not_right;
            }
            for end in ends {
                seen += 1;
                let mut at = end + 1;
                while at < tree.len() {
                    tree[at] += 1;
                    at += at & at.wrapping_neg();
                }
            }
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crossings_are_counted() {
        // 0 and 1 above 2 and 3.
        for (below, expected) in [
            (vec![vec![2], vec![3], vec![], vec![]], 0),
            (vec![vec![3], vec![2], vec![], vec![]], 1),
            (vec![vec![2, 3], vec![2, 3], vec![], vec![]], 1),
            (vec![vec![3], vec![3], vec![], vec![]], 0),
        ] {
            assert_eq!(crossings(&[vec![0, 1], vec![2, 3]], &below), expected);
        }
    }
}
