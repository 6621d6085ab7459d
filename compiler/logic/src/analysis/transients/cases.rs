//! Case by case: what an input is, for the whole of a reaction.
//!
//! `1 -a-> 2 -b-> 3 -not a-> 4 -c-> 1` is a circle, but no reaction goes all around it: with `a` true it stops in step
//! 3, else in step 1. So where the graph has circles, and some expression over inputs is asserted by one of their
//! transitions and denied by another, both values are tried, each without the transitions that contradict it.

use super::causes::{Causes, Effects};
use super::longest::{Endless, Times};
use super::stable::{Class, Literal, Stable};
use grafc_model::chart::TransitionId;
use grafc_net::Net;
use index_vec::{IndexVec, index_vec};

/// At most so many cases are tried; fewer where the graph is large.
const CASES: usize = 64;

/// So many edges of the graph may be looked at in all, beyond the first case.
const EFFORT: usize = 4_000_000;

/// The times of all cases, or the circle that is left.
pub(super) fn times<'a>(
    net: &'a Net,
    causes: &'a Causes,
    effects: &'a Effects,
    stable: &'a Stable,
) -> impl Iterator<Item = Result<Times, Vec<TransitionId>>> + 'a {
    let mut open: Vec<Vec<Literal>> = vec![Vec::new()];
    let mut left = CASES.min(1 + EFFORT / effects.len().max(1));
    std::iter::from_fn(move || {
        loop {
            let assumed = open.pop()?;
            left = left.saturating_sub(1);
            match Times::find(net, causes, effects, &|t| contradicts(stable, t, &assumed)) {
                Ok(times) => return Some(Ok(times)),
                Err(endless) => match undecided(stable, &endless, &assumed).filter(|_| left > open.len() + 1) {
                    Some(class) => {
                        for asserted in [false, true] {
                            open.push(assumed.iter().copied().chain([Literal { class, asserted }]).collect());
                        }
                    }
                    None => return Some(Err(endless.cycle)),
                },
            }
        }
    })
}

/// Whether the condition of a transition does not hold where these literals do.
fn contradicts(stable: &Stable, t: TransitionId, assumed: &[Literal]) -> bool {
    stable.literals(t).iter().any(|l| assumed.iter().any(|a| stable.contradict(*l, *a)))
}

/// What the transitions of a circle assert and deny most.
fn undecided(stable: &Stable, endless: &Endless, assumed: &[Literal]) -> Option<Class> {
    let mut count: IndexVec<Class, (usize, usize)> = index_vec![(0, 0); stable.count()];
    for literal in endless.transitions.iter().flat_map(|t| stable.literals(*t)) {
        let (asserted, denied) = &mut count[literal.class];
        *(if literal.asserted { asserted } else { denied }) += 1;
    }
    let both = count.into_iter_enumerated().filter(|(class, (asserted, denied))| {
        *asserted > 0 && *denied > 0 && assumed.iter().all(|a| a.class != *class)
    });
    both.max_by_key(|(class, (asserted, denied))| (*asserted.min(denied), std::cmp::Reverse(*class)))
        .map(|(class, _)| class)
}
