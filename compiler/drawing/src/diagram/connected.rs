//! Which elements links join.

use super::{Element, Elements};
use rustc_hash::FxHashMap;

/// The elements in pieces that links join, each piece in order.
pub(crate) fn connected(elements: &Elements<'_>, own: &[Element]) -> Vec<Vec<Element>> {
    let place: FxHashMap<Element, usize> = own.iter().enumerate().map(|(place, element)| (*element, place)).collect();
    let mut root: Vec<usize> = (0..own.len()).collect();
    let find = |root: &mut Vec<usize>, mut at: usize| {
        while root[at] != at {
            root[at] = root[root[at]];
            at = root[at];
        }
        at
    };
    let mut join = |a: usize, b: usize| {
        let (a, b) = (find(&mut root, a), find(&mut root, b));
        root[a.max(b)] = a.min(b);
    };
    for (from, to) in own.iter().flat_map(|element| elements.links(*element)) {
        if let (Some(&from), Some(&to)) = (place.get(&from), place.get(&to)) {
            join(from, to);
        }
    }
    // What a transition forks or joins that is elsewhere has a part of its double line in common.
    let mut beside: FxHashMap<(Element, bool), usize> = FxHashMap::default();
    for (at, &element) in own.iter().enumerate() {
        let others = elements.next_to(element).iter().map(|id| Element::Transition(*id));
        for (from, to) in others.filter(|other| !place.contains_key(other)).flat_map(|other| elements.links(other)) {
            if from == element || to == element {
                let key = if from == element { (to, false) } else { (from, true) };
                join(*beside.entry(key).or_insert(at), at);
            }
        }
    }
    let mut pieces: Vec<Vec<Element>> = Vec::new();
    let mut piece_of: FxHashMap<usize, usize> = FxHashMap::default();
    for (at, element) in own.iter().enumerate() {
        let root = find(&mut root, at);
        let piece = *piece_of.entry(root).or_insert_with(|| {
            pieces.push(Vec::new());
            pieces.len() - 1
        });
        pieces[piece].push(*element);
    }
    pieces
}
