//! Whether two machines do the same: their product has a state for each pair that they come to together, and in none of
//! them may they publish different things.

use crate::machine::{Machine, Set};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// Where two machines differ.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Difference {
    /// The inputs of each call up to the one that differs; there is no shorter way.
    pub inputs: Vec<Vec<bool>>,
    /// The output that differs in the last of them, by its place.
    pub output: usize,
}

/// How many pairs two machines with the same inputs and outputs come to, if they do the same.
///
/// # Errors
/// Where they differ.
pub fn product(a: &Machine, b: &Machine) -> Result<usize, Difference> {
    // Each pair, and how it was come to: from which one, with which inputs.
    let mut pairs: IndexMap<(usize, usize), Option<(usize, Set)>, FxBuildHasher> = IndexMap::default();
    pairs.insert((a.initial, b.initial), None);
    let mut at = 0;
    while let Some((&(one, other), _)) = pairs.get_index(at) {
        let (one, other) = (&a.states[one], &b.states[other]);
        for (output, (x, y)) in one.outputs.iter().zip(&other.outputs).enumerate() {
            if x != y {
                return Err(Difference { inputs: way(&pairs, at, x.xor(y)), output });
            }
        }
        for (when, to) in &one.arcs {
            for (and, too) in &other.arcs {
                let both = when.and(and);
                if !both.is_false() {
                    pairs.entry((*to, *too)).or_insert_with(|| Some((at, both)));
                }
            }
        }
        at += 1;
    }
    Ok(pairs.len())
}

type Pairs = IndexMap<(usize, usize), Option<(usize, Set)>, FxBuildHasher>;

/// The inputs that lead to a pair, and at last some of a set.
fn way(pairs: &Pairs, mut at: usize, last: Set) -> Vec<Vec<bool>> {
    let some = |set: &Set| set.first_valuation().map(|inputs| inputs.into_vector()).unwrap_or_default();
    let mut inputs = vec![some(&last)];
    while let Some(Some((before, when))) = pairs.get_index(at).map(|(_, from)| from) {
        inputs.push(some(when));
        at = *before;
    }
    inputs.reverse();
    inputs
}
