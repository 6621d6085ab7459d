//! R5: enclosures and orders act on the situation that clearing leaves.

use super::Activity;
use super::orders::{Forced, Orders};
use super::pulses::Pulses;
use crate::chart::Chart;

/// Whether orders asked for different situations; must go into the flags.
#[must_use]
pub(super) struct Conflict(pub bool);

/// When the situation is settled.
#[derive(Clone, Copy, Debug)]
pub(super) enum Phase<'a> {
    /// R10: links of the enclosing steps of this situation are suppressed; their initial enclosed steps are active instead.
    Start(&'a Activity),
    /// In a micro-step.
    Evolution,
}

/// `settle(X, N)`: changes `next` in place, one grafcet after the other, from the top of the hierarchy. One pass is
/// enough since whatever acts on a grafcet comes before it.
pub(super) fn settle(
    chart: &Chart,
    orders: &Orders,
    mut pulses: Pulses,
    phase: Phase,
    before: &Activity,
    next: &mut Activity,
) -> Conflict {
    let mut conflict = false;
    for &id in &chart.hierarchy {
        let grafcet = &chart.grafcets[id];
        // (a) the enclosure follows its enclosing step
        pulses.stop_with_enclosing(chart, id);
        if let Some(enclosing) = grafcet.enclosing_step {
            if !next[enclosing] {
                for &step in &grafcet.steps {
                    next[step] = false;
                }
                pulses.forget(chart, id);
                // An inactive enclosure obeys no order, so its orders cannot conflict.
                continue;
            }
            let suppressed = match phase {
                Phase::Start(initial) => initial[enclosing],
                Phase::Evolution => false,
            };
            if !before[enclosing] && !suppressed {
                for &step in grafcet.steps.iter().filter(|&&step| chart.steps[step].activated) {
                    next[step] = true;
                }
            }
        }
        // R15: pulse orders act
        conflict |= pulses.act(chart, id, before, next);
        // (b) the order in force decides
        if let Some(order) = orders.in_force(id, next) {
            conflict |= order.conflict;
            match order.forced {
                Forced::Steps(steps) => {
                    for &step in &grafcet.steps {
                        next[step] = false;
                    }
                    for &step in steps {
                        next[step] = true;
                    }
                    pulses.forget(chart, id);
                }
                Forced::Current => {}
            }
        }
    }
    Conflict(conflict)
}
