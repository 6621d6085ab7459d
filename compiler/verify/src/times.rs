//! Real times for a way on which delays were free: the earliest that agree with all that was answered.

use crate::atom::Atom;
use crate::beyond::Beyond;
use crate::goal::Way;
use crate::machine::{End, Machine};
use rustc_hash::FxHashMap;

/// A way that was gone once more.
pub(crate) struct Walked {
    /// Where each reaction ended.
    pub(crate) ends: Vec<End>,
    /// When each takes place, in milliseconds; none if delays never end in this order.
    pub(crate) times: Option<Vec<i64>>,
}

/// At least so much later: `to - from >= least`.
#[derive(Clone, Copy)]
struct Bound {
    from: usize,
    to: usize,
    least: i64,
}

/// Goes a way, and finds its times.
pub(crate) fn walk(machine: &mut Machine, way: &Way) -> Result<Walked, Beyond> {
    let mut ends = Vec::with_capacity(way.len());
    let mut bounds = Vec::new();
    // The reaction in which what is measured began.
    let mut begun: FxHashMap<usize, usize> = FxHashMap::default();
    let mut state = None;
    for (now, answers) in way.iter().enumerate() {
        if now > 0 {
            bounds.push(Bound { from: now - 1, to: now, least: 1 });
        }
        for (atom, is_over) in answers {
            if let (Atom::Ends(operand, time), Some(start)) = (atom, atom_start(&begun, atom)) {
                debug_assert!(begun.contains_key(operand), "what is asked runs");
                bounds.push(if *is_over {
                    Bound { from: start, to: now, least: *time }
                } else {
                    // Less than the time.
                    Bound { from: now, to: start, least: 1 - time }
                });
            }
        }
        let end = machine.walk(state.as_ref(), answers)?;
        for (t, phase) in machine.timers().iter_enumerated().filter(|(_, phase)| phase.fresh) {
            debug_assert!(phase.on, "what begins runs");
            begun.insert(machine.clocks().operand[t], now);
        }
        state = match &end {
            End::Rest(state, _) => Some(state.clone()),
            End::Livelock(_) | End::Barred => None,
        };
        ends.push(end);
    }
    Ok(Walked { ends, times: earliest(way.len(), &bounds) })
}

fn atom_start(begun: &FxHashMap<usize, usize>, atom: &Atom) -> Option<usize> {
    match atom {
        Atom::Ends(operand, _) => begun.get(operand).copied(),
        Atom::Holds(_) | Atom::AtLeast(..) | Atom::Bit(..) => None,
    }
}

/// The earliest times from 0 on that keep all bounds, if there are any.
fn earliest(count: usize, bounds: &[Bound]) -> Option<Vec<i64>> {
    let mut times = vec![0_i64; count];
    // What still changes after so many rounds changes for ever.
    for _ in 0..=count {
        let mut changed = false;
        for Bound { from, to, least } in bounds {
            let at_least = times[*from].saturating_add(*least);
            if times[*to] < at_least {
                times[*to] = at_least;
                changed = true;
            }
        }
        if !changed {
            return (times.first().is_none_or(|first| *first == 0)).then_some(times);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn bound(from: usize, to: usize, least: i64) -> Bound {
        Bound { from, to, least }
    }

    #[test]
    fn times_are_the_earliest() {
        // By hand: a delay of 3 s from reaction 1 is over in reaction 3; one of 5 s from reaction 2 is not, one of 2 s is.
        let bounds =
            [bound(0, 1, 1), bound(1, 2, 1), bound(2, 3, 1), bound(1, 3, 3000), bound(3, 2, -4999), bound(2, 3, 2000)];
        assert_eq!(earliest(4, &bounds), Some(vec![0, 1, 2, 3001]));
    }

    #[test]
    fn what_began_later_and_takes_longer_is_not_over_before() {
        // By hand: of 3 s from reaction 0, not over in reaction 2; of 5 s from reaction 1, over in reaction 2.
        let bounds = [bound(0, 1, 1), bound(1, 2, 1), bound(2, 0, -2999), bound(1, 2, 5000)];
        assert_eq!(earliest(3, &bounds), None);
    }
}
