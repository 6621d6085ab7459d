//! The order of variables: as they are met in a list of groups, of which those come first that say the most about what
//! belongs together. What depends on each other should be near, and declarations say best what that is: an order by the
//! spans of all formulas (FORCE) took ten times the nodes on a plant of six stations.

use grafc_logic::scan::{Program, TransitionId};

/// The transitions by the parts that steps and links connect, each before those that lead on from it, in whatever order they
/// were declared.
pub(super) fn transitions(program: &Program) -> Vec<Vec<TransitionId>> {
    let seen = program.observing.iter().flat_map(|observing| &observing.transitions);
    let all: Vec<TransitionId> = seen.map(|seen| seen.transition).collect();
    let mut after: Vec<Vec<TransitionId>> = vec![Vec::new(); program.steps.len()];
    for t in &all {
        let (pre, _) = program.elements.around(*t);
        for s in pre.iter().filter(|s| s.index() < program.steps.len()) {
            after[s.index()].push(*t);
        }
    }
    let mut is_met = vec![false; all.iter().map(|t| t.index() + 1).max().unwrap_or(0)];
    let mut parts = Vec::new();
    for t in &all {
        let mut order = Vec::new();
        let mut open = vec![*t];
        while let Some(t) = open.pop() {
            if std::mem::replace(&mut is_met[t.index()], true) {
                continue;
            }
            order.push(t);
            let (pre, post) = program.elements.around(t);
            for s in post.iter().chain(pre).rev().filter(|s| s.index() < program.steps.len()) {
                open.extend(std::mem::take(&mut after[s.index()]).into_iter().rev());
            }
        }
        parts.push(order);
    }
    parts.retain(|part| !part.is_empty());
    parts
}

/// For each of so many variables its place: those first that the first groups name.
pub(super) fn places(count: usize, groups: &[Vec<usize>]) -> Vec<usize> {
    let mut places = vec![usize::MAX; count];
    let mut next = 0;
    for v in groups.iter().flatten().copied().chain(0..count) {
        if places[v] == usize::MAX {
            places[v] = next;
            next += 1;
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::places;

    #[test]
    fn what_is_named_first_comes_first() {
        // Two rings, whose variables were declared in turn; one variable that nothing names.
        let groups = [vec![2, 0], vec![2, 4], vec![1, 3], vec![3, 5]];
        assert_eq!(places(7, &groups), [1, 3, 0, 4, 2, 5, 6]);
    }
}
